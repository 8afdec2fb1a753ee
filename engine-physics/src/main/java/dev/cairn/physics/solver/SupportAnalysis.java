package dev.cairn.physics.solver;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.direct.DirectIslands;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.graph.Collector;
import dev.cairn.physics.solver.load.CarriedIslands;
import dev.cairn.physics.solver.load.LoadSweep;
import dev.cairn.physics.solver.load.StaticStart;
import dev.cairn.physics.solver.load.Unloading;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

/**
 * What rests on what, found once a tick before the sub-steps: which bodies have lost a load, begin
 * at rest or ride on others, what inertia a load gives, and which islands are solved directly. Each
 * has a tunable that switches it off.
 *
 * <p>Simulation thread; allocates only when a store has grown.
 */
final class SupportAnalysis {
    /**
     * A point rests while it moves slower than gravity makes a body fall in this share of a tick.
     */
    static final double STILL = 0.125;

    /** Islands that begin at rest. */
    final StaticStart start = new StaticStart();

    /** Bodies on what speeds up. */
    final CarriedIslands riders = new CarriedIslands();

    /** Islands that are solved directly. */
    final DirectIslands direct = new DirectIslands();

    /** Whether warm starts are corrected first in this tick, see {@link Passes#settle}. */
    boolean settles;

    private final LoadSweep loads = new LoadSweep();
    private final Unloading unloading = new Unloading();
    private final EdgeList list;
    private final Batches batches;
    private final Collector collector;

    SupportAnalysis(EdgeList list, Batches batches, Collector collector) {
        this.list = list;
        this.batches = batches;
        this.collector = collector;
    }

    /**
     * Finds them for a tick whose rows are listed.
     *
     * @param stacked whether any two dynamic bodies touch
     * @param softSeconds length of the sub-step by which contacts are soft
     * @param locals get their room for direct solves
     */
    void find(
            SolverContext tick,
            boolean stacked,
            double softSeconds,
            WorkerScratch[] locals,
            Jobs jobs) {
        settles =
                tick.settings.count(Tunable.UNLOAD_SWEEPS) > 0
                        && unloading.find(
                                tick.bodies,
                                list,
                                tick.impulseScale / tick.subStep,
                                tick.weight(),
                                collector.isSame());
        // what rides is put in balance, and keeps its place, also where nothing is on it
        boolean weighs = stacked || collector.sides.count() > 0 || standsOnKinematic(tick);
        findStart(tick, weighs);
        settles |= start.found;
        findRiders(tick);
        findLoads(tick, weighs, jobs);
        findDirect(tick, softSeconds, locals);
    }

    /** Also on one that stands still: it may start in any tick. */
    private boolean standsOnKinematic(SolverContext t) {
        BodyStore b = t.bodies;
        // a world that never had one has no room for their ramps
        for (int m = 0; b.ramp.length > 0 && m < list.contacts; m++) {
            int row = list.source[m];
            if (b.kind[t.contacts.bodyA[row]] == BodyStore.KINEMATIC
                    || b.kind[t.contacts.bodyB[row]] == BodyStore.KINEMATIC) {
                return true;
            }
        }
        return false;
    }

    private void findStart(SolverContext t, boolean weighs) {
        int sweeps = t.settings.count(Tunable.START_SWEEPS);
        start.clear();
        if (weighs && sweeps > 0 && t.weight() > 0 && !collector.isSame()) {
            double still = STILL * t.weight() * t.step;
            start.find(t.bodies, t.contacts, list, still, t.weight() * t.subStep, sweeps);
        }
    }

    /** An uneven tick scales all impulses, and takes riders as they are. */
    private void findRiders(SolverContext t) {
        double weight = t.weight();
        riders.found = false;
        if (t.impulseScale == 1 && weight > 0) {
            riders.seek(
                    t.bodies,
                    t.contacts,
                    list,
                    STILL * weight * t.step + weight * t.subStep,
                    weight * t.subStep,
                    t.settings.count(Tunable.START_SWEEPS));
        }
    }

    private void findLoads(SolverContext t, boolean weighs, Jobs jobs) {
        Tuning settings = t.settings;
        boolean wanted =
                settings.get(Tunable.LOAD_INERTIA) > 0
                        || settings.count(Tunable.UNLOAD_SWEEPS) > 0
                        || settings.count(Tunable.START_SWEEPS) > 0
                        || settings.count(Tunable.DIRECT_FROM) > 0;
        BodyStore bodies = t.bodies;
        ContactStore contacts = t.contacts;
        boolean same = collector.isSame();
        t.loaded =
                wanted
                        && loads.run(
                                bodies, contacts, list, t.body, t.gravity, t.step, settings, weighs,
                                same, jobs);
    }

    private void findDirect(SolverContext t, double softSeconds, WorkerScratch[] locals) {
        int from = t.settings.count(Tunable.DIRECT_FROM);
        if (from > 0) {
            direct.update(
                    t.bodies,
                    list,
                    batches,
                    t.loaded ? from : Integer.MAX_VALUE,
                    t.weight() * softSeconds * softSeconds,
                    collector.isSame());
            for (WorkerScratch local : locals) {
                local.direct.reserve(direct);
            }
        }
    }

    /** What of it lasts from tick to tick. */
    void state(StateVisitor s) {
        loads.state(s);
        direct.state(s);
    }
}
