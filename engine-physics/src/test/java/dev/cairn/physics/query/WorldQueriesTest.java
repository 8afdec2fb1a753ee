package dev.cairn.physics.query;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.WorldQueries;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Questions to a world, against the same questions to each of its bodies in turn. */
class WorldQueriesTest {
    private static final long SEED = 4711;
    private static final double FAR = 30;

    private final SplittableRandom random = new SplittableRandom(SEED);
    private final ShapeQueries shapes = new ShapeQueries();
    private final Hit hit = new Hit(), expected = new Hit();
    private final Closest closest = new Closest(), nearest = new Closest();

    private double around(double size) {
        return size * (2 * random.nextDouble() - 1);
    }

    private Quaterniond turn() {
        return new Quaterniond(around(1), around(1), around(1), around(1)).normalize();
    }

    private static Shape shape(int i) {
        return switch (i % 6) {
            case 0 -> Sphere.of(0.5);
            case 1 -> Box.ofHalfExtents(0.5, 0.3, 0.7);
            case 2 -> Capsule.of(0.3, 0.5);
            case 3 -> Cylinder.of(0.4, 0.3);
            case 4 -> Cone.of(0.5, 0.5);
            default ->
                    Box.cubeOfHalfExtent(0.4).moved(0.3, 0.2, 0.1, new Quaterniond().rotateX(0.5));
        };
    }

    /** All that may be in a world: fast, slow, asleep, fixed, without end. */
    private List<BodyRef> fill(PhysicsWorld world, int count) {
        List<BodyRef> bodies = new ArrayList<>();
        bodies.add(world.add(Body.fixed().shape(HalfSpace.of()).at(0, -6, 0)));
        for (int i = 0; i < count; i++) {
            Body body = i % 4 == 3 ? Body.fixed() : Body.dynamic();
            body.shape(shape(i)).at(around(8), around(5), around(8)).rotation(turn());
            if (i % 4 != 3) {
                double speed = i % 5 == 0 ? 40 : 1;
                body.velocity(around(speed), around(speed), around(speed));
            }
            bodies.add(world.add(body));
        }
        return bodies;
    }

    private static Placement placement(BodyRef body) {
        Vector3d p = body.position();
        Quaterniond q = body.orientation();
        return new Placement().set(body.shape(), p.x, p.y, p.z, q.x, q.y, q.z, q.w);
    }

    /** The worlds that are asked: fresh, in motion, and with bodies moved, new and gone since. */
    private interface Question {
        void ask(WorldQueries queries, List<BodyRef> bodies);
    }

    private void inAllWorlds(Question question) {
        for (int workers = 1; workers <= 3; workers += 2) {
            try (PhysicsWorld world = PhysicsWorld.builder().workers(workers).build()) {
                WorldQueries queries = world.queries();
                List<BodyRef> bodies = fill(world, 120);
                question.ask(queries, bodies);
                for (int tick = 0; tick < 20; tick++) {
                    world.step(1.0 / 60);
                }
                question.ask(queries, bodies);
                for (int i = 0; i < 20; i++) {
                    bodies.get(5 * i + 2).teleport(around(8), around(5), around(8), turn());
                    bodies.get(5 * i + 3).remove();
                }
                bodies.removeIf(body -> !body.isAlive());
                bodies.add(world.add(Body.dynamic().shape(Sphere.of(1)).at(0, 0, 0)));
                bodies.add(world.add(Body.fixed().shape(Box.cubeOfHalfExtent(1)).at(4, 0, 0)));
                question.ask(queries, bodies);
            }
        }
    }

