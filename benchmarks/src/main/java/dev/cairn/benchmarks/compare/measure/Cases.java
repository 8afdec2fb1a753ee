package dev.cairn.benchmarks.compare.measure;

import java.util.List;
import java.util.Map;

/** The scenes of the report, in its order. */
public final class Cases {
    private static final String OVERLAP = "deepest overlap at rest, m";
    private static final String GAP = "gapMetres";
    private static final String GAP_TEXT = "widest gap of a joint, m";

    public static final List<Case> ALL =
            List.of(
                    Case.small(
                            "free-flight",
                            "Free flight",
                            "free-fall",
                            Map.of("height", "100"),
                            90,
                            "positionMetres",
                            "largest distance from the parabola, m",
                            10,
                            "Five spinning bodies follow x0 + v0 t + g t²/2 for 1.5 s. A"
                                + " first-order integrator (semi-implicit Euler) is off by g T h/2"
                                + " at the end: 0.123 m at N = 1."),
                    Case.small(
                            "tumble",
                            "Tumbling box",
                            "tumble",
                            Map.of(),
                            600,
                            "momentumRelative",
                            "change of angular momentum, share",
                            100,
                            "A thrown box turns about its middle axis for 10 s (Gazebo boxes"
                                    + " study, complex case). Its angular momentum is a constant"
                                    + " vector."),
                    Case.small(
                            "slope",
                            "Box slides down a slope",
                            "slope-box",
                            Map.of(
                                    "angle",
                                    "20",
                                    "friction",
                                    "0.2",
                                    "drop",
                                    "0",
                                    "speed",
                                    "0",
                                    "length",
                                    "14"),
                            180,
                            "distanceRelative",
                            "distance error, share of the distance",
                            0.5,
                            "A box on 20 degrees with mu = 0.2 starts from rest: s = g (sin - mu"
                                    + " cos) t²/2, 6.80 m after 3 s."),
                    Case.small(
                            "roll",
                            "Ball rolls down a slope",
                            "slope-ball",
                            Map.of("restitution", "0", "length", "14"),
                            150,
                            "rollRelative",
                            "distance error, share of the distance",
                            0.5,
                            "A solid ball on 15 degrees rolls without slipping: s = 5/7 g sin"
                                    + " t²/2."),
                    Case.small(
                            "friction-stop",
                            "Sliding to a stop in all directions",
                            "friction-stop",
                            Map.of(),
                            180,
                            "distanceRelative",
                            "distance error, share of the distance",
                            2,
                            "24 blocks are pushed off in 24 directions and stop after v²/(2 mu g)"
                                + " on the line of their push. A pyramid of friction makes a star"
                                + " of the circle."),
                    Case.small(
                            "slide-askew",
                            "Long blocks slide askew",
                            "friction-stop",
                            Map.of("blocks", "8", "length", "0.6"),
                            180,
                            "distanceRelative",
                            "distance error, share of the distance",
                            2,
                            "8 blocks of 0.6 x 0.1 x 0.3 m, all turned the same way, are pushed off"
                                + " in 8 directions and stop after v²/(2 mu g) on the line of their"
                                + " push: friction is opposite to the slip, however a block is"
                                + " turned."),
                    Case.small(
                            "slip-to-roll",
                            "Slip to roll",
                            "slip-to-roll",
                            Map.of(),
                            300,
                            "speedRelative",
                            "speed error, share of the speed",
                            2,
                            "Balls slide until they roll, one with backspin: v = (5 v0 + 2 r w0)"
                                    + " / 7, whatever the friction."),
                    Case.small(
                            "rolling",
                            "Balls on a pulled plate (SimBenchmark rolling)",
                            "rolling",
                            Map.of(),
                            240,
                            "velocitySquared",
                            "mean squared velocity error, m²/s²",
                            100,
                            "A 10 kg plate is pulled by 150 N over ground with mu = 0.4; 25 balls"
                                + " of 1 kg roll on it: 0.7385 and 0.2110 m/s². A plate that never"
                                + " moves has an error of 3.15."),
                    Case.small(
                            "bounce",
                            "Bouncing ball",
                            "bouncing-ball",
                            Map.of(),
                            120,
                            "heightRelative",
                            "RMS height error, share of the height",
                            0.5,
                            "A ball falls 1 m and bounces with e = 0.7: parabolas between impacts,"
                                    + " apexes e² of the one before."),
                    Case.small(
                            "bouncing",
                            "Elastic bouncing (SimBenchmark bouncing)",
                            "bouncing",
                            Map.of(),
                            1200,
                            "energySquaredJoules2",
                            "mean squared energy error, J²",
                            5e8,
                            "49 balls fall 5 m and bounce with e = 1 for 20 s; the energy stays 24"
                                    + " 034.5 J. Semi-implicit Euler alone: 185 J² at 1 ms, growing"
                                    + " with h²."),
                    Case.small(
                            "spheres-666",
                            "216 spheres fall (SimBenchmark 666)",
                            "spheres-666",
                            Map.of(),
                            600,
                            "overlapSquaredMetres2",
                            "mean sum of squared overlaps, m²",
                            100,
                            "6 x 6 x 6 frictionless inelastic spheres collapse and flow apart;"
                                    + " nothing may overlap."),
                    Case.small(
                            "elastic-666",
                            "216 elastic spheres (SimBenchmark elastic 666)",
                            "elastic-666",
                            Map.of(),
                            600,
                            "energySquaredJoules2",
                            "mean squared energy error, J²",
                            5e9,
                            "6 x 6 x 6 frictionless elastic spheres fall; the energy stays"
                                    + " 34.5 kJ."),
                    Case.small(
                            "stack-4",
                            "Stack of four",
                            "stack-4",
                            Map.of(),
                            300,
                            "sagMetres",
                            "largest height error at rest, m",
                            0.25,
                            "Four 1 m boxes fall onto each other and stand: centres at 0.5, 1.5,"
                                    + " 2.5, 3.5 m."),
                    Case.small(
                            "cubes-18",
                            "Eighteen cubes",
                            "cubes-18",
                            Map.of(),
                            240,
                            "sagMetres",
                            "largest height error at rest, m",
                            0.25,
                            "Nine columns of two 1 m cubes fall a little and stand: centres at 0.5"
                                    + " and 1.5 m."),
                    Case.small(
                                    "pyramid",
                                    "Pyramid",
                                    "pyramid",
                                    Map.of("base", "20"),
                                    200,
                                    "driftMetres",
                                    "largest displacement, m",
                                    0.5,
                                    "A one-thick pyramid of 1 m boxes, touching from the start,"
                                            + " stands as built. More than half a box off is a"
                                            + " collapse.")
                            .large(32, 1, Map.of("base", "10")),
                    pile("pile-spheres", "Pile of 500 spheres", "10", "5", 0.25, 1),
                    pile("pile-boxes", "Pile of 500 boxes", "10", "5", 0.25, 1),
                    pile("falling-boxes", "pile-boxes", "Falling boxes, 4096", "16", "16", 0.25, 1),
                    pile(
                            "pile-mixed",
                            "Pile of 500 spheres, boxes, capsules, hulls",
                            "10",
                            "5",
                            0.25,
                            4),
                    pile("pile-rounds", "Pile of 192 capsules, cylinders", "8", "3", 0.25, 30),
                    pile("convex-pile", "Pile of 256 hulls (convex_pile)", "8", "4", 1, 10),
                    pile("junkyard", "Junkyard, 512 rocks", "16", "2", 0.75, 4),
                    ground(
                            "terrain",
                            "Terrain: 1000 bodies, 32 768 triangles",
                            Map.of("bodies", "1000", "hulls", "1"),
                            Map.of("bodies", "60", "squares", "48")),
                    ground(
                            "mesh-drop",
                            "Tray of triangles, 150 bodies",
                            Map.of("bodies", "150", "hulls", "1"),
                            Map.of("bodies", "40")),
                    Case.small(
                                    "washer",
                                    "Washer, 1000 boxes",
                                    "washer",
                                    Map.of("side", "10"),
                                    300,
                                    Case.REST_OVERLAP,
                                    "deepest overlap in the last quarter, m",
                                    0.1,
                                    "0.4 m boxes tumble in a drum, seen from the drum: gravity"
                                            + " turns by 25 degrees a second. Nothing may overlap.")
                            .large(8, 1, Map.of("side", "4")),
                    Case.small(
                                    "large-world",
                                    "Large world (100 balls, 10000 fixed boxes)",
                                    "large-world",
                                    Map.of("side", "100", "balls", "100"),
                                    150,
                                    "sagMetres",
                                    "largest height error at rest, m",
                                    0.1,
                                    "100 balls fall onto 100 of 10 000 fixed boxes 10 m apart"
                                            + " (after Box3D's large_world) and rest at their"
                                            + " radius. What nothing touches should cost nothing.")
                            .large(4, 1, Map.of("side", "20", "balls", "20")),
                    Case.small(
                                    "shafts",
                                    "Shafts (2028 bodies, 19 683 fixed boxes)",
                                    "shafts",
                                    Map.of("side", "27", "bodies", "3"),
                                    120,
                                    "offMetres",
                                    "largest distance from the parabola, m",
                                    10,
                                    "Balls and spinning boxes fall straight through a lattice of"
                                            + " fixed boxes for 2 s, near to some and touching"
                                            + " none: y0 - g t²/2. Work for the broad phase.")
                            .large(4, 1, Map.of("side", "9", "bodies", "2")),
                    Case.small(
                                    "many-pyramids",
                                    "Many pyramids (10780 boxes)",
                                    "many-pyramids",
                                    Map.of("side", "14", "base", "10"),
                                    60,
                                    "driftMetres",
                                    "largest displacement, m",
                                    0.5,
                                    "14 x 14 pyramids of 55 boxes stand as built (Box3D's"
                                            + " many_pyramids).")
                            .large(4, 1, Map.of("side", "2", "base", "5")),
                    Case.small(
                                    "large-pyramid",
                                    "Large pyramid (5050 boxes)",
                                    "pyramid",
                                    Map.of("base", "100"),
                                    200,
                                    "driftMetres",
                                    "largest displacement, m",
                                    2,
                                    "A pyramid of 100 rows stands as built (Box3D's large_pyramid:"
                                        + " 200 steps, density 100, friction 0.6). More than two"
                                        + " boxes off is a collapse.")
                            .large(8, 1, Map.of("base", "12")),
                    Case.small(
                            "pendulum",
                            "Pendulum on a rod",
                            "pendulum",
                            Map.of("degrees", "90"),
                            1200,
                            "heightLostRelative",
                            "largest change of energy, share of that of the way down and up",
                            1,
                            "A ball on a rod of 1 m without mass swings for 20 s from the"
                                    + " horizontal; its energy stays."),
                    Case.small(
                            "falling-rod",
                            "Rod falls over on a hinge",
                            "falling-rod",
                            Map.of(),
                            90,
                            "angleRadians",
                            "largest error of its angle, rad",
                            2,
                            "A rod of 1 m on a hinge at its foot falls from 0.01 rad beside the"
                                    + " vertical: a'' = 3 g/(2 L) sin a, so what is wrong at first"
                                    + " grows 160 times."),
                    chain("chain-heavy", "Ten links carry 100 times their mass", "100"),
                    chain("chain-heavy-1000", "Ten links carry 1000 times their mass", "1000"),
                    Case.small(
                                    "bridge",
                                    "Bridge of 20 planks under boxes",
                                    "bridge",
                                    Map.of(),
                                    600,
                                    GAP,
                                    GAP_TEXT,
                                    2,
                                    "Planks of 0.5 m hang on hinges between two piers; six boxes"
                                            + " of twice their mass fall onto them. No joint is"
                                            + " ever open.")
                            .large(16, 1, Map.of("planks", "8", "boxes", "2")),
                    Case.small(
                                    "joint-grid",
                                    "Net of 10 000 balls, 19 701 joints (Box3D's joint_grid)",
                                    "joint-grid",
                                    Map.of("side", "100"),
                                    300,
                                    GAP,
                                    GAP_TEXT,
                                    200,
                                    "A square net of balls 1 m apart swings down from its upper"
                                            + " edge. No joint is ever open.")
                            .large(8, 1, Map.of("side", "8")),
                    Case.small(
                            "newton-pendulums",
                            "Newton's cradle on strings",
                            "newton-pendulums",
                            Map.of(),
                            180,
                            "heightRelative",
                            "height that the last ball lacks, share",
                            1.5,
                            "Five elastic balls hang on two rods each; the last one rises as high"
                                    + " as the first one came from."));

