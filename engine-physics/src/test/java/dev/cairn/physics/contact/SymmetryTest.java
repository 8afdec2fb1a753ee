package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.support.Scenes;
import dev.cairn.physics.tuning.Tunable;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * What physics does not change under: a random body on a plane, a slab or tiles goes its way once
 * as it is, and once larger and slower, heavier, on a floor that moves with it, or on one that was
 * added after it. A second later both are the same, to the bit or to rounding. See "Symmetries" in
 * {@code docs/laws.md}.
 */
class SymmetryTest {
    private static final int TICKS = 60;
    private static final int WORLDS = 100;
    private static final double GRAVITY = 9.81;

    /** Rounding after a second, in sizes and in speeds that gravity gives on such a way. */
    private static final double ROUNDING = 1e-8;

    /** What comes of taking the normal of the other one of two faces that are nearly parallel. */
    private static final double OTHER_FACE = 1e-4;

    /** How a world is told. */
    private record View(
            double scale,
            double slower,
            double density,
            boolean isFloorLast,
            boolean isKinematic,
            Vector3d frame,
            boolean asPart) {
        static final View PLAIN = new View(1, 1, 1000, false, false, new Vector3d(), false);

        View carried(double x, double y, double z) {
            return new View(1, 1, 1000, false, true, new Vector3d(x, y, z), false);
        }
    }

    @Tag("compiled")
    @Test
    void aWorldOfFourTimesTheSizeInTwiceTheTimeHasTheSameBits() {
        compare(1, View.PLAIN, new View(4, 2, 1000, false, false, new Vector3d(), false), 0);
    }

    @Tag("compiled")
    @Test
    void whatIsAThousandTimesAsHeavyHasTheSameBits() {
        View heavy = new View(1, 1, 1024 * 1000, false, false, new Vector3d(), false);
        compare(2, View.PLAIN, heavy, 0);
    }

    @Tag("compiled")
    @Test
    void oneShapeAndABodyOfOnePartHaveTheSameBits() {
        compare(3, View.PLAIN, new View(1, 1, 1000, false, false, new Vector3d(), true), 0);
    }

    @Tag("compiled")
    @Test
    void aFloorThatIsAddedAfterTheBodyIsTheSameFloor() {
        View last = new View(1, 1, 1000, true, false, new Vector3d(), false);
        compare(4, View.PLAIN, last, OTHER_FACE);
    }

    @Tag("compiled")
    @Test
    void aFloorThatMovesEvenlyIsAsGoodAsOneThatStands() {
        View stands = View.PLAIN.carried(0, 0, 0);
        // of one shape, on a half-space and a slab
        compare(5, stands, View.PLAIN.carried(3.5, 0, -1.25), ROUNDING);
    }

    private static void compare(int seed, View one, View other, double bound) {
        StringBuilder broken = new StringBuilder();
        double worst = 0;
        for (int k = 0; k < WORLDS; k++) {
            if (bound > 0 && bound < OTHER_FACE && !new RandomStart(world(seed, k)).isOneShape()) {
                continue; // what is joined for one part of a body is not for another
            }
            double[] a = run(world(seed, k), one);
            double[] b = run(world(seed, k), other);
            double most = 0;
            for (int i = 0; i < a.length; i++) {
                most = Math.max(most, Math.abs(a[i] - b[i]));
            }
            worst = Math.max(worst, most);
            if (!(most <= bound)) {
                broken.append('\n').append(k).append(": ").append(most).append(", ");
                broken.append(new RandomStart(world(seed, k)));
            }
        }
        System.out.println("seed " + seed + ", worst difference " + worst);
        assertEquals("", broken.toString(), "worlds of seed " + seed);
    }

    private static SplittableRandom world(int seed, int k) {
        return new SplittableRandom(1000L * seed + k);
    }

    /** Place, turn, velocities after each tick, as they are seen in the plain world. */
    private static double[] run(SplittableRandom random, View view) {
        RandomStart start = new RandomStart(random);
        int ground = random.nextInt(view.isKinematic ? 2 : 3); // tiles: see laws.md
        double tile = Scenes.STEP * (40 + random.nextInt(120));
        double friction = random.nextDouble();
        double speed = view.scale / view.slower;
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withLanes(1);
        settings =
                settings.with(Tunable.PUSH_SPEED, speed * Tunable.PUSH_SPEED.initial())
                        .withRestitutionThreshold(speed * settings.restitutionThreshold());
        double fall = -GRAVITY * speed / view.slower;
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(settings)
                        .sleeping(false)
                        .workers(1)
                        .gravity(0, fall, 0)
                        .build()) {
            Material surface = new Material(friction, 0, 1000);
            if (!view.isFloorLast) {
                floor(world, ground, tile, surface, view);
            }
            BodyRef body =
                    world.add(
                            start.body(
                                    view.scale,
                                    view.slower,
                                    view.density,
                                    view.frame,
                                    view.asPart));
            if (view.isFloorLast) {
                floor(world, ground, tile, surface, view);
            }
            double[] all = new double[13 * TICKS];
            double size = start.size * view.scale;
            double fast = Math.sqrt(-fall * size);
            for (int tick = 0; tick < TICKS; tick++) {
                world.step(view.slower * Scenes.STEP);
                double time = view.slower * Scenes.STEP * (tick + 1);
                Vector3d p = body.position().sub(new Vector3d(view.frame).mul(time)).div(size);
                Vector3d v = body.velocity().sub(view.frame).div(fast);
                Vector3d w = body.angularVelocity().mul(size / fast);
                Quaterniond q = body.orientation();
                double[] now = {p.x, p.y, p.z, v.x, v.y, v.z, w.x, w.y, w.z, q.x, q.y, q.z, q.w};
                System.arraycopy(now, 0, all, 13 * tick, 13);
            }
            return all;
        }
    }

    private static void floor(
            PhysicsWorld world, int ground, double tile, Material surface, View view) {
        if (ground == 0) {
            world.add(floor(view).shape(HalfSpace.of()).material(surface));
            return;
        }
        double s = view.scale;
        double half = ground == 1 ? 8 : tile / 2;
        int n = ground == 1 ? 0 : (int) Math.ceil(8 / tile);
        for (int i = -n; i <= n; i++) {
            for (int j = -n; j <= n; j++) {
                world.add(
                        floor(view)
                                .shape(Box.ofHalfExtents(s * half, s * .5, s * half))
                                .at(s * i * tile, s * -.5, s * j * tile)
                                .material(surface));
            }
        }
    }

    private static Body floor(View view) {
        return view.isKinematic
                ? Body.kinematic().velocity(view.frame.x, view.frame.y, view.frame.z)
                : Body.fixed();
    }
}
