package dev.cairn.physics.collider;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Inside;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/**
 * Bodies of hundreds of shapes have trees of their own: the same pairs as by asking each shape of
 * each other, at what a tree costs, counted in nodes.
 */
class CompoundTreesTest {
    private static Body raft(int wide, int deep, double spacing) {
        Body body = Body.dynamic();
        for (int i = 0; i < wide * deep; i++) {
            body.collider(
                    Collider.of(Box.ofHalfExtents(.2, .1, .2))
                            .at(spacing * (i % wide), 0, spacing * (i / wide)));
        }
        return body;
    }

    /** A body of 25 by 40 shapes falls on a field of 25 by 40 posts, each shape on one of them. */
    @Test
    void aThousandShapesOverAFieldOfAThousandBodiesCostWhatATreeCosts() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            for (int i = 0; i < 1000; i++) {
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(.15, .5, .15))
                                .at(.5 * (i % 25), -.5, .5 * (i / 25)));
            }
            BodyRef raft = world.add(raft(25, 40, .5).at(0, 2.1, 0));
            world.step(Scenes.STEP);
            BroadPhase boxes = Inside.broadPhase(world);
            int moves = 0;
            while (raft.position().y > 1.2) {
                long unions = boxes.dynamicTree().unions();
                world.step(Scenes.STEP);
                long visits = boxes.visits();
                unions = boxes.dynamicTree().unions() - unions;
                // in the air: a few nodes say that nothing is near, and each box is made once
                assertEquals(0, boxes.pairCount());
                assertTrue(visits <= 8, visits + " nodes in the air");
                assertTrue(unions <= 1010, unions + " boxes made anew");
                moves += unions > 0 ? 1 : 0;
            }
            assertTrue(moves >= 5, "it left its boxes " + moves + " times");
            long most = 0;
            for (int i = 0; i < 60; i++) {
                world.step(Scenes.STEP);
                most = Math.max(most, boxes.visits());
            }
            assertEquals(1000, boxes.pairCount(), "one post for each shape");
            // each shape for itself looks at 20 nodes of a tree of 1000, and again at its own
            // body's
            assertTrue(most <= 1000 * 20, most + " nodes on the posts");
            assertEquals(.1, raft.position().y, 1e-3);
            assertTrue(world.contacts().count() <= 1000, "at most a row for each shape");
            long before = boxes.dynamicTree().changes();
            for (int i = 0; i < 30; i++) {
                world.step(Scenes.STEP);
            }
            assertEquals(before, boxes.dynamicTree().changes(), "at rest nothing is looked at");
            world.validate();
        }
    }

    /** Each pair of shapes asked by itself is the oracle, while bodies come, change and go. */
    @Tag("compiled")
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void thePairsAreThoseOfAskingEachOfEach(long seed) {
        Set<Long> digests = new HashSet<>();
        for (int workers = 1; workers <= 2; workers++) {
            for (int lanes : workers == 1 ? new int[] {1, 8} : new int[] {4}) {
                digests.add(play(seed, workers, lanes));
            }
        }
        assertEquals(1, digests.size(), "seed " + seed);
    }

    private static long play(long seed, int workers, int lanes) {
        Random random = new Random(seed);
        try (PhysicsWorld world =
                Scenes.awake()
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes).withSleeping(false))
                        .workers(workers)
                        .build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, .5, 9)).at(0, -.5, 0));
            List<BodyRef> bodies = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                bodies.add(world.add(cluster(random, i)));
            }
            for (int i = 0; i < 20; i++) {
                world.add(
                        Body.dynamic()
                                .shape(Sphere.of(.2))
                                .at(3 * random.nextGaussian(), 1, 3 * random.nextGaussian()));
            }
            for (int tick = 0; tick < 60; tick++) {
                BodyRef body = bodies.get(random.nextInt(bodies.size()));
                if (tick % 5 == 0 && body.colliders().size() > 12) {
                    change(world, bodies, body, random);
                }
                world.step(Scenes.STEP);
                pairsAreRight(world, "seed " + seed + " tick " + tick);
                world.validate();
            }
            queriesSeeEachShape(world);
            return world.digest();
        }
    }

    private static void change(
            PhysicsWorld world, List<BodyRef> bodies, BodyRef body, Random random) {
        List<ColliderRef> parts = body.colliders();
        switch (random.nextInt(5)) {
            case 0 -> body.add(Collider.of(Sphere.of(.1)).at(random.nextDouble(), 1, 0));
            case 1 -> parts.get(random.nextInt(parts.size())).remove();
            case 2 -> {
                for (int i = 0; i < 12; i++) {
                    parts.get(i).remove();
                }
            }
            case 3 -> {
                bodies.remove(body);
                body.remove();
                bodies.add(world.add(cluster(random, random.nextInt(4))));
            }
            default -> {
                if (!body.isFixed()) {
                    body.teleport(random.nextGaussian(), 3, random.nextGaussian());
                }
            }
        }
    }

    private static Body cluster(Random random, int kind) {
        Body body = kind == 0 ? Body.kinematic().velocity(.4, 0, 0) : Body.dynamic();
        if (kind == 1) {
            body = Body.fixed();
        }
        int shapes = 30 + random.nextInt(40);
        for (int i = 0; i < shapes; i++) {
            body.collider(
                    Collider.of(Box.ofHalfExtents(.1, .15, .1))
                            .at(random.nextGaussian(), .5 * random.nextDouble(), 0)
                            .sensor(random.nextInt(12) == 0));
        }
        return body.mass(5)
                .angularVelocity(kind == 1 ? 0 : 1, 0, 0)
                .at(2 * random.nextGaussian(), 1 + kind, 2 * random.nextGaussian());
    }

    private static void pairsAreRight(PhysicsWorld world, String when) {
        BroadPhase boxes = Inside.broadPhase(world);
        ColliderStore colliders = Inside.colliders(world);
        boxes.dynamicTree().validate();
        boxes.staticTree().validate();
        int pairs = 0;
        for (int a = 0; a < colliders.slotCount; a++) {
            for (int b = a + 1; b < colliders.slotCount; b++) {
                boolean is = boxes.overlap(a, b) && boxes.admits(a, b);
                assertEquals(is, boxes.isPair(a, b), when + ": " + a + " and " + b);
                pairs += is ? 1 : 0;
            }
        }
        assertEquals(pairs, boxes.pairCount(), when);
    }

    /** A ray that begins in a shape hits at once. */
    private static void queriesSeeEachShape(PhysicsWorld world) {
        ColliderStore colliders = Inside.colliders(world);
        Hit hit = new Hit();
        for (BodyRef body : world.bodies()) {
            for (ColliderRef part : body.colliders()) {
                double x = colliders.poses.positionX[Inside.slot(part)];
                double y = colliders.poses.positionY[Inside.slot(part)];
                double z = colliders.poses.positionZ[Inside.slot(part)];
                if (!part.isSensor()) {
                    assertNotNull(world.queries().rayCast(x, y, z, 0, -1, 0, 1e-6, hit));
                }
            }
        }
    }
}
