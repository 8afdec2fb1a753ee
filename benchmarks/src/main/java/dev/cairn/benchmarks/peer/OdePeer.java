package dev.cairn.benchmarks.peer;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.samples.SceneBuilder.ConstantForce;

import org.joml.Matrix3dc;
import org.joml.Vector3d;
import org.ode4j.math.DQuaternion;
import org.ode4j.math.DQuaternionC;
import org.ode4j.math.DVector3C;
import org.ode4j.ode.DBallJoint;
import org.ode4j.ode.DBody;
import org.ode4j.ode.DContact;
import org.ode4j.ode.DContactBuffer;
import org.ode4j.ode.DDoubleBallJoint;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DHingeJoint;
import org.ode4j.ode.DJointGroup;
import org.ode4j.ode.DMass;
import org.ode4j.ode.DSpace;
import org.ode4j.ode.DTriMeshData;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeConstants;
import org.ode4j.ode.OdeHelper;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** ode4j: contacts are made in a callback, as its manual shows, and solved by quickStep. */
final class OdePeer implements Peer {
    private static final int MAX_POINTS = 8;

    /** Capsules and cylinders lie along z there, along y here: -90 degrees about x. */
    private static final DQuaternion UPRIGHT =
            new DQuaternion(Math.sqrt(0.5), -Math.sqrt(0.5), 0, 0);

    private static final int BEST_ITERATIONS = 100;
    private static final double BEST_BOUNCE_SPEED = 0.01;

    private final PeerSettings settings;
    private final double bounceSpeed;
    private final double substepSeconds;
    private final DWorld world;
    private final DSpace space;
    private final DJointGroup joints;
    private final SceneDescription scene;
    private final List<DGeom> geoms = new ArrayList<>();

    /** Bodies with a joint between them, which do not collide. */
    private final Set<Long> linked = new HashSet<>();

    private final DContactBuffer buffer = new DContactBuffer(MAX_POINTS);
    private int pairs;
    private int points;

    OdePeer(SceneDescription scene, PeerSettings settings) {
        this.scene = scene;
        this.settings = settings;
        this.substepSeconds = scene.stepSeconds() / settings.substeps();
        OdeHelper.initODE2(0);
        world = OdeHelper.createWorld();
        world.setGravity(0, -scene.gravity(), 0);
        world.setAutoDisableFlag(false);
        world.setDamping(0, 0);
        boolean best = settings.tuning() == PeerSettings.Tuning.BEST;
        bounceSpeed = best ? BEST_BOUNCE_SPEED : 0.1;
        int iterations = best ? BEST_ITERATIONS : world.getQuickStepNumIterations();
        world.setQuickStepNumIterations(settings.iterationFactor() * iterations);
        space = OdeHelper.createHashSpace();
        joints = OdeHelper.createJointGroup();
        for (int i = 0; i < scene.bodies().size(); i++) {
            add(scene.bodies().get(i), i);
        }
        scene.links().forEach(this::join);
    }

    private void join(Link link) {
        DBody a = geoms.get(link.a()).getBody();
        DBody b = geoms.get(link.b()).getBody();
        Vector3d p = link.startA(scene);
        Vector3d q = link.startB(scene);
        switch (link.kind()) {
            case BALL -> {
                DBallJoint joint = OdeHelper.createBallJoint(world);
                joint.attach(a, b);
                joint.setAnchor(p.x, p.y, p.z);
            }
            case HINGE -> {
                Vector3d axis = link.startAxis(scene);
                DHingeJoint joint = OdeHelper.createHingeJoint(world);
                joint.attach(a, b);
                joint.setAnchor(p.x, p.y, p.z);
                joint.setAxis(axis.x, axis.y, axis.z);
            }
            case ROD -> {
                DDoubleBallJoint joint = OdeHelper.createDBallJoint(world);
                joint.attach(a, b);
                joint.setAnchor1(p.x, p.y, p.z);
                joint.setAnchor2(q.x, q.y, q.z);
                joint.setDistance(link.length());
            }
        }
        linked.add(pair(link.a(), link.b()));
    }

