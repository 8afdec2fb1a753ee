package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;

/** The two threads of an application. Every wait is for a condition. */
@Timeout(60)
class SimulationTest {
    /** One ball that flies and is never stopped. */
    private static class Flight implements Simulation.Host {
        final AtomicInteger updates = new AtomicInteger();

        @Override
        public PhysicsWorld createPhysics() {
            return PhysicsWorld.builder().workers(1).build();
        }

        @Override
        public void begin(PhysicsWorld physics) {
            Sphere ball = Sphere.of(0.5);
            physics.add(
                    Body.dynamic().shape(ball).velocity(0, 2, 0).with(new Visual(Model.of(ball))));
        }

        @Override
        public void update(double seconds) {
            updates.incrementAndGet();
        }
    }

    private static void await(BooleanSupplier condition) {
        long deadline = System.nanoTime() + 50_000_000_000L;
        while (!condition.getAsBoolean()) {
            assertTrue(System.nanoTime() < deadline, "waited in vain");
            Thread.yield();
        }
    }

    @Test
    void pauseStopsThePhysicsButNotTheFrames() {
        GlTests.require();
        Flight flight = new Flight();
        Simulation simulation = new Simulation(flight, 1.0 / 240, -1);
        try (Offscreen view = Offscreen.open(64, 36)) {
            simulation.start();
            Camera camera = new Camera().lookAt(0, 0, 40, 0, 0, 0);
            long last = -1;
            while (simulation.ticks() < 20) {
                PoseSnapshot snapshot = simulation.exchange().latest();
                assertTrue(snapshot.tick() >= last, "snapshots never go back");
                last = snapshot.tick();
                view.draw(snapshot, 1, camera, Light.DAYLIGHT);
            }
            simulation.setPaused(true);
            // Two ticks after the request everything stands.
            long asked = simulation.ticks();
            await(() -> simulation.exchange().latest().tick() >= asked + 2);
            PoseSnapshot still = simulation.exchange().latest();
            double[] pose = Arrays.copyOf(still.current(), 7);
            assertArrayEquals(pose, Arrays.copyOf(still.previous(), 7));
            int updates = flight.updates.get();
            view.draw(still, 1, camera, Light.DAYLIGHT);
            Picture before = view.picture();
            int uploads = view.uploads();
            // Frames and ticks of the rest of the world go on.
            while (view.uploads() < uploads + 10) {
                view.draw(simulation.exchange().latest(), 0.5, camera, Light.DAYLIGHT);
            }
            assertArrayEquals(before.argb(), view.picture().argb());
            assertArrayEquals(pose, Arrays.copyOf(simulation.exchange().latest().current(), 7));
            assertEquals(updates, flight.updates.get());
            // The camera still moves.
            camera.fly(10, 3, 0);
            view.draw(simulation.exchange().latest(), 1, camera, Light.DAYLIGHT);
            assertFalse(Arrays.equals(before.argb(), view.picture().argb()));
            // One step is one step.
            simulation.singleStep();
            await(() -> flight.updates.get() == updates + 1);
            long stepped = simulation.ticks();
            await(() -> simulation.exchange().latest().tick() >= stepped + 2);
            double[] moved = Arrays.copyOf(simulation.exchange().latest().current(), 7);
            assertNotEquals(pose[1], moved[1]);
            assertEquals(updates + 1, flight.updates.get());
            simulation.setPaused(false);
            await(() -> flight.updates.get() > updates + 10);
        } finally {
            simulation.stop();
        }
        assertTrue(simulation.isOver());
        simulation.rethrow();
    }

    @Test
    void actionsRunOnTheSimulationThreadAlsoDuringAPause() {
        Simulation simulation = new Simulation(new Flight(), 1.0 / 240, -1);
        simulation.start();
        simulation.setPaused(true);
        String[] name = new String[1];
        AtomicInteger ran = new AtomicInteger();
        simulation.post(() -> name[0] = Thread.currentThread().getName());
        simulation.post(ran::incrementAndGet);
        await(() -> ran.get() == 1);
        assertEquals("cairn-simulation", name[0]);
        simulation.stop();
        assertTrue(simulation.isOver());
    }

