package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.narrowphase.oracle.ReachOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.oracle.ShapeKind;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.Cylinder;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/**
 * Poses that {@link EveryPairTest}'s soak or a search like it found, each for a way of missing the
 * best axis: the separation along the axis is the distance, pushing out by it leaves none, the
 * order does not matter, and the mirror image has the mirrored bits.
 */
class HardPosesTest {
    /** Of the size. */
    private static final double ALONG = 1e-14, OUT = 1e-12;

    private final NarrowPhase special = new NarrowPhase();
    private final NarrowPhase general = new NarrowPhase(NarrowPhase.Method.GENERAL);
    private final ReachOracle oracle = new ReachOracle();

    private void check(Scene s) {
        double size = ShapeKind.size(s) + s.d.length();
        double d = s.distance(special);
        Vector3d axis = EveryPairTest.axis(special);
        assertEquals(d, oracle.separation(s, axis), ALONG * size, "along");
        assertEquals(d, s.distance(general), OUT * size, "GENERAL");
        assertEquals(d, s.swapped().distance(special), OUT * size, "swapped");
        assertEquals(d, ShapeKind.mirrored(s).distance(special), 0.0, "mirrored");
        Vector3d m = EveryPairTest.axis(special);
        assertEquals(axis, new Vector3d(-m.x, m.y, m.z), "mirrored axis");
        s.d.fma(-d, axis);
        assertEquals(0, s.distance(special), OUT * size, "pushed out");
    }

    /** Newton did not arrive between two axes that differ by 3e-7: 2.6e-9. */
    @Test
    void rimsNearlyParallel() {
        Scene s =
                new Scene(
                                Cylinder.of(1.1777566163804176, 0.373955750332958),
                                Cylinder.of(1.2728360165221144, 1.0669351421639215))
                        .at(-0.14235679974176962, 0.5087222656038254, -0.8145996971564826);
        s.qa =
                new Quaterniond(
                        -0.7297516008765448,
                        -0.31371291449805416,
                        0.42959760297034993,
                        -0.4295261433456481);
        s.qb =
                new Quaterniond(
                        -0.7297515655918655,
                        -0.3137129686958372,
                        0.42959752273051977,
                        -0.429526243961957);
        check(s);
    }

    /**
     * Of two edges on whose circles Newton arrives, only one touches: 3.5e-10 where either would
     * do.
     */
    @Test
    void aRimOverAnEdgeNearlyInItsPlane() {
        Scene s =
                new Scene(
                                Cylinder.of(1.0245045344895727, 0.6865230696536987),
                                Box.ofHalfExtents(
                                        0.507561363158904,
                                        0.06728254636824456,
                                        0.08489637408640387))
                        .at(-0.19383788340474398, 0.8152688386881126, -0.9664059571312362);
        s.qa =
                new Quaterniond(
                        -0.45305293115074124,
                        -0.15070638712956347,
                        0.8607212166160427,
                        -0.17660581451660914);
        s.qb =
                new Quaterniond(
                        -0.445235992535835,
                        0.5020563001310161,
                        0.7151872999196801,
                        0.19547764190050607);
        check(s);
    }

    /** The rough axis is beyond the normal of a face, where another corner touches: 1.1e-8. */
    @Test
    void aRimOverAFaceNearlyParallel() {
        Scene s =
                new Scene(
                                Cone.of(0.6848387773945586, 0.2659308193372202),
                                Box.ofHalfExtents(
                                        0.8161968305491938,
                                        0.16147209921926736,
                                        0.34643116744771135))
                        .at(0.05518258643549571, -0.12924983551582322, -0.9200758132608318);
        s.qa =
                new Quaterniond(
                        0.12948495100892354,
                        0.5802479668195126,
                        0.15163931954133664,
                        -0.7896527472459517);
        s.qb =
                new Quaterniond(
                        -0.4668094455349172,
                        0.5175226162804072,
                        -0.3030716425202604,
                        -0.6499283519725363);
        check(s);
    }

    /** The side touches the end of an edge that was not tried: 1.6e-9. */
    @Test
    void aSideAlongAnEdge() {
        Scene s =
                new Scene(
                                Cylinder.of(1.6769857169263636, 4.057653703857571),
                                Box.ofHalfExtents(
                                        0.21832879719063897,
                                        0.09702459195365831,
                                        0.4178757697870028))
                        .at(-0.06634683548708735, 0.8688177383791814, -1.4400133415887566);
        s.qa =
                new Quaterniond(
                        -0.9452480570449346,
                        -0.0810129037635975,
                        0.2680477902871806,
                        -0.1676108653957903);
        s.qb =
                new Quaterniond(
                        -0.7869100889075845,
                        0.1322536387030249,
                        0.24682318533773595,
                        0.5498725326882596);
        check(s);
    }

