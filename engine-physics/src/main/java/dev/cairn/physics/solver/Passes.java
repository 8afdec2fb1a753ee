package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.DrivenSides;
import dev.cairn.physics.solver.body.Motion;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.direct.DirectIslands;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.graph.BouncingContacts;
import dev.cairn.physics.solver.impact.ImpactStart;
import dev.cairn.physics.solver.impact.Impacts;
import dev.cairn.physics.solver.joint.Assemblies;
import dev.cairn.physics.solver.kernel.Rescaling;
import dev.cairn.physics.solver.kernel.ScalarPasses;
import dev.cairn.physics.solver.kernel.ScalarSweep;
import dev.cairn.physics.solver.kernel.SingleScalarSweep;
import dev.cairn.physics.solver.kernel.Sweeps;
import dev.cairn.physics.solver.load.CarriedIslands;
import dev.cairn.physics.solver.load.SingleStartSweep;
import dev.cairn.physics.solver.load.StartPass;
import dev.cairn.physics.solver.load.StartSweep;
import dev.cairn.physics.solver.load.StaticStart;
import dev.cairn.physics.solver.load.ThinRows;
import dev.cairn.physics.solver.load.Unloading;
import dev.cairn.physics.solver.refresh.CoreGuard;
import dev.cairn.physics.solver.refresh.JacobianRefresh;
import dev.cairn.physics.solver.refresh.WarmStartLimit;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.KindRows;
import dev.cairn.physics.solver.row.RowPrefetch;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;
import dev.cairn.physics.tuning.Tunable;

import java.util.function.IntPredicate;

/**
 * The passes of a tick, each over a range of rows of one colour or over a range of the bodies with
 * contacts, in the order of {@link Batches#order}. The blocks of a stage in lockstep and the
 * batches that one worker solves on its own are made of the same passes.
 *
 * <p>Any worker; what ranges may run at the same time is the caller's matter. Does not allocate.
 */
final class Passes {
    final SolverContext tick;
    final ConstraintRows rows;
    private final SolverBodies body;
    private final JacobianRefresh refresh = new JacobianRefresh();
    private final CoreGuard cores = new CoreGuard();
    final WarmStartLimit warmStarts;

    /** What is done row by row. */
    private final ScalarPasses one;

    private final StartPass starts;
    private final StaticStart start;
    private final CarriedIslands riders;
    final DirectIslands direct;
    final BouncingContacts bouncing;
    final Assemblies assemblies;
    private final IntPredicate jointed;
    final JointPasses joints;
    private final DrivenSides sides;

    /**
     * Passes over the rows of one precision.
     *
     * @param bouncing the contacts with restitution
     * @param sides kinematic bodies that move
     * @param supports what rests on what
     * @param assemblies what hangs together by joints
     */
    Passes(
            SolverContext tick,
            ConstraintRows rows,
            BouncingContacts bouncing,
            DrivenSides sides,
            SupportAnalysis supports,
            Assemblies assemblies) {
        this.assemblies = assemblies;
        jointed = assemblies::binds;
        warmStarts = new WarmStartLimit(tick, rows, jointed);
        this.bouncing = bouncing;
        this.sides = sides;
        this.tick = tick;
        this.rows = rows;
        body = tick.body;
        start = supports.start;
        riders = supports.riders;
        direct = supports.direct;
        one = rows.isSingle ? new SingleScalarSweep() : new ScalarSweep();
        joints = new JointPasses(tick, rows, assemblies, refresh);
        starts = rows.isSingle ? new SingleStartSweep() : new StartSweep();
    }

    void ensureCapacity(int slots) {
        refresh.ensureCapacity(slots);
        warmStarts.ensureCapacity(slots);
        refresh.ensurePlaces(rows, tick.bodies.curved);
        cores.ensurePlaces(rows.settleMark.length);
        for (int k = 0; k < sides.count(); k++) {
            refresh.keep(sides.slot(k));
        }
        rows.rolling.begin(tick.contacts.rolls, rows.settleMark.length);
        rows.drags.begin(tick.contacts.belts, rows.settleMark.length);
    }

    /** Loads a body that has contacts. */
    void load(int i, double weight) {
        BodyStore b = tick.bodies;
        boolean isBall = body.axes.isIsotropic(i) && b.outerRadius[i] == b.innerRadius[i];
        refresh.look(b, i, weight, tick.step, isBall);
        if (!isBall && assemblies.binds(i)) {
            refresh.turnAlways(b, i);
        }
        body.motion[MotionRecord.STRIDE * i + MotionRecord.STRUCK] = 0;
        body.loadBound(b, i, tick.loaded && !riders.has(i) ? b.inertiaScale[i] : 1);
        if (rows.isSingle) {
            body.round(i);
            body.roundRoot(i);
        }
    }

