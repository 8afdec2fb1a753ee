package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;

/**
 * G10: poses that broke other engines, each named after the issue it was filed in. Sizes are the
 * full ones of the issues, poses row by row; z is up there, which does not matter here. Numbers are
 * those of the issue or of the test that its project added for it, unless a comment says that the
 * issue gives none and the situation was built anew.
 */
class G10FailureCorpusTest {
    /** Rotation and position, as the issues print them. */
    private record Pose(Quaterniond turn, Vector3d at) {
        static Pose at(double x, double y, double z) {
            return new Pose(new Quaterniond(), new Vector3d(x, y, z));
        }

        static Pose rows(double... m) {
            Matrix3d r = new Matrix3d(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]);
            Quaterniond q = new Quaterniond().setFromUnnormalized(r).normalize();
            return new Pose(q, new Vector3d(m[3], m[7], m[11]));
        }
    }

    private record Case(String source, Scene scene, double truth) {
        @Override
        public String toString() {
            return source;
        }
    }

    private static Box box(double x, double y, double z) {
        return Box.ofHalfExtents(x / 2, y / 2, z / 2);
    }

    /** A cylinder along z. */
    private static Shape cylinder(double radius, double length) {
        Quaterniond upright = new Quaterniond().rotationX(StrictMath.PI / 2);
        return Cylinder.of(radius, length / 2).moved(0, 0, 0, upright);
    }

    private static Scene scene(Shape a, Pose pa, Shape b, Pose pb) {
        Scene s = new Scene(a, b);
        s.qa = pa.turn;
        s.qb = pb.turn;
        s.d = pb.at.sub(pa.at, new Vector3d());
        return s;
    }

    private final List<Case> cases = new ArrayList<>();

    private void boxes(String source, Box a, Pose pa, Box b, Pose pb) {
        Scene s = scene(a, pa, b, pb);
        double truth = ConvexOracle.separatingAxes(s.placedA(), s.placedB());
        if (truth > 0) {
            truth = ConvexOracle.distance(s.placedA(), s.placedB());
        }
        cases.add(new Case(source, s, truth));
    }

    private void known(String source, Shape a, Pose pa, Shape b, Pose pb, double truth) {
        cases.add(new Case(source, scene(a, pa, b, pb), truth));
    }

    private void reach(String source, Shape a, Pose pa, Shape b, Pose pb) {
        cases.add(new Case(source, scene(a, pa, b, pb), Double.NaN));
    }

    static List<Case> corpus() {
        G10FailureCorpusTest t = new G10FailureCorpusTest();
        t.fclBoxes();
        t.fclKissing();
        t.fclRound();
        t.others();
        t.builtAnew();
        return t.cases;
    }

    private void fclBoxes() {
        Pose wall = Pose.rows(0, -1, 0, .8, 1, 0, 0, -.4575, 0, 0, 1, 1.0225);
        boxes(
                "FCL 388 and 390",
                box(.03, .12, .1),
                Pose.rows(
                        -3.0627937852578681533e-08,
                        -0.99999999999999888978,
                        -2.8893865161583314238e-08,
                        0.63499979627350811029,
                        0.9999999999999980016,
                        -3.0627939739957803544e-08,
                        6.4729926918527511769e-08,
                        -0.48500002215636439651,
                        -6.4729927722963847085e-08,
                        -2.8893863029448751323e-08,
                        0.99999999999999711342,
                        1.0778146458339641356),
                box(.025, .35, 1.845),
                wall);
        boxes(
                "FCL 395",
                box(.46, .48, .01),
                Pose.at(-0.72099999999999997424, -0.77200000000000001954, 0.81000000000000005329),
                box(.049521, .146, .0725),
                Pose.rows(
                        0.10758262492983036718,
                        -0.6624881850015212903,
                        -0.74130653817877356637,
                        -0.42677133002999478872,
                        0.22682184885125472595,
                        -0.709614040775253474,
                        0.6670830248314786326,
                        -0.76596851247746788882,
                        -0.96797615037608542021,
                        -0.23991106241273435495,
                        0.07392465377049164954,
                        0.80746731400091054098));
        Pose shelf = Pose.at(-.675, 0, .9115);
        Pose tray = Pose.at(-.692, 0, .935);
        boxes("FCL 398, as filed", box(.614, 3, .037), shelf, box(.494, .552, .01), tray);
        boxes("FCL 398, as tested", box(.614, 3, .37), shelf, box(.494, .552, .01), tray);
        boxes(
                "FCL 399",
                box(0.23768037557601928711, 0.15702305734157562256, .25),
                Pose.rows(
                        -0.099432387353076273628,
                        0.99504432079443971837,
                        0,
                        0.29526406526565551758,
                        -0.99504432079443971837,
                        -0.099432387353076273628,
                        0,
                        -0.013230856508016586304,
                        0,
                        0,
                        1,
                        0),
                box(.01, 0.78165709972381591797, .25),
                Pose.rows(
                        0.99506598442099225554,
                        0.099215354901756730444,
                        0,
                        0.22759585694545214629,
                        -0.099215354901756730444,
                        0.99506598442099225554,
                        0,
                        0.14974093549228112421,
                        0,
                        0,
                        1,
                        0));
        boxes(
                "FCL 415",
                box(.49, .05, .21),
                Pose.rows(
                        4.8966386501092529215e-12,
                        -1,
                        0,
                        -0.43999999999999994671,
                        1,
                        4.8966386501092529215e-12,
                        0,
                        -0.61499999999858001587,
                        0,
                        0,
                        1,
                        0.35499999999999998224),
                box(.035, .12, .03),
                Pose.rows(
                        0.83512153565236335595,
                        -0.55006546945762568868,
                        -9.4542360608233572896e-16,
                        -0.40653441507331000704,
                        0.55006546945762568868,
                        0.83512153565236313391,
                        1.1787444236552387666e-15,
                        -0.69166166923735727945,
                        1.2902271444330665572e-16,
                        -1.4878153530113264589e-15,
                        1,
                        0.43057093858718892276));
        boxes(
                "FCL 428",
                box(.2, .33, .1),
                Pose.at(-0.071000000000000035305, -0.77200000000000001954, 0.79999999999999993339),
                box(.452, .27, .6),
                Pose.at(0.12099999999999999645, -0.78769605692727695523, 0.53422044196125151316));
        known("FCL 508", box(1, 1, 1), Pose.at(0, 4, 0), box(1, 1, 1), Pose.at(0, 0, 0), 3);
        boxes(
                "drake 21673",
                box(.05, .55, .3),
                Pose.rows(
                        0.00079632671073326442932,
                        -0.99999968293183538748,
                        0,
                        0.75000000000000055511,
                        0.99999968293183538748,
                        0.00079632671073326442932,
                        0,
                        -2.4083553715553102684e-15,
                        0,
                        0,
                        1,
                        .15),
                box(.25, .2, .15),
                Pose.rows(
                        6.1232339957367660359e-17,
                        0,
                        1,
                        .75,
                        -1,
                        6.1232339957367660359e-17,
                        6.1232339957367660359e-17,
                        0,
                        -6.1232339957367660359e-17,
                        -1,
                        3.7493994566546440196e-33,
                        .15));
    }

    private void fclKissing() {
        double[] r = {
            0.96193976625564348026, 0.15401279915737359216, 0.22572537250328919556,
            -0.19134171618254486313, 0.96936494951283913579, 0.15401279915737359216,
            -0.19509032201612822033, -0.19134171618254486313, 0.96193976625564348026
        };
        boxes(
                "FCL 493",
                box(.5, .5, .5),
                turned(r, 2.0770063995786869349, 0.48468247475641951239, 1.1543291419087275962),
                box(.5, .5, .5),
                turned(r, 2, 0, 1.25));
        double[] t = {
            0.94096063217417758029, 0.29296840037289501035, 0.16959541586174811667,
            -0.23569836841299879326, 0.92661523595848427348, -0.29296840037289506586,
            -0.2429801799032638987, 0.23569836841299884878, 0.94096063217417758029
        };
        boxes(
                "FCL 495",
                box(.25, .25, .25),
                turned(t, 0.073242100093223821977, 0.2316538089896212349, 1.3089245921032497399),
                box(.25, .25, .25),
                turned(t, 0, 0, 1.25));
        for (double size : new double[] {.01, .25, .5, 10, 1000}) {
            for (double gap : new double[] {-1e-15, -2.5e-16, -1e-16, 0, 1e-16, 2.5e-16, 1e-15}) {
                double scaled = gap * Math.max(1, size);
                Pose a = turned(t, 0, 0, 5 * size);
                Vector3d up = a.turn.transform(new Vector3d(0, size + scaled, 0));
                boxes(
                        "FCL 493 generalised, side " + size + ", gap " + gap,
                        box(size, size, size),
                        a,
                        box(size, size, size),
                        new Pose(a.turn, up.add(0, 0, 5 * size)));
            }
        }
    }

    private static Pose turned(double[] r, double x, double y, double z) {
        return Pose.rows(r[0], r[1], r[2], x, r[3], r[4], r[5], y, r[6], r[7], r[8], z);
    }

    private void fclRound() {
        Pose wall = Pose.rows(0, -1, 0, .8, 1, 0, 0, -.4575, 0, 0, 1, 1.0225);
        reach(
                "FCL 319",
                box(.05, .39, 1.47),
                new Pose(new Quaterniond(0, 0, .707107, .707107).normalize(), at(.8, -.385, .735)),
                cylinder(.18, .18),
                new Pose(new Quaterniond(0, 0, -.130526, .991445).normalize(), at(.4, -.4, .93)));
        reach(
                "FCL 319, later",
                cylinder(.05, .06),
                Pose.rows(
                        -0.99999999997999022838,
                        6.2572835802045040178e-10,
                        6.3260669852976095481e-06,
                        0.57500009756757608503,
                        6.3260669851683709551e-06,
                        -6.3943303429958554955e-10,
                        0.99999999997999056145,
                        -0.42711963046787942977,
                        6.2573180158128459924e-10,
                        1,
                        6.3942912945996747041e-10,
                        1.1867093358746836351),
                box(.025, .35, 1.845),
                wall);
        reach(
                "FCL 390, cylinder",
                cylinder(.05, .06),
                Pose.rows(
                        -0.97313010759279283679,
                        -0.12202804064972551379,
                        0.19526123781136842106,
                        0.87472781461138560122,
                        0.20950801135757171623,
                        -0.11745920593569325607,
                        0.97072639199619581429,
                        -0.4038687881347159947,
                        -0.095520609678929752073,
                        0.98555187191549953329,
                        0.13986894183635001365,
                        1.5871328698116491385),
                box(.025, .35, 1.845),
                wall);
        reach(
                "FCL 391",
                cylinder(.03, .65),
                Pose.at(.6, 0, .325),
                Sphere.of(.055),
                Pose.at(.5419794018, -.0621175025, .6016236576));
        known(
                "FCL 408",
                Sphere.of(.06),
                Pose.at(1.7855056639081962376e-10, 0.039999999999999993894, 0.33000000000000012657),
                box(.1, .1, .1),
                Pose.at(.05, .15, .35),
                0);
        reach(
                "drake 21234",
                cylinder(.041, .17),
                Pose.rows(
                        0.62286449762754547699,
                        0.71651535568044355529,
                        -0.31407891153229777759,
                        0.20238033346825459735,
                        -0.20605566270224237591,
                        -0.23703718387133412837,
                        -0.94939688083050233214,
                        0.027845683594011010065,
                        -0.75470582445316081177,
                        0.65606334948423605802,
                        4.0172294049188053423e-17,
                        0.3114233939246693339),
                box(.3, .6, .016),
                Pose.at(.4, 0, .26885));
        known("FCL 346", Sphere.of(.5), Pose.at(0, 0, 0), Sphere.of(.5), Pose.at(0, 0, 0), -1);
    }

    private static Vector3d at(double x, double y, double z) {
        return new Vector3d(x, y, z);
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
        Scene s = c.scene;
        String where = c + " " + method;
        double size = s.size();
        double d = s.distance(n);
        Vector3d axis = EveryPairTest.axis(n);
        assertFalse(n.capped(), where);
        assertEquals(1, axis.length(), 1e-14, where);
        if (Double.isNaN(c.truth)) {
            ReachOracle oracle = new ReachOracle();
            assertEquals(oracle.separation(s, axis), d, 1e-14 * size, where);
            assertTrue(d >= oracle.distance(s) - 2e-9 * size, where + ": " + d);
        } else {
            assertEquals(c.truth, d, 4 * Math.ulp(size), where);
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