    /**
     * The length of n bends the separation upwards, so there is a better axis 5e-5 away: 2.7e-10.
     */
    @Test
    void aPointOfARimJustInsideADisc() {
        Scene s =
                new Scene(
                                Cone.of(2.373451733061349, 0.6439454624115459)
                                        .moved(
                                                0.8194136401691946,
                                                0.8629219140242023,
                                                0.7880293710397898,
                                                new Quaterniond(
                                                        -0.7783712406140006,
                                                        0.34608005821162746,
                                                        0.4932990714172992,
                                                        0.17613299302540797)),
                                Cone.of(1.3979010354271877, 0.1720626779532862))
                        .at(-0.4909450820369203, -1.2509460831771815, 2.463766790611139);
        s.qa =
                new Quaterniond(
                        0.6847319194743703,
                        0.595800206673492,
                        0.40818761817669413,
                        0.09770967479224546);
        s.qb =
                new Quaterniond(
                        -0.41508740992207915,
                        -0.13266213356204692,
                        -0.7099265991802983,
                        -0.5532697571883373);
        check(s);
    }

    /** A face merged from nearly coplanar ones has lost the edge that touches: 3.7e-9. */
    @Test
    void aFaceWhoseCornersAreNotInOnePlane() {
        Scene s =
                new Scene(
                                Cylinder.of(0.26410501123700564, 0.08215935506051235)
                                        .moved(
                                                0.5654823365092359,
                                                0.7577946425545028,
                                                0.6676847777525861,
                                                new Quaterniond(
                                                        -0.13283468835433057,
                                                        0.8329523952700527,
                                                        0.42947709213360385,
                                                        0.32263707182553286)),
                                ShapeKind.hull(
                                                new double[] {
                                                    -0.7222954239428264,
                                                    -0.7137475347820854,
                                                    -0.2412658569494246,
                                                    -0.14096741840829402,
                                                    1.0098205988617746,
                                                    0.43286592552255443,
                                                    0.4260135970102681,
                                                    -0.1245843971250922,
                                                    -0.48899339032402256,
                                                    0.5384781295265012,
                                                    -0.7277918992876284,
                                                    -0.361510904106396,
                                                    0.5213797228630829,
                                                    0.29397232057145434,
                                                    -0.30222015874591923,
                                                    0.035483872554733696,
                                                    -0.6866572430787327,
                                                    -0.5594908048046323,
                                                    0.01004249826177508,
                                                    1.0035612723677059,
                                                    0.4471600934929276,
                                                    -0.4732261300388941,
                                                    0.28277505857550544,
                                                    0.4035989951964079
                                                })
                                        .moved(
                                                0.9545891532806271,
                                                0.7012830179164736,
                                                0.07162736453670793,
                                                new Quaterniond(
                                                        -0.15799657424577412,
                                                        0.573347042853121,
                                                        0.796612147043741,
                                                        -0.1082558920361492)))
                        .at(0.0, 0.0, 0.0);
        s.qa =
                new Quaterniond(
                        -0.5819270377303367,
                        -0.5989752264387443,
                        -0.343648923679086,
                        -0.42952883270539105);
        s.qb =
                new Quaterniond(
                        0.20941367651243117,
                        0.8366618006781019,
                        -0.29718675042274273,
                        0.4096620299085495);
        check(s);
    }

    /** Points of a rim make slivers, and the axis is off by a tenth: 4.6e-8. */
    @Test
    void nearlyTouchingFromARoughAxisFarOff() {
        Scene s =
                new Scene(
                                Cylinder.of(0.3331899552345517, 0.03905546436712308),
                                Box.ofHalfExtents(
                                        0.2561695130878965,
                                        0.28093010507584154,
                                        0.7184042013290683))
                        .at(-0.7796388413643963, 0.379144673240762, 0.19014917319489047);
        s.qa =
                new Quaterniond(
                        -0.54038764009744,
                        -0.4212063916637682,
                        0.534660567220326,
                        -0.4946761080860358);
        s.qb =
                new Quaterniond(
                        0.22461015649352825,
                        -0.4119962233910507,
                        0.8325493853891991,
                        -0.2943992364112571);
        check(s);
    }

    /** Axes that differ by 6e-6 tell one distance, but one leads to where they meet: 3.2e-12. */
    @Test
    void boxesNearlyTouching() {
        Scene s =
                new Scene(
                                Box.ofHalfExtents(
                                        0.8069475253860091,
                                        0.5886931147632788,
                                        0.11892909878715051),
                                Box.ofHalfExtents(
                                        2.1021790012202652, 2.126346770086534, 0.3327750055132206))
                        .at(0.6438780663298218, 2.2471084449674854, -0.2707195998357252);
        s.qa =
                new Quaterniond(
                        0.23777678980658046,
                        0.5954460682704561,
                        -0.2383369261736132,
                        -0.7294530057739474);
        s.qb =
                new Quaterniond(
                        0.271806629710762,
                        -0.14379725373059193,
                        -0.5889957798626078,
                        0.7473469590283052);
        check(s);
    }

