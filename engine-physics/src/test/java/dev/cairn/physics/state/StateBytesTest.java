package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.StateException;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import java.util.zip.CRC32C;

/** A state as bytes: it comes back whole, or is refused with a reason. */
class StateBytesTest {
    record Wind(float x, String from) {}

    private static final StateCodecs CODECS = PhysicsWorld.codecs(Component.of(Wind.class));

    /** All shapes, several colliders, joints, filters, names, a component with a text. */
    private static PhysicsWorld world() {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        world.add(Body.fixed().shape(HalfSpace.of()));
        double[] corners = {-9, 0.2, -9, -9, 0.1, 9, 9, 0.1, 9, 9, 0.3, -9};
        world.add(Body.fixed().shape(TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3})));
        double[] points = new double[60];
        SplittableRandom random = new SplittableRandom(3);
        Arrays.setAll(points, i -> random.nextDouble(-0.5, 0.5));
        ConvexHull hull = ConvexHull.of(points);
        Shape turned = Cone.of(0.4, 0.5).moved(0.1, 0, 0, new Quaterniond().rotateX(1));
        Shape[] shapes = {
            Sphere.of(0.5),
            Box.ofHalfExtents(0.5, 0.4, 0.3),
            Capsule.of(0.3, 0.4),
            Cylinder.of(0.4, 0.3),
            Cone.of(0.5, 0.5),
            hull,
            turned,
            hull
        };
        BodyRef last = null;
        for (int i = 0; i < 24; i++) {
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(shapes[i % shapes.length])
                                    .name("body " + i)
                                    .filter(new Filter(1 + i % 2, -1))
                                    .with(new Wind(i, "west"))
                                    .at(i % 4 * 0.8, 1 + i / 4 * 0.9, i % 3 * 0.1));
            if (i % 8 == 7 && last != null) {
                world.add(Joint.hinge(last, body).at(0, 2, 0).axis(0, 0, 1).limits(-1, 1));
            }
            last = body;
        }
        world.add(
                Body.dynamic()
                        .collider(Collider.of(Box.cubeOfHalfExtent(0.3)))
                        .collider(Collider.of(hull).at(0.5, 0, 0))
                        .at(-2, 1, 0));
        for (int tick = 0; tick < 40; tick++) {
            world.step(1.0 / 60);
        }
        return world;
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
    void bytesComeBackAsTheSameWorld() throws IOException {
        try (PhysicsWorld world = world();
                PhysicsWorld other = PhysicsWorld.builder().workers(2).build()) {
            byte[] bytes = bytes(world.save());
            WorldState state = read(bytes);
            assertTrue(state.isRead());
            other.restore(state);
            assertArrayEquals(bytes, bytes(other.save()), "written again");
            BodyRef twin = other.bodyOf(world.bodies().get(3).entity());
            assertNotNull(twin);
            assertEquals(world.bodies().get(3).name(), twin.name());
            assertEquals(world.bodies().get(3).shape().toString(), twin.shape().toString());
            assertEquals(
                    new Wind(1, "west"), other.ecs().get(twin.entity(), Component.of(Wind.class)));
            assertEquals(world.joints().count(), other.joints().count());
            for (int tick = 0; tick < 60; tick++) {
                assertEquals(world.digest(), other.digest(), "tick " + tick);
                assertEquals(world.ecs().digest(), other.ecs().digest(), "tick " + tick);
                world.step(1.0 / 60);
                other.step(1.0 / 60);
            }
        }
    }

    enum Side {
        LEFT,
        RIGHT
    }

    record Mark(Side side, Wind wind, double[] numbers) {}

    /** Objects in columns need no codec where their class says how. */
    @Test
    void componentsOfRecordsNeedOnlyBeNamed() throws IOException {
        Component<Mark> marks = Component.of(Mark.class);
        StateCodecs codecs = PhysicsWorld.codecs(marks);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
                PhysicsWorld other = PhysicsWorld.builder().workers(1).build()) {
            Mark mark = new Mark(Side.RIGHT, new Wind(2, "east"), new double[] {1, -0.0});
            BodyRef body = world.add(Body.dynamic().shape(Sphere.of(1)).with(mark));
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            world.save().writeTo(out, codecs);
            other.restore(WorldState.read(new ByteArrayInputStream(out.toByteArray()), codecs));
            Mark twin = other.ecs().get(body.entity(), marks);
            assertEquals(mark.side(), twin.side());
            assertEquals(mark.wind(), twin.wind());
            assertArrayEquals(mark.numbers(), twin.numbers());
            assertEquals(world.digest(), other.digest());
        }
    }

    /** Flipped, cut, shifted and put in: refused with a reason, or the same state. */
    @Test
    void damagedBytesAreRefused() throws IOException {
        fuzz(100_000, 29, false);
    }

    /** With sums made anew, as by somebody who means it: what stands behind them is read. */
    @Test
    void forgedBytesAreRefusedOrAState() throws IOException {
        fuzz(20_000, 32, true);
    }

    private static void fuzz(int mutations, long seed, boolean forged) throws IOException {
        SplittableRandom random = new SplittableRandom(seed);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        try (PhysicsWorld small = PhysicsWorld.builder().workers(1).build();
                PhysicsWorld other = PhysicsWorld.builder().workers(1).build()) {
            BodyRef a = small.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).name("a"));
            BodyRef b = small.add(Body.dynamic().shape(Sphere.of(0.5)).at(0.9, 0, 0));
            small.add(Joint.ball(a, b).at(0.5, 0, 0));
            small.step(1.0 / 60);
            byte[] whole = bytes(small.save());
            long digest = small.digest();
            int refused = 0;
            for (int i = 0; i < mutations; i++) {
                byte[] bad = mutate(whole, random);
                if (forged) {
                    sign(bad);
                }
                String what = "seed " + seed + ", mutation " + i;
                long before = threads.getCurrentThreadAllocatedBytes();
                try {
                    WorldState read = read(bad);
                    other.restore(read);
                    if (!forged) {
                        assertArrayEquals(whole, bytes(read), what);
                        assertEquals(digest, other.digest(), what);
                    }
                } catch (StateException told) {
                    refused++;
                    assertTrue(told.getMessage().length() > 20, what + ": " + told.getMessage());
                }
                long took = threads.getCurrentThreadAllocatedBytes() - before;
                assertTrue(
                        took < (forged ? 64_000_000 : 4_000_000) + 40L * whole.length,
                        what + " takes " + took);
            }
            assertTrue(refused > mutations / 10, refused + " were refused");
        }
    }

    /** Puts the right sums to bytes of the length that they tell. */
    static void sign(byte[] bytes) {
        if (bytes.length < 24) {
            return;
        }
        ByteBuffer view = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        int length = bytes.length - 24;
        view.putLong(8, length);
        CRC32C first = new CRC32C();
        first.update(bytes, 16, length);
        CRC32 second = new CRC32();
        second.update(bytes, 16, length);
        view.putLong(16 + length, first.getValue() << 32 | second.getValue());
    }

    static byte[] mutate(byte[] whole, SplittableRandom random) {
        byte[] bad = whole.clone();
        int at = random.nextInt(random.nextBoolean() ? whole.length : 64);
        switch (random.nextInt(5)) {
            case 0 -> bad[at] ^= (byte) (1 << random.nextInt(8));
            case 1 -> bad[at] = (byte) random.nextInt(256);
            case 2 -> bad = Arrays.copyOf(whole, at);
            case 3 -> System.arraycopy(whole, at, bad, Math.max(0, at - 4), whole.length - at);
            default -> {
                for (int k = at; k < Math.min(bad.length, at + 8); k++) {
                    bad[k] = (byte) (random.nextBoolean() ? -1 : 0);
                }
            }
        }
        return bad;
    }

    @Test
    void whatCannotBeWrittenIsNamed() throws IOException {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(1)));
            ball.setUserData(new StringBuilder("mine"));
            StateException refusal = assertThrows(StateException.class, () -> bytes(world.save()));
            assertEquals(
                    "references.userData: the state holds an object of java.lang.StringBuilder, and"
                            + " there is no codec that writes it; add one by StateCodecs.with(..)",
                    refusal.getMessage());
            StateCodecs mine =
                    CODECS.with(
                            StateCodec.of(
                                    StringBuilder.class,
                                    "builder",
                                    (b, out) -> out.writeString(b.toString()),
                                    in -> new StringBuilder(in.readString())));
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            world.save().writeTo(out, mine);
            byte[] bytes = out.toByteArray();
            StateException unread = assertThrows(StateException.class, () -> read(bytes));
            assertTrue(unread.getMessage().contains("'builder'"), unread.getMessage());
            world.restore(WorldState.read(new ByteArrayInputStream(bytes), mine));
            assertEquals("mine", String.valueOf(ball.userData()));
            assertNull(world.bodyOf(99));
        }
    }

    @Test
    void bytesOfAnotherKindOfWorldChangeNothing() throws IOException {
        try (PhysicsWorld world = world()) {
            WorldState ecsOnly = read(bytes(world.ecs().save()));
            long before = world.digest();
            assertThrows(StateException.class, () -> world.restore(ecsOnly));
            assertEquals(before, world.digest());
            world.step(1.0 / 60);
        }
        assertThrows(
                StateException.class,
                () -> read("no state at all, but text".getBytes(StandardCharsets.UTF_8)));
    }
}
