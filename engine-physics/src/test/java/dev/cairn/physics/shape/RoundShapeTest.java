package dev.cairn.physics.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;

/**
 * Mass, bounds and errors of what is turned on a lathe, against slices summed by Simpson's rule.
 */
class RoundShapeTest {
    private static final double R = .7;
    private static final double H = 1.3;

    /** Radius over height of each shape's frame. */
    private static double radius(Shape shape, double y) {
        return switch (shape) {
            case Capsule c -> {
                double over = Math.max(0, Math.abs(y) - c.halfLength());
                yield Math.sqrt(Math.max(0, c.radius() * c.radius() - over * over));
            }
            case Cylinder c -> c.radius();
            case Cone c -> c.radius() * (c.halfHeight() - y) / (2 * c.halfHeight());
            default -> throw new IllegalArgumentException();
        };
    }

    /** Simpson's rule on pieces on which the integrand is a polynomial. */
    private static double integral(Shape shape, DoubleUnaryOperator f) {
        double[] cuts =
                shape instanceof Capsule
                        ? new double[] {-H - R, -H, H, H + R}
                        : new double[] {-H, H};
        double sum = 0;
        for (int k = 0; k + 1 < cuts.length; k++) {
            int n = 2000;
            double h = (cuts[k + 1] - cuts[k]) / n;
            for (int i = 0; i < n; i++) {
                double y = cuts[k] + i * h;
                sum +=
                        h
                                / 6
                                * (f.applyAsDouble(y)
                                        + 4 * f.applyAsDouble(y + h / 2)
                                        + f.applyAsDouble(y + h));
            }
        }
        return sum;
    }

    private static Shape[] shapes() {
        return new Shape[] {Capsule.of(R, H), Cylinder.of(R, H), Cone.of(R, H)};
    }

    @Test
    void massCentreAndInertiaAreThoseOfTheSlices() {
        for (Shape shape : shapes()) {
            DoubleUnaryOperator area = y -> Math.PI * radius(shape, y) * radius(shape, y);
            double mass = integral(shape, area);
            double com = integral(shape, y -> y * area.applyAsDouble(y)) / mass;
            double axial =
                    integral(
                                    shape,
                                    y ->
                                            area.applyAsDouble(y)
                                                    * radius(shape, y)
                                                    * radius(shape, y))
                            / 2;
            double across =
                    axial / 2 + integral(shape, y -> area.applyAsDouble(y) * (y - com) * (y - com));
            MassProperties p = shape.massProperties(2);
            assertEquals(2 * mass, p.mass(), 1e-11, shape.toString());
            assertEquals(mass, shape.volume(), 1e-11, shape.toString());
            assertEquals(com, p.comY(), 1e-12, shape.toString());
            assertEquals(com, shape.centreOfMass(new Vector3d()).y, 1e-12, shape.toString());
            assertEquals(2 * axial, p.iyy(), 1e-11, shape.toString());
            assertEquals(2 * across, p.ixx(), 1e-11, shape.toString());
            assertEquals(p.ixx(), p.izz(), 0.0, shape.toString());
        }
    }

    /** Points of the surface, from the centre of mass. */
    private static Vector3d point(Shape shape, SplittableRandom r) {
        double top = shape instanceof Capsule ? H + R : H;
        double y = -top + 2 * top * r.nextDouble();
        double angle = 2 * Math.PI * r.nextDouble();
        double radius = radius(shape, y);
        return new Vector3d(radius * Math.cos(angle), y, radius * Math.sin(angle))
                .sub(shape.centreOfMass(new Vector3d()));
    }

    @Test
    void boundsAndRadiiHoldTheSurfaceAndTouchIt() {
        SplittableRandom r = new SplittableRandom(11);
        double[] box = new double[6];
        for (Shape shape : shapes()) {
            for (int turn = 0; turn < 10; turn++) {
                Quaterniond q =
                        new Quaterniond(
                                        r.nextDouble() - .5,
                                        r.nextDouble() - .5,
                                        r.nextDouble() - .5,
                                        r.nextDouble() - .5)
                                .normalize();
                shape.bounds(q.x, q.y, q.z, q.w, box, 0);
                Vector3d low = new Vector3d(Double.MAX_VALUE);
                Vector3d high = new Vector3d(-Double.MAX_VALUE);
                double inner = Double.MAX_VALUE;
                double outer = 0;
                for (int i = 0; i < 40_000; i++) {
                    Vector3d p = point(shape, r);
                    inner = Math.min(inner, p.length());
                    outer = Math.max(outer, p.length());
                    q.transform(p);
                    low.min(p);
                    high.max(p);
                }
                for (int axis = 0; axis < 3; axis++) {
                    assertTrue(box[axis] <= low.get(axis) + 1e-12, shape + " low");
                    assertTrue(box[3 + axis] >= high.get(axis) - 1e-12, shape + " high");
                    assertEquals(low.get(axis), box[axis], .03, shape + " is tight");
                    assertEquals(high.get(axis), box[3 + axis], .03, shape + " is tight");
                }
                assertTrue(shape.innerRadius() <= inner + 1e-12, shape + " inner");
                assertTrue(shape.outerRadius() >= outer - 1e-12, shape + " outer");
                assertEquals(outer, shape.outerRadius(), .03, shape + " outer");
            }
        }
    }

    @ParameterizedTest
    @ValueSource(
            doubles = {
                0,
                -1,
                1e-300,
                1e300,
                Double.NaN,
                Double.POSITIVE_INFINITY,
                Double.MIN_VALUE
            })
    void badLengthsAreNamed(double bad) {
        Runnable[] makers = {
            () -> Capsule.of(bad, 1), () -> Capsule.of(1, bad), () -> Cylinder.of(bad, 1),
            () -> Cylinder.of(1, bad), () -> Cone.of(bad, 1), () -> Cone.of(1, bad)
        };
        for (Runnable maker : makers) {
            String told =
                    String.valueOf(
                            assertThrows(DegenerateShapeException.class, maker::run).getMessage());
            assertTrue(told.contains(String.valueOf(bad)), told);
        }
    }

    @Test
    void aMovedShapeHasTheMassOfItsPlace() {
        Quaterniond turn = new Quaterniond().rotationZ(.5 * Math.PI);
        Shape moved = Cone.of(R, H).moved(1, 2, 3, turn);
        MassProperties still = Cone.of(R, H).massProperties(1);
        MassProperties p = moved.massProperties(1);
        assertEquals(1 + .5 * H, p.comX(), 1e-14);
        assertEquals(2, p.comY(), 1e-14);
        assertEquals(3, p.comZ(), 1e-14);
        assertEquals(still.iyy(), p.ixx(), 1e-14);
        assertEquals(still.ixx(), p.iyy(), 1e-14);
        Shape twice = moved.moved(0, 0, 1, turn);
        assertEquals(-2, twice.massProperties(1).comX(), 1e-14);
        assertTrue(twice instanceof Moved m && m.inner() instanceof Cone, twice.toString());
        assertThrows(
                IllegalArgumentException.class,
                () -> Sphere.of(1).moved(Double.NaN, 0, 0, new Quaterniond()));
        assertThrows(
                IllegalArgumentException.class,
                () -> Sphere.of(1).moved(0, 0, 0, new Quaterniond(1, 1, 0, 0)));
        assertThrows(
                IllegalArgumentException.class,
                () -> HalfSpace.of().moved(0, 0, 0, new Quaterniond()));
    }
}
