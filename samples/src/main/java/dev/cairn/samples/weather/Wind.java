package dev.cairn.samples.weather;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Velocity;

/**
 * A steady wind, {@code F = c (u - v)} against the air that moves at u, added to the force of the
 * water.
 *
 * @param windX velocity of the air, m/s
 * @param windZ velocity of the air, m/s
 */
public record Wind(double windX, double windZ) implements ChunkSystem {
    private static final DoubleField VX = Velocity.COMPONENT.doubleField("vx");
    private static final DoubleField VZ = Velocity.COMPONENT.doubleField("vz");
    private static final DoubleField DRAG = Hull.COMPONENT.doubleField("drag");
    private static final DoubleField FX = Force.COMPONENT.doubleField("x");
    private static final DoubleField FZ = Force.COMPONENT.doubleField("z");

    @Override
    public String name() {
        return "wind";
    }

    @Override
    public void describe(Access access) {
        access.in(Velocity.COMPONENT, Hull.COMPONENT)
                .out(Force.COMPONENT)
                .after(Buoyancy.NAME); // both write Force: which comes first is asked for
    }

    @Override
    public void run(Chunk chunk, Tick tick) {
        double[] vx = chunk.in(VX);
        double[] vz = chunk.in(VZ);
        double[] drag = chunk.in(DRAG);
        double[] x = chunk.out(FX);
        double[] z = chunk.out(FZ);
        for (int row = 0; row < chunk.size(); row++) {
            x[row] += drag[row] * (windX - vx[row]);
            z[row] += drag[row] * (windZ - vz[row]);
        }
    }
}