    @Test
    void aRayMeetsTheBodyThatIsFirstAmongAll() {
        System.out.println("WorldQueriesTest: seed " + SEED);
        int[] hits = new int[1];
        inAllWorlds((queries, bodies) -> {
            for (int i = 0; i < 60; i++) {
                double[] o = {around(10), around(6), around(10)};
                double[] d = {around(1), around(1), i % 9 == 0 ? 0 : around(1)};
                double far = i % 3 == 0 ? 5 : Double.POSITIVE_INFINITY;
                BodyRef first = null;
                for (BodyRef body : bodies) {
                    if (shapes.rayCast(
                                    placement(body), o[0], o[1], o[2], d[0], d[1], d[2], far, hit)
                            && (first == null || hit.distance() < expected.distance())) {
                        first = body;
                        expected.set(hit);
                    }
                }
                check(first, queries.rayCast(o[0], o[1], o[2], d[0], d[1], d[2], far, hit));
                hits[0] += first == null ? 0 : 1;
            }
        });
        assertTrue(hits[0] > 100, "only " + hits[0] + " rays hit");
    }

    @Test
    void aMovingShapeMeetsTheBodyThatIsFirstAmongAll() {
        inAllWorlds((queries, bodies) -> {
            for (int i = 0; i < 40; i++) {
                Quaterniond q = turn();
                Placement mover =
                        new Placement()
                                .set(
                                        shape(i),
                                        around(10),
                                        around(6),
                                        around(10),
                                        q.x,
                                        q.y,
                                        q.z,
                                        q.w);
                double[] d = {around(1), i % 7 == 0 ? 0 : around(1), around(1)};
                BodyRef first = null;
                for (BodyRef body : bodies) {
                    if (shapes.shapeCast(mover, d[0], d[1], d[2], FAR, placement(body), hit)
                            && (first == null || hit.distance() < expected.distance())) {
                        first = body;
                        expected.set(hit);
                    }
                }
                check(first, queries.shapeCast(mover, d[0], d[1], d[2], FAR, hit));
            }
        });
    }

    /**
     * {@code hit} against {@code expected}; a body's own frame and its centre differ by rounding.
     */
    @Test
    void aTurningShapeMeetsTheBodyThatIsFirstAmongAll() {
        ShapeQueries single = new ShapeQueries();
        Placement mover = new Placement();
        Motion motion = new Motion();
        inAllWorlds((queries, bodies) -> {
            for (int i = 0; i < 60; i++) {
                Quaterniond q = turn();
                mover.set(shape(i), around(8), around(5), around(8), q.x, q.y, q.z, q.w);
                motion.clear()
                        .velocity(around(9), around(9), around(9))
                        .angularVelocity(around(20), around(20), around(20))
                        .acceleration(0, i % 2 == 0 ? -9.81 : 0, 0);
                BodyRef first = null;
                double least = 1;
                int met = 0;
                for (BodyRef body : bodies) {
                    if (single.turningCast(mover, motion, 1, placement(body), hit)) {
                        met++;
                        if (first == null || hit.seconds() < least) {
                            least = hit.seconds();
                            first = body;
                        }
                    }
                }
                BodyRef found = queries.turningCast(mover, motion, 1, hit);
                assertEquals(first == null, found == null);
                if (found != null) {
                    assertTrue(least == 0 || first == found, "seed 4711 motion " + i);
                    assertEquals(least, hit.seconds(), 1e-12);
                    assertSame(found, queries.collider().body());
                }
                List<WorldQueries.Met> all = new ArrayList<>();
                assertEquals(met, queries.turningCastAll(mover, motion, 1, all));
                for (int k = 1; k < met; k++) {
                    assertTrue(all.get(k - 1).hit().seconds() <= all.get(k).hit().seconds());
                }
                if (first != null) {
                    BodyRef hidden = first;
                    queries.filter(body -> body != hidden);
                    assertTrue(queries.turningCast(mover, motion, 1, hit) != first);
                    queries.filter(null);
                }
            }
        });
    }