    private Cases() {}

    private static Case chain(String id, String title, String ratio) {
        return Case.small(
                id,
                title,
                "chain-heavy",
                Map.of("ratio", ratio),
                600,
                "stretchRelative",
                "widest gap of a joint, share of a link",
                20,
                "Ten links of 1 kg and 0.5 m on ball joints swing by one end from 80 degrees, with"
                        + " a ball at the other. No joint is ever open.");
    }

    private static Case ground(
            String id, String title, Map<String, String> settings, Map<String, String> quick) {
        return Case.small(
                        id,
                        title,
                        id,
                        settings,
                        240,
                        Case.REST_OVERLAP,
                        "deepest overlap at rest, with bodies or ground, m",
                        0.25,
                        "Balls, boxes, capsules and hulls of 16 sides fall on a ground of triangles"
                                + " and come to rest; nothing may overlap, and nobody may be below"
                                + " the ground.")
                .large(8, 4, quick);
    }

    private static Case pile(
            String id, String title, String side, String layers, double failure, int lookCost) {
        return pile(id, id, title, side, layers, failure, lookCost);
    }

    private static Case pile(
            String id,
            String scene,
            String title,
            String side,
            String layers,
            double failure,
            int lookCost) {
        return Case.small(
                        id,
                        title,
                        scene,
                        Map.of("side", side, "layers", layers),
                        300,
                        Case.REST_OVERLAP,
                        OVERLAP,
                        failure,
                        "Bodies fall into a pit and come to rest; nothing may overlap. How they"
                                + " lie is chaotic, so nothing else is compared.")
                .large(8, lookCost, Map.of("side", "4", "layers", "2"));
    }
}
