package dev.cairn.samples.fuzz;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.LookSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneLoader;
import dev.cairn.samples.scenefile.Xyz;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * A world to be tried: a scene, and what a scene file does not say. Immutable.
 *
 * @param seed of the generator
 * @param index of the world
 * @param family what it was drawn from
 * @param scene what is in it; sub-steps and number of ticks are those of its run
 * @param pace how long its ticks are
 * @param sleeping whether bodies may sleep
 * @param room half the inner width of the closed room around it, from 0 to twice that above the
 *     floor, m; infinite if there is none
 * @param floor half the width of the floor: what rolls off it is not held, m
 */
public record FuzzWorld(
        long seed,
        long index,
        Family family,
        SceneFile scene,
        Pace pace,
        boolean sleeping,
        double room,
        double floor) {
    private static final LookSpec UNSEEN = new LookSpec(false, null, null, 0, null, Xyz.ONE);

    /** Whether nothing fixed is there and nothing pulls. */
    public boolean isFree() {
        return scene.gravity().equals(Xyz.ZERO)
                && scene.entities().stream().allMatch(e -> e.body() == BodyKind.DYNAMIC);
    }

    /** How many bodies move. */
    public int movers() {
        return (int) scene.entities().stream().filter(e -> e.body() == BodyKind.DYNAMIC).count();
    }

    /**
     * The same with another scene.
     *
     * @param value the scene
     * @return a copy
     */
    public FuzzWorld withScene(SceneFile value) {
        return new FuzzWorld(seed, index, family, value, pace, sleeping, room, floor);
    }

    /**
     * The same with ticks of another length.
     *
     * @param value the pace
     * @return a copy
     */
    public FuzzWorld withPace(Pace value) {
        return new FuzzWorld(seed, index, family, scene, value, sleeping, room, floor);
    }

    /**
     * The same for another number of ticks.
     *
     * @param ticks at least 1
     * @param substeps 1 to 64
     * @return a copy
     */
    public FuzzWorld lasting(int ticks, int substeps) {
        return withScene(
                scene.withTick(
                        new SceneFile.TickSpec(
                                scene.tick().seconds(), substeps, ticks, Math.min(ticks, 1))));
    }

    /** The lengths of its ticks, s. */
    public double[] tickSeconds() {
        return pace.seconds(scene.tick().seconds(), scene.tick().ticks(), seed + index);
    }

    /**
     * The settings of its run.
     *
     * @param lanes rows at once, 1, 4, 8 or 16
     * @return the defaults but for sub-steps, sleep and lanes
     */
    public PhysicsSettings settings(int lanes) {
        return PhysicsSettings.DEFAULT
                .withSubsteps(scene.tick().substeps())
                .withSleeping(sleeping)
                .withLanes(lanes);
    }

    /** Whether something moves that nothing stops, and so gives energy. */
    public boolean isDriven() {
        return scene.entities().stream().anyMatch(e -> e.body() == BodyKind.KINEMATIC);
    }

    /**
     * Builds the world.
     *
     * @param workers threads
     * @param settings see {@link #settings}
     * @param bodies receives its bodies, in the order of the scene
     * @return a world, to be closed
     */
    public PhysicsWorld build(int workers, PhysicsSettings settings, List<BodyRef> bodies) {
        PhysicsWorld world = PhysicsWorld.builder().workers(workers).settings(settings).build();
        SceneFile unseen =
                scene.withEntities(scene.entities().stream().map(e -> e.withLook(UNSEEN)).toList());
        SceneBuilder builder = new SceneBuilder(world, new SceneOptions(Map.of(), 1, null));
        SceneLoader.build(unseen, Path.of(""), builder);
        bodies.addAll(builder.bodies());
        return world;
    }

    /** The scene without one entity and its joints. */
    FuzzWorld without(int entity) {
        List<EntitySpec> rest = new ArrayList<>(scene.entities());
        rest.remove(entity);
        List<JointSpec> joints = new ArrayList<>();
        for (JointSpec joint : scene.joints()) {
            if (joint.a() != entity && joint.b() != entity) {
                joints.add(
                        joint.between(
                                joint.a() - (joint.a() > entity ? 1 : 0),
                                joint.b() - (joint.b() > entity ? 1 : 0)));
            }
        }
        return withScene(scene.withJoints(List.of()).withEntities(rest).withJoints(joints));
    }

    /** The scene without one joint. */
    FuzzWorld withoutJoint(int joint) {
        List<JointSpec> rest = new ArrayList<>(scene.joints());
        rest.remove(joint);
        return withScene(scene.withJoints(rest));
    }

    /** The scene with another entity in the place of one. */
    FuzzWorld with(int entity, EntitySpec other) {
        List<EntitySpec> all = new ArrayList<>(scene.entities());
        all.set(entity, other);
        return withScene(scene.withEntities(all));
    }
}
