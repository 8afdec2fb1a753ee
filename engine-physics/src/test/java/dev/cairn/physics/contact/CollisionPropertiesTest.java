package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.ContactListener;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Inside;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.collider.ContactHook;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.statistics.Statistics;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;

/**
 * Any order of adding, changing, filtering, removing and sleeping, hooks, belts and given masses
 * among it: each end has its begin, a list of who touches that is made of events alone is that of
 * the world, the state holds, and the bits do not depend on workers or lanes.
 */
@Tag("compiled")
class CollisionPropertiesTest {
    private static final Filter[] FILTERS = {
        Filter.ALL,
        new Filter(2, 1),
        new Filter(1, 3),
        Filter.ALL.neverWith(1),
        Filter.ALL.alwaysWith(2),
        Filter.NOTHING
    };

    /** None; what lets through from one side; what is slippery and remembers. */
    private static final @Nullable ContactHook[] HOOKS = {
        null,
        contact -> {
            if (contact.normalX() > .3) {
                contact.disable();
            }
        },
        contact -> {
            contact.surface(contact.memory() % 2 == 0 ? .1 : .9, 0);
            contact.remember(contact.memory() + 1);
        }
    };

    @Property(tries = 12, shrinking = ShrinkingMode.OFF)
    void eventsPairUpAndBitsStay(@ForAll @LongRange(min = 0, max = 1 << 20) long seed) {
        long digest = play(seed, 1, 1);
        assertEquals(digest, play(seed, 2, 4), "seed " + seed);
        assertEquals(digest, play(seed, 4, 8), "seed " + seed);
    }

