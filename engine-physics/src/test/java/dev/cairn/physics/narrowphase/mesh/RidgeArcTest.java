package dev.cairn.physics.narrowphase.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.mesh.Meshed;
import dev.cairn.physics.shape.mesh.TriangleSet;

import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;

import java.util.Random;

/** Truth: the separation along a normal is that of the deepest point, tried over all normals. */
class RidgeArcTest {
    private static final int TRIED = 20_000;

    @Test
    void theNormalIsTheBestOfAllAndTheShapeIsMetThere() {
        Random random = new Random(3);
        double[] xyz = new double[60];
        for (int i = 0; i < xyz.length; i++) {
            xyz[i] = 0.3 * random.nextGaussian();
        }
        Shape[] shapes = {
            Box.ofHalfExtents(.3, .2, .25), ConvexHull.of(xyz), Sphere.of(.2), Capsule.of(.2, .3)
        };
        Pair pair = new Pair();
        RidgeArc arc = new RidgeArc();
        Deepest deepest = new Deepest();
        int between = 0;
        int unknown = 0;
        for (int i = 0; i < 200; i++) {
            Shape shape = shapes[i % shapes.length];
            Quaterniond q =
                    new Quaterniond(
                                    random.nextGaussian(),
                                    random.nextGaussian(),
                                    random.nextGaussian(),
                                    random.nextGaussian())
                            .normalize();
            pair.set(shape, shape, q.x, q.y, q.z, q.w, q.x, q.y, q.z, q.w, 0, 0, 0);
            // the ridge is along z, the face's normal y, over the ridge is x
            double[] corner = {.1 * random.nextGaussian(), -.42, 0};
            double angle = 1.4 * random.nextDouble() + .05;
            arc.ridge(corner, 0, 0, 1, 0, 1, 0, 0);
            if (!arc.find(pair, Math.tan(angle))) {
                unknown++;
                continue;
            }
            double most = Double.NEGATIVE_INFINITY;
            double at = 0;
            for (int k = 0; k <= TRIED; k++) {
                double a = angle * k / TRIED;
                deepest.find(pair, -Math.sin(a), -Math.cos(a), 0);
                double s =
                        (deepest.y - corner[1]) * Math.cos(a)
                                + (deepest.x - corner[0]) * Math.sin(a);
                if (s > most) {
                    most = s;
                    at = a;
                }
            }
            assertTrue(arc.separation >= most - 1e-12, "of all normals");
            assertEquals(most, arc.separation, 1e-4);
            double found = Math.atan2(arc.sine, arc.cosine);
            assertTrue(found >= 0 && found <= angle + 1e-12);
            if (at > 0 && at < angle) {
                between++;
            }
        }
        assertTrue(between > 60, between + " between the faces");
        assertTrue(unknown < 20, unknown + " are in deep");
    }

    /** A square of two triangles, 1 m below the middle of a ball of 0.9 m. */
    @Test
    void whatDoesNotComeNearerHasNoContactHoweverFastItIs() {
        TriangleMesh floor =
                TriangleMesh.of(
                        new double[] {-5, 0, -5, -5, 0, 5, 5, 0, 5, 5, 0, -5},
                        new int[] {0, 1, 2, 0, 2, 3});
        assertEquals(0, contacts(floor, .5, 0));
        assertEquals(0, contacts(floor, .5, .05));
        assertEquals(0, contacts(floor, .5, -.05));
        assertEquals(1, contacts(floor, .5, -.15));
    }

    private static int contacts(TriangleMesh floor, double vx, double vy) {
        MeshContact contact = new MeshContact(new NarrowPhase());
        ContactList out = new ContactList();
        TriangleSet set = TriangleSet.of((Meshed) floor);
        double face = .01 + Math.hypot(vx, vy);
        Sphere ball = Sphere.of(.9);
        contact.collide(set, 0, 0, 0, 1, ball, 0, 0, 0, 1, 0, 1, 0, vx, vy, 0, .01, face, out);
        return out.count;
    }
}
