package dev.cairn.physics.rest;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.tuning.Tunable;

import java.util.Locale;

/** Tables of {@link StackStudy} for variants of the settings, on standard output. */
final class StackTables {
    private StackTables() {}

    static String scene(String name, PhysicsSettings k) {
        switch (name) {
            case "unload100":
                return StackStudy.unloaded(k, 5, 100).toString();
            case "unload1000":
                return StackStudy.unloaded(k, 10, 1000).toString();
            case "hit":
                return String.format(
                        Locale.ROOT, "stack p/p0 %.3f", StackStudy.hitMomentum(k, 1000));
            case "kick":
                return String.format(Locale.ROOT, "slide %.4f m", StackStudy.kickDistance(k));
            case "drop10":
                return StackStudy.drop(k, 10, 1);
            case "drop4":
                return StackStudy.drop(k, 4, 1);
            case "hold":
                return StackStudy.incline(k, 0.5, 60);
            case "slide":
                return StackStudy.incline(k, 0.2, 2);
            case "hit100":
                return StackStudy.hitTop(k, 100);
            case "hit1000":
                return StackStudy.hitTop(k, 1000);
            case "lean":
                return StackStudy.lean(k);
            case "pile":
                return StackStudy.pile(k, 12);
            case "cost":
                return StackStudy.cost(
                        k, k.with(Tunable.LOAD_INERTIA, 0).with(Tunable.UNLOAD_SWEEPS, 0), 30);
            default:
                break;
        }
        StackStudy s;
        double t = 20;
        switch (name) {
            case "stack10" -> {
                s = StackStudy.stack(k, StackStudy.equal(10, 1000));
                t = 60;
            }
            case "stack15" -> {
                s = StackStudy.stack(k, StackStudy.equal(15, 1000));
                t = 60;
            }
            case "stack20" -> {
                s = StackStudy.stack(k, StackStudy.equal(20, 1000));
                t = 60;
            }
            case "stack40" -> s = StackStudy.stack(k, StackStudy.equal(40, 1000));
            case "stack40-60" -> {
                s = StackStudy.stack(k, StackStudy.equal(40, 1000));
                t = 60;
            }
            case "pair" -> s = StackStudy.stack(k, 1, 1000);
            case "alt100" -> s = StackStudy.stack(k, StackStudy.alternating(10, 100));
            case "top100" -> s = StackStudy.stack(k, StackStudy.top(10, 100));
            case "top1000" -> s = StackStudy.stack(k, StackStudy.top(10, 1000));
            case "dropheavy" -> s = StackStudy.heavyDropped(k);
            case "pyramid20" -> s = StackStudy.pyramid(k, 20);
            default -> throw new IllegalArgumentException(name);
        }
        try (s) {
            return s.rest(t);
        }
    }

    /** Settings of a variant: its parts joined by +. */
    static PhysicsSettings settings(String variant) {
        PhysicsSettings k = PhysicsSettings.DEFAULT;
        StackStudy.seed = 777;
        for (String part : variant.split("\\+")) {
            double x =
                    part.length() > 1 && part.charAt(1) == '='
                            ? Double.parseDouble(part.substring(2))
                            : 0;
            switch (part.charAt(0)) {
                case 'S' ->
                        k =
                                k.with(Tunable.OFFSET_GAIN, 0)
                                        .with(Tunable.LOAD_INERTIA, 0)
                                        .with(Tunable.UNLOAD_SWEEPS, 0);
                case 'O' -> k = k.with(Tunable.LOAD_INERTIA, 0).with(Tunable.UNLOAD_SWEEPS, 0);
                case 'L' -> k = k.with(Tunable.UNLOAD_SWEEPS, 0);
                case 'k' -> k = k.with(Tunable.LOAD_INERTIA, x);
                case 'g' -> k = k.with(Tunable.OFFSET_GAIN, x);
                case 'n' -> k = k.withSubsteps((int) x);
                case 's' -> StackStudy.seed = (long) x;
                default -> {}
            }
        }
        return k;
    }

    /**
     * The table of {@code docs/notebook/stacks.md}, or single cells of it.
     *
     * @param args nothing, or scenes and variants, each joined by commas; a variant is {@code S}
     *     (soft step), {@code O} (and offset), {@code L} (and load-proportional inertia) or {@code
     *     A} (all), and may go on with {@code +n=8} (sub-steps), {@code +k=3} (inertia), {@code
     *     +g=0.02} (gain), {@code +s=1} (seed)
     */
    public static void main(String[] args) {
        String[] scenes =
                (args.length > 0
                                ? args[0]
                                : "stack10,stack15,stack20,stack40,stack40-60,pair,alt100,top100,"
                                        + "top1000,pyramid20,pile,unload100,unload1000,hit,kick,"
                                        + "drop4,drop10,hit100,hit1000,dropheavy,lean,hold,slide,"
                                        + "cost")
                        .split(",");
        String[] variants = (args.length > 1 ? args[1] : "S,O,L,A,A+n=8").split(",");
        for (String scene : scenes) {
            for (String v : variants) {
                System.out.printf(
                        Locale.ROOT, "| %s | %s | %s |%n", scene, v, scene(scene, settings(v)));
            }
        }
    }
}
