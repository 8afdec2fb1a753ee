package dev.cairn.benchmarks.peer;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Sphere;

import org.joml.Matrix3dc;
import org.ode4j.math.DQuaternion;
import org.ode4j.math.DQuaternionC;
import org.ode4j.math.DVector3C;
import org.ode4j.ode.DBody;
import org.ode4j.ode.DContact;
import org.ode4j.ode.DContactBuffer;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DJointGroup;
import org.ode4j.ode.DMass;
import org.ode4j.ode.DSpace;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeConstants;
import org.ode4j.ode.OdeHelper;

import java.util.ArrayList;
import java.util.List;

/** ode4j: contacts are made in a callback, as its manual shows, and solved by quickStep. */
final class OdePeer implements Peer {
    private static final int MAX_POINTS = 8;

    private final PeerSettings settings;
    private final double substepSeconds;
    private final DWorld world;
    private final DSpace space;
    private final DJointGroup joints;
    private final SceneDescription scene;
    private final List<DGeom> geoms = new ArrayList<>();
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
        space = OdeHelper.createHashSpace();
        joints = OdeHelper.createJointGroup();
        for (int i = 0; i < scene.bodies().size(); i++) {
            add(scene.bodies().get(i), i);
        }
    }

    private void add(SceneDescription.Solid solid, int index) {
        DGeom geom =
                switch (solid.shape()) {
                    case Box box ->
                            OdeHelper.createBox(
                                    space, 2 * box.halfX(), 2 * box.halfY(), 2 * box.halfZ());
                    case Sphere sphere -> OdeHelper.createSphere(space, sphere.radius());
                    case ConvexHull _ ->
                            throw new IllegalArgumentException(
                                    "ode4j: its convex shapes collide with few others; hulls are"
                                            + " left out");
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
    }

    private void near(DGeom a, DGeom b) {
        DBody bodyA = a.getBody();
        DBody bodyB = b.getBody();
        if (bodyA == null && bodyB == null) {
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
            contact.surface.bounce_vel = 0.1;
            OdeHelper.createContactJoint(world, joints, contact).attach(bodyA, bodyB);
        }
        pairs++;
        points += count;
    }

    @Override
    public void step() {
        for (int n = 0; n < settings.substeps(); n++) {
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
            DQuaternionC q = geom.getQuaternion();
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
