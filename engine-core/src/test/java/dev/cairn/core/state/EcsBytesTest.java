package dev.cairn.core.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** A world of entities alone, as bytes: components need to be named and no more. */
class EcsBytesTest {
    enum Mood {
        CALM,
        WILD
    }

    record Home(double x, double y, String street) {}

    record Animal(String name, Mood mood, Home home, int[] legs, byte age) {}

    record Owner(Object anything) {}

    private static final Component<Animal> ANIMAL = Component.of(Animal.class);
    private static final Component<Owner> OWNER = Component.of(Owner.class);
    private static final StateCodecs CODECS = World.codecs(ANIMAL);

    /** Animals are born and age; their names say when. */
    private record Farm() implements WorldSystem {
        @Override
        public void describe(Access access) {
            access.out(ANIMAL).commands();
        }

        @Override
        public void run(Tick tick) {
            for (int c = 0; c < tick.chunkCount(); c++) {
                int[] age = tick.chunk(c).out(ANIMAL.intField("age"));
                for (int row = 0; row < tick.chunk(c).size(); row++) {
                    age[row]++;
                    long entity = tick.chunk(c).entity(row);
                    if (tick.random(entity, 1).nextInt(4) == 0) {
                        tick.commands().spawn(animal(tick.random(entity, 2).nextInt(1000)));
                    } else if (age[row] > 9) {
                        tick.commands().delete(entity);
                    }
                }
            }
        }
    }

    private static Animal animal(int number) {
        return new Animal(
                number % 7 == 0 ? null : "animal " + number,
                number % 3 == 0 ? Mood.WILD : Mood.CALM,
                number % 5 == 0 ? null : new Home(number, -number, "street " + number % 9),
                new int[] {number, 4},
                (byte) 0);
    }

    private static World world(int workers) {
        return World.builder().systems(new Farm()).workers(workers).seed(3).build();
    }

    private static byte[] bytes(WorldState state) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        state.writeTo(out, CODECS);
        return out.toByteArray();
    }

    private static WorldState read(byte[] bytes) throws IOException {
        return WorldState.read(new ByteArrayInputStream(bytes), CODECS);
    }

    @Test
    void aWorldComesBackFromBytesAndGoesOn() throws IOException {
        try (World world = world(1);
                World other = world(2)) {
            for (int i = 0; i < 100; i++) {
                world.spawn(animal(i));
            }
            for (int i = 0; i < 5; i++) {
                world.step(1);
            }
            byte[] bytes = bytes(world.save());
            other.restore(read(bytes));
            assertArrayEquals(bytes, bytes(other.save()), "written again");
            List<Long> entities = new ArrayList<>();
            world.query(ANIMAL).forEach(entities::add);
            assertTrue(entities.size() > 100);
            for (long entity : entities) {
                Animal one = world.get(entity, ANIMAL);
                Animal two = other.get(entity, ANIMAL);
                assertEquals(one.home(), two.home());
                assertEquals(one.mood(), two.mood());
                assertArrayEquals(one.legs(), two.legs());
            }
            for (int tick = 0; tick < 20; tick++) {
                assertEquals(world.digest(), other.digest(), "tick " + tick);
                world.step(1);
                other.step(1);
            }
        }
    }

    /** Another version of the component is told by name; the world is as it was. */
    @Test
    void anotherVersionIsTold() throws IOException {
        try (World world = world(1)) {
            world.spawn(animal(1));
            byte[] bytes = bytes(world.save());
            byte[] other = bytes.clone();
            String text = new String(bytes, StandardCharsets.ISO_8859_1);
            other[text.indexOf("legs:int[]")] = 'p'; // it had pegs
            RecordCodecTest.sign(other);
            StateException refusal = assertThrows(StateException.class, () -> read(other));
            assertTrue(refusal.getMessage().contains("Animal"), refusal.getMessage());
            assertTrue(refusal.getMessage().contains("'pegs' (int[])"), refusal.getMessage());
            StateException unknown =
                    assertThrows(
                            StateException.class,
                            () ->
                                    WorldState.read(
                                            new ByteArrayInputStream(bytes), World.codecs(OWNER)));
            assertTrue(unknown.getMessage().contains("Animal"), unknown.getMessage());
        }
    }

    @Test
    void whatHasNoCodecIsRefusedByTheNameOfItsField() {
        try (World world = world(1)) {
            world.spawn(new Owner(new Thread()));
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            StateException refusal =
                    assertThrows(
                            StateException.class,
                            () -> world.save().writeTo(out, World.codecs(OWNER)));
            assertTrue(refusal.getMessage().contains("anything"), refusal.getMessage());
            assertTrue(refusal.getMessage().contains("java.lang.Thread"), refusal.getMessage());
        }
    }

    /** Bytes with sums made to fit: refused with a message and nothing changed, or a world. */
    @Test
    void damagedBytesLeaveTheWorld() throws IOException {
        long seed = 29_05;
        SplittableRandom random = new SplittableRandom(seed);
        try (World world = world(1)) {
            for (int i = 0; i < 8; i++) {
                world.spawn(animal(i));
            }
            WorldState good = world.save();
            long digest = world.digest();
            byte[] bytes = bytes(good);
            int refused = 0;
            for (int i = 0; i < 3000; i++) {
                byte[] bad = bytes.clone();
                for (int n = random.nextInt(1, 3); n > 0; n--) {
                    bad[random.nextInt(16, bad.length - 8)] = (byte) random.nextInt();
                }
                RecordCodecTest.sign(bad);
                try {
                    world.restore(read(bad));
                    world.restore(good);
                } catch (StateException refusal) {
                    assertTrue(refusal.getMessage().length() > 20, refusal.getMessage());
                    refused++;
                }
                assertEquals(digest, world.digest(), "seed " + seed + " mutation " + i);
            }
            assertTrue(refused > 1000, refused + " refused");
        }
    }
}
