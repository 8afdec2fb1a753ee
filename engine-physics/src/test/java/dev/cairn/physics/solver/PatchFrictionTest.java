package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.solver.kernel.PatchFriction;

import org.junit.jupiter.api.Test;

import java.util.Random;

/**
 * The law of {@link PatchFriction} against quadrature over an evenly pressed disc, and its limits.
 */
class PatchFrictionTest {
    /**
     * Force and torque, over mu N and mu N R, of a disc that slides at x and spins at rim speed y.
     */
    private static double[] disc(double x, double y) {
        int rings = 200;
        int spokes = 200;
        double force = 0;
        double torque = 0;
        for (int i = 0; i < rings; i++) {
            // rings of equal area
            double r = Math.sqrt((i + 0.5) / rings);
            for (int j = 0; j < spokes; j++) {
                double angle = 2 * Math.PI * (j + 0.5) / spokes;
                double px = r * StrictMath.cos(angle);
                double py = r * StrictMath.sin(angle);
                double vx = x - y * py;
                double vy = y * px;
                double v = Math.sqrt(vx * vx + vy * vy);
                force += vx / v;
                torque += (px * vy - py * vx) / v;
            }
        }
        return new double[] {force / (rings * spokes), torque / (rings * spokes)};
    }

    /** Force and torque by the law, mass, inertia and radius 1. */
    private static double[] law(double x, double y) {
        double g = PatchFriction.share(x, y, 1 / PatchFriction.RADIUS, 1, 1);
        double s = Math.sqrt(x * x + (PatchFriction.FAR + PatchFriction.CLOSE * g) * y * y);
        return new double[] {x / s, (PatchFriction.FAR + PatchFriction.NEAR * g) * y / s};
    }

    @Test
    void isWhatADiscDoes() {
        double worst = 0;
        for (double angle = 0.02; angle < 1.56; angle += 0.02) {
            double[] is = law(StrictMath.sin(angle), StrictMath.cos(angle));
            double[] must = disc(StrictMath.sin(angle), StrictMath.cos(angle));
            worst = Math.max(worst, Math.abs(is[0] - must[0]));
            worst = Math.max(worst, Math.abs(is[1] - must[1]));
        }
        assertTrue(worst < 0.012, "share of mu N: " + worst);
    }

    @Test
    void itsEndsAreExact() {
        assertEquals(1, law(1, 0)[0], 1e-15);
        assertEquals(0, law(1, 0)[1], 1e-15);
        assertEquals(2.0 / 3, law(0, 1)[1], 1e-15);
        // slide with little spin: torque mu N R/4 y/x; spin with little slide: force mu N x/y
        assertEquals(0.25, law(1, 1e-4)[1] / 1e-4, 1e-6);
        assertEquals(1, law(1e-4, 1)[0] / 1e-4, 1e-6);
    }

    /**
     * A disc that slides and spins stops both at once, with v/(R w) = 0.653 (Weidman, Malhotra).
     */
    @Test
    void slideAndSpinEndTogether() {
        for (double start : new double[] {0.2, 1, 5}) {
            double v = start;
            double w = 1;
            while (v + w > 1e-6) {
                double[] f = law(v, w);
                double h = 1e-4 * Math.max(v, w);
                v -= h * f[0];
                w -= h * f[1] / 0.5; // I = m R²/2
            }
            assertEquals(0.653, v / w, 0.02, "from " + start);
        }
    }