    /** GJK ended on edges that are not the nearest by a rounding: 2.5e-14 along the axis. */
    @Test
    void boxesNearlyParallelAndApart() {
        Scene s =
                new Scene(
                                Box.ofHalfExtents(
                                        1.298855115388011, 3.8919333889954046, 1.4642614499826896),
                                Box.ofHalfExtents(
                                        2.1173078649538, 0.4924521450053993, 3.3599960953268866))
                        .at(-5.407583399265223, 5.075207825380863, -0.627590558607316);
        s.qa =
                new Quaterniond(
                        0.4247171465838212,
                        -0.5404087765268648,
                        0.651367268273707,
                        0.321394432857949);
        s.qb =
                new Quaterniond(
                        0.4247171465838908,
                        -0.5404087765268559,
                        0.6513672682736691,
                        0.3213944328579491);
        check(s);
    }

    /**
     * Cores that nearly touch: the way from one to the other was not quite at right angles to both:
     * 1.3e-13 along.
     */
    @Test
    void capsulesWhoseCoresNearlyTouch() {
        Scene s =
                new Scene(
                                Capsule.of(1.7588502350119928, 0.1791306681606125),
                                Capsule.of(0.4042219162833745, 0.4826905008099538))
                        .at(1.3874656745913185E-4, -2.7838853873139834E-5, 1.6624403417952563E-4);
        s.qa =
                new Quaterniond(
                        -0.5294780492189418,
                        0.6605007344724628,
                        -0.4439541592303871,
                        0.29376262467965714);
        s.qb =
                new Quaterniond(
                        0.29376599838256,
                        -0.4439543351484533,
                        -0.6605008146449003,
                        0.5294759299067484);
        check(s);
    }

    /**
     * Of hulls of a million to one GJK stalled on a sliver that it could not tell from an overlap,
     * and the axis of the polytope was off by 0.06: 3.0e-11.
     */
    @Test
    void aSliverThatLooksLikeAnOverlap() {
        Scene s =
                new Scene(
                                ShapeKind.hull(
                                        new double[] {
                                            -0.3256849739868362,
                                            0.15035100055127903,
                                            -0.2356006082187085,
                                            0.0019708026953175403,
                                            0.059809034472342634,
                                            0.2878120397349687,
                                            0.1317782807531008,
                                            -0.2054502910632948,
                                            -0.3706419609110866,
                                            -0.128576696963014,
                                            0.22815316439843325,
                                            -0.0445427325327663,
                                            -0.21650695599308026,
                                            0.18367525336526608,
                                            -0.08531893249995356,
                                            0.2513818291198086,
                                            -0.18484149779669032,
                                            -0.026331458509887024,
                                            -0.4770072005762398,
                                            0.13332823123283288,
                                            0.07047151161838254,
                                            -0.20616497410830742,
                                            -0.16863601543569698,
                                            -0.28336330203203136,
                                            -0.2267010172311493,
                                            0.2653980817804838,
                                            0.05185143668682016
                                        }),
                                ShapeKind.hull(
                                        new double[] {
                                            2.7730531637626166E-7,
                                            1.2828548664193294E-6,
                                            -5.4586137107404865E-9,
                                            -6.871876486878682E-7,
                                            4.811967703722379E-7,
                                            9.232193097401038E-7,
                                            9.032622305745112E-7,
                                            -5.146169549876296E-7,
                                            -7.186895400383315E-7,
                                            4.8062040390773E-7,
                                            -1.7093262464716602E-7,
                                            9.450165218409497E-7,
                                            9.180312772041059E-8,
                                            1.3318312388108862E-6,
                                            1.3796291871925088E-6,
                                            3.7856732051661715E-7,
                                            -4.6089361986326384E-7,
                                            1.3841484838412922E-6,
                                            3.558206899711009E-7,
                                            1.0053023857971095E-6,
                                            1.4506879557929179E-6,
                                            6.188410258366947E-7,
                                            -3.5290549169639063E-7,
                                            1.6117507735290754E-6,
                                            1.0279048336898802E-6,
                                            -1.1690273174755907E-7,
                                            1.0110702548094173E-8,
                                            -5.016856962264792E-9,
                                            -5.872579848976588E-7,
                                            -1.707336580935631E-6,
                                            -1.3649422243936646E-6,
                                            -2.7221628786087867E-7,
                                            2.061116792263972E-7,
                                            -5.421372499953495E-7,
                                            1.2959446907896614E-6,
                                            1.1726464542994462E-6
                                        }))
                        .at(-0.123398178626468, -0.25423358639262117, 0.07498278877431494);
        s.qa =
                new Quaterniond(
                        0.9283593436690355,
                        0.3139788075732653,
                        0.19153820514024986,
                        -0.05365960667876387);
        s.qb =
                new Quaterniond(
                        -0.36189702028912285,
                        0.7124412216626255,
                        -0.5896771887418265,
                        -0.11721290653872687);
        check(s);
    }
}
