package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.DegenerateShapeException;
import dev.cairn.physics.shape.DegenerateShapeException.Reason;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.polyhedron.Polyhedron;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;

/**
 * The cases N1 to N4, N6, N9 and N10 of the accuracy catalogue for every kind of shape: what cannot
 * be is refused by name, all else steps without a NaN.
 */
class DegenerateInputTest {
    private static final double[] NO_LENGTH = {
        0,
        -0.0,
        -1,
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        Double.MIN_VALUE,
        1e-310,
        1e-300,
        1e300,
        Double.MAX_VALUE
    };

    /** Each length of each shape as a function of it. */
    private static Map<String, DoubleFunction<Shape>> lengths() {
        Map<String, DoubleFunction<Shape>> all = new LinkedHashMap<>();
        all.put("Sphere", Sphere::of);
        all.put("Box x", v -> Box.ofHalfExtents(v, 1, 1));
        all.put("Box y", v -> Box.ofHalfExtents(1, v, 1));
        all.put("Box z", v -> Box.ofHalfExtents(1, 1, v));
        all.put("Box", Box::cubeOfHalfExtent);
        all.put("Capsule radius", v -> Capsule.of(v, 1));
        all.put("Capsule halfLength", v -> Capsule.of(1, v));
        all.put("Cylinder radius", v -> Cylinder.of(v, 1));
        all.put("Cylinder halfHeight", v -> Cylinder.of(1, v));
        all.put("Cone radius", v -> Cone.of(v, 1));
        all.put("Cone halfHeight", v -> Cone.of(1, v));
        return all;
    }

