package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.Columns;
import dev.cairn.physics.internal.PerWorker;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;

/**
 * Which bodies are in which sensor. A sensor's pairs are rows of their own, which no solver, island
 * or sleeper sees: a sensor pushes nothing and wakes no body.
 *
 * <p>After the bodies have moved, each pair of which one may have moved is asked whether it
 * overlaps; if it does not now and did not before, whether it did on the way: the one moves along a
 * line, seen from the other, from the last tick's place to this one's. Turning on the way is not
 * looked at. What flies through so enters and leaves within the tick.
 *
 * <p>Simulation thread, the questions in blocks of rows; row order is a function of history, as
 * that of contacts. Allocates only when something grows.
 */
public final class SensorStage implements Stateful {
    private static final int ROWS_PER_BLOCK = 32;
    private static final byte OUT = 0;
    private static final byte IN = 1;
    private static final byte THROUGH = 2;

    private final ColliderStore colliders;
    private final BroadPhase broadPhase;
    private final BlockJob job = this::block;
    private final Columns.Kept kept = new Columns.Kept();
    private final PerWorker<Scratch> scratch = new PerWorker<>(Scratch::new);

    /** Pairs of a sensor and what its box overlaps. */
    private int count;

    private int[] sensor = {};
    private int[] visitor = {};

    /** Whether the visitor is in, as told. */
    private boolean[] in = {};

    /** What was found in this tick. */
    private byte[] found = {};

    /** Whether what was found holds while neither body moves. */
    private boolean[] looked = {};

    /** From the sensor to the visitor when they were looked at last, m. */
    private double[] from = {};

    /** Sensors, and the visitors that entered or left them. */
    public final PairList entered = new PairList(), left = new PairList();

    /** How many of {@link #left} went with their rows, before bodies moved; they come first. */
    private int dropped;

    /** Without sensors. */
    public SensorStage(ColliderStore colliders, BroadPhase broadPhase) {
        this.colliders = colliders;
        this.broadPhase = broadPhase;
    }

    /** How many pairs there are. */
    public int count() {
        return count;
    }

    /** Empties the lists of events; at the start of a tick. */
    public void clear() {
        entered.clear();
        left.clear();
        dropped = 0;
    }

    /**
     * How many of {@link #left}, the first ones, left because their row did. A row also goes when a
     * collider gets another number or another box, and comes again in the same tick: what is among
     * these and entered, by the same colliders, was in all the time.
     */
    public int dropped() {
        return dropped;
    }

    /** Whether a pair of colliders is the sensors' business. */
    boolean takes(int a, int b) {
        return colliders.sensors && (colliders.sensor[a] || colliders.sensor[b]);
    }

    /** A new pair. */
    void add(int a, int b) {
        if (count == sensor.length) {
            columns(new Columns.Growth(Math.max(32, 2 * count)));
        }
        boolean first = colliders.sensor[a];
        sensor[count] = first ? a : b;
        visitor[count] = first ? b : a;
        in[count] = false;
        looked[count] = false;
        Poses p = colliders.poses;
        from[3 * count] = p.apartX(sensor[count], visitor[count]);
        from[3 * count + 1] = p.apartY(sensor[count], visitor[count]);
        from[3 * count + 2] = p.apartZ(sensor[count], visitor[count]);
        count++;
    }

    private void columns(Columns c) {
        sensor = c.column("sensor", sensor);
        visitor = c.column("visitor", visitor);
        in = c.column("in", in);
        found = c.column("found", found);
        looked = c.column("looked", looked);
        from = c.column("from", from, 3);
    }

    @Override
    public void state(StateVisitor s) {
        s.section("sensors", this);
        count = s.count("count", count);
        if (count > sensor.length) {
            columns(new Columns.Growth(count));
        }
        columns(kept.of(s, count, sensor.length, false));
        dropped = s.count("dropped", dropped);
        entered.state(s);
        left.state(s);
    }

    /** Pairs whose boxes parted, or that filters refuse now, go; a visitor that was in has left. */
    void drop() {
        int kept = 0;
        for (int row = 0; row < count; row++) {
            int s = sensor[row];
            int v = visitor[row];
            boolean moved = broadPhase.moved(s) || broadPhase.moved(v);
            if (moved
                    && (!broadPhase.overlap(s, v)
                            || (broadPhase.isRefiltered() && !broadPhase.admits(s, v)))) {
                broadPhase.forget(s, v);
                if (in[row]) {
                    left.add(s, v);
                }
                continue;
            }
            sensor[kept] = s;
            visitor[kept] = v;
            in[kept] = in[row];
            looked[kept] = looked[row] && !moved;
            System.arraycopy(from, 3 * row, from, 3 * kept, 3);
            kept++;
        }
        count = kept;
        dropped = left.count();
    }

    /** Looks what is in; after the bodies have moved and their colliders with them. */
    public void run(Jobs jobs) {
        if (count == 0) {
            return;
        }
        scratch.ensure(jobs.workers());
        jobs.run(job, Blocks.count(count, ROWS_PER_BLOCK));
        for (int row = 0; row < count; row++) {
            boolean now = found[row] == IN;
            if (found[row] == THROUGH) {
                entered.add(sensor[row], visitor[row]);
                left.add(sensor[row], visitor[row]);
            } else if (now != in[row]) {
                in[row] = now;
                if (now) {
                    entered.add(sensor[row], visitor[row]);
                } else {
                    left.add(sensor[row], visitor[row]);
                }
            }
        }
    }

    private void block(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, count);
        for (int row = Blocks.begin(block, ROWS_PER_BLOCK); row < end; row++) {
            look(row, scratch.of(worker));
        }
    }

    private void look(int row, Scratch own) {
        Poses p = colliders.poses;
        int s = sensor[row];
        int v = visitor[row];
        double x = p.apartX(s, v);
        double y = p.apartY(s, v);
        double z = p.apartZ(s, v);
        int at = 3 * row;
        double dx = x - from[at];
        double dy = y - from[at + 1];
        double dz = z - from[at + 2];
        if (looked[row] && isStill(s) && isStill(v)) {
            found[row] = in[row] ? IN : OUT;
            return;
        }
        looked[row] = true;
        from[at] = x;
        from[at + 1] = y;
        from[at + 2] = z;
        place(own.sensor, s, 0, 0, 0);
        place(own.visitor, v, x, y, z);
        if (own.queries.overlaps(own.sensor, own.visitor)) {
            found[row] = IN;
            return;
        }
        double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        found[row] = OUT;
        if (!in[row] && distance > 0) {
            place(own.visitor, v, x - dx, y - dy, z - dz);
            if (own.queries.shapeCast(own.visitor, dx, dy, dz, distance, own.sensor, own.hit)) {
                found[row] = THROUGH;
            }
        }
    }

    private boolean isStill(int collider) {
        byte kind = colliders.bodies.kind[colliders.body[collider]];
        return kind == BodyStore.ASLEEP || kind == BodyStore.STATIC;
    }

    private void place(Placement to, int c, double x, double y, double z) {
        Poses p = colliders.poses;
        to.setCentre(
                colliders.shape[c],
                x,
                y,
                z,
                p.orientationX[c],
                p.orientationY[c],
                p.orientationZ[c],
                p.orientationW[c]);
    }

    private static final class Scratch {
        final ShapeQueries queries = new ShapeQueries();
        final Placement sensor = new Placement();
        final Placement visitor = new Placement();
        final Hit hit = new Hit();
    }
}