    /** The impulses that are left obey the law at the velocities that are left. */
    @Test
    void whatIsGivenSolvesItsEquation() {
        long seed = 20;
        Random random = new Random(seed);
        int slips = 0;
        double worst = 0;
        for (int i = 0; i < 10_000; i++) {
            // impulses of some times the limit, a radius of gyration of some patch radii
            double mass = StrictMath.exp(random.nextGaussian());
            double limit = StrictMath.exp(random.nextGaussian());
            double r2 = StrictMath.exp(random.nextGaussian());
            double inertia = mass * r2 * StrictMath.exp(0.5 * random.nextGaussian());
            double slide = limit * limit * StrictMath.exp(2 * random.nextGaussian());
            double spin = r2 * limit * limit * StrictMath.exp(2 * random.nextGaussian());
            double bound = limit * Math.sqrt(r2) / PatchFriction.RADIUS;
            double reach = bound / limit;
            boolean holds =
                    PatchFriction.holds(slide, Math.sqrt(spin), limit * limit, bound, reach);
            if (PatchFriction.isStuck(slide, Math.sqrt(spin), limit * limit, bound)) {
                assertTrue(holds, "stuck, yet does not hold; seed " + seed + ", round " + i);
            }
            double g = PatchFriction.share(Math.sqrt(slide), Math.sqrt(spin), reach, mass, inertia);
            double give = give(slide, spin, r2, mass, inertia, limit, g);
            double left = left(slide, spin, r2, mass, inertia, limit, g, give);
            if (holds) {
                assertEquals(0, give, 0.0, "holds, yet gives; seed " + seed + ", round " + i);
            }
            if (give > 0) {
                slips++;
                worst = Math.max(worst, Math.abs(left - 1));
            } else {
                assertTrue(left <= 1 + 1e-12, "sticks beyond the law: " + left);
            }
        }
        assertTrue(slips > 1000, "rounds that slip: " + slips);
        assertTrue(worst < 0.01, "more than the error of the fit: " + worst);
    }

    /**
     * A block that is harder to move one way than the other: what is left of friction is opposite
     * to the slip that is left, v' = v0 + M^-1 F', and as large as mu N.
     */
    @Test
    void frictionIsOppositeToTheSlip() {
        long seed = 23;
        Random random = new Random(seed);
        double worst = 0;
        for (int i = 0; i < 10_000; i++) {
            // M with axes turned anyhow, up to ten times as heavy along one as along the other
            double heavy = power(random, -2, 2);
            double light = heavy * power(random, -1, 0);
            double turn = random.nextDouble() * Math.PI;
            double mean = 0.5 * (heavy + light);
            double half = 0.5 * (heavy - light) * StrictMath.cos(2 * turn);
            double skew = 0.5 * (heavy - light) * StrictMath.sin(2 * turn);
            double v1 = random.nextGaussian();
            double v2 = random.nextGaussian();
            // what stops the slip: F = -M v
            double f1 = -((mean + half) * v1 + skew * v2);
            double f2 = -(skew * v1 + (mean - half) * v2);
            double size = Math.sqrt(f1 * f1 + f2 * f2);
            double limit = size * random.nextDouble();
            double give = PatchFriction.give(f1, f2, 0, 0, mean, half, skew, 1, limit);
            // F' = mu N (D M + mu N)^-1 F, by Cramer's rule
            double a11 = give * (mean + half) + limit;
            double a22 = give * (mean - half) + limit;
            double a12 = give * skew;
            double det = a11 * a22 - a12 * a12;
            double g1 = limit * (a22 * f1 - a12 * f2) / det;
            double g2 = limit * (a11 * f2 - a12 * f1) / det;
            double m = heavy * light;
            double left1 = v1 + ((mean - half) * g1 - skew * g2) / m;
            double left2 = v2 + ((mean + half) * g2 - skew * g1) / m;
            double left = Math.sqrt(left1 * left1 + left2 * left2);
            double cosine = -(g1 * left1 + g2 * left2) / (limit * left);
            worst = Math.max(worst, 1 - cosine);
            worst = Math.max(worst, Math.abs(left / give - 1));
            worst = Math.max(worst, Math.abs(Math.sqrt(g1 * g1 + g2 * g2) / limit - 1));
        }
        // what three steps leave where the one axis is ten times as heavy as the other
        assertTrue(worst < 1e-5, "worst " + worst + ", seed " + seed);
    }

