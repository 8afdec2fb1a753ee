package dev.cairn.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.StateException;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.hand.Hand;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiConsumer;

/** Runs that are written down with what was done in them come again, and tell where they do not. */
@Tag("compiled")
class RecordingTest {
    private static final double STEP = 1.0 / 60;

    private enum Kind {
        FORCE,
        IMPULSE,
        TELEPORT,
        SPAWN,
        REMOVE,
        GRAB,
        PULL,
        RELEASE
    }

    /** What a user does. */
    private record Act(Kind kind, long entity, double x, double y, double z) {}

    private static final StateCodecs CODECS =
            PhysicsWorld.codecs()
                    .with(
                            StateCodec.of(
                                    Act.class,
                                    "act",
                                    (act, out) -> {
                                        out.writeInt(act.kind.ordinal());
                                        out.writeLong(act.entity);
                                        out.writeDoubles(new double[] {act.x, act.y, act.z});
                                    },
                                    in -> {
                                        Kind kind = Kind.values()[in.readInt()];
                                        long entity = in.readLong();
                                        double[] v = in.readDoubles();
                                        return new Act(kind, entity, v[0], v[1], v[2]);
                                    }));

    /** Does it; the hand is of one run. */
    private static BiConsumer<PhysicsWorld, Act> acts(PhysicsWorld of) {
        Hand hand = new Hand(of);
        return (world, act) -> {
            switch (act.kind) {
                case FORCE -> world.bodyOf(act.entity).applyForce(act.x, act.y, act.z);
                case IMPULSE -> world.bodyOf(act.entity).applyImpulse(act.x, act.y, act.z);
                case TELEPORT -> world.bodyOf(act.entity).teleport(act.x, act.y, act.z);
                case SPAWN ->
                        world.add(Body.dynamic().shape(Sphere.of(0.3)).at(act.x, act.y, act.z));
                case REMOVE -> world.bodyOf(act.entity).remove();
                case GRAB -> {
                    BodyRef body = world.bodyOf(act.entity);
                    hand.grab(body, body.position(new Vector3d()).add(0, 0.1, 0));
                }
                case PULL -> hand.pull(act.x, act.y, act.z);
                case RELEASE -> hand.release();
            }
        };
    }

    private static PhysicsWorld world(int workers, int lanes) {
        return PhysicsWorld.builder()
                .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                .workers(workers)
                .build();
    }

