package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * A tick goes where sixteen ticks of a sixteenth of its length go: from each moment of a random
 * body's way on a plane, the velocities at the end of one are compared with those of the other.
 * Velocities are in those that gravity gives on a way of the body's size.
 */
class OneTickTest {
    private static final int FINE = 16;
    private static final int TICKS = 60;
    private static final double GRAVITY = 9.81;

    /**
     * It was 0.0077 when friction acted in the middle of points that had not touched, and a blow
     * was taken for a load that goes on.
     */
    @Tag("compiled")
    @Test
    void onAverageItIsRightToLessThanAHundredth() {
        double sum = 0;
        int ticks = 0;
        for (int seed : new int[] {6, 11}) {
            for (int k = 0; k < 150; k++) {
                if (new RandomStart(random(seed, k)).isOneShape()) {
                    for (double error : errors(seed, k, TICKS)) {
                        sum += Math.min(1, error);
                        ticks++;
                    }
                }
            }
        }
        System.out.println(ticks + " ticks, mean error " + sum / ticks);
        assertTrue(sum / ticks < 0.0068, "mean error " + sum / ticks);
    }

    /** The friction of a capsule that lands on one end was in its middle: 1.4. */
    @Tag("compiled")
    @Test
    void whatLandsOnOneEndHasItsFrictionThere() {
        below(0.1, 6, 17, 14);
    }

    /** A rock's corner that struck was moved by the mean of velocities before and after: 1.0. */
    @Tag("compiled")
    @Test
    void whatIsStruckWithinASubStepMovesByBothVelocities() {
        below(0.1, 6, 59, 18);
    }

    /** The blow to a cube's corner went on pressing until the next corner landed: 1.8. */
    @Tag("compiled")
    @Test
    void aBlowIsNoLoadThatGoesOn() {
        below(0.1, 6, 139, 7);
    }

    private static void below(double bound, int seed, int k, int tick) {
        double error = errors(seed, k, tick + 1)[tick];
        System.out.println("seed " + seed + ", world " + k + ", tick " + tick + ": " + error);
        assertEquals(0, error, bound);
    }

    private static SplittableRandom random(int seed, int k) {
        return new SplittableRandom(1000L * seed + k);
    }

    private static double[] errors(int seed, int k, int ticks) {
        SplittableRandom random = random(seed, k);
        RandomStart start = new RandomStart(random);
        random.nextInt(3);
        random.nextInt(120);
        Material surface = new Material(random.nextDouble(), 0, 1000);
        double fast = Math.sqrt(GRAVITY * start.size);
        double[] errors = new double[ticks];
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(PhysicsSettings.DEFAULT.withLanes(1))
                        .sleeping(false)
                        .workers(1)
                        .gravity(0, -GRAVITY, 0)
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()).material(surface));
            BodyRef body = world.add(start.body(1, 1, 1000, new Vector3d(), false));
            for (int tick = 0; tick < ticks; tick++) {
                WorldState before = world.save();
                for (int i = 0; i < FINE; i++) {
                    world.step(Scenes.STEP / FINE);
                }
                Vector3d velocity = body.velocity();
                Vector3d spin = body.angularVelocity();
                world.restore(before);
                world.step(Scenes.STEP);
                errors[tick] =
                        (body.velocity().sub(velocity).length()
                                        + start.size * body.angularVelocity().sub(spin).length())
                                / fast;
            }
        }
        return errors;
    }
}
