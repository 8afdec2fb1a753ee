package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.ContactListener;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.WorldQueries;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.query.Closest;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;

/**
 * What a world tells while a {@link RandomUser} does things to it, against a search through all
 * that it holds: every end has its begin and the events add up to what touches now; in each sensor
 * is who overlaps it; queries answer as each collider asked alone; what sleeps does not move, and
 * events of sleep add up to who sleeps.
 */
@Tag("compiled")
class RandomReportsTest {
    /** Of what only touches, m: rounding says which side it is on. */
    private static final double TOUCH = 1e-9;

    private final ShapeQueries shapes = new ShapeQueries();
    private String where = "";

    /** What the events told so far add up to. */
    private final class Told implements ContactListener {
        final Set<List<ColliderRef>> touching = new HashSet<>();
        final Set<Set<BodyRef>> bodies = new HashSet<>();
        final Set<List<ColliderRef>> inside = new HashSet<>();

        @Override
        public void ended(ColliderRef a, ColliderRef b) {
            assertTrue(touching.remove(List.of(a, b)), () -> where + ", no begin: " + a + b);
        }

        @Override
        public void began(ColliderRef a, ColliderRef b) {
            assertTrue(touching.add(List.of(a, b)), () -> where + ", began twice: " + a + b);
        }

        @Override
        public void bodiesEnded(BodyRef a, BodyRef b) {
            assertTrue(bodies.remove(Set.of(a, b)), () -> where + ", no begin: " + a + b);
        }

        @Override
        public void bodiesBegan(BodyRef a, BodyRef b) {
            assertTrue(bodies.add(Set.of(a, b)), () -> where + ", began twice: " + a + b);
        }

        @Override
        public void entered(ColliderRef sensor, ColliderRef visitor) {
            assertTrue(inside.add(List.of(sensor, visitor)), () -> where + ", twice: " + visitor);
        }

        @Override
        public void left(ColliderRef sensor, ColliderRef visitor) {
            assertTrue(inside.remove(List.of(sensor, visitor)), () -> where + ": " + visitor);
        }
    }

