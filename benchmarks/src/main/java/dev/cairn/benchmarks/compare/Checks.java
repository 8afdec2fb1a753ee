package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/**
 * Closed-form cases set beside what is known: the closed form of the integrator, or the figure that
 * others published for the same engine, brought to the step used here by its known order.
 *
 * <p>Published figures at 1 ms: SimBenchmark (Leggedrobotics 2018, raw data) and the Gazebo boxes
 * study (S. Peters 2014, raw data, complex case). Both took Bullet's multi-body solver or their own
 * build; Libbulletjme is the rigid-body solver.
 */
final class Checks {
    private static final double G = 9.81;
    private static final double TICK = 1.0 / 60;
    private static final double MILLI = 1e-3;

    private Checks() {}

    /**
     * A line of the table.
     *
     * @param what scene and quantity, with its unit
     * @param engine the engine
     * @param substeps N
     * @param expected what it should be, or NaN for nothing but rounding
     * @param found what it is
     * @param order the slope of the error between the two smallest steps, or NaN
     * @param source where the expectation is from
     */
    record Row(
            String what,
            Engine engine,
            int substeps,
            double expected,
            double found,
            double order,
            String source) {}

    private record Rule(
            String scene,
            String metric,
            String what,
            List<Engine> engines,
            DoubleUnaryOperator ofStep,
            String source) {}

    private static final List<Engine> ODE = List.of(Engine.ODE4J);
    private static final List<Engine> BULLET = List.of(Engine.BULLET);
    private static final List<Engine> FIRST_ORDER =
            List.of(
                    Engine.JOLT,
                    Engine.BULLET,
                    Engine.PHYSX,
                    Engine.ODE4J,
                    Engine.JBULLET,
                    Engine.BOX3D);
    private static final List<Engine> CAIRN = List.of(Engine.CAIRN);

