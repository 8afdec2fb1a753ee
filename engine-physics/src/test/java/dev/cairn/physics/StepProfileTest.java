package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.profile.SystemProfile;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.profile.StepProfile;
import dev.cairn.physics.profile.StepStage;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** What a step cost can be read, by program and by a recording of the Flight Recorder. */
class StepProfileTest {
    private static final double STEP = 1.0 / 60;

    private static PhysicsWorld stack() {
        PhysicsWorld world = Scenes.awake().gravity(0, -9.81, 0).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(5, 1, 5)).at(0, -1, 0));
        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 1.5, 0));
        return world;
    }

    private static void step(PhysicsWorld world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(STEP);
        }
    }

    @Test
    void timesOnlyWhatIsAskedFor() {
        try (PhysicsWorld world = stack()) {
            StepProfile profile = world.profile();
            step(world, 3);
            assertEquals(0, profile.steps());
            profile.enable();
            step(world, 5);
            profile.disable();
            step(world, 2);
            assertEquals(5, profile.steps());
            long sum = 0;
            double mean = 0;
            for (StepStage stage : StepStage.values()) {
                assertTrue(profile.lastNanos(stage) >= 0, stage.name());
                sum += profile.lastNanos(stage);
                mean += profile.meanSeconds(stage);
            }
            assertTrue(sum > 0 && mean > 0, sum + " ns, " + mean + " s");
            profile.reset();
            assertEquals(0, profile.steps());
            assertEquals(0, profile.meanSeconds(StepStage.SOLVE));
        }
    }

    /** Each system's work, the physics' among it; the stages are parts of the latter. */
    @Test
    void tellsTheTimeOfEachSystem() {
        ChunkSystem still =
                new ChunkSystem() {
                    @Override
                    public String name() {
                        return "still";
                    }

                    @Override
                    public void describe(Access access) {
                        access.in(Pose.COMPONENT);
                    }

                    @Override
                    public void run(Chunk chunk, Tick tick) {}
                };
        for (int workers = 1; workers <= 2; workers++) {
            try (PhysicsWorld world =
                    PhysicsWorld.builder().workers(workers).systems(still).build()) {
                world.add(Body.dynamic().shape(Box.cubeOfEdge(1)));
                SystemProfile systems = world.profile().systems();
                assertEquals(2, systems.count());
                assertEquals("still", systems.name(0));
                assertEquals(PhysicsWorld.SYSTEM, systems.name(1));
                step(world, 2);
                assertEquals(0, systems.ticks());
                assertEquals(0, systems.lastNanos(1));
                world.profile().enable();
                step(world, 3);
                long stages = 0;
                for (StepStage stage : StepStage.values()) {
                    stages += world.profile().lastNanos(stage);
                }
                assertEquals(3, systems.ticks());
                assertTrue(systems.lastNanos(0) > 0);
                assertTrue(systems.lastNanos(1) >= stages, systems.lastNanos(1) + " " + stages);
                assertTrue(systems.meanSeconds(1) > 0);
                world.ecs().schedule().setEnabled("still", false);
                step(world, 1);
                assertEquals(0, systems.lastNanos(0));
                world.profile().disable();
                world.profile().reset();
                step(world, 1);
                assertEquals(0, systems.ticks());
                assertEquals(0, systems.meanSeconds(1));
            }
        }
    }

    @Test
    void theClockDoesNotChangeTheBits() {
        try (PhysicsWorld plain = stack();
                PhysicsWorld timed = stack()) {
            timed.profile().enable();
            step(plain, 30);
            step(timed, 30);
            assertEquals(plain.digest(), timed.digest());
        }
    }

    @Test
    void aRecordingHasOneEventForEachStep(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("steps.jfr");
        try (PhysicsWorld world = stack();
                Recording recording = new Recording()) {
            step(world, 4);
            recording.enable("dev.cairn.PhysicsStep").withoutThreshold();
            recording.start();
            step(world, 7);
            recording.stop();
            recording.dump(file);
        }
        List<RecordedEvent> events =
                RecordingFile.readAllEvents(file).stream()
                        .filter(e -> e.getEventType().getName().equals("dev.cairn.PhysicsStep"))
                        .toList();
        assertEquals(7, events.size());
        for (RecordedEvent event : events) {
            assertEquals(3, event.getInt("bodies"));
            assertEquals(2, event.getInt("contacts"));
            assertTrue(event.getDuration("solve").toNanos() > 0, event.toString());
        }
    }
}