    private static long play(long seed, int workers, int lanes) {
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                        .workers(workers)
                        .build()) {
            Random random = new Random(seed);
            Ledger ledger = new Ledger();
            world.contacts().listen(ledger);
            world.contacts().setHitSpeed(.5);
            world.add(Body.fixed().shape(Box.ofHalfExtents(6, .5, 6)).at(0, -.5, 0));
            for (int i = 0; i < 12; i++) {
                world.add(body(random));
            }
            for (int tick = 0; tick < 100; tick++) {
                if (random.nextInt(3) == 0) {
                    change(world, random);
                }
                world.step(Scenes.STEP);
                world.validate();
                ledger.check(world, "seed " + seed + " tick " + tick);
            }
            for (BodyRef body : world.bodies()) {
                body.remove();
            }
            world.step(Scenes.STEP);
            assertTrue(ledger.touching.isEmpty() && ledger.inside.isEmpty(), "seed " + seed);
            assertTrue(ledger.bodies.isEmpty(), "seed " + seed);
            // a hook may let nobody touch in one world, and not in most
            Statistics.label("has hits")
                    .collect(ledger.count > 0)
                    .coverage(found -> found.check(true).percentage(share -> share > 80));
            return world.digest() + 31 * ledger.told;
        }
    }

    private static void change(PhysicsWorld world, Random random) {
        List<BodyRef> bodies = world.bodies();
        BodyRef body = bodies.get(random.nextInt(bodies.size()));
        List<ColliderRef> colliders = body.colliders();
        ColliderRef collider = colliders.get(random.nextInt(colliders.size()));
        switch (random.nextInt(18)) {
            case 0, 1 -> world.add(body(random));
            case 2 -> {
                if (!body.isFixed()) {
                    body.remove();
                }
            }
            case 3 -> body.setFilter(FILTERS[random.nextInt(FILTERS.length)]);
            case 4 -> collider.setFilter(FILTERS[random.nextInt(FILTERS.length)]);
            case 5 -> body.add(part(random));
            case 6 -> {
                if (colliders.size() > 1) {
                    collider.remove();
                }
            }
            case 7 -> collider.replace(part(random).sensor(collider.isSensor()));
            case 8 -> body.sleep();
            case 9 -> {
                BodyType[] types = BodyType.values();
                body.setType(types[random.nextInt(types.length)]);
            }
            case 10 -> {
                BodyRef other = bodies.get(random.nextInt(bodies.size()));
                if (other != body && body.type() == BodyType.DYNAMIC) {
                    world.add(Joint.ball(body, other).at(0, 1, 0));
                }
            }
            case 11 -> {
                List<JointRef> joints = world.joints().all();
                if (!joints.isEmpty()) {
                    joints.get(random.nextInt(joints.size())).remove();
                }
            }
            case 12 -> world.collisions().setHook(HOOKS[random.nextInt(HOOKS.length)]);
            case 13 ->
                    collider.replace(
                            part(random).sensor(collider.isSensor()).surfaceVelocity(1, 0, .5));
            case 14 -> collider.setMaterial(new Material(random.nextDouble(), .4, 900));
            case 15 -> {
                body.setMass(1 + random.nextDouble());
                body.setInertia(.1, .2, .15);
            }
            case 16 -> body.setCentreOfMass(.1 * random.nextDouble(), -.1, 0);
            default -> {
                if (!body.isFixed()) {
                    body.teleport(random.nextDouble() * 4 - 2, 1, random.nextDouble() * 4 - 2);
                }
            }
        }
    }

    private static Body body(Random random) {
        Body body = Body.dynamic().mass(1).collider(part(random).sensor(false));
        for (int i = random.nextInt(3); i > 0; i--) {
            body.collider(part(random));
        }
        return body.at(random.nextDouble() * 4 - 2, 3 * random.nextDouble(), random.nextDouble());
    }

    private static Collider part(Random random) {
        Shape shape =
                switch (random.nextInt(3)) {
                    case 0 -> Sphere.of(.3);
                    case 1 -> Box.ofHalfExtents(.2, .3, .4);
                    default -> Capsule.of(.2, .3);
                };
        return Collider.of(shape)
                .at(random.nextDouble() - .5, random.nextDouble() - .5, 0)
                .sensor(random.nextInt(4) == 0);
    }

    /** Who touches and who is inside, by what was told alone. */
    private static final class Ledger implements ContactListener {
        final Set<List<ColliderRef>> touching = new HashSet<>();
        final Set<List<ColliderRef>> inside = new HashSet<>();
        final Set<List<BodyRef>> bodies = new HashSet<>();
        long told;

        @Override
        public void ended(ColliderRef a, ColliderRef b) {
            assertTrue(touching.remove(List.of(a, b)), "end of " + a + " and " + b);
            told = 31 * told + 1 + Inside.slot(a.body());
        }

        @Override
        public void began(ColliderRef a, ColliderRef b) {
            assertTrue(touching.add(List.of(a, b)), "begin of " + a + " and " + b);
            told = 31 * told + 2 + Inside.slot(b.body());
        }

        @Override
        public void bodiesEnded(BodyRef a, BodyRef b) {
            assertTrue(bodies.remove(List.of(a, b)), "end of " + a + " and " + b);
            told = 31 * told + 5 + Inside.slot(a);
        }

        @Override
        public void bodiesBegan(BodyRef a, BodyRef b) {
            assertTrue(bodies.add(List.of(a, b)), "begin of " + a + " and " + b);
            told = 31 * told + 6 + Inside.slot(b);
        }

        /** Of the hits of a pair's shapes the strongest, in the order of the first. */
        @Override
        public void hit(Contacts.Hits hits, int hit) {
            BodyRef a = hits.bodyA(hit);
            BodyRef b = hits.bodyB(hit);
            strongest.merge(
                    Inside.slot(a) < Inside.slot(b) ? List.of(a, b) : List.of(b, a),
                    hits.impulse(hit),
                    Math::max);
            told = 31 * told + 7 + Inside.slot(b);
        }

        @Override
        public void bodiesHit(Contacts.Hits hits, int hit) {
            List<BodyRef> pair = List.of(hits.bodyA(hit), hits.bodyB(hit));
            assertEquals(strongest.keySet().iterator().next(), pair, "in the order of the first");
            assertEquals(strongest.remove(pair), hits.impulse(hit));
            assertTrue(hits.approachSpeed(hit) >= .5 && bodies.contains(pair), "they touch");
            told = 31 * told + 8 + Double.doubleToLongBits(hits.impulse(hit));
            count++;
        }

        private final Map<List<BodyRef>, Double> strongest = new LinkedHashMap<>();
        private int count;

        @Override
        public void left(ColliderRef a, ColliderRef b) {
            // what flies through leaves before it is told that it entered
            if (!inside.remove(List.of(a, b))) {
                through.add(List.of(a, b));
            }
            told = 31 * told + 3 + Inside.slot(a.body());
        }

        @Override
        public void entered(ColliderRef a, ColliderRef b) {
            if (!through.remove(List.of(a, b))) {
                assertTrue(inside.add(List.of(a, b)), b + " entered " + a);
            }
            told = 31 * told + 4 + Inside.slot(b.body());
        }

        private final List<List<ColliderRef>> through = new ArrayList<>();

        void check(PhysicsWorld world, String when) {
            assertTrue(through.isEmpty(), when + ": left without having entered");
            assertTrue(strongest.isEmpty(), when + ": a hit of shapes and none of their bodies");
            Set<List<ColliderRef>> now = new HashSet<>();
            Contacts contacts = world.contacts();
            for (int i = 0; i < contacts.count(); i++) {
                assertFalse(contacts.colliderA(i).isSensor() || contacts.colliderB(i).isSensor());
                if (contacts.touching(i)) {
                    now.add(List.of(contacts.colliderA(i), contacts.colliderB(i)));
                }
            }
            assertTrue(touching.containsAll(now), when + ": touches that were not told");
            Set<List<BodyRef>> byShapes = new HashSet<>();
            for (List<ColliderRef> pair : touching) {
                BodyRef a = pair.get(0).body();
                BodyRef b = pair.get(1).body();
                byShapes.add(Inside.slot(a) < Inside.slot(b) ? List.of(a, b) : List.of(b, a));
            }
            assertEquals(byShapes, bodies, when + ": bodies touch where their shapes do");
            for (List<ColliderRef> pair : touching) {
                assertTrue(pair.get(0).isAlive() && pair.get(1).isAlive(), when + " " + pair);
            }
        }
    }
}
