package dev.cairn.samples.weather;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Velocity;

/**
 * Water below y = 0: the weight of what a hull displaces, {@code F = rho g A d}, d the depth of its
 * bottom, at most its height (Archimedes).
 *
 * <p>The depth is that of the middle of the tick, {@code y + v h/2}: then heaving neither gains nor
 * loses energy, since the step's map of (y, v) has determinant 1.
 *
 * <p>Of the forces of a tick it is the first: it writes all of {@code Force}, and what comes after
 * it adds to that.
 *
 * @param density of the water, kg/m³
 * @param gravity m/s²
 */
public record Buoyancy(double density, double gravity) implements ChunkSystem {
    private static final DoubleField Y = Pose.COMPONENT.doubleField("y");
    private static final DoubleField VY = Velocity.COMPONENT.doubleField("vy");
    private static final DoubleField AREA = Hull.COMPONENT.doubleField("waterplane");
    private static final DoubleField HALF = Hull.COMPONENT.doubleField("halfHeight");
    private static final DoubleField FX = Force.COMPONENT.doubleField("x");
    private static final DoubleField FY = Force.COMPONENT.doubleField("y");
    private static final DoubleField FZ = Force.COMPONENT.doubleField("z");

    /** Name of the system, for those that come after it. */
    public static final String NAME = "buoyancy";

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public void describe(Access access) {
        access.in(Pose.COMPONENT, Velocity.COMPONENT, Hull.COMPONENT).writesAll(Force.COMPONENT);
    }

    @Override
    public void run(Chunk chunk, Tick tick) {
        double[] y = chunk.in(Y);
        double[] v = chunk.in(VY);
        double[] area = chunk.in(AREA);
        double[] half = chunk.in(HALF);
        double[] x = chunk.out(FX);
        double[] lift = chunk.out(FY);
        double[] z = chunk.out(FZ);
        double ahead = 0.5 * tick.stepSeconds();
        for (int row = 0; row < chunk.size(); row++) {
            double depth = half[row] - (y[row] + ahead * v[row]);
            double wet = Math.max(0, Math.min(depth, 2 * half[row]));
            x[row] = 0;
            z[row] = 0;
            lift[row] = density * gravity * area[row] * wet;
        }
    }
}