    /**
     * Fills rows of a colour.
     *
     * @param kind of constraint; 0 is contact
     */
    void prepare(int kind, Sweeps sweeps, SubStep sub, int from, int to, WorkerScratch local) {
        if (kind > 0) {
            kinds(kind).prepare(tick, sub, from, to);
            return;
        }
        boolean learns = tick.settings.get(Tunable.OFFSET_GAIN) > 0;
        if (tick.impulseScale != 1 && learns) {
            double before = sub.seconds / tick.impulseScale;
            Rescaling.keepLoads(rows, tick.contacts, tick.impulseScale, before, from, to);
        }
        sweeps.fill(rows, body, tick.contacts, sub, from, to, local.scratch);
        if (rows.rolling.isUsed) {
            rows.rolling.fill(rows, body, tick.contacts, sub.fillScale, from, to);
        }
        if (tick.softScale != 1 && learns) {
            Rescaling.carryOver(rows, tick.contacts, tick.softScale, from, to);
        }
        if (rows.drags.isUsed) {
            rows.drags.fill(rows, body, tick.contacts, from, to);
        }
    }

    private KindRows kinds(int kind) {
        return rows.list.kinds[kind - 1].rows(rows.isSingle);
    }

    /** Finds the rows whose levers are renewed in each sub-step; whether there is one. */
    boolean findRenewed(SubStep sub, int from, int to, WorkerScratch local) {
        boolean any = refresh.find(rows, tick.contacts, tick.bodies, tick.weight(), from, to);
        if (any) {
            refresh.meet(rows, body, tick.bodies, tick.contacts, sub, from, to, local.renew);
        }
        return any;
    }

    /**
     * The same for all rows of the bodies from {@code head} to {@code tail}, which have no others.
     */
    boolean findRenewed(SubStep sub, int head, int tail, int from, int to, WorkerScratch local) {
        double weight = tick.weight();
        return !refresh.isCalm(tick.bodies, tick.order, head, tail, weight, from, to)
                && findRenewed(sub, from, to, local);
    }

    /** Gravity, forces and warm start of sub-step {@code index}. */
    void kick(SubStep sub, int index, int from, int to, WorkerScratch local) {
        double[] g = tick.gravity;
        double gain = tick.weight() * sub.seconds;
        for (int k = from; k < to; k++) {
            int i = tick.order[k];
            if (rows.isSingle && index == 0) {
                body.addWarm(i);
            }
            if (isGuided(i)) {
                local.single.begin(tick, rows, sub, refresh, gain, i);
            }
            Motion.kick(tick.bodies, body, i, g[0], g[1], g[2], sub.seconds);
            if (rows.isSingle) {
                body.roundVelocity(i);
            }
        }
    }

    /** Shows the sweeps a body as it is now. */
    private void round(int i) {
        if (rows.isSingle) {
            body.round(i);
        }
    }

    /** Takes over what the sweeps have done to a body. */
    private void add(int i) {
        if (rows.isSingle) {
            body.add(i);
        }
    }

    /** Corrects the warm start of rows that have lost a load, or know of none yet. */
    void settle(SubStep sub, int from, int to, WorkerScratch local) {
        if (start.found) {
            starts.start(rows, body, tick.contacts, sub, 0, start, from, to, local.scratch);
            refresh.know(rows, tick.contacts, from, to);
        }
        one.settle(
                rows,
                body,
                sub,
                tick.settings.count(Tunable.UNLOAD_SWEEPS),
                from,
                to,
                local.scratch);
    }

    /** Puts what rides on what speeds up in balance with the load of a sub-step. */
    void ride(SubStep sub, int index, int from, int to, WorkerScratch local) {
        starts.start(rows, body, tick.contacts, sub, index, riders, from, to, local.scratch);
        refresh.know(rows, tick.contacts, from, to);
    }

