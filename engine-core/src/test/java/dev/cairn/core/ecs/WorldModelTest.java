package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.DeadEntityException;
import dev.cairn.core.ecs.component.Entities;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;

/** Random structural changes, beside a naive model that is a map of maps. */
class WorldModelTest {
    private static final List<Component<?>> KINDS = List.of(POSITION, VELOCITY, FORCE, TAG, MIXED);

    private final Map<Long, Map<Component<?>, Record>> model = new LinkedHashMap<>();
    private final Set<Long> everUsed = new HashSet<>();
    private final List<Long> dead = new ArrayList<>();

    @Property(tries = 60)
    void theWorldIsTheModel(@ForAll long seed) {
        run(seed, 400, false);
    }

    @Property(tries = 6)
    void alsoAcrossManyChunksAndWithCommands(@ForAll long seed) {
        run(seed, 12_000, true);
    }

    private void run(long seed, int operations, boolean commands) {
        Random random = new Random(seed);
        List<Operation> pending = new ArrayList<>();
        WorldSystem recorder =
                world(
                        "recorder",
                        access -> access.commands(),
                        tick -> {
                            for (Operation operation : pending) {
                                operation.record(tick.commands());
                            }
                        });
        model.clear();
        everUsed.clear();
        dead.clear();
        try (World world = World.builder().systems(recorder).workers(1).build()) {
            for (int i = 0; i < operations; i++) {
                Operation operation = draw(random);
                if (commands && operation.entity != Entities.NONE && random.nextBoolean()) {
                    pending.add(operation);
                    world.step(1);
                    pending.clear();
                } else {
                    operation.make(world);
                }
                operation.model();
                if (operation.entity == Entities.NONE || random.nextInt(50) == 0) {
                    compareTotals(world);
                }
            }
            compare(world);
        }
    }

    private Operation draw(Random random) {
        List<Long> alive = new ArrayList<>(model.keySet());
        int roll = random.nextInt(100);
        if (alive.isEmpty() || roll < 45) {
            return new Operation(0, Entities.NONE, parts(random), null);
        }
        long entity = alive.get(random.nextInt(alive.size()));
        Map<Component<?>, Record> has = model.get(entity);
        Record part = part(random.nextInt(KINDS.size()), random);
        boolean present = has.containsKey(Component.of(part.getClass()));
        if (roll < 65) {
            return new Operation(1, entity, new Record[0], null);
        }
        if (roll < 70) {
            return new Operation(2, entity, new Record[0], null);
        }
        if (!present) {
            return new Operation(3, entity, new Record[] {part}, null);
        }
        return roll < 85
                ? new Operation(4, entity, new Record[] {part}, null)
                : new Operation(5, entity, new Record[0], Component.of(part.getClass()));
    }

    private static Record[] parts(Random random) {
        List<Record> parts = new ArrayList<>();
        int first = random.nextInt(KINDS.size());
        for (int i = 0, n = random.nextInt(KINDS.size() + 1); i < n; i++) {
            parts.add(part((first + i) % KINDS.size(), random));
        }
        return parts.toArray(Record[]::new);
    }

    private static Record part(int kind, Random random) {
        return switch (kind) {
            case 0 -> new Position(random.nextDouble(), random.nextDouble());
            case 1 -> new Velocity(random.nextDouble(), random.nextDouble());
            case 2 -> new Force(random.nextFloat());
            case 3 -> new Tag();
            default ->
                    new Mixed(
                            random.nextDouble(),
                            random.nextFloat(),
                            random.nextLong(),
                            random.nextInt(),
                            random.nextBoolean(),
                            (byte) random.nextInt(),
                            (short) random.nextInt(),
                            (char) random.nextInt(),
                            "t" + random.nextInt(9));
        };
    }

    /** One change, for the world, for commands and for the model. */
    private final class Operation {
        final int kind;
        long entity;
        final Record[] parts;
        final Component<?> removed;

        Operation(int kind, long entity, Record[] parts, Component<?> removed) {
            this.kind = kind;
            this.entity = entity;
            this.parts = parts;
            this.removed = removed;
        }

        void make(World world) {
            switch (kind) {
                case 0 -> {
                    entity = spawn(world);
                    assertTrue(everUsed.add(entity), "an id was given twice");
                }
                case 1 -> world.delete(entity);
                case 2 -> world.clear(entity);
                case 3 -> world.add(entity, parts[0]);
                case 4 -> world.set(entity, parts[0]);
                default -> world.remove(entity, removed);
            }
        }

        private long spawn(World world) {
            return switch (parts.length) {
                case 1 -> world.spawn(parts[0]);
                case 2 -> world.spawn(parts[0], parts[1]);
                case 3 -> world.spawn(parts[0], parts[1], parts[2]);
                case 4 -> world.spawn(parts[0], parts[1], parts[2], parts[3]);
                default -> world.spawn(parts);
            };
        }

        void record(Commands commands) {
            switch (kind) {
                case 1 -> commands.delete(entity);
                case 2 -> commands.clear(entity);
                case 3 -> commands.add(entity, parts[0]);
                case 4 -> commands.set(entity, parts[0]);
                default -> commands.remove(entity, removed);
            }
        }

        void model() {
            switch (kind) {
                case 0 -> {
                    Map<Component<?>, Record> has = new LinkedHashMap<>();
                    for (Record part : parts) {
                        has.put(Component.of(part.getClass()), part);
                    }
                    model.put(entity, has);
                }
                case 1 -> {
                    model.remove(entity);
                    dead.add(entity);
                }
                case 2 -> model.get(entity).clear();
                case 3, 4 -> model.get(entity).put(Component.of(parts[0].getClass()), parts[0]);
                default -> model.get(entity).remove(removed);
            }
        }
    }

    private void compareTotals(World world) {
        assertEquals(model.size(), world.entityCount());
    }

    private void compare(World world) {
        compareTotals(world);
        model.forEach((entity, has) -> {
            for (Component<?> kind : KINDS) {
                assertEquals(has.containsKey(kind), world.has(entity, kind));
                if (has.containsKey(kind)) {
                    assertEquals(has.get(kind), world.get(entity, kind));
                }
            }
        });
        for (long entity : dead) {
            assertFalse(world.isAlive(entity));
            assertThrows(DeadEntityException.class, () -> world.delete(entity));
        }
        for (Component<?> kind : KINDS) {
            Set<Long> found = new HashSet<>();
            Query query = world.query(kind);
            for (int i = 0; i < query.chunkCount(); i++) {
                for (int row = 0; row < query.chunk(i).size(); row++) {
                    assertTrue(found.add(query.chunk(i).entity(row)));
                }
            }
            Set<Long> expected = new HashSet<>();
            model.forEach((entity, has) -> {
                if (has.containsKey(kind)) {
                    expected.add(entity);
                }
            });
            assertEquals(expected, found);
        }
    }
}
