package dev.cairn.physics.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A heap of all kinds of bodies on a ground of triangles. */
class HillsTest {
    private static final int TICKS = 240;

    private static long[] digests(int workers, int lanes) {
        long[] digests = new long[TICKS / 3];
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                        .sleeping(false)
                        .workers(workers)
                        .build()) {
            Grounds.drop(world, 35, 11);
            for (int tick = 0; tick < digests.length; tick++) {
                world.step(1 / 60.0);
                digests[tick] = world.digest();
            }
        }
        return digests;
    }

    @Tag("compiled")
    @Test
    void theSameBitsForWorkersAndLanes() {
        long[] first = digests(1, 1);
        assertArrayEquals(first, digests(2, 1), "2 workers");
        assertArrayEquals(first, digests(1, 8), "8 lanes");
        assertArrayEquals(first, digests(2, 4), "2 workers, 4 lanes");
    }

    /**
     * Where the hollows between corners are, the ground is below the smooth one by 2 cm at most.
     */
    @Test
    void nothingFallsThroughAndAllComesToRest() {
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(false).workers(1).build()) {
            List<BodyRef> bodies = Grounds.drop(world, 80, 5);
            for (int tick = 0; tick < 2 * TICKS; tick++) {
                world.step(1 / 60.0);
                if (tick % 20 == 0) {
                    world.validate();
                }
                for (BodyRef body : bodies) {
                    Vector3d at = body.centreOfMass(new Vector3d());
                    double height = at.y - Grounds.hills(at.x, at.z);
                    assertTrue(height > 0, body + " is " + height + " m above in tick " + tick);
                }
            }
            for (BodyRef body : bodies) {
                // what is round rolls on in the hollows
                double speed = body.velocity(new Vector3d()).length();
                Shape shape = body.colliders().get(0).shape();
                boolean rolls = !(shape instanceof Box || shape instanceof ConvexHull);
                assertTrue(rolls || speed < .05, body + " goes on at " + speed);
            }
        }
    }

    /** Who touches, made of events alone, is who touches; every end has its begin. */
    @Test
    void eventsTellEachPairOnce() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            List<BodyRef> bodies = Grounds.drop(world, 60, 3);
            Map<Set<ColliderRef>, Integer> told = new HashMap<>();
            for (int tick = 0; tick < 400; tick++) {
                if (tick % 50 == 49) {
                    bodies.remove(bodies.size() - 1).remove();
                }
                world.step(1 / 60.0);
                Contacts contacts = world.contacts();
                for (int i = 0; i < contacts.ended().count(); i++) {
                    Set<ColliderRef> pair =
                            Set.of(contacts.ended().colliderA(i), contacts.ended().colliderB(i));
                    assertEquals(0, told.merge(pair, -1, Integer::sum), "ended in tick " + tick);
                }
                for (int i = 0; i < contacts.began().count(); i++) {
                    Set<ColliderRef> pair =
                            Set.of(contacts.began().colliderA(i), contacts.began().colliderB(i));
                    assertEquals(1, told.merge(pair, 1, Integer::sum), "began in tick " + tick);
                }
                Set<Set<ColliderRef>> touching = new HashSet<>();
                for (int i = 0; i < contacts.count(); i++) {
                    if (contacts.touching(i)) {
                        touching.add(Set.of(contacts.colliderA(i), contacts.colliderB(i)));
                    }
                }
                Set<Set<ColliderRef>> open = new HashSet<>(told.keySet());
                open.removeIf(pair -> told.get(pair) == 0);
                assertEquals(touching, open, "tick " + tick);
            }
            assertTrue(bodies.stream().anyMatch(BodyRef::isAsleep), "somebody sleeps");
        }
    }
}