    /** The first world fails at its fifth tick; what throws in its place is asked for. */
    @Test
    void aWorldThatFailsIsMadeAnewIfTheSceneSaysSo() throws InterruptedException {
        for (boolean goesOn : new boolean[] {true, false}) {
            AtomicInteger worlds = new AtomicInteger();
            Flight flight =
                    new Flight() {
                        @Override
                        public PhysicsWorld createPhysics() {
                            worlds.incrementAndGet();
                            return super.createPhysics();
                        }

                        @Override
                        public void update(double seconds) {
                            if (updates.incrementAndGet() == 5) {
                                throw new IllegalStateException("the fifth");
                            }
                        }

                        @Override
                        public boolean beginsAgainAfter(RuntimeException failure) {
                            assertEquals("the fifth", failure.getMessage());
                            return goesOn;
                        }
                    };
            Simulation simulation = new Simulation(flight, 1.0 / 240, -1);
            simulation.start();
            if (goesOn) {
                await(() -> flight.updates.get() > 20 || simulation.isOver());
                simulation.stop();
                simulation.rethrow();
                assertEquals(2, worlds.get());
            } else {
                simulation.await();
                assertThrows(IllegalStateException.class, simulation::rethrow);
                assertEquals(1, worlds.get());
            }
        }
    }

    @Test
    void headlessRunDoesExactlyTheTicksAskedFor() throws InterruptedException {
        Flight flight = new Flight();
        Simulation simulation = new Simulation(flight, 1.0 / 60, 90);
        simulation.start();
        simulation.await();
        simulation.rethrow();
        assertEquals(90, simulation.ticks());
        assertEquals(90, flight.updates.get());
        // The parabola of a body without contacts, at t = 1.5 s.
        assertEquals(
                2 * 1.5 - 0.5 * 9.81 * 2.25, simulation.exchange().latest().current()[1], 1e-9);
    }

    /** A pile that falls together, and its digest after each tick. */
    private static final class Pile implements Simulation.Host {
        private PhysicsWorld world;
        private volatile long digest;
        private final AtomicInteger begun = new AtomicInteger();
        private final AtomicInteger stepped = new AtomicInteger();

        @Override
        public PhysicsWorld createPhysics() {
            world = PhysicsWorld.builder().workers(1).build();
            return world;
        }

        @Override
        public void begin(PhysicsWorld physics) {
            physics.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
            Box box = Box.cubeOfHalfExtent(0.5);
            for (int i = 0; i < 20; i++) {
                physics.add(
                        Body.dynamic()
                                .shape(box)
                                .at(0.3 * (i % 5), 0.6 + 1.1 * (i / 5), 0.2 * (i % 3))
                                .with(new Visual(Model.of(box))));
            }
            begun.incrementAndGet();
        }

        @Override
        public void update(double seconds) {}

        @Override
        public void updated(double seconds) {
            digest = world.digest();
            stepped.incrementAndGet();
        }
    }

    /** What the window's thread does while the simulation does its 600 ticks, ten seconds. */
    private interface Reader {
        void read(Simulation simulation);
    }

    private static long digestBeside(Reader reader) throws InterruptedException {
        Pile pile = new Pile();
        Simulation simulation = new Simulation(pile, 1.0 / 60, 600);
        simulation.start();
        reader.read(simulation);
        simulation.await();
        simulation.rethrow();
        assertEquals(600, simulation.ticks());
        return pile.digest;
    }

    @Test
    void aSlowOrStoppedWindowChangesNothing() throws InterruptedException {
        GlTests.require();
        long alone = digestBeside(simulation -> {});
        long busy =
                digestBeside(simulation -> {
                    simulation.debug(DebugLayer.CONTACTS.bit(), true);
                    while (!simulation.isOver()) {
                        simulation.exchange().latest();
                    }
                });
        assertEquals(alone, busy, "a window that reads all the time, debug data included");
        long slow =
                digestBeside(simulation -> {
                    // Five frames a second of simulated time, each of them drawn.
                    try (Offscreen view = Offscreen.open(64, 36)) {
                        for (long tick = 0; tick <= 600; tick += 12) {
                            long due = tick;
                            await(() -> simulation.ticks() >= due);
                            PoseSnapshot seen = simulation.exchange().latest();
                            view.draw(seen, 1, new Camera(), Light.DAYLIGHT);
                        }
                    }
                });
        assertEquals(alone, slow, "a window at five frames a second");
        long stopped =
                digestBeside(simulation -> {
                    await(() -> simulation.ticks() >= 3);
                    PoseSnapshot held = simulation.exchange().latest();
                    long tick = held.tick();
                    double[] poses = held.current().clone();
                    await(simulation::isOver);
                    // Ten seconds went by, and what the window held is still whole.
                    assertEquals(tick, held.tick());
                    assertArrayEquals(poses, held.current());
                });
        assertEquals(alone, stopped, "a window that stands for ten seconds");
    }

