package dev.cairn.samples.overlap;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/** Depths that a person can work out with pencil and paper. */
class PenetrationTest {
    private static final double TINY = 1e-12;
    private static final Quaterniond UPRIGHT = new Quaterniond();
    private static final Box CUBE = Box.cubeOfHalfExtent(0.5);

    private static double depth(
            Shape a, Shape b, double x, double y, double z, Quaterniond turned) {
        double one =
                Penetration.depth(a, new Vector3d(), UPRIGHT, b, new Vector3d(x, y, z), turned);
        double other =
                Penetration.depth(b, new Vector3d(x, y, z), turned, a, new Vector3d(), UPRIGHT);
        assertEquals(one, other, TINY, "depth must not depend on the order");
        return one;
    }

    private static Quaterniond about(double x, double y, double z, double degrees) {
        return new Quaterniond().rotateAxis(StrictMath.toRadians(degrees), x, y, z);
    }

    @Test
    void boxesFaceToFace() {
        assertEquals(0.1, depth(CUBE, CUBE, 0, 0.9, 0, UPRIGHT), TINY);
        assertEquals(0.1, depth(CUBE, CUBE, 0.3, 0.9, -0.2, UPRIGHT), TINY);
        assertEquals(0, depth(CUBE, CUBE, 0, 1, 0, UPRIGHT), TINY);
        assertEquals(0, depth(CUBE, CUBE, 0, 1.1, 0, UPRIGHT), TINY);
        // The shallowest way out counts.
        assertEquals(0.05, depth(CUBE, CUBE, 0.95, 0.9, 0, UPRIGHT), TINY);
        // One inside the other.
        assertEquals(0.6, depth(CUBE, Box.cubeOfHalfExtent(0.1), 0, 0, 0, UPRIGHT), TINY);
    }

    @Test
    void boxStandsOnItsEdgeInAFace() {
        // Half the diagonal of a unit square is sqrt(1/2).
        double reach = StrictMath.sqrt(0.5);
        assertEquals(0.02, depth(CUBE, CUBE, 0, 0.5 + reach - 0.02, 0, about(0, 0, 1, 45)), TINY);
    }

    @Test
    void boxesCrossAtTheirEdges() {
        // Two cubes, each with an edge towards the other, the edges at right angles: only an
        // edge-edge axis parts them.
        double reach = StrictMath.sqrt(0.5);
        Vector3d up = new Vector3d(0, 2 * reach - 0.03, 0);
        double depth =
                Penetration.depth(
                        CUBE, new Vector3d(), about(0, 0, 1, 45), CUBE, up, about(1, 0, 0, 45));
        assertEquals(0.03, depth, TINY);
    }

    @Test
    void diagonalNeighboursWhoseBoundsOverlapDoNotTouch() {
        double along = 1.05 * StrictMath.sqrt(0.5);
        Quaterniond turned = about(0, 0, 1, 45);
        assertEquals(
                0,
                Penetration.depth(
                        CUBE, new Vector3d(), turned, CUBE, new Vector3d(along, along, 0), turned));
    }

    @Test
    void spheres() {
        Sphere sphere = Sphere.of(0.5);
        assertEquals(0.2, depth(sphere, sphere, 0.48, 0.64, 0, UPRIGHT), TINY);
        assertEquals(0, depth(sphere, sphere, 0.6, 0.8, 0, UPRIGHT), TINY);
        assertEquals(1, depth(sphere, sphere, 0, 0, 0, UPRIGHT), TINY);
    }

    @Test
    void sphereAgainstFaceEdgeCornerAndInside() {
        Sphere sphere = Sphere.of(0.5);
        assertEquals(0.1, depth(CUBE, sphere, 0.2, 0.9, 0.1, UPRIGHT), TINY);
        // Nearest point is on the edge at (0.5, 0.5): offset (0.3, 0.4) is 0.5 away.
        assertEquals(0, depth(CUBE, sphere, 0.8, 0.9, 0, UPRIGHT), TINY);
        assertEquals(0.25, depth(CUBE, sphere, 0.65, 0.7, 0, UPRIGHT), TINY);
        // At the corner: offset (0.1, 0.2, 0.2) is 0.3 away.
        assertEquals(0.2, depth(CUBE, sphere, 0.6, 0.7, 0.7, UPRIGHT), TINY);
        // Centre inside, 0.1 below the upper face.
        assertEquals(0.6, depth(CUBE, sphere, 0, 0.4, 0, UPRIGHT), TINY);
    }

    @Test
    void hullOfABoxIsTheBox() {
        double[] corners = new double[24];
        for (int i = 0; i < 8; i++) {
            corners[3 * i] = (i & 1) - 0.5;
            corners[3 * i + 1] = (i >> 1 & 1) - 0.5;
            corners[3 * i + 2] = (i >> 2 & 1) - 0.5;
        }
        ConvexHull hull = ConvexHull.of(corners);
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 200; i++) {
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double z = random.nextDouble(-1, 1);
            Quaterniond turned = about(0.48, 0.64, 0.6, random.nextDouble(0, 360));
            assertEquals(
                    depth(CUBE, CUBE, x, y, z, turned),
                    depth(hull, CUBE, x, y, z, turned),
                    1e-10,
                    "case " + i);
            assertEquals(
                    depth(CUBE, Sphere.of(0.4), x, y, z, turned),
                    depth(hull, Sphere.of(0.4), x, y, z, turned),
                    1e-10,
                    "case " + i);
        }
    }

    @Test
    void depthPartsThePair() {
        // Moving by the depth in the best of many directions parts the boxes, and no direction does
        // it with less.
        SplittableRandom random = new SplittableRandom(11);
        for (int i = 0; i < 50; i++) {
            Vector3d at =
                    new Vector3d(
                            random.nextDouble(0.9), random.nextDouble(0.9), random.nextDouble(0.9));
            Quaterniond turned = about(0.6, 0, 0.8, random.nextDouble(0, 360));
            double depth = depth(CUBE, CUBE, at.x, at.y, at.z, turned);
            for (int k = 0; k < 50; k++) {
                Vector3d d =
                        new Vector3d(
                                random.nextDouble(-1, 1),
                                random.nextDouble(-1, 1),
                                random.nextDouble(-1, 1));
                if (d.length() > 0.1) {
                    Vector3d moved = new Vector3d(at).add(d.normalize(0.99 * depth));
                    double left = depth(CUBE, CUBE, moved.x, moved.y, moved.z, turned);
                    if (depth > 1e-9) {
                        assertEquals(
                                true, left > 0, "case " + i + ": parted by less than the depth");
                    }
                }
            }
        }
    }
}
