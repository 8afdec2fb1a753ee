package dev.cairn.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** A fork is a world by itself, and takes what differs. */
class ForksTest {
    private static final double STEP = 1.0 / 60;

    private static PhysicsWorld boxes(int bodies) {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(60, 1, 60)).at(0, -1, 0));
        for (int i = 0; i < bodies; i++) {
            Body body = Body.dynamic().shape(Box.cubeOfHalfExtent(0.4));
            world.add(body.at(i % 33 * 1.5 - 24, 0.4, i / 33 * 1.5 - 24));
        }
        for (int t = 0; t < 90; t++) {
            world.step(STEP);
        }
        return world;
    }

    /** Ten of the bodies hop, each fork's in its own way. */
    private static void push(PhysicsWorld world, int fork, int bodies) {
        List<BodyRef> all = world.bodies();
        for (int n = 0; n < 10; n++) {
            BodyRef body = all.get(1 + (fork + n * bodies / 10) % bodies);
            body.applyImpulse(0.01 * fork * body.mass(), 2 * body.mass(), 0);
        }
    }

    private static void step(PhysicsWorld world, int ticks) {
        for (int t = 0; t < ticks; t++) {
            world.step(STEP);
        }
    }

    /** As many forks as one likes: 100 of a world of 1000 bodies of which ten move in each. */
    @Test
    void aHundredForksOfAThousandBodiesTakeWhatMoves() {
        try (PhysicsWorld world = boxes(1000);
                Forks forks = new Forks(world)) {
            List<Forks.Fork> all = new ArrayList<>();
            for (int f = 0; f < 100; f++) {
                Forks.Fork fork = forks.fork();
                assertEquals(0, fork.byteCount());
                int number = f;
                fork.in(own -> {
                    push(own, number, 1000);
                    step(own, 5);
                });
                all.add(fork);
            }
            long own = 0;
            for (Forks.Fork fork : all) {
                assertTrue(fork.byteCount() <= 5000, fork.byteCount() + " bytes to a fork");
                own += fork.byteCount();
            }
            assertTrue(own < forks.sharedByteCount() / 2, own + " bytes");
            long present = world.digest();
            assertEquals(present, digest(forks.fork()));
            for (int f = 0; f < 100; f += 33) {
                try (PhysicsWorld alone = world.fork()) {
                    push(alone, f, 1000);
                    step(alone, 5);
                    assertEquals(alone.digest(), digest(all.get(f)), "fork " + f);
                }
            }
        }
    }

    private static long digest(Forks.Fork fork) {
        long[] digest = {0};
        fork.in(own -> digest[0] = own.digest());
        return digest[0];
    }

    /** Taken up in turn, each goes on as if it were alone; so does a fork of a fork. */
    @Test
    void forksGoOnInTurn() {
        try (PhysicsWorld world = boxes(60);
                Forks forks = new Forks(world);
                PhysicsWorld first = world.fork();
                PhysicsWorld second = world.fork()) {
            push(first, 1, 60);
            push(second, 2, 60);
            Forks.Fork a = forks.fork();
            Forks.Fork b = forks.fork();
            a.in(own -> push(own, 1, 60));
            b.in(own -> push(own, 2, 60));
            for (int t = 0; t < 80; t++) {
                step(first, 1);
                step(second, 1);
                a.in(own -> step(own, 1));
                b.in(own -> step(own, 1));
            }
            assertEquals(first.digest(), digest(a));
            assertEquals(second.digest(), digest(b));
            assertNull(first.save().difference(a.save(), "bodies"));

            Forks.Fork c = a.fork();
            assertEquals(a.byteCount(), c.byteCount());
            second.restore(a.save());
            push(second, 3, 60);
            step(second, 20);
            c.in(own -> {
                push(own, 3, 60);
                step(own, 20);
            });
            assertEquals(second.digest(), digest(c));
            assertEquals(first.digest(), digest(a));
        }
    }

    @Test
    void whatThrowsLeavesAForkAsItWas() {
        try (PhysicsWorld world = boxes(20);
                Forks forks = new Forks(world)) {
            Forks.Fork fork = forks.fork();
            fork.in(own -> push(own, 1, 20));
            long digest = digest(fork);
            assertThrows(
                    ArithmeticException.class,
                    () ->
                            fork.in(own -> {
                                step(own, 3);
                                throw new ArithmeticException("no");
                            }));
            assertEquals(digest, digest(fork));
            assertThrows(IllegalStateException.class, () -> fork.in(own -> digest(forks.fork())));
            assertEquals(digest, digest(fork));
        }
    }
}
