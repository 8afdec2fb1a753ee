package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.oracle.FailureCases;
import dev.cairn.physics.narrowphase.oracle.FclCases;
import dev.cairn.physics.narrowphase.oracle.ReachOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;

/**
 * G10: poses that broke other engines, each named after the issue it was filed in. Sizes are the
 * full ones of the issues, poses row by row; z is up there, which does not matter here. Numbers are
 * those of the issue or of the test that its project added for it, unless a comment says that the
 * issue gives none and the situation was built anew.
 */
class G10FailureCorpusTest extends FailureCases {
    static List<Case> corpus() {
        G10FailureCorpusTest t = new G10FailureCorpusTest();
        t.cases.addAll(FclCases.all());
        t.others();
        t.builtAnew();
        return t.cases;
    }

    private void others() {
        known("libccd 25", box(2, 2, 2), Pose.at(0, 0, 0), box(2, 2, 2), Pose.at(0, 0, 1.9), -.1);
        boxes(
                "coal 604",
                box(.363, .277, .363),
                Pose.rows(
                        0.9999195703,
                        0.01021849413,
                        0.007512347878,
                        1.503354966,
                        -0.01021878248,
                        0.9999477869,
                        -3.329855922e-17,
                        -0.8531707835,
                        -0.007511955635,
                        -7.676704888e-05,
                        0.9999717819,
                        0.7700092418),
                box(.363, .363, .277),
                Pose.rows(
                        0.9998670967,
                        -0.01297708324,
                        0.009868343982,
                        1.48838308,
                        0.01297771517,
                        0.9999157859,
                        5.255670031e-17,
                        -1.102020834,
                        -0.009867512928,
                        0.0001280685574,
                        0.9999513067,
                        0.4497073799));
        for (double half : new double[] {1, 10, 25, 50, 100}) {
            // The depth at rest that MuJoCo C finds.
            known(
                    "mujoco_warp 1430, half size " + half,
                    box(2 * half, 2 * half, .5),
                    Pose.at(0, 0, .25),
                    box(.2, .2, .2),
                    Pose.at(0, 0, .6 - 1.078e-4),
                    .6 - 1.078e-4 - .25 - .25 - .1);
        }
        // A ball sinks from a plane into the slab below it: the depth grows by what it sinks.
        for (double z : new double[] {-.015, -.00501, -.005, -.00499, 0, .004}) {
            known(
                    "MuJoCo 2206, height " + z,
                    box(.1, .1, .05),
                    Pose.at(0, 0, -.025),
                    Sphere.of(.005),
                    Pose.at(0, 0, z),
                    z - .005);
        }
        // Touching within the float's rounding; Jolt found 7.25 m.
        reach(
                "Jolt 2103 and 2108",
                Capsule.of(7.19732189, 2.03114343),
                Pose.at(0, 0, 0),
                Cylinder.of(.4975, .3),
                Pose.at(-0.951660156, -2.09155273, -7.63574218));
        double a = .414213562373;
        double b = .171572875254;
        double[] xyz = {
            a, b, a, a, a, b, b, a, a, -a, -b, -a, -a, -a, -b, -b, -a, -a, -a, b, a, -a, a, b, -b,
            a, a, a, -a, -b, a, -b, -a, b, -a, -a, a, -a, b, a, -b, a, b, -a, a, -a, a, -b, -a, b,
            -a, -b, a, -a, a, a, -b, a, b, -a, b, a, -a, -a, -a, b, -a, -b, a, -b, -a, a
        };
        reach(
                "openGJK 54, the polytope, with a ball",
                ConvexHull.of(xyz),
                Pose.at(0, 0, 0),
                Sphere.of(.1),
                Pose.at(.5, .1, 0));
    }