    void bias(int kind, Sweeps sweeps, SubStep sub, int from, int to, WorkerScratch local) {
        if (kind > 0) {
            kinds(kind).bias(tick, sub, from, to, local.scratch);
            return;
        }
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            if (rows.rolling.isUsed) {
                one.calm(rows, body, j, last);
            }
            sweeps.bias(rows, body, sub, j, last, local.scratch);
        }
    }

    /** Sweeps what the bias pass turns far until it agrees; bodies with a guide. */
    void press(SubStep sub, int from, int to, WorkerScratch local) {
        for (int k = from; k < to; k++) {
            int i = tick.order[k];
            if (isGuided(i)) {
                add(i);
                local.single.press(tick, rows, sub, i, local.scratch);
                round(i);
            }
        }
    }

    /** Moves bodies, each by a share of the sub-step if paced: {@link SolverBodies#pace}. */
    void drift(SubStep sub, int from, int to, boolean paced) {
        double[] g = tick.gravity;
        // in three loops: a turn is one long chain, and short bodies of a loop overlap
        for (int k = from; k < to; k++) {
            add(tick.order[k]);
        }
        for (int k = from; k < to; k++) {
            double h = paced ? body.pace[tick.order[k]] * sub.seconds : sub.seconds;
            Motion.drift(tick.bodies, body, tick.order[k], g[0], g[1], g[2], h);
            if (!refresh.hasRenewedRow(tick.order[k])) {
                Motion.renewRoot(tick.bodies, body, tick.order[k], sub.seconds);
            }
        }
        for (int k = from; k < to; k++) {
            round(tick.order[k]);
        }
    }

    /** Measures how far the cores of bodies are from static bodies; rows of doubles. */
    void lookAtCores(int from, int to) {
        if (!rows.isSingle) {
            cores.look(rows, tick.contacts, tick.bodies, from, to);
        }
    }

    /** Keeps the cores of moving bodies out of static ones; rows of doubles. */
    void guard(SubStep sub, int from, int to) {
        if (!rows.isSingle) {
            cores.keepOut(rows, body, tick.bodies, sub, from, to);
        }
    }

    /** Friction of a batch on kinematic bodies, before its bodies move. */
    void carry(SubStep sub, int batch, WorkerScratch local) {
        for (int k = sides.from(batch); k < sides.from(batch + 1); k++) {
            int m = sides.edge(k);
            if (m < rows.list.contacts) {
                one.carry(rows, body, sub, rows.list.place[m], local.scratch);
            }
        }
    }

    /** Gives the kinematic bodies that a batch touches their velocity of a sub-step. */
    void paceSides(SubStep sub, int index, int batch) {
        sides.pace(tick.bodies, body, batch, index, sub.count, rows.isSingle);
    }

    /** Moves the kinematic bodies that a batch touches. */
    void moveSides(SubStep sub, int batch) {
        sides.move(body, batch, sub.seconds, rows.isSingle);
    }

    /** What the bias pass did is part of the warm start, before levers change. */
    void keep(int from, int to) {
        for (int k = from; k < to; k++) {
            if (refresh.hasRenewedRow(tick.order[k])) {
                Motion.keep(tick.bodies, body, tick.order[k]);
            }
        }
    }

    /** Bodies whose rows are renewed; before these. */
    void renewBodies(SubStep sub, int from, int to) {
        for (int k = from; k < to; k++) {
            if (refresh.hasRenewedRow(tick.order[k])) {
                refresh.body(body, tick.bodies, tick.order[k], sub.seconds);
                round(tick.order[k]);
            }
        }
    }

    /**
     * Fills the rows anew that are renewed.
     *
     * @param index of the sub-step; the first one scales what the contacts know
     */
    void renewRows(SubStep sub, int index, int from, int to, WorkerScratch local) {
        if (rows.drags.isUsed) {
            rows.drags.show(rows, from, to);
        }
        refresh.rows(rows, body, tick.bodies, tick.contacts, sub, index, from, to, local.renew);
        if (rows.drags.isUsed) {
            rows.drags.hide(rows, from, to);
        }
    }

    void relax(int kind, Sweeps sweeps, SubStep sub, int from, int to, WorkerScratch local) {
        if (kind > 0) {
            kinds(kind).relax(tick, sub, from, to, local.scratch);
            return;
        }
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            local.scratch.doubles[Scratch.PACKED] = RowPrefetch.rows(rows, j, last);
            sweeps.relax(rows, body, sub, j, last, local.scratch);
            if (rows.rolling.isUsed) {
                one.roll(rows, body, j, last);
            }
            if (rows.drags.isUsed) {
                rows.drags.show(rows, j, last);
                one.drag(rows, body, j, last);
                rows.drags.hide(rows, j, last);
            }
        }
    }

    /**
     * Solves the islands directly that ask for it, after the last sweep of a pass.
     *
     * @param index among those of the batch
     */
    void direct(SubStep sub, int batch, int index, boolean soft, WorkerScratch local) {
        DirectIslands islands = direct;
        int island = islands.open(batch, index);
        boolean renewed = false;
        for (int k = islands.firstBody[island]; k < islands.firstBody[island + 1]; k++) {
            renewed |= refresh.hasRenewedRow(islands.body[k]);
        }
        local.direct.run(
                rows,
                body.state,
                sub,
                islands,
                island,
                renewed,
                soft,
                tick.weight() * sub.seconds,
                local.scratch.doubles);
    }

    /** The whole tick of a batch of assemblies that touch nothing. */
    void swing(SubStep sub, int batch, int from, int to, WorkerScratch local) {
        for (int a = assemblies.first(batch); a < assemblies.first(batch + 1); a++) {
            local.swing.run(tick, sub, assemblies.store, assemblies.at(a));
        }
        storeBodies(from, to);
    }

    /** What the contacts of such an island have learnt of their loads. */
    void learn(SubStep sub, int batch, int index, WorkerScratch local) {
        if (tick.settings.get(Tunable.OFFSET_GAIN) > 0) {
            local.direct.learn(tick, rows, sub, direct, direct.open(batch, index));
        }
    }

    /** How fast bodies of a batch with bouncing contacts can be when the next sub-step begins. */
    void limit(SubStep sub, int from, int to) {
        double weight = tick.weight();
        for (int k = from; k < to; k++) {
            body.limit(tick.bodies, tick.order[k], weight, sub.seconds);
        }
    }

    /** Whether a batch has impacts of two balls. */
    boolean hasBalls(int batch) {
        return Impacts.hasBalls(
                tick, rows.list, bouncing.row, bouncing.from(batch), bouncing.to(batch));
    }

    /** Whether a body of a batch may bounce in the next sub-step, see {@link #limit}. */
    boolean isFast(int head, int tail) {
        return Impacts.isFast(tick, sides, head, tail);
    }

    /** Impacts of a batch at the start of a sub-step: its bodies, and places of its contacts. */
    void impacts(
            SubStep sub, int batch, int head, int tail, int from, int to, WorkerScratch local) {
        ImpactStart.forget(tick, head, tail);
        if (local.impacts.run(
                tick,
                rows,
                bouncing.row,
                bouncing.impactLimits,
                bouncing.from(batch),
                bouncing.to(batch),
                sub.seconds,
                jointed)) {
            local.start.fit(tick, head, tail);
            for (int k = head; k < tail; k++) {
                round(tick.order[k]);
            }
            one.separate(rows, body, from, to);
        }
    }

    void finish(SubStep sub, int from, int to, WorkerScratch local) {
        double gain = tick.weight() * sub.seconds;
        for (int k = from; k < to; k++) {
            int i = tick.order[k];
            add(i);
            if (!isGuided(i)) {
                Motion.keep(tick.bodies, body, i);
            } else {
                local.single.end(tick, rows, sub, refresh, gain, i, local.scratch);
            }
        }
    }

    /** In the tick in which what it rides on stops, a body has its speed, and does not slide. */
    private boolean isGuided(int slot) {
        return body.guide[slot] >= 0 && !riders.has(slot);
    }

    /** Whether a body turns in this tick, or may. */
    boolean turns(int slot) {
        return refresh.turns(slot);
    }

    void storeBodies(int from, int to) {
        for (int k = from; k < to; k++) {
            body.store(tick.bodies, tick.order[k]);
            round(tick.order[k]);
        }
    }

    /** Writes the impulses of a kind beside contacts back. */
    void storeKind(int kind, SubStep sub, int from, int to) {
        kinds(kind).store(tick, sub, from, to);
    }

    /** Writes the impulses of contacts back, and the loads of their bodies. */
    void storeRows(
            Sweeps sweeps, SubStep sub, boolean renewed, int from, int to, WorkerScratch local) {
        for (int j = from; j < to; j += ConstraintRows.CHUNK) {
            int last = Math.min(to, j + ConstraintRows.CHUNK);
            local.scratch.doubles[Scratch.PACKED] =
                    RowPrefetch.results(rows, tick.contacts, j, last);
            if (rows.drags.isUsed) {
                rows.drags.showImpulses(rows, j, last);
            }
            sweeps.store(rows, body, tick.contacts, sub, j, last, local.scratch);
            if (rows.rolling.isUsed) {
                rows.rolling.store(rows, tick.contacts, j, last);
            }
        }
        ThinRows.learn(tick, rows, one, sub, from, to);
        if (renewed) {
            refresh.restore(rows, tick.contacts, from, to);
        }
        if (tick.settings.count(Tunable.UNLOAD_SWEEPS) > 0) {
            Unloading.press(tick.bodies, tick.contacts, rows, 1 / tick.subStep, from, to);
        }
    }
}
