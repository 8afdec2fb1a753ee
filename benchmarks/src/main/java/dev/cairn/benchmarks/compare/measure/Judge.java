package dev.cairn.benchmarks.compare.measure;

import dev.cairn.benchmarks.peer.Peer;
import dev.cairn.benchmarks.peer.SceneDescription;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.overlap.Penetration;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Measures any engine's poses and velocities by the scene's own truths.
 *
 * <p>It holds a mirror: the scene as its script built it, in a world that is never stepped. After
 * each tick of the engine the mirror's bodies are put where the engine's bodies are, and move as
 * they do; then the scene's hooks compare them with the closed form, and {@link Penetration}
 * measures the overlaps of bodies and {@link GroundDepth} those with a ground of triangles. Metrics
 * that read forces or contacts see none here and must not be drawn. One thread.
 */
public final class Judge implements AutoCloseable {
    /** Overlaps of many or of many-sided bodies take long: fewer looks. */
    public static final int BODIES_PER_LOOK = 60;

    /** At the end of the scene: the last quarter counts as rest. */
    private static final double REST = 0.75;

    private final Case scene;
    private final PhysicsWorld world;
    private final SceneBuilder built;
    private final SceneDescription description;
    private final GroundDepth ground;
    private final double[] poses;
    private final double[] velocities;
    private final Quaterniond turned = new Quaterniond();
    private final Quaterniond back = new Quaterniond();
    private final Vector3d shift = new Vector3d();
    private final int stride;
    private double deepest;
    private double deepestAtRest;
    private int ticks;

    public Judge(Case scene) {
        this.scene = scene;
        this.world =
                PhysicsWorld.builder()
                        // never stepped: no vectors, and no word about their absence
                        .settings(PhysicsSettings.DEFAULT.withLanes(1))
                        .sleeping(false)
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .build();
        this.built = scene.scene().build(new SceneBuilder(world, scene.options()));
        List<BodyRef> bodies = built.bodies();
        this.description = SceneDescription.of(built);
        this.ground = new GroundDepth(bodies);
        this.poses = new double[Peer.POSE_STRIDE * bodies.size()];
        this.velocities = new double[Peer.VELOCITY_STRIDE * bodies.size()];
        this.stride = Math.max(1, bodies.size() * scene.lookCost() / BODIES_PER_LOOK);
    }

    public SceneDescription description() {
        return description;
    }

    /** Sets the engine's gravity for the tick to come, if the scene turns it. */
    public static void turnGravity(SceneBuilder built, Peer peer, long tick) {
        double angle = built.gravityAngle(tick);
        if (angle != 0) {
            peer.setGravity(
                    SampleScene.GRAVITY * StrictMath.sin(angle),
                    -SampleScene.GRAVITY * StrictMath.cos(angle),
                    0);
        }
    }

    public SceneBuilder built() {
        return built;
    }

    /** Takes over the poses after one more tick; returns false if one of them is no number. */
    public boolean tick(Peer peer) {
        peer.readPoses(poses);
        peer.readVelocities(velocities);
        built.beforeTick();
        for (int i = 0; i < built.bodies().size(); i++) {
            BodyRef body = built.bodies().get(i);
            if (!body.isFixed() && !place(body, i)) {
                return false;
            }
        }
        built.afterTick();
        ticks++;
        if (ticks % stride == 0 || ticks == scene.ticks()) {
            double depth = Penetration.deepest(built.bodies(), built.world().joints().all());
            depth = Math.max(depth, ground.deepest(built.bodies()));
            deepest = Math.max(deepest, depth);
            if (ticks >= REST * scene.ticks()) {
                deepestAtRest = Math.max(deepestAtRest, depth);
            }
        }
        return true;
    }

    private boolean place(BodyRef body, int i) {
        int o = Peer.POSE_STRIDE * i;
        turned.set(poses[o + 3], poses[o + 4], poses[o + 5], poses[o + 6]).normalize();
        turned.mul(description.bodies().get(i).sceneFromShape().conjugate(back));
        body.shape().centreOfMass(shift);
        turned.transform(shift);
        double x = poses[o] - shift.x;
        double y = poses[o + 1] - shift.y;
        double z = poses[o + 2] - shift.z;
        int v = Peer.VELOCITY_STRIDE * i;
        double sum = x + y + z + turned.x + turned.y + turned.z + turned.w;
        for (int k = 0; k < Peer.VELOCITY_STRIDE; k++) {
            sum += velocities[v + k];
        }
        if (!Double.isFinite(sum)) {
            return false;
        }
        body.teleport(x, y, z, turned);
        body.setVelocity(velocities[v], velocities[v + 1], velocities[v + 2]);
        body.setAngularVelocity(velocities[v + 3], velocities[v + 4], velocities[v + 5]);
        return true;
    }

    /** Returns the error that is drawn, NaN if the closed form never applied. */
    public double error() {
        if (scene.metric().equals(Case.REST_OVERLAP)) {
            return deepestAtRest;
        }
        Double value = built.errors().get(scene.metric());
        return value == null ? Double.NaN : value;
    }

    /** Returns all errors of the scene that are finite. */
    public Map<String, Double> errors() {
        Map<String, Double> finite = new LinkedHashMap<>();
        built.errors()
                .forEach((name, value) -> {
                    if (Double.isFinite(value)) {
                        finite.put(name, value);
                    }
                });
        return finite;
    }

    public double deepest() {
        return deepest;
    }

    @Override
    public void close() {
        world.close();
    }
}
