package dev.cairn.samples.time;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.time.Ensemble;

import java.util.List;
import java.util.Locale;

/**
 * A billiard shot that is aimed by trying it out: the cue ball shall send the red one by the
 * cushion into the corner. Each of many directions is played to its end in a fork of the world, on
 * all workers; the best one is then played in the world itself, and comes out as it did in its
 * fork, to the bit.
 */
public final class AimedShot {
    private static final double RADIUS = 0.0286;
    private static final double HALF_LENGTH = 1.27;
    private static final double HALF_WIDTH = 0.635;
    private static final double SPEED = 4;
    private static final int TICKS = 240;
    private static final Material BALL = new Material(0.06, 0.94, 1700, 0.0002);
    private static final Material CUSHION = new Material(0.2, 0.8, 1000);

    /**
     * A shot and what came of it.
     *
     * @param number of the direction
     * @param miss least distance of the red ball from the corner, m
     * @param digest of the world at the end
     */
    public record Shot(int number, double miss, long digest) {}

    private AimedShot() {}

    /**
     * Aims and prints how well.
     *
     * @param arguments how many directions are tried; 1000 if left out
     */
    public static void main(String[] arguments) {
        int directions = arguments.length == 0 ? 1000 : Integer.parseInt(arguments[0]);
        try (PhysicsWorld table = table(Runtime.getRuntime().availableProcessors())) {
            Shot best = aim(table, directions);
            Shot real = play(table, best.number, directions);
            System.out.printf(
                    Locale.ROOT,
                    "of %d directions number %d brings the red ball within %.1f mm of the corner;"
                            + " played: %.1f mm, %s%n",
                    directions,
                    best.number,
                    1000 * best.miss,
                    1000 * real.miss,
                    best.equals(real) ? "the same bits" : "OTHER bits");
        }
    }

    /**
     * Tries all directions, and leaves the table as it is.
     *
     * @param table in its first state
     * @param directions how many
     * @return the best shot; the first of equals
     */
    public static Shot aim(PhysicsWorld table, int directions) {
        List<Shot> shots =
                Ensemble.run(table, directions, (fork, number) -> play(fork, number, directions));
        Shot best = shots.get(0);
        for (Shot shot : shots) {
            best = shot.miss < best.miss ? shot : best;
        }
        return best;
    }

    /**
     * Plays a shot.
     *
     * @param table in its first state
     * @param number of the direction
     * @param directions how many there are
     * @return what came of it
     */
    public static Shot play(PhysicsWorld table, int number, int directions) {
        BodyRef cue = table.bodies().get(0);
        BodyRef red = table.bodies().get(1);
        double angle = 2 * Math.PI * number / directions;
        double x = StrictMath.cos(angle); // at set-up only: the same bits on every machine
        double z = StrictMath.sin(angle);
        cue.setVelocity(SPEED * x, 0, SPEED * z);
        double miss = Double.POSITIVE_INFINITY;
        for (int tick = 0; tick < TICKS; tick++) {
            table.step(1.0 / 120);
            double dx = red.position().x - (HALF_LENGTH - RADIUS);
            double dz = red.position().z - (HALF_WIDTH - RADIUS);
            miss = Math.min(miss, Math.sqrt(dx * dx + dz * dz));
        }
        return new Shot(number, miss, table.digest());
    }

    /**
     * A table with a cue ball, a red one and a few in the way.
     *
     * @param workers of the world
     * @return it
     */
    public static PhysicsWorld table(int workers) {
        PhysicsWorld world = PhysicsWorld.builder().workers(workers).sleeping(false).build();
        ball(world, -0.6, 0.1);
        ball(world, 0.3, -0.2);
        for (int i = 0; i < 5; i++) {
            ball(world, 0.1 * i, 0.3 - 0.02 * i * i);
        }
        world.add(Body.fixed().shape(Box.ofHalfExtents(2, 0.1, 2)).at(0, -0.1, 0).material(BALL));
        double thick = 0.1;
        for (int side = -1; side <= 1; side += 2) {
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(thick, 0.1, HALF_WIDTH + thick))
                            .at(side * (HALF_LENGTH + thick), 0.1, 0)
                            .material(CUSHION));
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(HALF_LENGTH + thick, 0.1, thick))
                            .at(0, 0.1, side * (HALF_WIDTH + thick))
                            .material(CUSHION));
        }
        return world;
    }

    private static void ball(PhysicsWorld world, double x, double z) {
        world.add(Body.dynamic().shape(Sphere.of(RADIUS)).at(x, RADIUS, z).material(BALL));
    }
}
