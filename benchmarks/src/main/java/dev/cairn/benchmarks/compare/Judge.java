package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Peer;
import dev.cairn.benchmarks.peer.SceneDescription;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.Penetration;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.List;

/**
 * Measures any engine's poses by the scene's own truths.
 *
 * <p>It holds a mirror: the scene as its script built it, in a world that is never stepped. After
 * each tick of the engine the mirror's bodies are put where the engine's bodies are; then the
 * scene's hooks compare them with the closed form, and {@link Penetration} measures the overlaps.
 * Metrics that read forces or velocities see none here and must not be drawn. One thread.
 */
final class Judge implements AutoCloseable {
    private final Case scene;
    private final PhysicsWorld world;
    private final SceneBuilder built;
    private final SceneDescription description;
    private final double[] poses;
    private final Quaterniond turned = new Quaterniond();
    private final Vector3d shift = new Vector3d();
    private final int stride;
    private double deepest;
    private int ticks;

    Judge(Case scene) {
        this.scene = scene;
        this.world = PhysicsWorld.builder().gravity(0, -SampleScene.GRAVITY, 0).workers(1).build();
        this.built = scene.scene().build(new SceneBuilder(world, scene.options()));
        List<BodyRef> bodies = built.bodies();
        this.description = SceneDescription.of(bodies);
        this.poses = new double[Peer.POSE_STRIDE * bodies.size()];
        this.stride = Math.max(1, bodies.size() / 60);
    }

    SceneDescription description() {
        return description;
    }

    /** Takes over the poses after one more tick; returns false if one of them is no number. */
    boolean tick(Peer peer) {
        peer.readPoses(poses);
        built.beforeTick();
        for (int i = 0; i < built.bodies().size(); i++) {
            BodyRef body = built.bodies().get(i);
            if (body.isFixed()) {
                continue;
            }
            int o = Peer.POSE_STRIDE * i;
            turned.set(poses[o + 3], poses[o + 4], poses[o + 5], poses[o + 6]).normalize();
            body.shape().centreOfMass(shift);
            turned.transform(shift);
            double x = poses[o] - shift.x;
            double y = poses[o + 1] - shift.y;
            double z = poses[o + 2] - shift.z;
            if (!Double.isFinite(x + y + z + turned.x + turned.y + turned.z + turned.w)) {
                return false;
            }
            body.teleport(x, y, z, turned);
        }
        built.afterTick();
        ticks++;
        if (ticks % stride == 0 || ticks == scene.ticks()) {
            deepest = Math.max(deepest, Penetration.deepest(built.bodies()));
        }
        return true;
    }

    /** Returns the error that is drawn, NaN if the closed form never applied. */
    double error() {
        Double value = built.errors().get(scene.metric());
        return value == null ? Double.NaN : value;
    }

    double deepest() {
        return deepest;
    }

    @Override
    public void close() {
        world.close();
    }
}