    /** The issues tell what happened but not where. */
    private void builtAnew() {
        // Two boxes of 71 mm whose faces kiss, with 0.056 mm of overlap at one corner only.
        boxes(
                "MuJoCo 3476, built anew",
                box(.071, .071, .05),
                Pose.at(0, 0, 0),
                box(.071, .071, .05),
                new Pose(new Quaterniond().rotationZ(1.6e-3), at(1e-4, .071, 2e-5)));
        // Concentric in xy, dropped to the first overlap of 0.25 mm.
        known(
                "mujoco_warp 1526, built anew",
                box(.4, .4, .4),
                Pose.at(0, 0, .2),
                box(.4, .4, .4),
                Pose.at(0, 0, .6 - 2.5e-4),
                .6 - 2.5e-4 - .2 - .2 - .2);
        known(
                "Genesis 3223, built anew: a flat contact",
                box(.2, .2, .1),
                Pose.at(0, 0, .05),
                box(.2, .2, .1),
                Pose.at(.05, .05, .14999),
                .14999 - .05 - .05 - .05);
        known(
                "melax sandbox 2, built anew: a cube right above the middle of a larger one",
                box(10, 10, 1),
                Pose.at(0, 0, -.5),
                box(2, 2, 2),
                Pose.at(0, 0, 1 - 1e-3),
                -1e-3);
        // The zero vector: the origin exactly on a vertex, an edge and a face of the difference.
        known(
                "PhysX 126, vertex",
                box(1, 1, 1),
                Pose.at(0, 0, 0),
                box(1, 1, 1),
                Pose.at(1, 1, 1),
                0);
        known("FCL 366, edge", box(1, 1, 1), Pose.at(0, 0, 0), box(1, 1, 1), Pose.at(1, 1, .3), 0);
        known("FCL 446, face", box(1, 1, 1), Pose.at(0, 0, 0), box(1, 1, 1), Pose.at(.1, 1, .3), 0);
        // A square of a length that is too small to be compared with.
        known(
                "FCL 446, small",
                box(1e-6, 1e-6, 1e-6),
                Pose.at(0, 0, 0),
                box(1e-6, 1e-6, 1e-6),
                Pose.at(0, 0, 1.5e-6),
                .5e-6);
        // A cylinder that nearly touches a box.
        for (double gap : new double[] {-1e-6, -1e-12, 0, 1e-12, 1e-6}) {
            known(
                    "coal 37, built anew, gap " + gap,
                    cylinder(.5, 2),
                    Pose.at(0, 0, 0),
                    box(1, 1, 1),
                    Pose.at(1 + gap, .2, .1),
                    (1 + gap) - .5 - .5);
        }
        // An edge of 84 m, and a capsule of 5 cm beside it.
        known(
                "Jolt 2065, built anew",
                box(84, .5, .05),
                Pose.at(0, 0, 0),
                Capsule.of(.05, .05),
                Pose.at(31.4, 0, .125),
                .125 - .025 - .05);
        // Within the margin but apart: the axis came out flipped.
        reach(
                "Jolt 671, built anew",
                Box.ofHalfExtents(1, .1, 2),
                Pose.at(0, 0, 0),
                Capsule.of(.3, .8),
                new Pose(new Quaterniond().rotationX(1.5), at(.2, .41, .1)));
        // A simplex that repeats itself: flush faces with a common edge.
        known(
                "ReactPhysics3D 3, built anew",
                box(2, 2, 2),
                Pose.at(0, 0, 0),
                box(1, 1, 1),
                Pose.at(.5, .5, 1.5),
                0);
    }

    private static void check(Case c, NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Scene s = c.scene();
        String where = c + " " + method;
        double size = s.size();
        double d = s.distance(n);
        Vector3d axis = EveryPairTest.axis(n);
        assertFalse(n.capped(), where);
        assertEquals(1, axis.length(), 1e-14, where);
        if (Double.isNaN(c.truth())) {
            ReachOracle oracle = new ReachOracle();
            assertEquals(oracle.separation(s, axis), d, 1e-14 * size, where);
            assertTrue(d >= oracle.distance(s) - 2e-9 * size, where + ": " + d);
        } else {
            assertEquals(c.truth(), d, 4 * Math.ulp(size), where);
        }
        assertEquals(d, s.swapped().distance(n), 1e-14 * size, where);
        Manifold m = new Manifold();
        double margin = .02 * Math.min(s.a.innerRadius(), s.b.innerRadius());
        s.collide(n, margin, 0, m);
        assertEquals(d <= margin, m.pointCount > 0, where);
        double least = Double.MAX_VALUE;
        for (int i = 0; i < m.pointCount; i++) {
            least = Math.min(least, m.separation[i]);
        }
        if (m.pointCount > 0) {
            assertEquals(d, least, m.bound + 1e-14 * size, where);
        }
        s = scene(s.a, new Pose(s.qa, new Vector3d()), s.b, new Pose(s.qb, s.d));
        s.d.fma(-d, axis);
        assertEquals(0, s.distance(n), 1e-14 * size, where + " pushed out");
    }

    @ParameterizedTest
    @MethodSource("corpus")
    void g10PosesThatBrokeOtherEngines(Case c) {
        for (NarrowPhase.Method method : NarrowPhase.Method.values()) {
            check(c, method);
        }
    }

    /** FCL 493 and 495 ask for more than each pose: one verdict along the way through touching. */
    @ParameterizedTest
    @EnumSource
    void g10KissingCubesAreApartOrOverlapInOrder(NarrowPhase.Method method) {
        NarrowPhase n = new NarrowPhase(method);
        double last = -1;
        for (int k = -400; k <= 400; k++) {
            Scene s = new Scene(box(.25, .25, .25), box(.25, .25, .25));
            s.d.set(.01, .25 + k * Math.ulp(.25), .02);
            double d = s.distance(n);
            assertEquals(k * Math.ulp(.25), d, 0.0, method + " at " + k + " ulp");
            assertTrue(d >= last, method + " at " + k + " ulp");
            last = d;
        }
    }
}