    /** A dumbbell that spins about its middle strikes a post with its far ball. */
    @Test
    void bodiesMeetByTheirVelocities() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).workers(1).build()) {
            BodyRef bell =
                    world.add(
                            Body.dynamic()
                                    .collider(Collider.of(Sphere.of(0.1)).at(-1, 0, 0))
                                    .collider(Collider.of(Sphere.of(0.1)).at(1, 0, 0))
                                    .velocity(0, 0, 2)
                                    .angularVelocity(0, 10, 0));
            BodyRef post =
                    world.add(Body.kinematic().shape(Box.ofHalfExtents(0.1, 1, 0.1)).at(0, 0, 9));
            WorldQueries queries = world.queries();
            assertTrue(queries.timeOfImpact(bell, post, 10, hit));
            double t = hit.seconds();
            // the middle is at z = 2 t, a ball 1 m beside it, the post's face at 8.9
            double z = 2 * t + Math.abs(StrictMath.sin(10 * t));
            double x = Math.abs(StrictMath.cos(10 * t));
            double dx = Math.max(0, x - 0.1);
            assertEquals(0.1, StrictMath.sqrt(dx * dx + (8.9 - z) * (8.9 - z)), 1e-12);
            assertSame(post, queries.collider().body());
            assertEquals(-1, hit.normalZ(), 0.2);
            assertTrue(!queries.timeOfImpact(bell, post, t - 1e-9, hit));
            post.setVelocity(0, 0, 5);
            assertTrue(!queries.timeOfImpact(bell, post, 10, hit));
            bell.remove();
            assertThrows(RuntimeException.class, () -> queries.timeOfImpact(bell, post, 10, hit));
        }
    }

    private void check(@Nullable BodyRef first, @Nullable BodyRef found) {
        if (first == null) {
            assertNull(found);
            return;
        }
        assertTrue(found != null, "nothing was found, but " + first);
        assertEquals(expected.distance(), hit.distance(), 1e-12 * FAR);
        if (first != found) {
            assertEquals(0, hit.distance(), "another body, so both must be touched at the start");
            return;
        }
        assertEquals(expected.pointX(), hit.pointX(), 1e-6);
        assertEquals(expected.startsInside(), hit.startsInside());
    }

    @Test
    void theNearestBodyAndAllThatOverlapAreThoseOfASearchThroughAll() {
        inAllWorlds((queries, bodies) -> {
            for (int i = 0; i < 40; i++) {
                Quaterniond q = turn();
                Placement where =
                        new Placement()
                                .set(
                                        shape(i),
                                        around(10),
                                        around(6),
                                        around(10),
                                        q.x,
                                        q.y,
                                        q.z,
                                        q.w);
                double within = i % 3 == 0 ? 0.5 : Double.POSITIVE_INFINITY;
                double least = within;
                BodyRef first = null;
                List<BodyRef> touching = new ArrayList<>();
                for (BodyRef body : bodies) {
                    double d = shapes.closest(where, placement(body), closest);
                    if (d < least) {
                        least = d;
                        first = body;
                    }
                    if (d <= 0) {
                        touching.add(body);
                    }
                }
                assertSame(first, queries.closest(where, within, nearest));
                if (first != null) {
                    assertEquals(least, nearest.distance(), 1e-12 * FAR);
                }
                List<BodyRef> out = new ArrayList<>();
                assertEquals(touching.size(), queries.overlaps(where, out));
                assertEquals(java.util.Set.copyOf(touching), java.util.Set.copyOf(out));
            }
        });
    }

    @Test
    void ofBodiesThatOverlapThePlaceTheDeepestIsTheNearest() {
        for (int deep = 0; deep < 2; deep++) {
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
                BodyRef[] bodies = new BodyRef[2];
                for (int i = 0; i < 2; i++) {
                    double x = (i == deep ? 0.6 : 0.9) * (i == 0 ? 1 : -1);
                    bodies[i] =
                            world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)).at(x, 0, 0));
                }
                world.step(1.0 / 60);
                Placement place = new Placement().set(Sphere.of(0.5), 0, 0, 0);
                assertSame(bodies[deep], world.queries().closest(place, 1, closest));
                assertEquals(-0.4, closest.distance(), 1e-15);
            }
        }
    }

    /** A ray along a row of a thousand boxes asks a handful of them, and nothing is allocated. */
    @Test
    void aRayAsksFewAndAllocatesNothing() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).workers(1).build()) {
            for (int i = 0; i < 1000; i++) {
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(0.5))
                                .at(2 * (i % 40), 0, 2 * (i / 40)));
            }
            world.step(1.0 / 60);
            int[] asked = new int[1];
            WorldQueries queries =
                    world.queries()
                            .filter(body -> {
                                asked[0]++;
                                return true;
                            });
            assertTrue(queries.rayCast(-5, 0.1, 0.2, 1, 0, 0, 1000, hit) != null);
            assertEquals(4.5, hit.distance(), 1e-12);
            assertTrue(asked[0] <= 3, asked[0] + " bodies were asked");
            queries.filter(null);
            ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
            Placement place = new Placement().set(Sphere.of(0.4), 10, 1, 10);
            Motion motion = new Motion().velocity(0, -9, 1).angularVelocity(3, 2, 1);
            long before = 0;
            for (int i = 0; i < 4000; i++) {
                if (i == 2000) {
                    before = threads.getCurrentThreadAllocatedBytes();
                }
                queries.rayCast(-5, 3, 0.2, 1, -0.1, 0.5, 1000, hit);
                queries.shapeCast(place, 0, -1, 0.1, 1000, hit);
                queries.closest(place, 10, closest);
                queries.turningCast(place, motion, 1, hit);
            }
            long bytes = threads.getCurrentThreadAllocatedBytes() - before;
            assertTrue(bytes < 4096, bytes + " bytes in 6000 questions");
        }
    }

    @Test
    void whatIsFilteredOutIsLookedThrough() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef front = world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)).at(2, 0, 0));
            BodyRef back = world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)).at(4, 0, 0));
            WorldQueries queries = world.queries();
            assertSame(front, queries.rayCast(0, 0, 0, 1, 0, 0, 10, hit));
            queries.filter(body -> body != front);
            assertSame(back, queries.rayCast(0, 0, 0, 1, 0, 0, 10, hit));
            assertEquals(3.5, hit.distance(), 1e-15);
            assertNull(queries.rayCast(0, 0, 0, 1, 0, 0, 3.4, hit));
        }
    }

    @Test
    void badQuestionsAreRefusedByName() {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        WorldQueries queries = world.queries();
        assertNull(queries.rayCast(0, 0, 0, 0, 1, 0, 1, hit), "an empty world");
        Placement ground = new Placement().set(HalfSpace.of(), 0, 0, 0);
        for (Runnable bad :
                List.<Runnable>of(
                        () -> queries.rayCast(Double.NaN, 0, 0, 1, 0, 0, 1, hit),
                        () -> queries.rayCast(0, 0, 0, 0, 0, 0, 1, hit),
                        () -> queries.rayCast(0, 0, 0, 1, 0, 0, -1, hit),
                        () -> queries.rayCast(0, 0, 0, 1, 0, 0, Double.NaN, hit),
                        () -> queries.shapeCast(ground, 0, 1, 0, 1, hit),
                        () -> queries.turningCast(ground, new Motion(), 1, hit),
                        () -> queries.turningCast(new Placement(), new Motion(), -1, hit),
                        () -> queries.turningCast(new Placement(), new Motion(), 1 / 0.0, hit),
                        () -> queries.closest(new Placement(), Double.NaN, closest))) {
            String message = assertThrows(IllegalArgumentException.class, bad::run).getMessage();
            assertTrue(message.length() > 20, message);
        }
        world.close();
        assertThrows(IllegalStateException.class, () -> queries.rayCast(0, 0, 0, 1, 0, 0, 1, hit));
    }
}
