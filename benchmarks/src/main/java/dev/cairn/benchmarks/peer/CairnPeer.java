package dev.cairn.benchmarks.peer;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.tuning.Precision;
import dev.cairn.samples.SceneBuilder.ConstantForce;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/** Cairn, built from the description like all others. */
final class CairnPeer implements Peer {
    private final SceneDescription scene;
    private final int collisionsPerTick;
    private final PhysicsWorld world;
    private final List<BodyRef> bodies = new ArrayList<>();
    private final Vector3d at = new Vector3d();
    private final Quaterniond turned = new Quaterniond();

    CairnPeer(SceneDescription scene, PeerSettings settings, Precision precision) {
        this.scene = scene;
        this.collisionsPerTick = settings.collisionsPerTick();
        this.world =
                PhysicsWorld.builder()
                        .gravity(0, -scene.gravity(), 0)
                        .workers(settings.workers())
                        .settings(PhysicsSettings.DEFAULT.withPrecision(precision))
                        .substeps(settings.substeps() / collisionsPerTick)
                        .sleeping(false)
                        .build();
        for (SceneDescription.Solid solid : scene.bodies()) {
            Vector3d shift = solid.rotation().transform(solid.shape().centreOfMass(new Vector3d()));
            Vector3d origin = new Vector3d(solid.centre()).sub(shift);
            Body body = solid.fixed() ? Body.fixed() : Body.dynamic().mass(solid.mass());
            body.shape(solid.shape())
                    .at(origin.x, origin.y, origin.z)
                    .rotation(solid.rotation())
                    .material(new Material(solid.friction(), solid.restitution(), 1000));
            if (!solid.fixed()) {
                body.velocity(solid.velocity().x(), solid.velocity().y(), solid.velocity().z())
                        .angularVelocity(
                                solid.angularVelocity().x(),
                                solid.angularVelocity().y(),
                                solid.angularVelocity().z());
            }
            bodies.add(world.add(body));
        }
        scene.links().forEach(this::join);
    }

    private void join(Link link) {
        BodyRef a = bodies.get(link.a());
        BodyRef b = bodies.get(link.b());
        Joint joint =
                switch (link.kind()) {
                    case BALL -> Joint.ball(a, b);
                    case HINGE -> Joint.hinge(a, b);
                    case ROD -> Joint.rod(a, b).length(link.length());
                };
        Vector3d p = link.startA(scene);
        Vector3d q = link.startB(scene);
        world.add(joint.anchors(p.x, p.y, p.z, q.x, q.y, q.z).axis(link.startAxis(scene)));
    }

    @Override
    public void step() {
        for (int part = 0; part < collisionsPerTick; part++) {
            for (int f = 0; f < scene.forces().size(); f++) {
                ConstantForce force = scene.forces().get(f);
                bodies.get(force.body()).applyForce(force.fx(), force.fy(), force.fz());
            }
            world.step(scene.stepSeconds() / collisionsPerTick);
        }
    }

    @Override
    public void setGravity(double x, double y, double z) {
        world.setGravity(x, y, z);
    }

    @Override
    public void readVelocities(double[] velocities) {
        int o = 0;
        for (int i = 0; i < bodies.size(); i++) {
            BodyRef body = bodies.get(i);
            body.velocity(at);
            velocities[o] = at.x;
            velocities[o + 1] = at.y;
            velocities[o + 2] = at.z;
            body.angularVelocity(at);
            velocities[o + 3] = at.x;
            velocities[o + 4] = at.y;
            velocities[o + 5] = at.z;
            o += VELOCITY_STRIDE;
        }
    }

    @Override
    public void readPoses(double[] poses) {
        int o = 0;
        for (int i = 0; i < bodies.size(); i++) {
            BodyRef body = bodies.get(i);
            body.centreOfMass(at);
            body.orientation(turned);
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
    public int contactPairs() {
        Contacts contacts = world.contacts();
        int pairs = 0;
        for (int c = 0; c < contacts.count(); c++) {
            pairs += contacts.touching(c) ? 1 : 0;
        }
        return pairs;
    }

    @Override
    public int contactPoints() {
        Contacts contacts = world.contacts();
        int points = 0;
        for (int c = 0; c < contacts.count(); c++) {
            points += contacts.touching(c) ? contacts.pointCount(c) : 0;
        }
        return points;
    }

    @Override
    public List<String> notes() {
        return List.of(
                "defaults; one sweep per sub-step, contacts found once a tick; damping 0",
                "best effort is the same",
                "inertia: taken from shape and mass, the source of the description");
    }

    @Override
    public void close() {
        world.close();
    }
}
