package dev.cairn.render.camera;

import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * What is drawn beyond light by Lambert's law, one shadow edge for all distances and a hemisphere
 * of sky. Each costs time on the graphics processor and none on the CPU; {@code docs/rendering.md}
 * says how much. Immutable.
 *
 * @param softShadows whether the edges of shadows widen with the distance to what casts them
 * @param occlusion whether corners and the ground beneath things get less of the sky's light
 * @param reflections whether surfaces mirror sun and sky by their roughness and metal
 * @param filmic whether what is bright goes softly into white, and what is dark into black
 * @param horizon whether wide floors dissolve into a ground that ends in a horizon
 * @param skyLight whether surfaces get the light of the whole half of the sky that they face, and
 *     rough ones mirror it blurred
 * @param cascades whether shadows reach over the whole view, and are finer near the eye
 * @param antialiasing whether edges are drawn by four samples a pixel, as far as the graphics
 *     processor can, and not by one
 */
public record Effects(
        boolean softShadows,
        boolean occlusion,
        boolean reflections,
        boolean filmic,
        boolean horizon,
        boolean skyLight,
        boolean cascades,
        boolean antialiasing) {
    /** Everything; what pictures and windows on a graphics processor begin with. */
    public static final Effects ALL = new Effects(true, true, true, true, true, true, true, true);

    /** Nothing; what windows on a software rasteriser begin with. */
    public static final Effects PLAIN =
            new Effects(false, false, false, false, false, false, false, false);

    private static final List<String> NAMES =
            List.of(
                    "soft-shadows",
                    "occlusion",
                    "reflections",
                    "filmic",
                    "horizon",
                    "sky-light",
                    "cascades",
                    "antialiasing");

    /**
     * By names, as in the property {@code cairn.effects}.
     *
     * @param names {@code all}, {@code plain}, or some of {@code soft-shadows}, {@code occlusion},
     *     {@code reflections}, {@code filmic}, {@code horizon}, {@code sky-light}, {@code
     *     cascades}, {@code antialiasing}, separated by commas
     * @return the effects
     * @throws IllegalArgumentException if there is another name
     */
    public static Effects named(String names) {
        if (names.equals("all") || names.equals("plain")) {
            return names.equals("all") ? ALL : PLAIN;
        }
        List<String> wanted = List.of(names.strip().split("\\s*,\\s*"));
        for (String name : wanted) {
            if (!NAMES.contains(name)) {
                throw new IllegalArgumentException(
                        "cairn.effects holds '"
                                + name
                                + "', expected all, plain, or some of "
                                + String.join(",", NAMES));
            }
        }
        return new Effects(
                wanted.contains(NAMES.get(0)),
                wanted.contains(NAMES.get(1)),
                wanted.contains(NAMES.get(2)),
                wanted.contains(NAMES.get(3)),
                wanted.contains(NAMES.get(4)),
                wanted.contains(NAMES.get(5)),
                wanted.contains(NAMES.get(6)),
                wanted.contains(NAMES.get(7)));
    }

    /**
     * What the property {@code cairn.effects} asks for.
     *
     * @return the effects, or null without that property
     * @throws IllegalArgumentException if it holds another name
     */
    public static @Nullable Effects ofProperty() {
        String names = System.getProperty("cairn.effects");
        return names == null ? null : named(names);
    }
}
