package dev.cairn.render.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector4d;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * What is left out is outside of the picture: held against points that are projected one by one.
 */
class FrustumTest {
    private static final int CASES = 20_000;

    private final Frustum frustum = new Frustum();
    private final Vector4d clip = new Vector4d();

    private boolean isInside(Matrix4d matrix, Vector3d point, boolean openNear) {
        matrix.transform(clip.set(point, 1));
        // In front of the eye, and between the planes.
        return clip.w > 0
                && Math.abs(clip.x) <= clip.w
                && Math.abs(clip.y) <= clip.w
                && clip.z <= clip.w
                && (openNear || clip.z >= -clip.w);
    }

    /** A power of ten, from thousandths of a millimetre to a thousand kilometres. */
    private static double magnitude(SplittableRandom random) {
        return Math.pow(10, random.nextDouble(-6, 6));
    }

    private static Matrix4d perspective(SplittableRandom random) {
        double near = Math.pow(10, random.nextDouble(-3, 1));
        return new Matrix4d()
                .setPerspective(
                        random.nextDouble(0.02, 3),
                        random.nextDouble(0.2, 5),
                        near,
                        near * Math.pow(10, random.nextDouble(0.5, 6)))
                .rotateX(random.nextDouble(-1.5, 1.5))
                .rotateY(random.nextDouble(-3.2, 3.2))
                .translate(
                        random.nextDouble(-64, 64),
                        random.nextDouble(-64, 64),
                        random.nextDouble(-64, 64));
    }

    private static Vector3d direction(SplittableRandom random) {
        return new Vector3d(
                        random.nextDouble(-1, 1),
                        random.nextDouble(-1, 1),
                        random.nextDouble(-1, 1))
                .normalize();
    }

    @Test
    void nothingThatShowsIsLeftOut() {
        SplittableRandom random = new SplittableRandom(7);
        int shown = 0;
        int leftOut = 0;
        for (int i = 0; i < CASES; i++) {
            boolean openNear = random.nextBoolean();
            Matrix4d matrix =
                    openNear
                            ? new Matrix4d()
                                    .setOrtho(-9, 9, -9, 9, -18, 18)
                                    .rotate(random.nextDouble(3), direction(random))
                            : perspective(random);
            frustum.set(matrix, openNear);
            // A turned block: its sphere goes through its corners.
            double size = magnitude(random);
            Vector3d half =
                    new Vector3d(
                            size * random.nextDouble(), size * random.nextDouble(), size * 0.1);
            Quaterniond turn = new Quaterniond().rotateAxis(3, direction(random));
            Vector3d centre = direction(random).mul(magnitude(random));
            boolean touches = frustum.touches(centre.x, centre.y, centre.z, half.length());
            boolean seen = false;
            for (int p = 0; p < 40 && !seen; p++) {
                Vector3d point =
                        p < 8
                                ? new Vector3d(
                                        (p & 1) == 0 ? half.x : -half.x,
                                        (p & 2) == 0 ? half.y : -half.y,
                                        (p & 4) == 0 ? half.z : -half.z)
                                : new Vector3d(
                                        half.x * random.nextDouble(-1, 1),
                                        half.y * random.nextDouble(-1, 1),
                                        half.z * random.nextDouble(-1, 1));
                seen = isInside(matrix, turn.transform(point).add(centre), openNear);
            }
            assertTrue(touches || !seen, "case " + i + " of seed 7 shows, but is left out");
            shown += seen ? 1 : 0;
            leftOut += touches ? 0 : 1;
        }
        assertTrue(
                shown > CASES / 50 && leftOut > CASES / 5, shown + " shown, " + leftOut + " out");
    }

    @Test
    void whatLiesWhollyBehindOnePlaneIsLeftOut() {
        SplittableRandom random = new SplittableRandom(8);
        int out = 0;
        for (int i = 0; i < CASES; i++) {
            Matrix4d matrix = perspective(random);
            frustum.set(matrix, false);
            double radius = Math.pow(10, random.nextDouble(-4, 3));
            Vector3d centre = direction(random).mul(Math.pow(10, random.nextDouble(-2, 3)));
            // The clip conditions are linear in the point, so over a ball they are extreme where
            // their gradient says: the rows of the matrix.
            boolean behind = false;
            for (int plane = 0; plane < 6; plane++) {
                int axis = plane / 2;
                double sign = plane % 2 == 0 ? 1 : -1;
                Vector4d row = matrix.getRow(3, new Vector4d());
                row.add(matrix.getRow(axis, new Vector4d()).mul(sign));
                double length = Math.sqrt(row.x * row.x + row.y * row.y + row.z * row.z);
                double distance =
                        (row.x * centre.x + row.y * centre.y + row.z * centre.z + row.w) / length;
                behind |= distance < -1.001 * radius - 1e-4 * centre.length() - 1e-9;
            }
            if (behind) {
                out++;
                assertEquals(
                        false,
                        frustum.touches(centre.x, centre.y, centre.z, radius),
                        "case " + i + " of seed 8");
            }
        }
        assertTrue(out > CASES / 5, "only " + out + " cases");
    }
}