    private void live(long seed, int ticks) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withLanes(1);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).settings(settings).build()) {
            RandomUser user = new RandomUser(world, seed);
            user.begin(seed);
            Told told = new Told();
            world.contacts().listen(told);
            Set<BodyRef> asleep = new HashSet<>();
            for (int t = 0; t < ticks; t++) {
                user.act(seed, t);
                where = "seed " + seed + ", tick " + t + ":" + user.done;
                Map<BodyRef, double[]> still = new HashMap<>();
                for (BodyRef body : world.bodies()) {
                    if (body.isAsleep()) {
                        still.put(body, place(body));
                    }
                }
                Set<Set<Long>> apart = apart(world); // before a joint breaks in the step
                world.step(RandomUser.step(seed, t));
                sleep(world, still, asleep);
                contacts(world, told);
                sensors(world, told, apart, user.rules);
                queries(world, new SplittableRandom(seed * 1000 + t));
            }
        }
    }

    private static double[] place(BodyRef body) {
        Vector3d p = body.position(new Vector3d());
        Quaterniond q = body.orientation(new Quaterniond());
        return new double[] {p.x, p.y, p.z, q.x, q.y, q.z, q.w};
    }

    private static Placement place(ColliderRef collider) {
        Vector3d p = collider.body().position(new Vector3d());
        Quaterniond q = collider.body().orientation(new Quaterniond());
        return new Placement().set(collider.description().placed(), p, q);
    }

    private static List<ColliderRef> colliders(PhysicsWorld world) {
        return world.bodies().stream().flatMap(body -> body.colliders().stream()).toList();
    }

    private void sleep(PhysicsWorld world, Map<BodyRef, double[]> still, Set<BodyRef> asleep) {
        var events = world.sleepEvents();
        Map<BodyRef, Integer> changes = new HashMap<>();
        for (int i = 0; i < events.fellAsleepCount(); i++) {
            changes.merge(events.fellAsleep(i), 1, Integer::sum);
        }
        for (int i = 0; i < events.wokeCount(); i++) {
            changes.merge(events.woke(i), -1, Integer::sum);
        }
        changes.forEach((body, change) -> {
            if (change != 0) {
                boolean alternates = change > 0 ? asleep.add(body) : asleep.remove(body);
                assertTrue(alternates && Math.abs(change) == 1, where + " " + body);
            }
        });
        Set<BodyRef> now = new HashSet<>(world.bodies());
        now.removeIf(body -> !body.isAsleep());
        assertEquals(now, asleep, where);
        assertEquals(now.size(), events.asleepCount(), where);
        still.forEach((body, before) ->
                assertTrue(
                        !now.contains(body) || Arrays.equals(before, place(body)),
                        () -> where + ": moved asleep " + body));
    }

    private void contacts(PhysicsWorld world, Told told) {
        Contacts c = world.contacts();
        Set<List<ColliderRef>> touching = new HashSet<>();
        Set<Set<BodyRef>> bodies = new HashSet<>();
        Map<BodyRef, Integer> counts = new HashMap<>();
        Vector3d v = new Vector3d();
        for (int i = 0; i < c.count(); i++) {
            assertTrue(c.bodyA(i).isAlive() && c.bodyB(i).isAlive(), where);
            counts.merge(c.bodyA(i), 1, Integer::sum);
            counts.merge(c.bodyB(i), 1, Integer::sum);
            assertEquals(1, c.normal(i, v).length(), 1e-9, where);
            for (int k = 0; k < c.pointCount(i); k++) {
                double impulse = c.normalImpulse(i, k);
                assertTrue(impulse >= 0 && (impulse == 0 || c.touching(i)), where + " " + impulse);
                assertTrue(c.point(i, k, v).isFinite(), where);
            }
            if (c.touching(i)) {
                touching.add(List.of(c.colliderA(i), c.colliderB(i)));
                bodies.add(Set.of(c.bodyA(i), c.bodyB(i)));
            }
        }
        assertEquals(touching, told.touching, where);
        assertEquals(bodies, told.bodies, where);
        for (BodyRef body : world.bodies()) {
            assertEquals(counts.getOrDefault(body, 0), body.contacts().length, where);
        }
    }

    /** Bodies that joints keep from colliding, so that sensors of the one do not see the other. */
    private static Set<Set<Long>> apart(PhysicsWorld world) {
        Set<Set<Long>> apart = new HashSet<>();
        for (JointRef joint : world.joints().all()) {
            if (joint.isEnabled() && !joint.collides()) {
                apart.add(Set.of(joint.entityA(), joint.entityB()));
            }
        }
        return apart;
    }

    private void sensors(PhysicsWorld world, Told told, Set<Set<Long>> apart, RandomRules rules) {
        List<ColliderRef> all = colliders(world);
        Set<List<ColliderRef>> inside = new HashSet<>();
        for (ColliderRef s : all) {
            for (ColliderRef v : all) {
                BodyRef a = s.body();
                BodyRef b = v.body();
                if (!s.isSensor()
                        || v.isSensor()
                        || a == b
                        || rules.excludes(a, b)
                        || !s.filter().meets(v.filter())
                        || apart.contains(Set.of(a.entity(), b.entity()))) {
                    continue;
                }
                double distance = shapes.distance(place(s), place(v));
                List<ColliderRef> pair = List.of(s, v);
                if (Math.abs(distance) < TOUCH ? told.inside.contains(pair) : distance < 0) {
                    inside.add(pair);
                }
            }
        }
        assertEquals(inside, told.inside, where);
    }

    private void queries(PhysicsWorld world, SplittableRandom random) {
        boolean sensors = random.nextBoolean();
        WorldQueries queries = world.queries().withSensors(sensors);
        Vector3d from = new Vector3d(near(random), near(random), near(random));
        Vector3d way = new Vector3d(near(random), near(random), near(random)).normalize();
        Quaterniond turn = new Quaterniond(near(random), near(random), 1, 1).normalize();
        Shape shape = random.nextBoolean() ? Sphere.of(0.3) : Box.ofHalfExtents(0.2, 0.3, 0.1);
        double most = random.nextDouble(1, 10);
        Placement own = new Placement().set(shape, from, turn);
        double ray = Double.POSITIVE_INFINITY;
        double cast = Double.POSITIVE_INFINITY;
        double nearest = Double.POSITIVE_INFINITY;
        Set<BodyRef> over = new HashSet<>();
        Set<BodyRef> touched = new HashSet<>();
        Hit hit = new Hit();
        for (ColliderRef collider : colliders(world)) {
            if (collider.isSensor() && !sensors) {
                continue;
            }
            Placement place = place(collider);
            if (shapes.rayCast(place, from, way, most, hit)) {
                ray = Math.min(ray, hit.distance());
            }
            if (shapes.shapeCast(own, way, most, place, hit)) {
                cast = Math.min(cast, hit.distance());
            }
            double distance = shapes.distance(own, place);
            nearest = Math.min(nearest, distance);
            if (distance < -TOUCH) {
                over.add(collider.body());
            } else if (distance <= TOUCH) {
                touched.add(collider.body());
            }
        }
        assertEquals(ray < most, queries.rayCast(from, way, most, hit) != null, where);
        assertEquals(ray, ray < most ? hit.distance() : ray, TOUCH, where);
        assertEquals(cast < most, queries.shapeCast(own, way, most, hit) != null, where);
        assertEquals(cast, cast < most ? hit.distance() : cast, TOUCH, where);
        Closest closest = new Closest();
        assertTrue(queries.closest(own, 1000, closest) != null, where);
        assertEquals(nearest, closest.distance(), TOUCH, where);
        List<BodyRef> found = new ArrayList<>();
        queries.overlaps(own, found);
        assertEquals(new HashSet<>(found).size(), found.size(), where);
        assertTrue(found.containsAll(over), where);
        touched.addAll(over);
        assertTrue(touched.containsAll(found), where);
    }

    private static double near(SplittableRandom random) {
        return random.nextDouble(-4, 4);
    }

    /** Each world is drawn by its seed, which every message names. */
    @Test
    void whatIsToldIsWhatThereIs() {
        for (long seed = 1; seed <= Long.getLong("cairn.reports", 20); seed++) {
            live(seed, 150);
        }
    }
}
