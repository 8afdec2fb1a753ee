package dev.cairn.benchmarks.cost;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.tuning.Tunable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * The ablation ladder: the same scene with a feature on and off, as a ratio of CPU times with its
 * interval. In a scene that does not need the feature the ratio should be 1, and the bits the same.
 * Off is a setting, not a build without the code.
 *
 * <p>To tell one per cent from none, two worlds live side by side and are stepped in turns of a few
 * ticks, so that whatever the machine does meets both; a pair of turns gives a ratio, a pair of
 * worlds the median of its ratios. Where the arrays of a world lie in memory is a difference of its
 * own, so worlds are built anew many times, and the interval is that of the medians over the
 * builds. The first rung has the same on both sides: what it shows is what cannot be told apart.
 */
final class Ladder {
    private static final double STEP = 1.0 / 60;
    private static final int SETTLING = 20;
    private static final int TURN_TICKS = 3;
    private static final int RESAMPLES = 2000;

    private static final PhysicsSettings ON = PhysicsSettings.DEFAULT.withSleeping(false);

    /** Rest is looked for in every tick and never lasts long enough. */
    private static final PhysicsSettings ALMOST_ASLEEP =
            PhysicsSettings.DEFAULT.withSleepSeconds(1000);

    private static final Mix FLIGHT = new Mix(200, 200, 0, 0, 0, 0, 0, 0, 0, 0.6);
    private static final Mix SMOOTH_FLIGHT = new Mix(200, 200, 0, 0, 0, 0, 0, 0, 0, 0);
    private static final Mix REST = new Mix(0, 0, 0, 50, 100, 0, 50, 0, 0, 0.6);
    private static final Mix SMOOTH_REST = new Mix(0, 0, 0, 50, 100, 0, 50, 0, 0, 0);

    private static final Mix PAIR_IN_FLIGHT = new Mix(200, 200, 1, 0, 0, 0, 0, 0, 0, 0.6);
    private static final Mix PAIR_BESIDE_REST = new Mix(0, 0, 1, 50, 100, 0, 50, 0, 0, 0.6);

    private static final Mix ROLLING_FLIGHT = FLIGHT.withRollingArm(1e-3);
    private static final Mix ROLLING_REST = REST.withRollingArm(1e-3);
    private static final Mix BOUNCY_REST = REST.withRestitution(0.2);

    /**
     * A rung.
     *
     * @param feature what is on or off
     * @param needed whether the scene needs it
     * @param with the scene with it
     * @param on settings with it
     * @param without the scene without it
     * @param off settings without it
     */
    record Rung(
            String feature,
            boolean needed,
            Mix with,
            PhysicsSettings on,
            Mix without,
            PhysicsSettings off) {

        /** Says whether both sides are alike. */
        boolean isNull() {
            return on.equals(off) && with.equals(without);
        }
    }

    /** What was found: CPU time on over off, median and interval, and whether bits agree. */
    record Found(Rung rung, double ratio, double low, double high, boolean sameBits) {}

