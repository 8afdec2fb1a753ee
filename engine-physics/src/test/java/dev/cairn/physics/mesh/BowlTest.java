package dev.cairn.physics.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** A ball that slides in a bowl of triangles is a pendulum. */
class BowlTest {
    private static final double RADIUS = 2, BALL = .2;

    /** 2 pi sqrt(L/g) / agm(1, cos(a/2)), by Gauss. */
    private static double truth(double amplitude) {
        double a = 1;
        double b = StrictMath.cos(amplitude / 2);
        for (int i = 0; i < 8; i++) {
            double mean = (a + b) / 2;
            b = Math.sqrt(a * b);
            a = mean;
        }
        return 2 * Math.PI * Math.sqrt((RADIUS - BALL) / 9.81) / a;
    }

    private static double period(double amplitude, int facets) {
        Material smooth = new Material(0, 0, 1000);
        double length = RADIUS - BALL;
        try (PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -9.81, 0).sleeping(false).workers(1).build()) {
            world.add(Body.fixed().shape(Grounds.bowl(RADIUS, facets)).material(smooth));
            double out = length * StrictMath.sin(amplitude);
            double x = out * StrictMath.cos(.01);
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(BALL))
                                    .material(smooth)
                                    .at(
                                            x,
                                            -length * StrictMath.cos(amplitude),
                                            out * StrictMath.sin(.01)));
            double first = Double.NaN;
            int passed = 0;
            for (int tick = 1; tick < 400; tick++) {
                world.step(1 / 60.0);
                double now = ball.position(new Vector3d()).x;
                if (now < 0 != x < 0) {
                    double when = (tick - now / (now - x)) / 60;
                    passed++;
                    first = passed == 1 ? when : first;
                    if (passed == 3) {
                        return when - first;
                    }
                }
                x = now;
            }
        }
        throw new AssertionError("it never came back");
    }

    private static double error(double amplitude, int facets) {
        return Math.abs(period(amplitude, facets) / truth(amplitude) - 1);
    }

    /**
     * Over a polygon a point that loses what is across each corner has another period: at 0.2 rad,
     * which are six facets of 200, it is 3.9e-3 shorter, by integration of its straight pieces.
     */
    @Test
    void theBallHasThePeriodOfAPendulum() {
        assertEquals(0, error(.4, 200), 1e-3, "0.4 rad, 200 around");
        double coarse = error(.2, 100);
        double fine = error(.2, 400);
        assertEquals(0, error(.2, 200), 6e-3, "0.2 rad, 200 around");
        assertTrue(fine < 2e-3 && fine < coarse / 4, fine + " from " + coarse);
    }
}
