package dev.cairn.benchmarks.cost;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * The ablation ladder: the same scene with a feature on and off, interleaved, as a ratio of CPU
 * times with its interval. In a scene that does not need the feature the ratio should be 1, and the
 * bits the same. Off is a setting, not a build without the code.
 */
final class Ladder {
    private static final double STEP = 1.0 / 60;
    private static final int SETTLING = 20;
    private static final int TICKS = 60;
    private static final int RESAMPLES = 2000;

    private static final PhysicsSettings ON = PhysicsSettings.DEFAULT;
    private static final Mix FLIGHT = new Mix(200, 200, 0, 0, 0, 0, 0, 0, 0, 0.6);
    private static final Mix SMOOTH_FLIGHT = new Mix(200, 200, 0, 0, 0, 0, 0, 0, 0, 0);
    private static final Mix REST = new Mix(0, 0, 0, 50, 100, 0, 50, 0, 0, 0.6);
    private static final Mix SMOOTH_REST = new Mix(0, 0, 0, 50, 100, 0, 50, 0, 0, 0);

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
            PhysicsSettings off) {}

    /** What was found: CPU time on over off, median and interval, and whether bits agree. */
    record Found(Rung rung, double ratio, double low, double high, boolean sameBits) {}

    static final List<Rung> RUNGS =
            List.of(
                    rung("offset against sag", false, FLIGHT, ON.withOffsetGain(0)),
                    rung("load-proportional inertia", false, FLIGHT, ON.withLoadInertia(0)),
                    rung("unloading sweeps", false, FLIGHT, ON.withUnloadSweeps(0)),
                    rung("unloading sweeps", false, REST, ON.withUnloadSweeps(0)),
                    rung("restitution", false, FLIGHT, ON.withRestitutionThreshold(1000)),
                    rung("restitution", false, REST, ON.withRestitutionThreshold(1000)),
                    new Rung("friction", false, FLIGHT, ON, SMOOTH_FLIGHT, ON),
                    new Rung("friction", true, REST, ON, SMOOTH_REST, ON),
                    rung("offset against sag", true, REST, ON.withOffsetGain(0)),
                    rung("load-proportional inertia", true, REST, ON.withLoadInertia(0)));

    private Ladder() {}

    private static Rung rung(String feature, boolean needed, Mix scene, PhysicsSettings off) {
        return new Rung(feature, needed, scene, ON, scene, off);
    }

    static Found climb(Rung rung, int pairs, ThreadTime time) {
        List<Double> ratios = new ArrayList<>();
        long[] digest = new long[2];
        for (int pair = -1; pair < pairs; pair++) {
            // Who goes first changes, so that a drift of the machine cancels.
            double[] nanos = new double[2];
            for (int turn = 0; turn < 2; turn++) {
                int side = (pair + turn) & 1;
                Mix mix = side == 0 ? rung.with() : rung.without();
                try (PhysicsWorld world = mix.build(side == 0 ? rung.on() : rung.off())) {
                    nanos[side] = run(world, time);
                    digest[side] = world.digest();
                }
            }
            if (pair >= 0) {
                ratios.add(nanos[0] / nanos[1]);
            }
        }
        double[] interval = interval(ratios, new SplittableRandom(1));
        return new Found(rung, interval[1], interval[0], interval[2], digest[0] == digest[1]);
    }

    private static double run(PhysicsWorld world, ThreadTime time) {
        for (int tick = 0; tick < SETTLING; tick++) {
            world.step(STEP);
        }
        long before = time.nanos();
        for (int tick = 0; tick < TICKS; tick++) {
            world.step(STEP);
        }
        return time.nanos() - before;
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