    private static final List<Rule> RULES =
            List.of(
                    new Rule(
                            "free-flight",
                            "positionMetres",
                            "free flight, 1.5 s: position, m",
                            FIRST_ORDER,
                            h -> G * 1.5 * h / 2,
                            "g T h / 2: semi-implicit Euler"),
                    new Rule(
                            "free-flight",
                            "positionMetres",
                            "free flight, 1.5 s: position, m",
                            CAIRN,
                            h -> Double.NaN,
                            "exact flight: rounding only"),
                    new Rule(
                            "tumble",
                            "positionMetres",
                            "tumbling box, 10 s: position, m",
                            FIRST_ORDER,
                            h -> G * 10 * h / 2,
                            "g T h / 2; Gazebo boxes: 0.0490 at 1 ms for ODE and Bullet; above it"
                                    + " at small h: float positions of 500 m"),
                    new Rule(
                            "tumble",
                            "momentumRelative",
                            "tumbling box: angular momentum, share",
                            ODE,
                            h -> FreeTumble.momentumError(FreeTumble.Torque.IMPLICIT, h),
                            "own integrator with the implicit gyroscopic torque that ode4j has"
                                    + " (Lacoursiere 2006). Gazebo boxes: ODE 1.31e-2 at 1 ms, with"
                                    + " the explicit torque, which gives 1.36e-2 at N = 16"),
                    new Rule(
                            "tumble",
                            "momentumRelative",
                            "tumbling box: angular momentum, share",
                            List.of(Engine.BULLET, Engine.BOX3D),
                            h -> FreeTumble.momentumError(FreeTumble.Torque.NEWTON, h),
                            "own integrator, one Newton step in the body's frame. Gazebo boxes:"
                                    + " Bullet 1.25e-2 at 1 ms, order 1, when its torque was"
                                    + " explicit; since 2.83 it is implicit"),
                    new Rule(
                            "tumble",
                            "momentumRelative",
                            "tumbling box: angular momentum, share",
                            List.of(Engine.PHYSX, Engine.JBULLET),
                            h -> FreeTumble.momentumError(FreeTumble.Torque.NONE, h),
                            "own integrator without a gyroscopic torque: these two have none, or"
                                    + " none that can be switched on from Java"),
                    new Rule(
                            "tumble",
                            "momentumRelative",
                            "tumbling box: angular momentum, share",
                            CAIRN,
                            h -> Double.NaN,
                            "L is kept by the splitting: rounding only"),
                    new Rule(
                            "bouncing",
                            "energySquaredJoules2",
                            "bouncing: squared energy error, J²",
                            ODE,
                            h -> 185.0 * h * h / MILLI / MILLI,
                            "SimBenchmark: ODE 185.027 at 1 ms, order 2 in the square"),
                    new Rule(
                            "bouncing",
                            "energySquaredJoules2",
                            "bouncing: squared energy error, J²",
                            BULLET,
                            h -> 75245 * h * h / MILLI / MILLI,
                            "SimBenchmark: Bullet's multi-body solver 75 245 at 1 ms, ERP 0; this"
                                    + " is the rigid-body solver, whose ERP and 2 cm of margin take"
                                    + " part in bounces (without them: 201 at N = 16, as ODE)"),
                    new Rule(
                            "bouncing",
                            "energySquaredJoules2",
                            "bouncing: squared energy error, J²",
                            CAIRN,
                            h -> Double.NaN,
                            "exact flight: whatever the impacts leave"),
                    new Rule(
                            "bouncing",
                            "energySquaredJoules2",
                            "bouncing: squared energy error, J²",
                            List.of(Engine.PHYSX, Engine.JBULLET),
                            h -> 75245 * h * h / MILLI / MILLI,
                            "SimBenchmark: Bullet 75 245 at 1 ms; nothing published for this"
                                    + " engine"),
                    new Rule(
                            "rolling",
                            "velocitySquared",
                            "rolling at 60 degrees: squared velocity error, m²/s²",
                            BULLET,
                            h -> 1.7e-6,
                            "SimBenchmark: Bullet's multi-body solver, double, 10 iterations, 1"
                                    + " ms; here float and the rigid-body solver; from N = 8 on"
                                    + " it grows, as rounding does"),
                    new Rule(
                            "spheres-666",
                            "overlapSquaredMetres2",
                            "666: squared overlaps, m²",
                            ODE,
                            h -> 1.55e-4 * h * h / MILLI / MILLI,
                            "SimBenchmark: ODE 1.55e-4 at 1 ms, with ERP and CFM 0; here the"
                                    + " defaults, 0.2 and 1e-10"),
                    new Rule(
                            "rolling",
                            "velocitySquared",
                            "rolling at 60 degrees: squared velocity error, m²/s²",
                            ODE,
                            h -> 3.145,
                            "SimBenchmark: ODE never moves, its friction is a pyramid; x 1.006, for"
                                    + " the mean is over 240 ticks, not 4000 steps"));

    /** Returns a line for every rule and engine that the results cover, default settings. */
    static List<Row> of(Results results) {
        List<Row> rows = new ArrayList<>();
        for (Rule rule : RULES) {
            for (Engine engine : rule.engines()) {
                Row row = row(results, rule, engine);
                if (row != null) {
                    rows.add(row);
                }
            }
        }
        return rows;
    }

    /** The sub-steps nearest to 1 ms: 16, or the most there are. */
    private static @Nullable Row row(Results results, Rule rule, Engine engine) {
        Results.Point last = null;
        Results.Point before = null;
        for (Results.Point point : results.of(rule.scene())) {
            if (point.engine() == engine
                    && !point.best()
                    && point.workers() == 1
                    && point.substeps() <= 16
                    && point.judged().errors().containsKey(rule.metric())) {
                before = last;
                last = point;
            }
        }
        if (last == null) {
            return null;
        }
        double found = value(last, rule);
        double order = Double.NaN;
        if (before != null && found > 0) {
            order =
                    StrictMath.log(value(before, rule) / found)
                            / StrictMath.log((double) last.substeps() / before.substeps());
        }
        return new Row(
                rule.what(),
                engine,
                last.substeps(),
                rule.ofStep().applyAsDouble(TICK / last.substeps()),
                found,
                order,
                rule.source());
    }

    private static double value(Results.Point point, Rule rule) {
        Double value = point.judged().errors().get(rule.metric());
        return value == null ? Double.NaN : value;
    }
}
