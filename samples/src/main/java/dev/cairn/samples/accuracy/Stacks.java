package dev.cairn.samples.accuracy;

import static dev.cairn.samples.accuracy.AccuracyCase.metric;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Group E of the table, and B13: stacks, piles and structures. Most are scenes of the registry. */
final class Stacks {
    private static final double G = Trial.GRAVITY;

    private Stacks() {}

    static List<AccuracyCase> unloading() {
        return List.of(
                new AccuracyCase(
                        "B13",
                        "load removal",
                        "100 kg on 5 boxes of 1 kg, taken away after 10 s",
                        "nothing moves",
                        List.of(metric("gap", "m", 1e-3), metric("speed up", "m/s", 0.02)),
                        "Soft Step, 4 sub-steps: 0.16 m, 2.4 m/s [catalogue, toy]",
                        Effort.SHORT,
                        trial -> {
                            Trial.Errors e =
                                    trial.scene("load-removal", 15, Map.of("seconds", "10"));
                            return new double[] {e.get("gapMetres"), e.get("upMetresPerSecond")};
                        }));
    }

    static List<AccuracyCase> cases() {
        return List.of(
                new AccuracyCase(
                        "E1",
                        "stack of 10",
                        "unit cubes, ±1 mm and ±10 mrad untidy, 60 s",
                        "sag 0, level k carries what is above it",
                        List.of(
                                metric("sag", "m", 5e-6),
                                metric("speed", "m/s", 1e-6),
                                metric("force of a level", "", 1e-6),
                                metric("creep after 2 s", "m", Double.POSITIVE_INFINITY)),
                        "30 Hz soft 5e-3, PGS+NGS 7e-4 [catalogue, toy]",
                        Effort.SHORT,
                        trial -> {
                            Trial.Errors e = trial.scene("stack", 60, Map.of());
                            return new double[] {
                                e.get("sagMetres"),
                                e.get("speedMetresPerSecond"),
                                e.get("forceRelative"),
                                e.get("creepMetres")
                            };
                        }),
                tower("E2-50", 50, 60, Effort.MEDIUM, ""),
                tower(
                        "E2-100",
                        100,
                        60,
                        Effort.MEDIUM,
                        "Jolt's default loses a pyramid of 100 rows; Box3D moves 0.7 m [bake-off]"),
                tower("E2-200", 200, 600, Effort.LONG, ""),
                onTop("E3-100", 100, 1e-3),
                onTop("E3-1000", 1000, 1e-3),
                onTop("E3-10000", 10000, Double.POSITIVE_INFINITY),
                pair("E4-28", 28, 1e-4, "[PEEL's HeavyBoxOnLightBox]"),
                pair("E4-1e3", 1e3, 1e-4, ""),
                pair("E4-1e6", 1e6, 1e-4, "PGS at 100 iterations fails [ContactBench]"),
                pair("E4-1e9", 1e9, Double.POSITIVE_INFINITY, ""),
                new AccuracyCase(
                        "E5",
                        "pyramid of 5050",
                        "Box3D's large_pyramid, 1000 ticks",
                        "it stands as built",
                        List.of(metric("drift", "m", 0.05)),
                        "Box3D 0.79 m, Jolt x4 0.05 m at 157 ms a step [bake-off]",
                        Effort.HEAVY,
                        trial -> {
                            Trial.Errors e =
                                    trial.scene(
                                            "pyramid", 1000 * Trial.TICK, Map.of("base", "100"));
                            return new double[] {e.get("driftMetres")};
                        }),
                new AccuracyCase(
                        "E7",
                        "house of cards",
                        "5 levels of 2 mm cards at 25°, mu 0.7",
                        "stands for 60 s",
                        List.of(metric("falls too early by", "s", 0)),
                        "Box3D: hulls this thin break it [catalogue]",
                        Effort.MEDIUM,
                        trial -> new double[] {60 - stands(trial, "cards", 60, 0.1, Map.of())}),
                new AccuracyCase(
                        "E8",
                        "arch",
                        "15 wedges, mu 0.8, 20 s, thickness halved in by bisection",
                        "stands iff t/R >= 0.1075 (Milankovitch 1907)",
                        List.of(metric("threshold", "", 0.003)),
                        "",
                        Effort.MEDIUM,
                        Stacks::arch),
                new AccuracyCase(
                        "E10",
                        "harmonic overhang",
                        "6 planks, 20 s, overhang f of the harmonic one, 1 ± 0.1 to 1 ± 0.001",
                        "stands for f < 1, tips for f > 1",
                        List.of(metric("smallest distance of f from 1 told apart", "", 1e-3)),
                        "",
                        Effort.MEDIUM,
                        Stacks::overhang),
                new AccuracyCase(
                        "E12",
                        "pile of 10000",
                        "20 x 25 x 20 cubes dropped 2 m, 10 s",
                        "at rest, no overlap",
                        List.of(
                                metric("deepest overlap", "m", 5e-4),
                                metric("energy of a box", "J", Double.POSITIVE_INFINITY)),
                        "2 mm Box3D 10.2 ms, 0.5 mm Jolt x4 60.8 ms a step [bake-off]",
                        Effort.HEAVY,
                        Stacks::pile),
                new AccuracyCase(
                        "E13",
                        "overlap recovery",
                        "pyramid of 10 rows, each row pushed half into the one below",
                        "no faster than the push speed of 3 m/s",
                        List.of(metric("fastest box", "m/s", 3)),
                        "Box3D's scheme 22 m/s [study]",
                        Effort.SHORT,
                        Stacks::overlapped),
                new AccuracyCase(
                        "E16",
                        "big on small",
                        "20 m box on two of 1 m, dropped 6 m",
                        "rests 1 m above the ground",
                        List.of(
                                metric("sag at rest", "m", 1e-3),
                                metric("deepest", "m", Double.POSITIVE_INFINITY)),
                        "soft step at 4 sub-steps: falls through [study]",
                        Effort.SHORT,
                        trial -> {
                            Trial.Errors e = trial.scene("big-on-small", 20, Map.of("drop", "6"));
                            return new double[] {
                                Math.abs(e.get("sagMetres")), e.get("deepestMetres")
                            };
                        }),
                new AccuracyCase(
                        "E18",
                        "18 cubes on a plane",
                        "the thesis's scene, 20 s",
                        "they rest",
                        List.of(metric("sag", "m", 5e-6)),
                        "",
                        Effort.SHORT,
                        trial ->
                                new double[] {
                                    trial.scene("cubes-18", 20, Map.of()).get("sagMetres")
                                }));
    }

