package dev.cairn.samples.replay;

import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.hand.Hand;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.input.Control;
import dev.cairn.render.input.Drive;
import dev.cairn.render.mesh.Model;
import dev.cairn.samples.Palette;
import dev.cairn.samples.SceneBuilder;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.function.BiConsumer;

/**
 * Does to the world of a scene what was done to it: its hooks run, a hand pulls, balls fly, keys
 * drive. Simulation thread, between steps.
 */
public final class Player implements BiConsumer<PhysicsWorld, Act> {
    private final SceneBuilder scene;
    private @Nullable Hand hand;

    /**
     * For one run of a scene.
     *
     * @param scene as it was built, at the tick that the run begins with
     */
    public Player(SceneBuilder scene) {
        this.scene = scene;
    }

    @Override
    public void accept(PhysicsWorld world, Act act) {
        List<Double> n = act.numbers();
        switch (act.what()) {
            case BEFORE -> scene.beforeTick();
            case AFTER -> scene.afterTick();
            case GRAB -> grab(world, act);
            case PULL -> pull(n.get(0), n.get(1), n.get(2));
            case RELEASE -> release();
            case THROW -> throwBall(world, n);
            case BLAST -> blast(world, n);
            case PUSH, TURN, KICK -> drive(world, act);
            case SUBSTEPS -> world.setSubsteps((int) (double) n.get(0));
        }
    }

    private void drive(PhysicsWorld world, Act act) {
        List<Double> n = act.numbers();
        if (world.ecs().isAlive(act.entity())) {
            new Drive(world)
                    .apply(
                            act.entity(),
                            Control.Effect.valueOf(act.what().name()),
                            n.get(0),
                            n.get(1),
                            n.get(2),
                            n.get(3));
        }
    }

    private void grab(PhysicsWorld world, Act act) {
        release();
        BodyRef body = world.bodyOf(act.entity());
        if (body != null) {
            List<Double> n = act.numbers();
            Hand taken = new Hand(world);
            taken.grab(body, new Vector3d(n.get(0), n.get(1), n.get(2)));
            hand = taken;
        }
    }

    private void pull(double x, double y, double z) {
        Hand taken = hand;
        if (taken != null && taken.isHolding()) {
            taken.pull(x, y, z);
        } else {
            release();
        }
    }

    private void release() {
        if (hand != null) {
            hand.release();
            hand = null;
        }
    }

    /**
     * Throws a ball.
     *
     * @param world where
     * @param n the numbers of {@link Act.What#THROW}
     */
    public static void throwBall(PhysicsWorld world, List<Double> n) {
        Sphere shape = Sphere.of(n.get(6));
        BodyRef ball =
                world.add(
                        Body.dynamic()
                                .shape(shape)
                                .at(n.get(0), n.get(1), n.get(2))
                                .velocity(n.get(3), n.get(4), n.get(5))
                                .material(
                                        Material.DEFAULT.withDensity(n.get(7)).withRestitution(0.5))
                                .name("ball " + (long) (double) n.get(8)));
        Model look = Model.of(shape).color(Palette.BASKETBALL);
        world.ecs().add(ball.entity(), new Visual(look));
    }

    /**
     * An explosion: each dynamic body whose centre of mass is within the radius gets the speed,
     * less with the distance, away from the middle. No body shields another.
     *
     * @param world where
     * @param n the numbers of {@link Act.What#BLAST}
     */
    public static void blast(PhysicsWorld world, List<Double> n) {
        double radius = n.get(3);
        Vector3d arm = new Vector3d();
        for (BodyRef body : world.bodies()) {
            double distance = body.position(arm).sub(n.get(0), n.get(1), n.get(2)).length();
            if (body.type() == BodyType.DYNAMIC && distance < radius) {
                if (distance == 0) {
                    arm.set(0, 1, 0);
                } else {
                    arm.div(distance);
                }
                arm.mul(body.mass() * n.get(4) * (1 - distance / radius));
                body.applyImpulse(arm.x, arm.y, arm.z);
            }
        }
    }
}
