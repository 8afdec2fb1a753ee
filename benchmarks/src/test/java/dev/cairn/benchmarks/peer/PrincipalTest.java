package dev.cairn.benchmarks.peer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.SplittableRandom;

/** Principal axes against tensors that were made from known moments and a known rotation. */
class PrincipalTest {
    @Test
    void findsTheMomentsThatATensorWasMadeOf() {
        SplittableRandom random = new SplittableRandom(7);
        for (int trial = 0; trial < 200; trial++) {
            double[] moments = {
                random.nextDouble(0.1, 10), random.nextDouble(0.1, 10), random.nextDouble(0.1, 10)
            };
            Quaterniond turned =
                    new Quaterniond(
                                    random.nextDouble(-1, 1),
                                    random.nextDouble(-1, 1),
                                    random.nextDouble(-1, 1),
                                    random.nextDouble(-1, 1))
                            .normalize();
            Matrix3d r = new Matrix3d().rotation(turned);
            Matrix3d tensor =
                    new Matrix3d(r)
                            .mul(new Matrix3d().scaling(moments[0], moments[1], moments[2]))
                            .mul(new Matrix3d(r).transpose());
            Matrix3d axes = new Matrix3d().rotation(Principal.axes(tensor));
            Matrix3d diagonal = new Matrix3d(axes).transpose().mul(tensor).mul(axes);
            double[] found = {diagonal.m00(), diagonal.m11(), diagonal.m22()};
            Arrays.sort(moments);
            Arrays.sort(found);
            for (int i = 0; i < 3; i++) {
                assertEquals(moments[i], found[i], 1e-12, "seed 7, trial " + trial);
            }
            assertEquals(0, diagonal.m01(), 1e-12);
            assertEquals(0, diagonal.m02(), 1e-12);
            assertEquals(0, diagonal.m12(), 1e-12);
        }
    }
}
