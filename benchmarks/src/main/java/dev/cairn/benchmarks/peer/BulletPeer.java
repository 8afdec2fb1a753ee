package dev.cairn.benchmarks.peer;

import com.jme3.bullet.PhysicsSpace;
import com.jme3.bullet.SolverInfo;
import com.jme3.bullet.SolverMode;
import com.jme3.bullet.collision.PersistentManifolds;
import com.jme3.bullet.collision.shapes.BoxCollisionShape;
import com.jme3.bullet.collision.shapes.CapsuleCollisionShape;
import com.jme3.bullet.collision.shapes.CollisionShape;
import com.jme3.bullet.collision.shapes.CylinderCollisionShape;
import com.jme3.bullet.collision.shapes.HullCollisionShape;
import com.jme3.bullet.collision.shapes.MeshCollisionShape;
import com.jme3.bullet.collision.shapes.SphereCollisionShape;
import com.jme3.bullet.collision.shapes.infos.IndexedMesh;
import com.jme3.bullet.joints.Constraint;
import com.jme3.bullet.joints.HingeJoint;
import com.jme3.bullet.joints.PhysicsJoint;
import com.jme3.bullet.joints.Point2PointJoint;
import com.jme3.bullet.objects.PhysicsRigidBody;
import com.jme3.bullet.util.NativeLibrary;
import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;
import com.simsilica.mathd.Quatd;
import com.simsilica.mathd.Vec3d;

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
import java.util.logging.Level;
import java.util.logging.Logger;

/** Bullet by way of Libbulletjme. */
final class BulletPeer implements Peer {
    /** Kept, or its level would be lost with it. */
    private static final Logger QUIET = Logger.getLogger("com.jme3.bullet");

    private static boolean ready;

    private static final int BEST_ITERATIONS = 50;
    private static final float BEST_MARGIN = 1e-3f;
    private static final int Y_AXIS = 1;

    private final SceneDescription scene;
    private final PeerSettings settings;
    private final boolean best;
    private final float substepSeconds;
    private final PhysicsSpace space;
    private final List<PhysicsRigidBody> bodies = new ArrayList<>();
    private final IdentityHashMap<ConvexHull, HullCollisionShape> hulls = new IdentityHashMap<>();
    private final Vec3d at = new Vec3d();
    private final Quatd turned = new Quatd();

    BulletPeer(SceneDescription scene, PeerSettings settings) {
        this.scene = scene;
        this.settings = settings;
        this.best = settings.tuning() == PeerSettings.Tuning.BEST;
        this.substepSeconds = (float) (scene.stepSeconds() / settings.substeps());
        prepare();
        space = new PhysicsSpace(PhysicsSpace.BroadphaseType.DBVT);
        space.setGravity(new Vector3f(0, (float) -scene.gravity(), 0));
        SolverInfo solver = space.getSolverInfo();
        if (best) {
            solver.setNumIterations(BEST_ITERATIONS);
            solver.setSplitImpulseEnabled(true);
            solver.setSplitImpulseThreshold(-BEST_MARGIN);
            solver.setMode(solver.mode() | SolverMode.Use2Directions);
        }
        solver.setNumIterations(settings.iterationFactor() * solver.numIterations());
        double common = Restitutions.common(scene);
        for (SceneDescription.Solid solid : scene.bodies()) {
            add(solid, common);
        }
        scene.links().forEach(this::join);
    }

    private void join(Link link) {
        PhysicsRigidBody a = bodies.get(link.a());
        PhysicsRigidBody b = bodies.get(link.b());
        Vector3f p = vector(link.anchorA());
        Vector3f q = vector(link.anchorB());
        Constraint joint =
                switch (link.kind()) {
                    case BALL -> new Point2PointJoint(a, b, p, q);
                    case HINGE ->
                            new HingeJoint(a, b, p, q, vector(link.axisA()), vector(link.axisB()));
                    case ROD -> throw new IllegalArgumentException("Bullet: it has no rods");
                };
        joint.setCollisionBetweenLinkedBodies(false);
        space.addJoint(joint);
    }

    static void prepare() {
        if (ready) {
            return;
        }
        QUIET.setLevel(Level.OFF);
        String arch = System.getProperty("os.arch", "");
        String folder = arch.equals("aarch64") || arch.equals("arm64") ? "arm64" : "x86_64";
        String file =
                switch (Natives.system()) {
                    case "windows" -> "bulletjme.dll";
                    case "osx" -> "libbulletjme.dylib";
                    default -> "libbulletjme.so";
                };
        Natives.load(
                Engine.BULLET,
                List.of("native/%s/%s/%s".formatted(Natives.system(), folder, file)));
        NativeLibrary.setStartupMessageEnabled(false);
        ready = true;
    }

