package dev.cairn.samples.fuzz;

import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;

/** Counts worlds and broken laws by corner of the space of worlds. One thread. */
public final class Tally {
    /** How many worlds, and how many of them broke which law. */
    private static final class Row {
        int worlds;
        final Map<Law, Integer> broken = new EnumMap<>(Law.class);

        void add(Map<Law, Breach> laws) {
            worlds++;
            laws.keySet().forEach(law -> broken.merge(law, 1, Integer::sum));
        }

        void write(StringBuilder text, String name) {
            text.append("| ").append(name).append(" | ").append(worlds).append(" |");
            for (Law law : Law.values()) {
                Integer count = broken.get(law);
                text.append(count == null ? " |" : " %d |".formatted(count));
            }
            text.append('\n');
        }
    }

    /** By dimension and corner. */
    private final Map<String, Map<String, Row>> corners = new LinkedHashMap<>();

    private final Map<Law, Double> worst = new EnumMap<>(Law.class);
    private final Row total = new Row();
    private int failing;

    /** Nothing counted yet. */
    public Tally() {}

    /**
     * Counts a world.
     *
     * @param fuzz the world
     * @param broken the laws it broke
     */
    public void add(FuzzWorld fuzz, Map<Law, Breach> broken) {
        double thin = 1;
        double spin = 0;
        double lightest = Double.POSITIVE_INFINITY;
        double heaviest = 0;
        double bounce = 0;
        for (EntitySpec e : fuzz.scene().entities()) {
            if (e.body() == BodyKind.DYNAMIC) {
                thin = Math.min(thin, Extent.inner(e) / Extent.outer(e));
                spin = Math.max(spin, Extent.length(e.angularVelocity()));
                Double own = e.mass();
                double mass = own == null ? Math.pow(Extent.outer(e), 3) : own;
                lightest = Math.min(lightest, mass);
                heaviest = Math.max(heaviest, mass);
                bounce = Math.max(bounce, e.material().restitution());
            }
        }
        count("family", fuzz.family().toString(), broken);
        count("bodies", fuzz.movers() < 2 ? "1" : fuzz.movers() < 10 ? "2-9" : "10-30", broken);
        count("thickness", decade(thin), broken);
        count("turn a tick", decade(spin * fuzz.scene().tick().seconds()), broken);
        count("mass ratio", decade(heaviest / lightest), broken);
        count("restitution", bounce == 0 ? "0" : bounce < 1 ? "0-1" : "1", broken);
        count("sub-steps", "%2d".formatted(fuzz.scene().tick().substeps()), broken);
        count("ticks", fuzz.pace().toString(), broken);
        count(
                "around",
                fuzz.isFree()
                        ? "nothing"
                        : fuzz.room() < Double.POSITIVE_INFINITY ? "room" : "floor",
                broken);
        total.add(broken);
        failing += broken.isEmpty() ? 0 : 1;
        for (Breach breach : broken.values()) {
            worst.merge(breach.law(), breach.value(), Math::max);
        }
    }

    private static String decade(double value) {
        return value == 0 ? "0" : "1e%+d".formatted((int) Math.floor(Math.log10(value) + 1e-9));
    }

    private void count(String dimension, String corner, Map<Law, Breach> broken) {
        corners.computeIfAbsent(dimension, key -> new TreeMap<>())
                .computeIfAbsent(corner, key -> new Row())
                .add(broken);
    }

    /** How many worlds broke a law. */
    public int failing() {
        return failing;
    }

    /** The statistics as Markdown tables: how many worlds of each corner broke which law. */
    public String markdown() {
        StringBuilder text = new StringBuilder();
        text.append("| corner | worlds |");
        for (Law law : Law.values()) {
            text.append(' ').append(law).append(" |");
        }
        text.append("\n|").append("---|".repeat(2 + Law.values().length)).append('\n');
        total.write(text, "all");
        text.append("| worst | |");
        for (Law law : Law.values()) {
            Double value = worst.get(law);
            text.append(value == null ? " |" : " %.2g |".formatted(value));
        }
        text.append('\n');
        corners.forEach((dimension, rows) ->
                rows.forEach((corner, row) -> row.write(text, dimension + " " + corner)));
        return text.toString();
    }
}