    /** Whatever the shapes, a few ticks of them in one spot, on the ground and beside it. */
    private static void steps(String what, Shape... shapes) {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef witness =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(100, .5, 0));
            List<BodyRef> bodies = new ArrayList<>();
            for (Shape shape : shapes) {
                bodies.add(world.add(Body.dynamic().shape(shape).at(0, 1, 0)));
            }
            for (int tick = 0; tick < 20; tick++) {
                world.step(Scenes.STEP);
            }
            for (BodyRef body : bodies) {
                assertTrue(body.position().isFinite(), what + " " + body.shape());
                assertTrue(body.velocity().isFinite(), what + " " + body.shape());
                assertTrue(body.orientation().isFinite(), what + " " + body.shape());
            }
            assertEquals(.5, witness.position().y, 1e-4, what);
        }
    }

    /** N1: mass by density, and stated. */
    @Test
    void n1MassesThatAreNoneAreRefusedAndExtremeOnesStep() {
        for (double bad : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            for (Shape shape : Scenes.kinds()) {
                String what = bad + " " + shape;
                assertThrows(IllegalArgumentException.class, () -> shape.massProperties(bad), what);
            }
            var mass = assertThrows(IllegalArgumentException.class, () -> Body.dynamic().mass(bad));
            assertTrue(mass.getMessage().contains("" + bad), mass.getMessage());
            assertThrows(IllegalArgumentException.class, () -> new Material(0, 0, bad));
        }
        for (double extreme : new double[] {1e-300, 1e-30, 1e30, 1e300}) {
            for (Shape shape : Scenes.kinds()) {
                stepsOrTeaches("mass " + extreme, Body.dynamic().shape(shape).mass(extreme));
            }
        }
    }

    /** Either an error that names a number, or finite motion; the neighbour is untouched. */
    private static void stepsOrTeaches(String what, Body body) {
        stepsOrTeaches(what, body, 1);
    }

    private static void stepsOrTeaches(String what, Body body, double height) {
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef witness =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(100, .5, 0));
            BodyRef ref;
            try {
                ref = world.add(body.at(0, height, 0));
            } catch (IllegalArgumentException refused) {
                assertTrue(refused.getMessage().matches(".*[0-9].*"), refused.getMessage());
                return;
            }
            for (int tick = 0; tick < 20; tick++) {
                world.step(Scenes.STEP);
            }
            assertTrue(ref.position().isFinite(), what);
            assertTrue(ref.orientation().isFinite(), what);
            assertEquals(.5, witness.position().y, 1e-4, what);
        }
    }

    /** N2. */
    @Test
    void n2EveryLengthOfEveryShapeIsChecked() {
        lengths()
                .forEach((name, make) -> {
                    for (double bad : NO_LENGTH) {
                        var e =
                                assertThrows(
                                        DegenerateShapeException.class,
                                        () -> make.apply(bad),
                                        name + " " + bad);
                        Reason reason = Double.isFinite(bad) ? Reason.EXTENT : Reason.NOT_FINITE;
                        assertSame(reason, e.reason(), name + " " + bad);
                        String message = String.valueOf(e.getMessage());
                        assertTrue(message.contains(name.split(" ")[0]), message);
                        assertTrue(message.contains(String.valueOf(bad)), message);
                    }
                });
    }

    /** What is just within the bounds has finite mass, and collides and steps. */
    @Test
    void n2TinyAndHugeShapesStep() {
        for (double size : new double[] {1e-40, 1e-12, 1e-6, 1e6, 1e12}) {
            lengths()
                    .forEach((name, make) -> {
                        double length = name.contains(" ") && size > 1 ? 1 : size;
                        Shape shape = make.apply(length);
                        MassProperties m = shape.massProperties(1000);
                        String what = name + " " + length;
                        assertTrue(m.mass() > 0 && m.mass() < 1e60, what);
                        assertTrue(shape.innerRadius() > 0, what);
                        Body body = Body.dynamic().shape(shape);
                        stepsOrTeaches(what, body, 1 + 2 * shape.outerRadius());
                    });
        }
    }

    private static Reason reasonOf(double... xyz) {
        return assertThrows(DegenerateShapeException.class, () -> ConvexHull.of(xyz)).reason();
    }

    /** N3. */
    @Test
    void n3PointsWithoutAVolumeSayWhy() {
        double[] one = {1, 2, 3};
        double[] two = {1, 2, 3, 4, 5, 6};
        double[] three = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        assertSame(Reason.TOO_FEW_POINTS, reasonOf());
        assertSame(Reason.TOO_FEW_POINTS, reasonOf(one));
        assertSame(Reason.TOO_FEW_POINTS, reasonOf(two));
        assertSame(Reason.TOO_FEW_POINTS, reasonOf(three));
        for (int copies : new int[] {4, 100}) {
            double[] same = new double[3 * copies];
            double[] line = new double[3 * copies];
            double[] plane = new double[3 * copies];
            for (int i = 0; i < copies; i++) {
                Arrays.fill(same, 3 * i, 3 * i + 3, .1);
                Arrays.fill(line, 3 * i, 3 * i + 3, .1 * i);
                plane[3 * i] = i % 10;
                plane[3 * i + 1] = (i * 7) % 13;
                plane[3 * i + 2] = plane[3 * i] + plane[3 * i + 1];
            }
            assertSame(Reason.COINCIDENT, reasonOf(same));
            assertSame(Reason.COLLINEAR, reasonOf(line));
            assertSame(Reason.COPLANAR, reasonOf(plane));
        }
        double[] cube = new double[24];
        for (int i = 0; i < 24; i++) {
            cube[i] = (i / 3 >> i % 3 & 1) == 0 ? -1 : 1;
        }
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            for (int at = 0; at < 24; at++) {
                double[] broken = cube.clone();
                broken[at] = bad;
                assertSame(Reason.NOT_FINITE, reasonOf(broken), "coordinate " + at);
            }
        }
        // Duplicates of what has a volume change nothing.
        double[] twice = Arrays.copyOf(cube, 48);
        System.arraycopy(cube, 0, twice, 24, 24);
        assertEquals(8, ConvexHull.of(twice).volume(), 1e-14);
        assertEquals(8, Polyhedron.of(ConvexHull.of(twice)).vertexCount());
        steps("duplicates", ConvexHull.of(twice));
    }

    /** N4. */
    @Test
    void n4InertiaThatNoMatterHasIsRefused() {
        double[][] bad = {
            {1, 1, 2.1}, {1, 3, 1}, {5, 1, 1}, {0, 1, 1}, {1, 1, -1}, {1, Double.NaN, 1}
        };
        for (double[] i : bad) {
            var e =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> Body.dynamic().inertia(i[0], i[1], i[2]));
            assertTrue(String.valueOf(e.getMessage()).contains("inertia"), e.getMessage());
        }
        for (Shape shape : Scenes.kinds()) {
            MassProperties m = shape.massProperties(1);
            double trace = m.ixx() + m.iyy() + m.izz();
            double most = Math.max(m.ixx(), Math.max(m.iyy(), m.izz()));
            assertTrue(most <= (trace - most) * (1 + 1e-12), shape.toString());
            stepsOrTeaches("a plate", Body.dynamic().shape(shape).inertia(1, 1, 2));
            stepsOrTeaches("a rod", Body.dynamic().shape(shape).inertia(1, 1, 1e-12));
        }
    }

    /** N6: two, and three, of the same in one place. */
    @Test
    void n6ConcentricBodiesOfEveryKindPart() {
        for (Shape shape : Scenes.kinds()) {
            steps("concentric", shape, shape);
            steps("concentric", shape, shape, shape);
            for (Shape other : Scenes.kinds()) {
                steps("concentric", shape, other);
                part(shape, other);
            }
        }
    }

    /** Without weight nothing but the contact can move them, and nothing ends before they touch. */
    private static void part(Shape a, Shape b) {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).build()) {
            BodyRef first = world.add(Body.dynamic().shape(a));
            BodyRef second = world.add(Body.dynamic().shape(b));
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
            }
            double apart = first.position().distance(second.position());
            double inner = Math.min(a.innerRadius(), b.innerRadius());
            assertTrue(apart > inner, a + " and " + b + " are " + apart + " m apart");
        }
    }

    /** N9. */
    @Test
    void n9MaterialsOutOfRangeAreRefusedAndExtremeOnesStep() {
        for (double bad : new double[] {2, -.1, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> new Material(.5, bad, 1000));
        }
        for (double bad : new double[] {-1e-9, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> new Material(bad, 0, 1000));
        }
        for (Shape shape : Scenes.kinds()) {
            for (double friction : new double[] {0, 1e9}) {
                for (double restitution : new double[] {0, 1}) {
                    Material material = new Material(friction, restitution, 1000);
                    Body body = Body.dynamic().shape(shape).material(material).velocity(3, -3, 1);
                    stepsOrTeaches("friction " + friction + " bounce " + restitution, body);
                }
            }
        }
    }

    /** N10. */
    @Test
    void n10QuaternionsThatAreNoTurnAreRefused() {
        double[] lengths = {0, 1e-20, 1e-300, .5, 1 + 1e-3, 2, 1e20, 1e300, Double.NaN};
        for (double length : lengths) {
            Quaterniond q = new Quaterniond(0, 0, 0, length);
            assertThrows(IllegalArgumentException.class, () -> Body.dynamic().rotation(q));
            for (Shape shape : Scenes.kinds()) {
                String what = length + " " + shape;
                assertThrows(IllegalArgumentException.class, () -> shape.moved(0, 0, 0, q), what);
            }
        }
        Quaterniond nearly = new Quaterniond(.3, .4, .5, .7).normalize().mul(1 + 1e-9);
        for (Shape shape : Scenes.kinds()) {
            steps("a turn up to rounding", shape.moved(0, 0, 0, nearly.normalize()));
            for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, 1e300}) {
                assertThrows(
                        IllegalArgumentException.class,
                        () -> shape.moved(bad, 0, 0, new Quaterniond()));
            }
        }
        Vector3d out = new Vector3d();
        for (Shape shape : Scenes.kinds()) {
            assertTrue(shape.centreOfMass(out).isFinite(), shape.toString());
        }
    }
}