    private static long pair(int i, int j) {
        return (long) Math.max(i, j) << 32 | Math.min(i, j);
    }

    private void add(SceneDescription.Solid solid, int index) {
        DGeom geom =
                switch (solid.shape()) {
                    case Box box ->
                            OdeHelper.createBox(
                                    space, 2 * box.halfX(), 2 * box.halfY(), 2 * box.halfZ());
                    case Sphere sphere -> OdeHelper.createSphere(space, sphere.radius());
                    case Capsule capsule ->
                            OdeHelper.createCapsule(
                                    space, capsule.radius(), 2 * capsule.halfLength());
                    case Cylinder cylinder ->
                            OdeHelper.createCylinder(
                                    space, cylinder.radius(), 2 * cylinder.halfHeight());
                    case ConvexHull hull -> convex(hull);
                    case TriangleMesh _, HeightField _ -> mesh(Triangles.of(solid.shape()));
                    default ->
                            throw new IllegalArgumentException(
                                    "ode4j: its adapter has no "
                                            + solid.shape().getClass().getSimpleName());
                };
        DQuaternion q =
                new DQuaternion(
                        solid.rotation().w(),
                        solid.rotation().x(),
                        solid.rotation().y(),
                        solid.rotation().z());
        geom.setData(index);
        geoms.add(geom);
        if (solid.fixed()) {
            geom.setPosition(solid.centre().x(), solid.centre().y(), solid.centre().z());
            geom.setQuaternion(q);
            if (solid.shape() instanceof Capsule || solid.shape() instanceof Cylinder) {
                throw new IllegalArgumentException(
                        "ode4j: its adapter has no fixed "
                                + solid.shape().getClass().getSimpleName());
            }
            return;
        }
        DBody body = OdeHelper.createBody(world);
        Matrix3dc i = solid.inertia();
        DMass mass = OdeHelper.createMass();
        mass.setParameters(
                solid.mass(), 0, 0, 0, i.m00(), i.m11(), i.m22(), i.m01(), i.m02(), i.m12());
        body.setMass(mass);
        body.setPosition(solid.centre().x(), solid.centre().y(), solid.centre().z());
        body.setQuaternion(q);
        body.setLinearVel(solid.velocity().x(), solid.velocity().y(), solid.velocity().z());
        body.setAngularVel(
                solid.angularVelocity().x(),
                solid.angularVelocity().y(),
                solid.angularVelocity().z());
        geom.setBody(body);
        if (solid.shape() instanceof Capsule || solid.shape() instanceof Cylinder) {
            geom.setOffsetQuaternion(UPRIGHT);
        }
    }

    private DGeom mesh(Triangles surface) {
        DTriMeshData data = OdeHelper.createTriMeshData();
        data.build(surface.xyz(), surface.indices());
        // What it needs to collide convex geoms with triangles.
        data.preprocess2(1 << DTriMeshData.dTRIDATAPREPROCESS_BUILD.FACE_ANGLES, null);
        return OdeHelper.createTriMesh(space, data);
    }

    /** Planes (normal, offset), points, and polygons as lists led by their length. */
    private DGeom convex(ConvexHull hull) {
        double[] points = hull.vertices().clone();
        int[][] loops = hull.faceLoops();
        double[] planes = new double[4 * loops.length];
        int words = 0;
        for (int[] loop : loops) {
            words += 1 + loop.length;
        }
        int[] polygons = new int[words];
        int at = 0;
        Vector3d a = new Vector3d();
        Vector3d b = new Vector3d();
        for (int f = 0; f < loops.length; f++) {
            int[] loop = loops[f];
            polygons[at++] = loop.length;
            // Newell's normal: exact for a plane polygon, kind to a nearly plane one.
            Vector3d normal = new Vector3d();
            for (int i = 0; i < loop.length; i++) {
                polygons[at++] = loop[i];
                a.set(points, 3 * loop[i]);
                b.set(points, 3 * loop[(i + 1) % loop.length]);
                normal.add(a.cross(b));
            }
            normal.normalize();
            planes[4 * f] = normal.x;
            planes[4 * f + 1] = normal.y;
            planes[4 * f + 2] = normal.z;
            planes[4 * f + 3] = normal.dot(a.set(points, 3 * loop[0]));
        }
        return OdeHelper.createConvex(
                space, planes, loops.length, points, points.length / 3, polygons);
    }

