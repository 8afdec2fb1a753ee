package dev.cairn.core.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Entities with all components, as a value. */
class EcsStateTest {
    record Place(double x, int cell) {}

    record Name(String text) {}

    record Heat(float kelvin, long stamp, boolean on) {}

    private static final Component<Place> PLACE = Component.of(Place.class);
    private static final Component<Name> NAME = Component.of(Name.class);
    private static final Component<Heat> HEAT = Component.of(Heat.class);

    /** Entities come and go by the random stream of the tick. */
    private static final class Life implements WorldSystem {
        @Override
        public String name() {
            return "life";
        }

        @Override
        public void describe(Access access) {
            access.out(PLACE).commands();
        }

        @Override
        public void run(Tick tick) {
            for (int c = 0; c < tick.chunkCount(); c++) {
                double[] x = tick.chunk(c).out(PLACE.doubleField("x"));
                for (int row = 0; row < tick.chunk(c).size(); row++) {
                    long entity = tick.chunk(c).entity(row);
                    x[row] += tick.random(entity, 1).nextDouble();
                    int fate = tick.random(entity, 2).nextInt(10);
                    if (fate == 0) {
                        tick.commands().delete(entity);
                    } else if (fate == 1) {
                        tick.commands().spawn(new Place(x[row], fate), new Name("t" + fate));
                    } else if (fate == 2) {
                        tick.commands().add(entity, new Heat(2, tick.number(), true));
                    }
                }
            }
        }
    }

    private static World world() {
        return World.builder().systems(new Life()).workers(1).seed(7).build();
    }

    private static List<Long> future(World world, int ticks) {
        List<Long> digests = new ArrayList<>();
        for (int i = 0; i < ticks; i++) {
            world.step(0.1);
            digests.add(world.digest());
        }
        return digests;
    }

    @Test
    void aWorldGoesOnAsItDid() {
        try (World world = world();
                World other = world()) {
            for (int i = 0; i < 300; i++) {
                world.spawn(new Place(i, i), new Name("n" + i));
            }
            future(world, 5);
            WorldState state = world.save();
            List<Long> one = future(world, 30);
            world.restore(state);
            assertEquals(one, future(world, 30));
            other.restore(state);
            assertEquals(one, future(other, 30));
            assertNull(world.save().difference(other.save()));
        }
    }

    /** Tables that came after the state was saved were never there: their order is of the state. */
    @Test
    void tablesComeInTheOrderOfTheirOwnPast() {
        try (World world = world();
                World other = world()) {
            long kept = world.spawn(new Place(1, 1));
            Query places = world.query(PLACE);
            assertEquals(1, places.entityCount());
            WorldState state = world.save();
            world.spawn(new Heat(1, 1, false));
            world.spawn(new Place(3, 3), new Heat(2, 2, true));
            long gone = world.spawn(new Place(2, 2), new Name("gone"));
            assertEquals(3, places.entityCount());
            world.restore(state);
            assertEquals(1, places.entityCount());
            assertFalse(world.isAlive(gone));
            other.restore(state);
            for (World each : List.of(world, other)) {
                each.spawn(new Place(4, 4), new Name("four"));
                each.spawn(new Place(5, 5), new Heat(5, 5, true));
                each.add(kept, new Name("kept"));
            }
            assertEquals(world.digest(), other.digest());
            assertEquals(3, places.entityCount());
            assertEquals(new Name("kept"), world.get(kept, NAME));
            assertEquals(future(world, 10), future(other, 10));
        }
    }

    /** Against a model: what a world held is what it holds again, after any changes. */
    @Test
    void randomChangesAreTakenBack() {
        long seed = 20_26;
        SplittableRandom random = new SplittableRandom(seed);
        try (World world = world()) {
            List<WorldState> states = new ArrayList<>();
            List<Long> digests = new ArrayList<>();
            List<Long> entities = new ArrayList<>();
            for (int i = 0; i < 3000; i++) {
                if (random.nextInt(50) == 0) {
                    states.add(world.save());
                    digests.add(world.digest());
                }
                if (random.nextInt(60) == 0 && !states.isEmpty()) {
                    int at = random.nextInt(states.size());
                    world.restore(states.get(at));
                    assertEquals(digests.get(at), world.digest(), "seed " + seed + " change " + i);
                    entities.removeIf(entity -> !world.isAlive(entity));
                }
                change(world, entities, random);
            }
        }
    }

    private static void change(World world, List<Long> entities, SplittableRandom random) {
        int what = entities.isEmpty() ? 0 : random.nextInt(6);
        long entity = what == 0 ? 0 : entities.get(random.nextInt(entities.size()));
        switch (what) {
            case 0 -> entities.add(world.spawn(new Place(random.nextDouble(), what)));
            case 1 -> {
                world.delete(entity);
                entities.remove((Object) entity);
            }
            case 2 -> {
                if (!world.has(entity, HEAT)) {
                    world.add(entity, new Heat(1, random.nextLong(), true));
                }
            }
            case 3 -> {
                if (world.has(entity, HEAT)) {
                    world.remove(entity, HEAT);
                }
            }
            case 4 -> world.clear(entity);
            default -> {
                if (!world.has(entity, NAME)) {
                    world.add(entity, new Name("n" + random.nextInt(9)));
                }
            }
        }
    }

    @Test
    void aStateOfSomethingElseIsRefused() {
        try (World world = world()) {
            WorldState other = new WorldState();
            other.save(s -> s.value("length", 3));
            StateException refusal = assertThrows(StateException.class, () -> world.restore(other));
            assertTrue(refusal.getMessage().contains("another kind"), refusal.getMessage());
        }
    }

    @Test
    void arraysComeBackShorterAndLonger() {
        int[][] field = {{1, 2, 3, 4}};
        int[] count = {4};
        Stateful store =
                s -> {
                    count[0] = s.value("count", count[0]);
                    field[0] = s.array("numbers", field[0], count[0]);
                };
        WorldState four = new WorldState();
        four.save(store);
        count[0] = 2;
        WorldState two = new WorldState();
        two.save(store);
        two.restore(store);
        assertEquals(List.of(1, 2, 0, 0), list(field[0]), "what is behind is cleared");
        field[0] = new int[1];
        four.restore(store);
        assertEquals(List.of(1, 2, 3, 4), list(field[0]));
        assertEquals("count: 4 and 2", four.difference(two));
    }

    private static List<Integer> list(int[] numbers) {
        List<Integer> list = new ArrayList<>();
        for (int number : numbers) {
            list.add(number);
        }
        return list;
    }
}