    private static void build(PhysicsWorld world) {
        world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
        BodyRef last = null;
        for (int i = 0; i < 6; i++) {
            Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(0.4)).name("box " + i);
            BodyRef added = world.add(box.at(i % 2, 0.4 + i / 2 * 0.8, 0));
            if (i == 5) {
                world.add(Joint.ball(last, added).at(0.5, 2, 0));
            }
            last = added;
        }
    }

    /** What a user does before a tick. */
    private static List<Act> wishes(PhysicsWorld world, SplittableRandom random, int tick) {
        List<Act> acts = new ArrayList<>();
        List<BodyRef> bodies =
                world.bodies().stream().filter(b -> b.type() == BodyType.DYNAMIC).toList();
        BodyRef any = bodies.get(random.nextInt(bodies.size()));
        double x = random.nextDouble(-1, 1);
        double y = random.nextDouble(0, 2);
        int phase = tick % 240; // the mouse takes a body, drags it in a circle, lets it go
        if (phase == 20) {
            acts.add(new Act(Kind.GRAB, any.entity(), 0, 0, 0));
        } else if (phase > 20 && phase < 120) {
            double angle = 0.05 * phase;
            acts.add(new Act(Kind.PULL, 0, 2 * Math.cos(angle), 2, 2 * Math.sin(angle)));
        } else if (phase == 120) {
            acts.add(new Act(Kind.RELEASE, 0, 0, 0, 0));
        } else if (phase == 140) {
            acts.add(new Act(Kind.TELEPORT, any.entity(), 3 * x, 3, 0));
        } else if (phase == 160) {
            acts.add(new Act(Kind.SPAWN, 0, x, 4, 0));
        } else if (phase == 200 && bodies.size() > 6) {
            acts.add(new Act(Kind.REMOVE, any.entity(), 0, 0, 0));
        }
        if (random.nextInt(10) == 0 && phase != 200) {
            Kind kind = random.nextBoolean() ? Kind.FORCE : Kind.IMPULSE;
            acts.add(new Act(kind, any.entity(), 50 * x, 100 * y, 0));
        }
        return acts;
    }

    private static Recording<Act> record(int ticks, int keyframeTicks, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        try (PhysicsWorld world = world(1, 1)) {
            build(world);
            Recorder<Act> recorder = new Recorder<>(world, acts(world), keyframeTicks);
            for (int tick = 0; tick < ticks; tick++) {
                wishes(world, random, tick).forEach(recorder::input);
                recorder.step(STEP);
            }
            return recorder.recording();
        }
    }

    private static byte[] bytes(Recording<Act> recording) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        recording.writeTo(out, CODECS);
        return out.toByteArray();
    }

    private static Recording<Act> read(byte[] bytes) throws IOException {
        return Recording.read(new ByteArrayInputStream(bytes), CODECS, Act.class);
    }

    private static void comesAgain(int ticks) throws IOException {
        byte[] bytes = bytes(record(ticks, 60, 5));
        Recording<Act> recording = read(bytes);
        assertEquals(ticks, recording.tickCount());
        for (int workers = 1; workers <= 2; workers++) {
            try (PhysicsWorld other = world(workers, 4)) {
                assertNull(new Replay<>(recording, other, acts(other)).run());
                assertEquals(recording.digest(ticks), other.digest());
            }
        }
    }

    @Test
    void aRunWithForcesPullsAndNewBodiesComesAgain() throws IOException {
        comesAgain(1500);
    }

    @Test
    @Tag("soak")
    void tenMinutesComeAgain() throws IOException {
        comesAgain(36_000);
    }

    /** One bit of one input is another one. */
    @Test
    void aFlippedBitIsToldAtTheTickWhereItMatters() throws IOException {
        Recording<Act> recording = record(400, 1, 7);
        int found = 0;
        for (int t = 0; t < recording.tickCount(); t++) {
            List<Act> inputs = new ArrayList<>(recording.inputs(t));
            if (inputs.isEmpty() || inputs.getFirst().kind != Kind.IMPULSE) {
                continue;
            }
            Act act = inputs.getFirst();
            double x = Double.longBitsToDouble(Double.doubleToRawLongBits(act.x) ^ (1L << 40));
            inputs.set(0, new Act(act.kind, act.entity, x, act.y, act.z));
            Recording<Act> bad = read(bytes(with(recording, t, inputs)));
            try (PhysicsWorld world = world(1, 1)) {
                Replay.Mismatch told = new Replay<>(bad, world, acts(world)).run();
                assertNotNull(told, "tick " + t);
                assertEquals(t + 1, told.tick(), told.toString());
                assertEquals(t + 1, told.seenAt());
                assertNotNull(told.body(), told.toString());
                assertTrue(told.column().startsWith("bodies."), told.toString());
            }
            found++;
        }
        assertTrue(found > 3, found + " impulses were tried");
    }

    /**
     * What was seen elsewhere is written down, and a replay tells from where on it was otherwise.
     */
    @Test
    void digestsThatAnotherRunHadAreToldWhereTheyPart() {
        try (PhysicsWorld world = world(1, 1)) {
            build(world);
            Recorder<Act> recorder = new Recorder<>(world, acts(world), 3);
            try (PhysicsWorld seen = world.fork()) {
                BodyRef last = seen.bodies().getLast();
                for (int t = 1; t <= 9; t++) {
                    if (t == 5) {
                        last.applyImpulse(0, 1e-9, 0); // nobody writes this down
                    }
                    seen.step(STEP);
                    assertEquals(t < 5, recorder.step(STEP, seen.digest()), "tick " + t);
                }
            }
            Replay.Mismatch told = new Replay<>(recorder.recording(), world, acts(world)).run();
            assertNotNull(told);
            assertEquals(5, told.tick());
            assertTrue(told.toString().contains("of another run"), told.toString());
        }
    }

    /** Bodies that touch nobody: the one that was pushed is told. */
    @Test
    void theBodyIsToldThatWasPushedOtherwise() {
        try (PhysicsWorld world = world(1, 1)) {
            List<BodyRef> balls = new ArrayList<>();
            for (int i = 0; i < 9; i++) {
                balls.add(world.add(Body.dynamic().shape(Sphere.of(1)).at(5 * i, 0, 0)));
            }
            Recorder<Act> recorder = new Recorder<>(world, acts(world), 4);
            for (int t = 0; t < 36; t++) {
                long entity = balls.get(t % 9).entity();
                recorder.input(new Act(Kind.FORCE, entity, t, 1, 0));
                recorder.step(STEP);
            }
            Recording<Act> recording = recorder.recording();
            for (int t = 0; t < 36; t += 5) {
                Act act = recording.inputs(t).getFirst();
                double y = Double.longBitsToDouble(Double.doubleToRawLongBits(act.y) ^ (1L << 50));
                Act bad = new Act(act.kind, act.entity, act.x, y, act.z);
                Replay.Mismatch told =
                        new Replay<>(with(recording, t, List.of(bad)), world, acts(world)).run();
                assertEquals(t + 1, told.tick());
                assertEquals(4 * (t / 4 + 1), told.seenAt(), "the next keyframe");
                assertEquals(balls.get(t % 9).toString(), told.body());
                String slot = "[" + t % 9 + "]: ";
                assertTrue(told.column().contains(slot), told.toString());
                assertNull(told.contact());
            }
        }
    }

    private static Recording<Act> with(Recording<Act> recording, int tick, List<Act> inputs) {
        List<Recording.Tick<Act>> ticks = new ArrayList<>(recording.ticks());
        Recording.Tick<Act> then = ticks.get(tick);
        ticks.set(
                tick, new Recording.Tick<>(then.stepSeconds(), inputs, then.digest(), then.key()));
        return new Recording<>(recording.state(0), recording.digest(0), ticks);
    }

    @Test
    void seekingGoesToAnyTick() {
        for (int keyframeTicks : new int[] {1, 50}) {
            SplittableRandom random = new SplittableRandom(3);
            try (PhysicsWorld world = world(1, 1)) {
                build(world);
                BiConsumer<PhysicsWorld, Act> acts = acts(world);
                Recorder<Act> recorder = new Recorder<>(world, acts, keyframeTicks);
                for (int tick = 0; tick < 300; tick++) {
                    BodyRef body = world.bodies().get(1 + random.nextInt(6));
                    double x = random.nextDouble(-90, 90);
                    recorder.input(new Act(Kind.FORCE, body.entity(), x, 0, 0));
                    recorder.step(STEP);
                }
                Recording<Act> recording = recorder.recording();
                Replay<Act> replay = new Replay<>(recording, world, acts);
                for (int tick : new int[] {300, 0, 149, 150, 151, 7, 299}) {
                    replay.seek(tick);
                    assertEquals(tick, replay.tick());
                    assertEquals(recording.digest(tick), world.digest(), "tick " + tick);
                }
                replay.seek(123);
                assertNull(replay.run());
                assertFalse(replay.step());
            }
        }
    }

    @Test
    void damagedRecordingsAreRefused() throws IOException {
        byte[] whole = bytes(record(30, 7, 2));
        SplittableRandom random = new SplittableRandom(9);
        for (int i = 0; i < 500; i++) {
            byte[] bad = whole.clone();
            bad[random.nextInt(random.nextBoolean() ? bad.length : 40)] ^=
                    (byte) (1 << random.nextInt(8));
            byte[] cut = Arrays.copyOf(bad, random.nextInt(bad.length));
            for (byte[] each : List.of(bad, cut)) {
                StateException told = assertThrows(StateException.class, () -> read(each));
                assertTrue(told.getMessage().length() > 20, told.getMessage());
            }
        }
    }
}