    private static AccuracyCase tower(
            String id, int boxes, int seconds, Effort effort, String published) {
        return new AccuracyCase(
                id,
                "stack of " + boxes,
                boxes + " unit cubes, ±1 mm and ±10 mrad untidy, " + seconds + " s",
                "stands as built",
                List.of(metric("drift aside", "m", 0.01)),
                published,
                effort,
                trial -> {
                    Trial.Errors e =
                            trial.scene("stack", seconds, Map.of("boxes", Integer.toString(boxes)));
                    return new double[] {fallen(e, e.get("driftMetres"))};
                });
    }

    /** A fallen stack has no error, it fails. */
    private static double fallen(Trial.Errors errors, double value) {
        return errors.get("sagMetres") > 0.3 ? Double.POSITIVE_INFINITY : value;
    }

    private static AccuracyCase onTop(String id, int ratio, double bar) {
        return new AccuracyCase(
                id,
                "heavy top, " + ratio + ":1",
                "9 cubes of 1 kg under one of " + ratio + " kg, 30 s",
                "sag 0",
                List.of(
                        metric("sag", "m", bar),
                        metric("drift aside", "m", Double.POSITIVE_INFINITY)),
                ratio == 1000 ? "PGS+NGS 0.149 at 32 sweeps; 30 Hz soft collapses [toy]" : "",
                Effort.SHORT,
                trial -> {
                    Trial.Errors e =
                            trial.scene(
                                    "mass-ratio",
                                    30,
                                    Map.of("pattern", "2", "ratio", Integer.toString(ratio)));
                    return new double[] {
                        fallen(e, e.get("sagMetres")), fallen(e, e.get("driftMetres"))
                    };
                });
    }