    /**
     * Coulomb's law, {@code F <= mu N}, for patches of any radius: where all weight is on one point
     * the radius is next to 0, and a patch with a radius of 0 is a point.
     */
    @Test
    void noRadiusGivesMoreThanCoulombAllows() {
        long seed = 22;
        Random random = new Random(seed);
        double worst = 0;
        for (int i = 0; i < 100_000; i++) {
            double radius = power(random, -12, 0);
            double limit = power(random, -3, 1);
            double mass = power(random, -2, 2);
            double inertia = mass * power(random, -4, 1) * square(radius * power(random, -1, 6));
            double slide = limit * power(random, 0, 3);
            double spin = limit * radius * power(random, -3, 3);
            double g =
                    PatchFriction.share(slide, spin, radius / PatchFriction.RADIUS, mass, inertia);
            double give =
                    give(square(slide), square(spin), square(radius), mass, inertia, limit, g);
            worst = Math.max(worst, slide / (mass * give + limit));
        }
        // the rest of three steps, where slide and spin both are just beyond what sticks
        assertTrue(worst < 1.03, "share of mu N: " + worst + ", seed " + seed);
    }

    private static double power(Random random, double least, double most) {
        return StrictMath.pow(10, least + (most - least) * random.nextDouble());
    }

    private static double square(double x) {
        return x * x;
    }

    private static double give(
            double slide,
            double spin,
            double r2,
            double mass,
            double inertia,
            double limit,
            double g) {
        double whole = (PatchFriction.FAR + PatchFriction.NEAR * g) * r2 * limit;
        double across = Math.sqrt((PatchFriction.FAR + PatchFriction.CLOSE * g) * r2 * spin);
        return PatchFriction.give(Math.sqrt(slide), 0, across, whole, mass, 0, 0, inertia, limit);
    }

    private static double left(
            double slide,
            double spin,
            double r2,
            double mass,
            double inertia,
            double limit,
            double g,
            double give) {
        double whole = (PatchFriction.FAR + PatchFriction.NEAR * g) * r2 * limit;
        double u = mass * give + limit;
        double w = inertia * give + whole;
        return slide / (u * u)
                + (PatchFriction.FAR + PatchFriction.CLOSE * g) * r2 * spin / (w * w);
    }

    @Test
    void aPatchHoldsUpToItsLimitsAndNoFurther() {
        assertTrue(PatchFriction.holds(0.99, 0, 1, 1, 1));
        assertFalse(PatchFriction.holds(1.01, 0, 1, 1, 1));
        assertTrue(PatchFriction.holds(0, 0.748, 1, 1, 1));
        assertFalse(PatchFriction.holds(0, 1.01, 1, 1, 1));
        assertTrue(PatchFriction.holds(0, 0, 0, 0, 0));
    }

    /** Friction takes energy, whatever the impulses are. */
    @Test
    void neverAddsEnergy() {
        long seed = 21;
        Random random = new Random(seed);
        for (int i = 0; i < 10_000; i++) {
            double v = random.nextGaussian();
            double w = random.nextGaussian();
            double limit = StrictMath.exp(2 * random.nextGaussian());
            double bound = limit / PatchFriction.RADIUS;
            double slide = v * v;
            double spin = w * w;
            if (PatchFriction.holds(slide, Math.sqrt(spin), limit * limit, bound, bound / limit)) {
                continue;
            }
            double g =
                    PatchFriction.share(
                            Math.sqrt(slide), Math.sqrt(spin), 1 / PatchFriction.RADIUS, 1, 1);
            double give = give(slide, spin, 1, 1, 1, limit, g);
            double whole = (PatchFriction.FAR + PatchFriction.NEAR * g) * limit;
            double v1 = v * (1 - limit / (give + limit));
            double w1 = w * (1 - whole / (give + whole));
            assertTrue(v1 * v1 + w1 * w1 <= slide + spin, "seed " + seed + ", round " + i);
            assertTrue(v1 * v >= 0 && w1 * w >= 0, "turned round; seed " + seed);
        }
    }
}