    private void near(DGeom a, DGeom b) {
        DBody bodyA = a.getBody();
        DBody bodyB = b.getBody();
        if (bodyA == null && bodyB == null) {
            return;
        }
        if (!linked.isEmpty()
                && linked.contains(pair((Integer) a.getData(), (Integer) b.getData()))) {
            return;
        }
        int count = OdeHelper.collide(a, b, MAX_POINTS, buffer.getGeomBuffer());
        if (count == 0) {
            return;
        }
        SceneDescription.Solid solidA = scene.bodies().get((Integer) a.getData());
        SceneDescription.Solid solidB = scene.bodies().get((Integer) b.getData());
        double friction = Math.sqrt(solidA.friction() * solidB.friction());
        double bounce = Math.max(solidA.restitution(), solidB.restitution());
        for (int p = 0; p < count; p++) {
            DContact contact = buffer.get(p);
            contact.surface.mode =
                    OdeConstants.dContactApprox1 | (bounce > 0 ? OdeConstants.dContactBounce : 0);
            contact.surface.mu = friction;
            contact.surface.bounce = bounce;
            contact.surface.bounce_vel = bounceSpeed;
            OdeHelper.createContactJoint(world, joints, contact).attach(bodyA, bodyB);
        }
        pairs++;
        points += count;
    }

    @Override
    public void step() {
        for (int n = 0; n < settings.substeps(); n++) {
            for (int f = 0; f < scene.forces().size(); f++) {
                // Cleared by the engine after each step.
                ConstantForce force = scene.forces().get(f);
                geoms.get(force.body()).getBody().addForce(force.fx(), force.fy(), force.fz());
            }
            pairs = 0;
            points = 0;
            space.collide(null, (data, a, b) -> near(a, b));
            world.quickStep(substepSeconds);
            joints.empty();
        }
    }

    @Override
    public void readPoses(double[] poses) {
        int o = 0;
        for (int i = 0; i < geoms.size(); i++) {
            DGeom geom = geoms.get(i);
            DVector3C at = geom.getPosition();
            // the body's, for round shapes are turned against it
            DBody body = geom.getBody();
            DQuaternionC q = body == null ? geom.getQuaternion() : body.getQuaternion();
            poses[o] = at.get0();
            poses[o + 1] = at.get1();
            poses[o + 2] = at.get2();
            poses[o + 3] = q.get1();
            poses[o + 4] = q.get2();
            poses[o + 5] = q.get3();
            poses[o + 6] = q.get0();
            o += POSE_STRIDE;
        }
    }

    @Override
    public void setGravity(double x, double y, double z) {
        world.setGravity(x, y, z);
    }

    @Override
    public void readVelocities(double[] velocities) {
        for (int i = 0; i < geoms.size(); i++) {
            DBody body = geoms.get(i).getBody();
            if (body == null) {
                continue;
            }
            int o = VELOCITY_STRIDE * i;
            DVector3C v = body.getLinearVel();
            velocities[o] = v.get0();
            velocities[o + 1] = v.get1();
            velocities[o + 2] = v.get2();
            DVector3C w = body.getAngularVel();
            velocities[o + 3] = w.get0();
            velocities[o + 4] = w.get1();
            velocities[o + 5] = w.get2();
        }
    }

    @Override
    public int contactPairs() {
        return pairs;
    }

    @Override
    public int contactPoints() {
        return points;
    }

    @Override
    public List<String> notes() {
        return List.of(
                "quickStep with its default of 20 iterations; ERP and CFM as they come",
                "best effort: 100 iterations, bounce above 0.01 m/s",
                "friction as pyramid (dContactApprox1); pairs mixed by the callback as described",
                "auto-disable and damping off; up to 8 points per pair; bounce above 0.1 m/s");
    }

    @Override
    public void close() {
        joints.destroy();
        space.destroy();
        world.destroy();
    }
}
