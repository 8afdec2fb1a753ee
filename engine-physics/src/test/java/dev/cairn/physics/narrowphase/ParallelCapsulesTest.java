package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Capsule;

import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/** Capsules side by side in closed form against the general way. */
class ParallelCapsulesTest {
    /** The general way finds them by laying lines over each other in A's frame. */
    @Test
    void capsulesSideBySideHaveThePointsOfTheGeneralWay() {
        NarrowPhase special = new NarrowPhase();
        NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
        Manifold one = new Manifold();
        Manifold two = new Manifold();
        SplittableRandom r = new SplittableRandom(82);
        int lines = 0;
        int others = 0;
        for (int i = 0; i < 40_000; i++) {
            Scene s = new Scene(capsule(r), capsule(r));
            double tilt = Scene.logUniform(r, 1e-12, .4);
            s.qa = Scene.turn(r);
            s.qb = new org.joml.Quaterniond(s.qa);
            s.qb.rotateX(r.nextInt(2) * StrictMath.PI).rotateZ(tilt).rotateX(tilt * Scene.gauss(r));
            double far = s.a.innerRadius() + s.b.innerRadius() - .01;
            s.at(far, 2 * Scene.gauss(r), 0).d.rotateY(6 * r.nextDouble());
            s.qa.transform(s.d);
            long word = s.collide(special, .02, 0, one);
            long wordOther = s.collide(general, .02, 0, two);
            lines += two.pointCount == 2 ? 1 : 0;
            boolean same = one.pointCount == two.pointCount && word == wordOther;
            for (int p = 0; same && p < one.pointCount && one.pointCount == 2; p++) {
                double x = one.pointX[p] - two.pointX[p];
                double y = one.pointY[p] - two.pointY[p];
                double z = one.pointZ[p] - two.pointZ[p];
                // The axis of lines that hardly cross is known within rounding over their tilt.
                same = Math.sqrt(x * x + y * y + z * z) <= 1e-9;
                same &= Math.abs(one.separation[p] - two.separation[p]) <= 1e-14;
                same &= one.feature[p] == two.feature[p];
            }
            others += same ? 0 : 1;
        }
        System.out.println(lines + " side by side, " + others + " others");
        assertTrue(lines > 10_000, lines + " side by side");
        assertTrue(others <= 1e-3 * lines, others + " of " + lines + " are others");
    }

    private static Capsule capsule(SplittableRandom r) {
        return Capsule.of(.2 + .3 * r.nextDouble(), .2 + .8 * r.nextDouble());
    }
}
