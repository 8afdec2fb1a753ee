package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/** The contact of a ball and a box against the nearest point of the box, in either order. */
class BallBoxTest {
    private static double most(Vector3d v) {
        return Math.max(v.x, Math.max(v.y, v.z));
    }

    @Test
    void itTouchesMidwayBetweenTheCentreAndTheNearestPoint() {
        NarrowPhase n = new NarrowPhase();
        Manifold m = new Manifold();
        SplittableRandom r = new SplittableRandom(311);
        int touching = 0;
        int inside = 0;
        for (int i = 0; i < 40_000; i++) {
            Box box = Scene.box(r);
            Sphere ball = Sphere.of(Scene.logUniform(r, .1, 10));
            Scene s = Scene.random(r, box, ball);
            double margin = .02 * Math.min(box.innerRadius(), ball.innerRadius());
            Vector3d c = s.qa.transformInverse(s.d, new Vector3d());
            Vector3d half = new Vector3d(box.halfX(), box.halfY(), box.halfZ());
            Vector3d near = new Vector3d(c).min(half).max(half.negate(new Vector3d()));
            double truth = near.distance(c) - ball.radius();
            Vector3d over = c.absolute(new Vector3d()).sub(half);
            if (most(over) < 0) {
                truth = most(over) - ball.radius();
                inside++;
            }
            String where = "seed 311 pose " + i;
            double bar = 1e-14 * s.size();
            for (int order = 0; order < 2; order++) {
                Scene t = order == 0 ? s : s.swapped();
                assertEquals(0, t.collide(n, margin, 0, m), where);
                assertEquals(truth <= margin ? 1 : 0, m.pointCount, where);
                if (m.pointCount == 0) {
                    continue;
                }
                touching++;
                assertEquals(truth, m.separation[0], bar, where);
                assertTrue(Math.abs(truth - t.distance(n)) <= bar, where);
                double sign = order == 0 ? 1 : -1;
                Vector3d normal = new Vector3d(m.normalX, m.normalY, m.normalZ).mul(sign);
                Vector3d p = new Vector3d(m.pointX[0], m.pointY[0], m.pointZ[0]);
                p.add(order == 0 ? new Vector3d() : s.d);
                // On the ball's surface when half of the separation is added, and on the box's
                // when it is taken away.
                double half1 = .5 * truth;
                assertEquals(1, normal.length(), 1e-15, where);
                Vector3d onBall = new Vector3d(p).fma(half1, normal);
                assertEquals(ball.radius(), onBall.distance(s.d), bar, where);
                Vector3d onBox = new Vector3d(p).fma(-half1, normal);
                s.qa.transformInverse(onBox).absolute().sub(half);
                assertEquals(0, most(onBox), bar, where);
            }
        }
        assertTrue(touching > 20_000 && inside > 2_000, touching + " " + inside);
    }
}
