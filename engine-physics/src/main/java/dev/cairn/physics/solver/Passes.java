package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

/**
 * The passes of a tick, each over a range of rows of one colour or over a range of the bodies with
 * contacts, in the order of {@link Batches#order}. The blocks of a stage in lockstep and the
 * batches that one worker solves on its own are made of the same passes.
 *
 * <p>Any worker; what ranges may run at the same time is the caller's matter. Does not allocate.
 */
final class Passes {
    final SolverBodies body;
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

    /** What is done row by row. */
    private final ScalarPasses one;

    Passes(SolverSettings settings, int lanes, int group) {
        this.settings = settings;
        boolean isSingle = settings.single();
        body = new SolverBodies(isSingle);
        rows = new ConstraintRows(lanes, group, isSingle);
        one = isSingle ? new SingleScalarSweep() : new ScalarSweep();
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

    void prepare(Sweeps sweeps, SubStep sub, int from, int to, Scratch scratch) {
        sweeps.fill(rows, body, contacts, sub, from, to, scratch);
        if (impulseScale != 1 && settings.offsetGain() > 0) {
            Rescaling.carryOver(rows, contacts, impulseScale, from, to);
        }
    }

    /** Finds the rows whose levers are renewed in each sub-step; whether there is one. */
    boolean findRenewed(int from, int to) {
        return renewal.find(rows, contacts, bodies, weight(), from, to);
    }

    void kick(SubStep sub, int from, int to) {
        for (int k = from; k < to; k++) {
            body.addWarm(order[k]);
            Motion.kick(bodies, body, order[k], gravity[0], gravity[1], gravity[2], sub.seconds);
            body.round(order[k]);
        }
    }

    /** Corrects the warm start of rows that have lost a load. */
    void settle(SubStep sub, int from, int to, Scratch scratch) {
        one.settle(rows, body, sub, settings.unloadSweeps(), from, to, scratch);
    }

    void bias(Sweeps sweeps, SubStep sub, int from, int to, Scratch scratch) {
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            sweeps.bias(rows, body, sub, j, last, scratch);
        }
    }

    void drift(SubStep sub, int from, int to) {
        for (int k = from; k < to; k++) {
            body.add(order[k]);
            Motion.drift(bodies, body, order[k], gravity[0], gravity[1], gravity[2], sub.seconds);
            body.round(order[k]);
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

    void takeOut(int from, int to, Scratch scratch) {
        renewal.unload(rows, body.warm, from, to, scratch.row);
    }

    void renewBodies(int from, int to) {
        for (int k = from; k < to; k++) {
            if (renewal.stirs(order[k])) {
                renewal.body(body, bodies, order[k]);
                body.round(order[k]);
            }
        }
    }

    /**
     * Fills the rows anew that are renewed.
     *
     * @param index of the sub-step; the first one scales what the contacts know
     */
    void renewRows(SubStep sub, int index, int from, int to, Scratch scratch) {
        double scale = index == 0 ? sub.fillScale : 1;
        renewal.rows(rows, body, bodies, contacts, sub, scale, from, to, scratch.row);
    }

    void relax(Sweeps sweeps, SubStep sub, int from, int to, Scratch scratch) {
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            scratch.doubles[Scratch.PACKED] = Touch.rows(rows, j, last);
            sweeps.relax(rows, body, sub, j, last, scratch);
        }
    }

    /** Separations of all rows after the bodies from {@code from} to {@code to} were moved. */
    void separate(int from, int to) {
        for (int k = from; k < to; k++) {
            body.round(order[k]);
        }
        one.separate(rows, body);
    }

    void finish(SubStep sub, int from, int to, Scratch scratch) {
        double gain = weight() * sub.seconds;
        for (int k = from; k < to; k++) {
            int i = order[k];
            body.add(i);
            if (body.guide[i] < 0) {
                Motion.keep(bodies, body, i);
                continue;
            }
            ConstraintRows guides = scratch.row.open(rows, rows.place[body.guide[i]]);
            int place = scratch.row.place();
            if (sub.lone > 0) {
                LoneContact.agree(guides, body.state, sub, gain, place, i, scratch.doubles);
                scratch.row.close(rows, rows.place[body.guide[i]]);
            }
            Motion.keep(bodies, body, i);
            Glide.end(bodies, body, i, guides, place, sub.seconds);
        }
    }

    void storeBodies(int from, int to) {
        for (int k = from; k < to; k++) {
            body.store(bodies, order[k]);
            body.round(order[k]);
        }
    }

    /** Writes the impulses of the rows back, and tells their bodies what presses on them. */
    void storeRows(Sweeps sweeps, SubStep sub, boolean renewed, int from, int to, Scratch scratch) {
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            scratch.doubles[Scratch.PACKED] = Touch.results(rows, contacts, j, last);
            soften(j, last, scratch);
            sweeps.store(rows, body, contacts, sub, j, last, scratch);
        }
        if (renewed) {
            renewal.restore(rows, contacts, from, to);
        }
        if (settings.unloadSweeps() > 0) {
            Unloading.press(bodies, contacts, rows, 1 / subStep, from, to);
        }
    }

    /** Which contacts lose stiffness, see {@link RowStore}. */
    private void soften(int from, int to, Scratch scratch) {
        for (int j = from; j < to; j++) {
            int l = j * ConstraintRows.LINK;
            double share = 0;
            if (settings.effort() > 0 && rows.link[l + ConstraintRows.COUNT] > 0) {
                int source = rows.link[l + ConstraintRows.SOURCE];
                share = Effort.softened(bodies, contacts, source);
            }
            scratch.soften(j - from, share);
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
