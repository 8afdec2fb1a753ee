package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.storage.Handle;
import dev.cairn.core.ecs.storage.Store;
import dev.cairn.core.job.Jobs;

import java.util.ArrayList;
import java.util.List;

/** A schedule at work in one world: the levels of a tick as arrays, and the commit. */
final class Runner implements Commands.Handles {
    private final Store store;
    private final Jobs jobs;
    private final SystemRunner[] systems;
    private final Level[] levels;
    private final Tick[] ticks;
    private final Observers observers;
    final SystemClock clock;

    Runner(
            World world,
            Store store,
            Observers observers,
            Schedule schedule,
            Jobs jobs,
            boolean checked) {
        this.store = store;
        this.observers = observers;
        this.jobs = jobs;
        SystemRunner none = new SystemRunner(null, new Access("none"), -1, store, this, false);
        this.ticks = new Tick[jobs.workers()];
        for (int worker = 0; worker < ticks.length; worker++) {
            ticks[worker] = new Tick(world, none, worker);
        }
        this.clock = new SystemClock(schedule.systems().toArray(String[]::new), jobs.workers());
        List<SystemRunner> all = new ArrayList<>();
        List<Level> stages = new ArrayList<>();
        for (List<Schedule.Entry> level : schedule.levels()) {
            List<SystemRunner> members = new ArrayList<>();
            for (Schedule.Entry entry : level) {
                int index = all.size() + members.size();
                members.add(new SystemRunner(entry, entry.access(), index, store, this, checked));
            }
            all.addAll(members);
            stages.add(new Level(members.toArray(SystemRunner[]::new), ticks, clock, checked));
        }
        this.systems = all.toArray(SystemRunner[]::new);
        this.levels = stages.toArray(Level[]::new);
        observers.resolveBy(this);
    }

    /** Computes and publishes a tick; returns how many commands were skipped. */
    int run(long tick, double stepSeconds) {
        for (Tick context : ticks) {
            context.begin(tick, stepSeconds);
        }
        for (SystemRunner system : systems) {
            system.begin();
        }
        clock.begin();
        compute();
        clock.end();
        store.tick = tick;
        for (SystemRunner system : systems) {
            system.commitColumns(tick);
        }
        int skipped = 0;
        for (SystemRunner system : systems) {
            skipped += system.applyCommands(tick);
        }
        return skipped + observers.applyCommands();
    }

    private void compute() {
        boolean complete = false;
        jobs.beginTick();
        try {
            for (Level level : levels) {
                level.run(jobs);
            }
            complete = true;
        } finally {
            jobs.endTick();
            if (!complete) {
                for (SystemRunner system : systems) {
                    system.rollBack();
                }
            }
        }
    }

    /** The world has another state: what commands of the last tick made is forgotten. */
    void forgetCommands() {
        for (SystemRunner system : systems) {
            system.forgetCommands();
        }
        observers.forget();
    }

    @Override
    public long entityOf(long handle) {
        int system = Handle.system(handle);
        if (system == Handle.OBSERVERS) {
            return observers.entityOf(handle);
        }
        return system < systems.length ? systems[system].entityOf(handle) : Entities.NONE;
    }

    /** What the user gets to see of a failed tick. */
    static WorldFailedException explain(Throwable thrown, long tick) {
        if (!(thrown instanceof SystemFailure first)) {
            return new WorldFailedException("tick " + tick + " failed: " + thrown, thrown);
        }
        WorldFailedException failure =
                new WorldFailedException(
                        "tick "
                                + tick
                                + " failed in "
                                + first.place
                                + ": "
                                + first.failure
                                + (first.isPublished
                                        ? "; its changes are made, but this world cannot step again"
                                        : "; it was not published, and this world cannot step"
                                                + " again"),
                        first.failure);
        for (Throwable other : first.getSuppressed()) {
            failure.addSuppressed(other instanceof SystemFailure f ? f.failure : other);
        }
        return failure;
    }
}
