package dev.cairn.physics.state;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.ecs.component.IntField;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Torque;
import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * From columns to slots: adds the components {@link Force} and {@link Torque} to what acts on the
 * bodies in this tick. Wakes a sleeper whose force is another one than in the tick before.
 *
 * <p>Simulation thread; a world without such components pays one question per chunk.
 */
public final class ForceReader implements Stateful {
    private static final IntField SLOT = RigidBody.COMPONENT.intField("slot");
    private static final DoubleField[] FORCE = fields(Force.COMPONENT);
    private static final DoubleField[] TORQUE = fields(Torque.COMPONENT);

    private final BodyRegistry registry;

    /** By slot: force and torque of the last tick. */
    private double[] last = {};

    /**
     * A reader.
     *
     * @param registry whose bodies these are
     */
    public ForceReader(BodyRegistry registry) {
        this.registry = registry;
    }

    private static DoubleField[] fields(Component<?> component) {
        return new DoubleField[] {
            component.doubleField("x"), component.doubleField("y"), component.doubleField("z")
        };
    }

    @Override
    public void state(StateVisitor s) {
        s.section("forces", this);
        int count = Math.min(last.length, 6 * registry.bodies.slotCount);
        last = s.array("last", last, s.value("count", count));
    }

    /** Reads all chunks of the tick. */
    public void run(Tick tick) {
        for (int c = 0; c < tick.chunkCount(); c++) {
            Chunk chunk = tick.chunk(c);
            BodyStore b = registry.bodies;
            if (chunk.has(Force.COMPONENT)) {
                add(chunk, FORCE, 0, b.forceX, b.forceY, b.forceZ);
            }
            if (chunk.has(Torque.COMPONENT)) {
                add(chunk, TORQUE, 3, b.torqueX, b.torqueY, b.torqueZ);
            }
        }
    }

    private void add(
            Chunk chunk, DoubleField[] fields, int at, double[] x, double[] y, double[] z) {
        if (last.length < 6 * x.length) {
            last = Arrays.copyOf(last, 6 * x.length);
        }
        int[] slots = chunk.in(SLOT);
        double[] fx = chunk.next(fields[0]);
        double[] fy = chunk.next(fields[1]);
        double[] fz = chunk.next(fields[2]);
        int size = chunk.size();
        for (int row = 0; row < size; row++) {
            int s = slots[row];
            int k = 6 * s + at;
            if (fx[row] != last[k] || fy[row] != last[k + 1] || fz[row] != last[k + 2]) {
                registry.sleepers.wake(s);
                last[k] = fx[row];
                last[k + 1] = fy[row];
                last[k + 2] = fz[row];
            }
            if (registry.bodies.kind[s] == BodyStore.DYNAMIC) {
                x[s] += fx[row];
                y[s] += fy[row];
                z[s] += fz[row];
            }
        }
    }
}
