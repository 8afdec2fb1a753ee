package dev.cairn.benchmarks.peer;

import com.bulletphysics.collision.broadphase.DbvtBroadphase;
import com.bulletphysics.collision.dispatch.CollisionDispatcher;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.dispatch.DefaultCollisionConfiguration;
import com.bulletphysics.collision.shapes.BoxShape;
import com.bulletphysics.collision.shapes.BvhTriangleMeshShape;
import com.bulletphysics.collision.shapes.CapsuleShape;
import com.bulletphysics.collision.shapes.CollisionShape;
import com.bulletphysics.collision.shapes.ConvexHullShape;
import com.bulletphysics.collision.shapes.CylinderShape;
import com.bulletphysics.collision.shapes.SphereShape;
import com.bulletphysics.collision.shapes.TriangleIndexVertexArray;
import com.bulletphysics.dynamics.DiscreteDynamicsWorld;
import com.bulletphysics.dynamics.RigidBody;
import com.bulletphysics.dynamics.RigidBodyConstructionInfo;
import com.bulletphysics.dynamics.constraintsolver.ContactSolverInfo;
import com.bulletphysics.dynamics.constraintsolver.HingeConstraint;
import com.bulletphysics.dynamics.constraintsolver.Point2PointConstraint;
import com.bulletphysics.dynamics.constraintsolver.SequentialImpulseConstraintSolver;
import com.bulletphysics.dynamics.constraintsolver.TypedConstraint;
import com.bulletphysics.linearmath.DefaultMotionState;
import com.bulletphysics.linearmath.Transform;
import com.bulletphysics.util.ObjectArrayList;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.samples.SceneBuilder.ConstantForce;

import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;

import javax.vecmath.Quat4f;
import javax.vecmath.Vector3f;

/** JBullet, the Java port of Bullet 2.72. */
final class JBulletPeer implements Peer {
    private static final int BEST_ITERATIONS = 50;
    private static final float BEST_MARGIN = 1e-3f;

    private final SceneDescription scene;
    private final PeerSettings settings;
    private final boolean best;
    private final IdentityHashMap<ConvexHull, ConvexHullShape> hulls = new IdentityHashMap<>();
    private final float substepSeconds;
    private final CollisionDispatcher dispatcher;
    private final DiscreteDynamicsWorld world;
    private final List<RigidBody> bodies = new ArrayList<>();
    private final Vector3f at = new Vector3f();
    private final Quat4f turned = new Quat4f();

    JBulletPeer(SceneDescription scene, PeerSettings settings) {
        this.scene = scene;
        this.settings = settings;
        this.best = settings.tuning() == PeerSettings.Tuning.BEST;
        this.substepSeconds = (float) (scene.stepSeconds() / settings.substeps());
        DefaultCollisionConfiguration configuration = new DefaultCollisionConfiguration();
        dispatcher = new CollisionDispatcher(configuration);
        world =
                new DiscreteDynamicsWorld(
                        dispatcher,
                        new DbvtBroadphase(),
                        new SequentialImpulseConstraintSolver(),
                        configuration);
        world.setGravity(new Vector3f(0, (float) -scene.gravity(), 0));
        ContactSolverInfo solver = world.getSolverInfo();
        if (best) {
            solver.numIterations = BEST_ITERATIONS;
            solver.splitImpulse = true;
            solver.splitImpulsePenetrationThreshold = -BEST_MARGIN;
        }
        solver.numIterations *= settings.iterationFactor();
        double common = Restitutions.common(scene);
        for (SceneDescription.Solid solid : scene.bodies()) {
            add(solid, common);
        }
        scene.links().forEach(this::join);
    }

    private void join(Link link) {
        RigidBody a = bodies.get(link.a());
        RigidBody b = bodies.get(link.b());
        Vector3f p = vector(link.anchorA());
        Vector3f q = vector(link.anchorB());
        TypedConstraint joint =
                switch (link.kind()) {
                    case BALL -> new Point2PointConstraint(a, b, p, q);
                    case HINGE ->
                            new HingeConstraint(
                                    a, b, p, q, vector(link.axisA()), vector(link.axisB()));
                    case ROD -> throw new IllegalArgumentException("JBullet: it has no rods");
                };
        world.addConstraint(joint, true);
    }

