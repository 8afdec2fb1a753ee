package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * The passes of a tick, each over a range of rows of one colour or over a range of the bodies with
 * contacts, in the order of {@link Batches#order}. The blocks of a stage in lockstep and the
 * batches that one worker solves on its own are made of the same passes.
 *
 * <p>Any worker; what ranges may run at the same time is the caller's matter. Does not allocate.
 */
final class Passes {
    /**
     * A point rests while it moves slower than gravity makes a body fall in this share of a tick.
     */
    private static final double STILL = 0.125;

    final SolverBodies body = new SolverBodies();
    final ConstraintRows rows;
    final Renewal renewal = new Renewal();
    final double[] gravity = new double[3];

    // of the tick in work
    SolverSettings settings;
    BodyStore bodies = new BodyStore();
    ContactStore contacts = new ContactStore();
    int[] order = {};
    double step;

    /** Length of a sub-step without extra effort, s. */
    double subStep;

    /** This sub-step over the last tick's: the scale of the impulses that are kept. */
    double impulseScale = 1;

    /** Whether bodies have the inertia of their load. */
    boolean loaded;

    Passes(SolverSettings settings, int lanes, int group) {
        this.settings = settings;
        rows = new ConstraintRows(lanes, group);
    }

    /** Size of gravity, m/s². */
    double weight() {
        return Math.sqrt(
                gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    }

    /** By slot, all of them: flies the bodies without contacts, loads the others. */
    void begin(int from, int to) {
        BodyStore b = bodies;
        double weight = weight();
        for (int i = from; i < to; i++) {
            b.pressed[i] = 0;
            b.pressing[i] = 0;
            if (b.kind[i] != BodyStore.DYNAMIC) {
                continue;
            }
            body.axes.update(b, i);
            if (body.guide[i] == SolverBodies.FREE) {
                Motion.fly(
                        b, body, i, gravity[0], gravity[1], gravity[2], step, settings.substeps());
            } else {
                renewal.look(b, i, weight);
                body.loadBound(b, i, loaded ? b.inertiaScale[i] : 1);
            }
        }
    }

    void prepare(Sweeps sweeps, SubStep sub, int from, int to, double[] scratch) {
        sweeps.fill(rows, body, contacts, sub, sub.fillScale, from, to, scratch);
        if (impulseScale != 1 && settings.offsetGain() > 0) {
            Offsets.carryOver(rows, contacts, impulseScale, from, to);
        }
    }

    /** Finds the rows whose levers are renewed in each sub-step; whether there is one. */
    boolean findRenewed(int from, int to) {
        return renewal.find(rows, contacts, bodies, weight(), from, to);
    }

    void kick(SubStep sub, int from, int to) {
        for (int k = from; k < to; k++) {
            Motion.kick(bodies, body, order[k], gravity[0], gravity[1], gravity[2], sub.seconds);
        }
    }

    /** Corrects the warm start of rows that have lost a load. */
    void settle(SubStep sub, int from, int to, double[] scratch) {
        ScalarSweeps.settle(rows, body.state, sub, settings.unloadSweeps(), from, to, scratch);
    }

    void bias(Sweeps sweeps, SubStep sub, int from, int to, double[] scratch) {
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            sweeps.bias(rows, body.state, sub, j, last, scratch);
        }
    }

    void drift(SubStep sub, int from, int to) {
        for (int k = from; k < to; k++) {
            Motion.drift(bodies, body, order[k], gravity[0], gravity[1], gravity[2], sub.seconds);
        }
    }

    /** What the bias pass did is part of the warm start, before levers change. */
    void keep(int from, int to) {
        for (int k = from; k < to; k++) {
            if (renewal.stirs(order[k])) {
                Motion.keep(bodies, body, order[k]);
            }
        }
    }

    void takeOut(int from, int to) {
        renewal.unload(rows, body.warm, from, to);
    }

    void renewBodies(int from, int to) {
        for (int k = from; k < to; k++) {
            if (renewal.stirs(order[k])) {
                renewal.body(body, bodies, order[k]);
            }
        }
    }

    /**
     * Fills the rows anew that are renewed.
     *
     * @param index of the sub-step; the first one scales what the contacts know
     */
    void renewRows(SubStep sub, int index, int from, int to) {
        double scale = index == 0 ? sub.fillScale : 1;
        renewal.rows(rows, body, bodies, contacts, sub, scale, from, to);
    }

    void relax(Sweeps sweeps, SubStep sub, int from, int to, double[] scratch) {
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            scratch[Scratch.PACKED] = Touch.rows(rows, j, last);
            sweeps.relax(rows, body.state, sub, j, last, scratch);
        }
    }

    void finish(SubStep sub, int from, int to, double[] scratch) {
        double gain = weight() * sub.seconds;
        for (int k = from; k < to; k++) {
            int i = order[k];
            if (body.guide[i] >= 0 && sub.lone > 0) {
                LoneContact.agree(rows, body.state, sub, gain, body.guide[i], i, scratch);
            }
            Motion.keep(bodies, body, i);
            if (body.guide[i] >= 0) {
                Glide.end(bodies, body, i, rows, sub.seconds);
            }
        }
    }

    void storeBodies(int from, int to) {
        for (int k = from; k < to; k++) {
            body.store(bodies, order[k]);
        }
    }

    /** Writes the impulses of the rows back, and tells their bodies what presses on them. */
    void storeRows(
            Sweeps sweeps, SubStep sub, boolean renewed, int from, int to, double[] scratch) {
        double still = STILL * weight() * step;
        double gain = settings.offsetGain();
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            scratch[Scratch.PACKED] = Touch.results(rows, contacts, j, last);
            soften(j, last, scratch);
            sweeps.store(rows, body.state, contacts, sub, gain, still, j, last, scratch);
        }
        if (renewed) {
            renewal.restore(rows, contacts, from, to);
        }
        if (settings.unloadSweeps() > 0) {
            Unloading.press(bodies, contacts, rows, 1 / subStep, from, to);
        }
    }

    /** Which contacts lose stiffness, see {@link RowStore}. */
    private void soften(int from, int to, double[] scratch) {
        Arrays.fill(scratch, Scratch.SOFTENED, Scratch.SOFTENED + ConstraintRows.CHUNK, 0.0);
        for (int j = from; j < to && settings.effort() > 0; j++) {
            int l = j * ConstraintRows.LINK;
            if (rows.link[l + ConstraintRows.COUNT] > 0) {
                int source = rows.link[l + ConstraintRows.SOURCE];
                scratch[Scratch.SOFTENED + j - from] = Effort.softened(bodies, contacts, source);
            }
        }
    }

    /** Contacts without points have no impulses; a range of the active ones. */
    void clearRows(int from, int to) {
        ContactStore c = contacts;
        for (int i = from; i < to; i++) {
            int row = c.active[i];
            if (c.pointCount[row] == 0) {
                c.setFrictionImpulse(row, 0, 0, 0, 0);
            }
        }
    }
}