    private void add(SceneDescription.Solid solid, double commonRestitution) {
        CollisionShape shape =
                switch (solid.shape()) {
                    case Box box ->
                            new BoxCollisionShape(
                                    (float) box.halfX(), (float) box.halfY(), (float) box.halfZ());
                    case Sphere sphere -> new SphereCollisionShape((float) sphere.radius());
                    case Capsule capsule ->
                            new CapsuleCollisionShape(
                                    (float) capsule.radius(),
                                    (float) (2 * capsule.halfLength()),
                                    Y_AXIS);
                    case Cylinder cylinder ->
                            new CylinderCollisionShape(
                                    (float) cylinder.radius(),
                                    (float) (2 * cylinder.halfHeight()),
                                    Y_AXIS);
                    case ConvexHull hull ->
                            hulls.computeIfAbsent(
                                    hull,
                                    _ ->
                                            new HullCollisionShape(
                                                    SceneDescription.Solid.points(hull)));
                    case TriangleMesh _, HeightField _ -> mesh(Triangles.of(solid.shape()));
                    default ->
                            throw new IllegalArgumentException(
                                    "Bullet: its adapter has no "
                                            + solid.shape().getClass().getSimpleName());
                };
        if (best && (shape instanceof HullCollisionShape || shape instanceof MeshCollisionShape)) {
            shape.setMargin(BEST_MARGIN);
        }
        PhysicsRigidBody body = new PhysicsRigidBody(shape, (float) solid.mass());
        body.setPhysicsLocation(vector(solid.centre()));
        body.setPhysicsRotation(
                new Quaternion(
                        (float) solid.rotation().x(),
                        (float) solid.rotation().y(),
                        (float) solid.rotation().z(),
                        (float) solid.rotation().w()));
        body.setFriction((float) Math.sqrt(solid.friction()));
        body.setRestitution((float) Restitutions.factor(solid, commonRestitution));
        if (!solid.fixed()) {
            body.setInverseInertiaLocal(
                    new Vector3f(
                            (float) (1 / solid.inertia().m00()),
                            (float) (1 / solid.inertia().m11()),
                            (float) (1 / solid.inertia().m22())));
            Vector3f inverse = body.getInverseInertiaLocal(new Vector3f());
            ReadBack.inertia(Engine.BULLET, solid, 1 / inverse.x, 1 / inverse.y, 1 / inverse.z);
            body.setDamping(0, 0);
            body.setEnableSleep(false);
            body.setLinearVelocity(vector(solid.velocity()));
            body.setAngularVelocity(vector(solid.angularVelocity()));
        }
        space.addCollisionObject(body);
        bodies.add(body);
    }

    /** With compression of its tree, as its documentation's examples have it. */
    private static MeshCollisionShape mesh(Triangles surface) {
        return new MeshCollisionShape(
                true,
                new IndexedMesh(
                        surface.xyzBuffer().asFloatBuffer(), surface.indexBuffer().asIntBuffer()));
    }

    private static Vector3f vector(Vector3dc v) {
        return new Vector3f((float) v.x(), (float) v.y(), (float) v.z());
    }

    @Override
    public void step() {
        for (int n = 0; n < settings.substeps(); n++) {
            for (int f = 0; f < scene.forces().size(); f++) {
                // Cleared by the engine after each update.
                ConstantForce force = scene.forces().get(f);
                bodies.get(force.body())
                        .applyCentralForce(
                                new Vector3f(
                                        (float) force.fx(),
                                        (float) force.fy(),
                                        (float) force.fz()));
            }
            // maxSubSteps 0: one step of exactly this length, no listeners.
            space.update(substepSeconds, 0, false, false, false);
        }
    }

    @Override
    public void readPoses(double[] poses) {
        int o = 0;
        for (int i = 0; i < bodies.size(); i++) {
            PhysicsRigidBody body = bodies.get(i);
            body.getPhysicsLocationDp(at);
            body.getPhysicsRotationDp(turned);
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
        Vector3f gravity = new Vector3f((float) x, (float) y, (float) z);
        space.setGravity(gravity);
        // The engine copies gravity into a body when the body is added.
        for (PhysicsRigidBody body : bodies) {
            if (body.getMass() > 0) {
                body.setGravity(gravity);
            }
        }
    }

    @Override
    public void readVelocities(double[] velocities) {
        for (int i = 0; i < bodies.size(); i++) {
            if (scene.bodies().get(i).fixed()) {
                continue;
            }
            int o = VELOCITY_STRIDE * i;
            bodies.get(i).getLinearVelocityDp(at);
            velocities[o] = at.x;
            velocities[o + 1] = at.y;
            velocities[o + 2] = at.z;
            bodies.get(i).getAngularVelocityDp(at);
            velocities[o + 3] = at.x;
            velocities[o + 4] = at.y;
            velocities[o + 5] = at.z;
        }
    }

    @Override
    public int contactPairs() {
        int pairs = 0;
        for (long manifold : space.listManifoldIds()) {
            pairs += PersistentManifolds.countPoints(manifold) > 0 ? 1 : 0;
        }
        return pairs;
    }

    @Override
    public int contactPoints() {
        int points = 0;
        for (long manifold : space.listManifoldIds()) {
            points += PersistentManifolds.countPoints(manifold);
        }
        return points;
    }

    @Override
    public List<String> notes() {
        return List.of(
                "10 iterations, ERP and margins (4 cm: inside boxes and cylinders, around hulls and"
                        + " triangles) as they come",
                "best effort: 50 iterations, split impulse from 1 mm on, two friction directions,"
                        + " margin of hulls and triangles 1 mm",
                "sleeping and damping off",
                "frictions of a pair are multiplied by the engine: bodies carry the square root",
                "restitutions are multiplied: bodies carry e or 1, right if one e > 0 per scene",
                "one thread: the multithreaded build is a library of its own, left out");
    }

    @Override
    public void close() {
        for (PhysicsJoint joint : space.getJointList()) {
            space.removeJoint(joint);
        }
        for (PhysicsRigidBody body : bodies) {
            space.removeCollisionObject(body);
        }
        bodies.clear();
        space.destroy();
    }
}