    private void add(SceneDescription.Solid solid, double commonRestitution) {
        CollisionShape shape =
                switch (solid.shape()) {
                    case Box box ->
                            new BoxShape(
                                    new Vector3f(
                                            (float) box.halfX(),
                                            (float) box.halfY(),
                                            (float) box.halfZ()));
                    case Sphere sphere -> new SphereShape((float) sphere.radius());
                    case ConvexHull hull -> hulls.computeIfAbsent(hull, this::hull);
                    case Capsule capsule ->
                            new CapsuleShape(
                                    (float) capsule.radius(), (float) (2 * capsule.halfLength()));
                    case Cylinder cylinder ->
                            new CylinderShape(
                                    new Vector3f(
                                            (float) cylinder.radius(),
                                            (float) cylinder.halfHeight(),
                                            (float) cylinder.radius()));
                    case TriangleMesh _, HeightField _ -> mesh(Triangles.of(solid.shape()));
                    default ->
                            throw new IllegalArgumentException(
                                    "JBullet: its adapter has no "
                                            + solid.shape().getClass().getSimpleName());
                };
        Transform start = new Transform();
        start.setIdentity();
        start.setRotation(
                new Quat4f(
                        (float) solid.rotation().x(),
                        (float) solid.rotation().y(),
                        (float) solid.rotation().z(),
                        (float) solid.rotation().w()));
        start.origin.set(vector(solid.centre()));
        RigidBodyConstructionInfo info =
                new RigidBodyConstructionInfo(
                        (float) solid.mass(),
                        new DefaultMotionState(start),
                        shape,
                        new Vector3f(
                                (float) solid.inertia().m00(),
                                (float) solid.inertia().m11(),
                                (float) solid.inertia().m22()));
        info.friction = (float) Math.sqrt(solid.friction());
        info.restitution = (float) Restitutions.factor(solid, commonRestitution);
        info.linearDamping = 0;
        info.angularDamping = 0;
        RigidBody body = new RigidBody(info);
        if (!solid.fixed()) {
            body.setLinearVelocity(vector(solid.velocity()));
            body.setAngularVelocity(vector(solid.angularVelocity()));
            body.setActivationState(CollisionObject.DISABLE_DEACTIVATION);
        }
        world.addRigidBody(body);
        bodies.add(body);
    }

    private ConvexHullShape hull(ConvexHull hull) {
        float[] xyz = SceneDescription.Solid.points(hull);
        ObjectArrayList<Vector3f> points = new ObjectArrayList<>();
        for (int i = 0; i < xyz.length; i += 3) {
            points.add(new Vector3f(xyz[i], xyz[i + 1], xyz[i + 2]));
        }
        ConvexHullShape shape = new ConvexHullShape(points);
        if (best) {
            shape.setMargin(BEST_MARGIN);
        }
        return shape;
    }

    private static BvhTriangleMeshShape mesh(Triangles surface) {
        return new BvhTriangleMeshShape(
                new TriangleIndexVertexArray(
                        surface.count(),
                        surface.indexBuffer(),
                        Triangles.STRIDE,
                        surface.corners(),
                        surface.xyzBuffer(),
                        Triangles.STRIDE),
                true);
    }

    private static Vector3f vector(Vector3dc v) {
        return new Vector3f((float) v.x(), (float) v.y(), (float) v.z());
    }

    @Override
    public void step() {
        for (int n = 0; n < settings.substeps(); n++) {
            for (int f = 0; f < scene.forces().size(); f++) {
                // Cleared by the engine after each step.
                ConstantForce force = scene.forces().get(f);
                bodies.get(force.body())
                        .applyCentralForce(
                                new Vector3f(
                                        (float) force.fx(),
                                        (float) force.fy(),
                                        (float) force.fz()));
            }
            // maxSubSteps 0: one step of exactly this length.
            world.stepSimulation(substepSeconds, 0);
        }
    }

    @Override
    public void readPoses(double[] poses) {
        int o = 0;
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getCenterOfMassPosition(at);
            bodies.get(i).getOrientation(turned);
            poses[o] = at.x;
            poses[o + 1] = at.y;
            poses[o + 2] = at.z;
            poses[o + 3] = turned.x;
            poses[o + 4] = turned.y;
            poses[o + 5] = turned.z;
            poses[o + 6] = turned.w;
            o += POSE_STRIDE;
        }
    }

    @Override
    public void setGravity(double x, double y, double z) {
        // The engine hands its gravity on to the bodies.
        world.setGravity(new Vector3f((float) x, (float) y, (float) z));
    }

    @Override
    public void readVelocities(double[] velocities) {
        for (int i = 0; i < bodies.size(); i++) {
            int o = VELOCITY_STRIDE * i;
            bodies.get(i).getLinearVelocity(at);
            velocities[o] = at.x;
            velocities[o + 1] = at.y;
            velocities[o + 2] = at.z;
            bodies.get(i).getAngularVelocity(at);
            velocities[o + 3] = at.x;
            velocities[o + 4] = at.y;
            velocities[o + 5] = at.z;
        }
    }

    @Override
    public int contactPairs() {
        int pairs = 0;
        for (int m = 0; m < dispatcher.getNumManifolds(); m++) {
            pairs += dispatcher.getManifoldByIndexInternal(m).getNumContacts() > 0 ? 1 : 0;
        }
        return pairs;
    }

    @Override
    public int contactPoints() {
        int points = 0;
        for (int m = 0; m < dispatcher.getNumManifolds(); m++) {
            points += dispatcher.getManifoldByIndexInternal(m).getNumContacts();
        }
        return points;
    }

    @Override
    public List<String> notes() {
        return List.of(
                "10 iterations, ERP and margins as they come; sleeping and damping off",
                "best effort: 50 iterations, split impulse from 1 mm on, margin of hulls 1 mm",
                "frictions of a pair are multiplied by the engine: bodies carry the square root",
                "restitutions are multiplied: bodies carry e or 1, right if one e > 0 per scene",
                "no gyroscopic torque: a body spins with constant angular velocity");
    }

    @Override
    public void close() {
        world.destroy();
    }
}
