package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.AccessException;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.storage.Handle;
import dev.cairn.core.ecs.storage.Store;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/** One system at work in one world: its chunks, its commands, and whether it runs this tick. */
final class SystemRunner {
    final String name;
    final int index;
    final ChunkList chunks;
    final @Nullable ChunkSystem chunkSystem;
    final @Nullable WorldSystem worldSystem;
    boolean active;
    private final boolean givesCommands;

    private final Schedule.@Nullable Entry entry;
    private final Store store;
    private final Commands.Handles handles;
    private final @Nullable Guard guard;
    private @Nullable Commands[] commands = new Commands[0];
    private @Nullable Thread thread;

    /** Set by any worker, read after the join; only ever goes from false to true in a tick. */
    private boolean recorded;

    SystemRunner(
            Schedule.@Nullable Entry entry,
            Access access,
            int index,
            Store store,
            Commands.Handles handles,
            boolean checked) {
        this.entry = entry;
        this.name = access.system();
        this.givesCommands = access.givesCommands();
        this.index = index;
        this.store = store;
        this.handles = handles;
        this.chunks = new ChunkList(store, access, false, checked);
        this.guard = checked ? new Guard(name) : null;
        this.chunkSystem = entry != null && entry.system() instanceof ChunkSystem c ? c : null;
        this.worldSystem = entry != null && entry.system() instanceof WorldSystem w ? w : null;
    }

    /** Before the tick, simulation thread. */
    void begin() {
        active = entry != null && entry.isEnabled();
        recorded = false;
        if (active) {
            int needed = Math.max(1, chunks.refresh());
            if (needed > commands.length) {
                commands = Arrays.copyOf(commands, Math.max(needed, commands.length * 2));
            }
            if (worldSystem != null && !Thread.currentThread().equals(thread)) {
                thread = Thread.currentThread();
                commands[0] = null;
            }
        }
    }

    /** Runs a chunk system on one of its chunks. Any worker. */
    void runChunk(int index, Tick tick) {
        ChunkSystem system = chunkSystem;
        if (system == null) {
            return;
        }
        Chunk chunk = chunks.get(index);
        try {
            if (guard == null) {
                system.run(chunk, tick);
            } else {
                guard.before(chunk);
                system.run(chunk, tick);
                guard.after(chunk);
            }
        } catch (Throwable failure) {
            throw SystemFailure.of(name, index, failure);
        }
    }

    /** Runs a world system. Simulation thread. */
    void runWorld(Tick tick) {
        WorldSystem system = worldSystem;
        if (system == null) {
            return;
        }
        try {
            if (guard == null) {
                system.run(tick);
            } else {
                guard.before(chunks);
                system.run(tick);
                guard.after(chunks);
            }
        } catch (Throwable failure) {
            throw SystemFailure.of(name, -1, failure);
        }
    }

    Commands commands(int block, long tick) {
        if (!givesCommands) {
            throw new AccessException(
                    "system '"
                            + name
                            + "' gives commands, but has not declared it; add access.commands() to"
                            + " its describe method");
        }
        Commands buffer = commands[block];
        if (buffer == null) {
            buffer = new Commands(store, handles, index, block, thread);
            commands[block] = buffer;
        }
        recorded = true;
        return buffer.begin(tick);
    }

    void commitColumns(long tick) {
        if (active) {
            for (int i = 0; i < chunks.count(); i++) {
                chunks.get(i).commit(tick);
            }
        }
    }

    void rollBack() {
        if (active) {
            for (int i = 0; i < chunks.count(); i++) {
                chunks.get(i).rollBack();
            }
        }
    }

    int applyCommands(long tick) {
        int skipped = 0;
        if (recorded) {
            for (Commands buffer : commands) {
                if (buffer != null) {
                    skipped += buffer.apply(tick);
                }
            }
        }
        return skipped;
    }

    /** The world has another state. */
    void forgetCommands() {
        for (Commands buffer : commands) {
            if (buffer != null) {
                buffer.forget();
            }
        }
    }

    long entityOf(long handle) {
        int chunk = Handle.chunk(handle);
        Commands buffer = chunk < commands.length ? commands[chunk] : null;
        return buffer == null ? Entities.NONE : buffer.entityOf(handle);
    }
}