    private static AccuracyCase pair(String id, double ratio, double bar, String published) {
        return new AccuracyCase(
                id,
                "pair " + AccuracyText.number(ratio) + ":1",
                "1 kg under " + AccuracyText.number(ratio) + " kg, 30 s",
                "sag 0",
                List.of(metric("sag", "m", bar)),
                published,
                Effort.SHORT,
                trial -> {
                    Trial.Errors e =
                            trial.scene(
                                    "mass-ratio",
                                    30,
                                    Map.of(
                                            "boxes", "2",
                                            "pattern", "2",
                                            "ratio", Double.toString(ratio)));
                    return new double[] {fallen(e, e.get("sagMetres"))};
                });
    }

    /** Seconds that a scene of the registry stands, looked at every half second. */
    private static double stands(
            Trial trial, String id, int seconds, double moved, Map<String, String> parameters) {
        double[] stood = {seconds};
        trial.scene(
                id,
                seconds,
                parameters,
                (time, errors) -> {
                    if (errors.get("movedMetres") > moved && time < stood[0]) {
                        stood[0] = time;
                    }
                    return stood[0] == seconds;
                });
        return stood[0];
    }

    private static double[] arch(Trial trial) {
        double falls = 0.06;
        double holds = 0.2;
        for (int n = 0; n < 8; n++) {
            double middle = 0.5 * (falls + holds);
            Map<String, String> at = Map.of("thickness", Double.toString(middle));
            if (stands(trial, "arch", 20, 0.5, at) < 20) {
                falls = middle;
            } else {
                holds = middle;
            }
        }
        return new double[] {Math.abs(0.5 * (falls + holds) - 0.1075)};
    }

    private static double[] overhang(Trial trial) {
        double smallest = Double.POSITIVE_INFINITY;
        for (double off : new double[] {0.1, 0.03, 0.01, 0.003, 0.001}) {
            boolean under =
                    stands(trial, "overhang", 20, 0.3, Map.of("f", Double.toString(1 - off))) < 20;
            boolean over =
                    stands(trial, "overhang", 20, 0.3, Map.of("f", Double.toString(1 + off))) < 20;
            if (under || !over) {
                break;
            }
            smallest = off;
        }
        return new double[] {smallest};
    }

    private static double[] pile(Trial trial) {
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            Material surface = Trial.surface(0.6, 0);
            Trial.floor(world, surface);
            for (int k = 0; k < 10_000; k++) {
                int layer = k / 400;
                double x = 1.05 * (k % 20 - 9.5) + 0.02 * (layer % 3);
                double z = 1.05 * (k / 20 % 20 - 9.5) + 0.02 * (layer % 2);
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(0.5))
                                .at(x, 2.5 + 1.1 * layer, z)
                                .material(surface));
            }
            trial.run(world, 10);
            double deepest = 0;
            var contacts = world.contacts();
            for (int c = 0; c < contacts.count(); c++) {
                for (int p = 0; p < contacts.pointCount(c); p++) {
                    deepest = Math.max(deepest, -contacts.separation(c, p));
                }
            }
            return new double[] {deepest, world.kineticEnergy() / 10_000};
        }
    }

    private static double[] overlapped(Trial trial) {
        try (PhysicsWorld world = trial.world(0, -G, 0)) {
            Material surface = Trial.surface(0.6, 0);
            Trial.floor(world, surface);
            List<BodyRef> boxes = new ArrayList<>();
            for (int row = 0; row < 10; row++) {
                for (int i = 0; i < 10 - row; i++) {
                    boxes.add(
                            world.add(
                                    Body.dynamic()
                                            .shape(Box.cubeOfHalfExtent(0.5))
                                            .at(i + 0.5 * row - 4.5, 0.5 + 0.5 * row, 0)
                                            .material(surface)));
                }
            }
            double fastest = 0;
            Vector3d v = new Vector3d();
            for (int tick = 0; tick < 300; tick++) {
                trial.step(world);
                for (BodyRef box : boxes) {
                    fastest = Math.max(fastest, box.velocity(v).length());
                }
            }
            return new double[] {fastest};
        }
    }
}
