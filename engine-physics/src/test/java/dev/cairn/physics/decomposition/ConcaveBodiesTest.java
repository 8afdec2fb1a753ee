package dev.cairn.physics.decomposition;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.decomposition.Decomposer;
import dev.cairn.physics.shape.decomposition.Decomposition;

import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Bodies of convex parts behave as the concave ones that they were made of. */
class ConcaveBodiesTest {
    private static Body of(TriangleMesh mesh, Body body) {
        Decomposition d = Decomposer.of(mesh).run();
        body.massProperties(d.massProperties(1000));
        for (ConvexHull part : d.parts()) {
            body.collider(Collider.of(part));
        }
        return body;
    }

    private static PhysicsWorld world(int workers) {
        return PhysicsWorld.builder().gravity(0, -9.81, 0).workers(workers).build();
    }

    /** A ring lies on the floor, a ball falls through it; one that is too large stays on it. */
    @Test
    void aBallFallsThroughARing() {
        long[] digests = new long[2];
        for (int workers = 1; workers <= 2; workers++) {
            try (PhysicsWorld world = world(workers)) {
                world.add(Body.fixed().shape(Box.ofHalfExtents(5, .5, 5)).at(0, -.5, 0));
                TriangleMesh mesh = Concaves.torus(32, 12, 1, .3);
                BodyRef ring = world.add(of(mesh, Body.dynamic()).at(0, .35, 0));
                world.add(of(mesh, Body.dynamic()).at(3, .35, 0));
                BodyRef small = world.add(Body.dynamic().shape(Sphere.of(.5)).at(.1, 2, 0));
                BodyRef large = world.add(Body.dynamic().shape(Sphere.of(.9)).at(3, 2, 0));
                Hit hit = new Hit();
                assertNotNull(world.queries().rayCast(0, 1.2, 0, 0, -1, 0, 9, hit));
                assertEquals(1.2, hit.distance(), 1e-9, "the hole is open");
                for (int i = 0; i < 240; i++) {
                    world.step(1 / 60.0);
                }
                assertEquals(.5, small.position().y, .01);
                assertTrue(large.position().y > .9, () -> "large " + large.position());
                assertEquals(.3, ring.position().y, .02);
                digests[workers - 1] = world.digest();
            }
        }
        assertEquals(digests[0], digests[1]);
    }

    /** Upside down over a bar, a U hangs with its middle below the bar. */
    @Test
    void aHorseshoeHangsOnABar() {
        try (PhysicsWorld world = world(1)) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(.2, .1, 3)).at(0, -.1, 0));
            TriangleMesh mesh = Concaves.letter(1, "###", "#.#", "#.#");
            // its slot is 1 m wide, about x = 1.5, and ends at y = 2
            BodyRef hook = world.add(of(mesh, Body.dynamic()).at(-1.5, -1.9, -.5));
            for (int i = 0; i < 300; i++) {
                world.step(1 / 60.0);
            }
            Vector3d at = hook.position();
            assertEquals(-2, at.y, 1e-3, () -> "hangs at " + at);
            assertEquals(0, hook.velocity().length(), 1e-3);
            assertTrue(hook.centreOfMass(new Vector3d()).y < -.3);
        }
    }

    /** The tensor of a body is that of the solid: an L of three cubes about its centre. */
    @Test
    void theInertiaIsOfTheSolid() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).workers(1).build()) {
            BodyRef body = world.add(of(Concaves.letter(1, "#.", "##"), Body.dynamic()));
            assertEquals(3000, body.mass(), 1e-9);
            Vector3d products = body.statedProducts(new Vector3d());
            // -1000 sum dx dy about (5/6, 5/6)
            double xy = -1000 * (1 / 9.0 - 2 / 9.0 - 2 / 9.0);
            assertEquals(xy, products.x, 1e-9);
            double xx = 1000 * (3 / 6.0 + 6 / 9.0);
            Matrix3d tensor = new Matrix3d(xx, xy, 0, xy, xx, 0, 0, 0, 1000 * (.5 + 12 / 9.0));
            Vector3d kick = new Vector3d(100, 0, 0);
            Vector3d expected = tensor.invert().transform(new Vector3d(kick));
            body.applyAngularImpulse(kick.x, kick.y, kick.z);
            assertEquals(0, expected.distance(body.angularVelocity()), 1e-12);
        }
    }
}