    @Test
    void aRestartGoesThroughTheSameStates() {
        Pile pile = new Pile();
        Simulation simulation = new Simulation(pile, 1.0 / 240, -1);
        simulation.start();
        simulation.setPaused(true);
        await(() -> pile.begun.get() == 1);
        long[] digests = new long[2];
        for (int run = 0; run < 2; run++) {
            int worlds = pile.begun.get() + 1;
            simulation.restart();
            await(() -> pile.begun.get() == worlds);
            for (int step = 0; step < 30; step++) {
                int next = pile.stepped.get() + 1;
                simulation.singleStep();
                await(() -> pile.stepped.get() == next);
            }
            digests[run] = pile.digest;
        }
        simulation.stop();
        simulation.rethrow();
        assertEquals(digests[0], digests[1]);
    }

    /** A demo whose ball is at a known place at a known tick. */
    private static class Demo extends Application {
        private final RuntimeException inInit;
        private final RuntimeException inUpdate;
        private BodyRef ball;

        Demo(RuntimeException inInit, RuntimeException inUpdate) {
            this.inInit = inInit;
            this.inUpdate = inUpdate;
        }

        @Override
        protected PhysicsWorld createPhysics() {
            return PhysicsWorld.builder().workers(1).build();
        }

        @Override
        protected void initScene(Scene scene) {
            if (inInit != null) {
                throw inInit;
            }
            Sphere shape = Sphere.of(0.5);
            Model white = Model.of(shape).texture(Texture.WHITE).color(0xFFFFFF);
            ball = scene.add(Body.dynamic().shape(shape).at(0, 10, 0), white);
            scene.light(Light.DAYLIGHT.strengths(0, 1).background(0, 0).haze(0));
            scene.camera().lookAt(0, 10 - 0.5 * 9.81, 12, 0, 10 - 0.5 * 9.81, 0);
        }

        @Override
        protected void update(double seconds) {
            assertSame(ball, ball);
            if (inUpdate != null && ticks() == 3) {
                throw inUpdate;
            }
        }
    }

    @Test
    void applicationDrawsItsPictureAtTheTick(@TempDir Path folder) {
        GlTests.require();
        Path file = folder.resolve("fall.png");
        new Demo(null, null).size(160, 90).headless(file, 60).start();
        Texture picture = Texture.read(file);
        double sumX = 0;
        double sumY = 0;
        int white = 0;
        for (int i = 0; i < picture.argb().length; i++) {
            if ((picture.argb()[i] & 0xFF) > 128) {
                white++;
                sumX += i % 160 + 0.5;
                sumY += i / 160 + 0.5;
            }
        }
        // After one second the ball has fallen g / 2, to where the camera looks.
        assertTrue(white > 20, "white pixels " + white);
        assertEquals(80, sumX / white, 0.5);
        assertEquals(45, sumY / white, 0.5);
    }

    @Test
    void failureOfTheSimulationLeavesStart(@TempDir Path folder) {
        GlTests.require();
        Path file = folder.resolve("never.png");
        IllegalArgumentException init = new IllegalArgumentException("in initScene");
        assertSame(
                init,
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new Demo(init, null).headless(file, 10).start()));
        IllegalArgumentException update = new IllegalArgumentException("in update");
        assertSame(
                update,
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new Demo(null, update).headless(file, 10).start()));
        assertFalse(Files.exists(file));
    }

    @Test
    void applicationRefusesBadUse(@TempDir Path folder) {
        Demo demo = new Demo(null, null);
        assertThrows(IllegalArgumentException.class, () -> demo.size(1, 1));
        assertThrows(IllegalArgumentException.class, () -> demo.step(0));
        assertThrows(
                IllegalArgumentException.class, () -> demo.headless(folder.resolve("x.png"), -1));
        assertThrows(IllegalStateException.class, demo::isPaused);
        assertThrows(IllegalStateException.class, demo::scene);
    }
}
