package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.storage.Hash;
import dev.cairn.core.job.Jobs;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;

/** What observers are told, beside a model that knows nothing else. */
class ObserverModelTest {
    /** Keeps the set of all values by what it is told only, and checks each step of it. */
    private static final class Mirror<T extends Record> implements Observer<T> {
        final Component<T> component;
        final Map<Long, Record> values = new TreeMap<>();
        long order;

        Mirror(Component<T> component) {
            this.component = component;
        }

        private void note(int what, Change<T> change) {
            order = Hash.mix(Hash.mix(order, what), change.entity());
            order = Hash.mix(order, change.value().toString().hashCode());
            assertEquals(change.world().get(change.entity(), component), change.value());
        }

        @Override
        public void added(Change<T> change) {
            note(1, change);
            assertEquals(null, values.put(change.entity(), change.value()), "added once");
        }

        @Override
        public void set(Change<T> change) {
            note(2, change);
            assertEquals(change.previous(), values.put(change.entity(), change.value()));
        }

        @Override
        public void removed(Change<T> change) {
            note(3, change);
            assertEquals(change.value(), values.remove(change.entity()), "the last value");
        }

        void check(World world, String when) {
            Map<Long, Record> found = new TreeMap<>();
            world.query(component).forEach(e -> found.put(e, world.get(e, component)));
            assertEquals(found, values, when);
        }
    }

    private static Record part(SplittableRandom random, int kind) {
        double x = random.nextInt(100);
        return switch (kind) {
            case 0 -> new Position(x, -x);
            case 1 -> new Force((float) x);
            case 2 -> new Tag();
            default ->
                    new Mixed(x, 1, 2, 3, true, (byte) 4, (short) 5, 'c', "t" + random.nextInt(9));
        };
    }

    private static Component<?> key(int kind) {
        return kind == 0 ? POSITION : kind == 1 ? FORCE : kind == 2 ? TAG : MIXED;
    }

    /** Any command on an entity, by the numbers of the tick. */
    private static void any(Commands commands, long entity, SplittableRandom random) {
        switch (random.nextInt(9)) {
            case 0 -> commands.delete(entity);
            case 1 -> commands.clear(entity);
            case 2, 3 -> commands.add(entity, part(random, random.nextInt(4)));
            case 4 -> commands.remove(entity, key(random.nextInt(4)));
            case 5, 6 -> {
                long child = commands.spawn(part(random, 0), part(random, 3));
                commands.set(child, part(random, 3));
            }
            default -> commands.set(entity, part(random, random.nextInt(4)));
        }
    }

    private static EcsSystem life(long seed) {
        return chunks(
                "life",
                a -> a.commands(),
                (chunk, tick) -> {
                    for (int row = 0; row < chunk.size(); row++) {
                        long entity = chunk.entity(row);
                        SplittableRandom random =
                                new SplittableRandom(seed ^ tick.number() * 31 ^ entity * 77);
                        if (random.nextInt(3) == 0) {
                            any(tick.commands(), entity, random);
                        }
                    }
                });
    }

    /**
     * What observers were told adds up to what a walk over the world finds, tick by tick, whatever
     * was changed by commands and directly; in the same order for any number of workers.
     */
    @Test
    void whatIsToldIsWhatIsThere() {
        long seed = 29_11;
        List<Long> expected = new ArrayList<>();
        for (int workers : new int[] {1, 2, 3, 4}) {
            try (Jobs jobs = Jobs.perturbed(workers, seed + workers);
                    World world = World.builder().systems(life(seed)).jobs(jobs).build()) {
                List<Mirror<?>> mirrors = new ArrayList<>();
                mirror(world, mirrors, POSITION);
                mirror(world, mirrors, FORCE);
                mirror(world, mirrors, TAG);
                mirror(world, mirrors, MIXED);
                SplittableRandom random = new SplittableRandom(seed);
                List<Long> seen = new ArrayList<>();
                for (int tick = 0; tick < 40; tick++) {
                    direct(world, random);
                    world.step(1);
                    for (Mirror<?> mirror : mirrors) {
                        mirror.check(world, "seed " + seed + " tick " + tick);
                        seen.add(mirror.order);
                    }
                    seen.add(world.digest());
                }
                assertTrue(world.entityCount() > 2000, "entities: " + world.entityCount());
                if (expected.isEmpty()) {
                    expected.addAll(seen);
                }
                assertEquals(expected, seen, workers + " workers, seed " + seed);
            }
        }
    }

    private static <T extends Record> void mirror(
            World world, List<Mirror<?>> all, Component<T> component) {
        Mirror<T> mirror = new Mirror<>(component);
        world.observe(component, mirror);
        all.add(mirror);
    }

    private static void direct(World world, SplittableRandom random) {
        long[] many = world.spawnMany(100, part(random, 0), part(random, 2));
        long one = world.spawn(part(random, 1));
        long two = world.spawn(part(random, 1), part(random, 3));
        world.spawn(part(random, 0), part(random, 1), part(random, 2));
        world.spawn();
        world.add(one, part(random, 2));
        world.set(two, part(random, 3));
        world.remove(two, FORCE);
        world.clear(many[0]);
        world.delete(many[1]);
    }
}