    static final List<Rung> RUNGS =
            List.of(
                    rung("nothing (both sides alike)", false, FLIGHT, ON),
                    rung("nothing (both sides alike)", false, REST, ON),
                    new Rung("sleep", false, FLIGHT, ON.withSleeping(true), FLIGHT, ON),
                    new Rung("sleep", false, REST, ALMOST_ASLEEP, REST, ON),
                    rung("offset against sag", false, FLIGHT, ON.with(Tunable.OFFSET_GAIN, 0)),
                    rung(
                            "load-proportional inertia",
                            false,
                            FLIGHT,
                            ON.with(Tunable.LOAD_INERTIA, 0)),
                    rung("unloading sweeps", false, FLIGHT, ON.with(Tunable.UNLOAD_SWEEPS, 0)),
                    rung("unloading sweeps", false, REST, ON.with(Tunable.UNLOAD_SWEEPS, 0)),
                    rung("help for single bodies", false, FLIGHT, ON.with(Tunable.LONE_SWEEPS, 0)),
                    rung("help for single bodies", false, REST, ON.with(Tunable.LONE_SWEEPS, 0)),
                    rung("static start", false, FLIGHT, ON.with(Tunable.START_SWEEPS, 0)),
                    rung("static start", false, REST, ON.with(Tunable.START_SWEEPS, 0)),
                    rung("direct solves", false, FLIGHT, ON.with(Tunable.DIRECT_FROM, 0)),
                    rung("direct solves", false, REST, ON.with(Tunable.DIRECT_FROM, 0)),
                    rung("restitution", false, FLIGHT, ON.withRestitutionThreshold(1000)),
                    rung("restitution", false, REST, ON.withRestitutionThreshold(1000)),
                    new Rung("restitution of 0.2 at rest", false, BOUNCY_REST, ON, REST, ON),
                    new Rung(
                            "filters on all that let all through",
                            false,
                            FLIGHT.withFilters(),
                            ON,
                            FLIGHT,
                            ON),
                    new Rung(
                            "filters on all that let all through",
                            false,
                            REST.withFilters(),
                            ON,
                            REST,
                            ON),
                    new Rung(
                            "one rod beside it",
                            false,
                            PAIR_IN_FLIGHT.withRods(1),
                            ON,
                            PAIR_IN_FLIGHT,
                            ON),
                    new Rung(
                            "one rod beside it",
                            false,
                            PAIR_BESIDE_REST.withRods(1),
                            ON,
                            PAIR_BESIDE_REST,
                            ON),
                    new Rung("friction", false, FLIGHT, ON, SMOOTH_FLIGHT, ON),
                    new Rung("rolling friction", false, ROLLING_FLIGHT, ON, FLIGHT, ON),
                    new Rung("friction", true, REST, ON, SMOOTH_REST, ON),
                    new Rung("rolling friction", true, ROLLING_REST, ON, REST, ON),
                    rung("offset against sag", true, REST, ON.with(Tunable.OFFSET_GAIN, 0)),
                    rung(
                            "load-proportional inertia",
                            true,
                            REST,
                            ON.with(Tunable.LOAD_INERTIA, 0)));

    private Ladder() {}

    private static Rung rung(String feature, boolean needed, Mix scene, PhysicsSettings off) {
        return new Rung(feature, needed, scene, ON, scene, off);
    }

    /** Builds worlds so many times, and takes so many pairs of turns of each. */
    static Found climb(Rung rung, int builds, int pairs, ThreadTime time) {
        List<Double> medians = new ArrayList<>();
        boolean sameBits = true;
        // The first build warms up.
        for (int build = -1; build < builds; build++) {
            // Who comes first changes, in memory and in time.
            boolean swap = (build & 1) != 0;
            Mix first = swap ? rung.without() : rung.with();
            Mix second = swap ? rung.with() : rung.without();
            try (PhysicsWorld a = first.build(swap ? rung.off() : rung.on());
                    PhysicsWorld b = second.build(swap ? rung.on() : rung.off())) {
                step(a, SETTLING);
                step(b, SETTLING);
                double ratio = ratio(a, b, pairs, time);
                if (build >= 0) {
                    medians.add(swap ? 1 / ratio : ratio);
                }
                sameBits &= a.digest() == b.digest();
            }
        }
        double[] interval = interval(medians, new SplittableRandom(1));
        return new Found(rung, interval[1], interval[0], interval[2], sameBits);
    }

    /** Median of the ratios of turns of two worlds. */
    private static double ratio(PhysicsWorld a, PhysicsWorld b, int pairs, ThreadTime time) {
        double[] ratios = new double[pairs];
        for (int pair = 0; pair < pairs; pair++) {
            boolean backwards = (pair & 1) != 0;
            long start = time.nanos();
            step(backwards ? b : a, TURN_TICKS);
            long middle = time.nanos();
            step(backwards ? a : b, TURN_TICKS);
            long end = time.nanos();
            double ratio = (middle - start) / (double) (end - middle);
            ratios[pair] = backwards ? 1 / ratio : ratio;
        }
        return median(ratios);
    }

    private static void step(PhysicsWorld world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(STEP);
        }
    }

    /** Low end, median and high end of 95 %, by bootstrap of the median (Efron 1979). */
    static double[] interval(List<Double> values, SplittableRandom random) {
        double[] medians = new double[RESAMPLES];
        double[] drawn = new double[values.size()];
        for (int r = 0; r < RESAMPLES; r++) {
            for (int i = 0; i < drawn.length; i++) {
                drawn[i] = values.get(random.nextInt(drawn.length));
            }
            medians[r] = median(drawn);
        }
        Arrays.sort(medians);
        double[] all = values.stream().mapToDouble(Double::doubleValue).toArray();
        return new double[] {
            medians[(int) (0.025 * RESAMPLES)], median(all), medians[(int) (0.975 * RESAMPLES) - 1]
        };
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int n = sorted.length;
        return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
    }
}
