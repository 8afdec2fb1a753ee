package dev.cairn.render.mesh;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Reads materials from Wavefront {@code .mtl} files: the diffuse colour {@code Kd} and picture
 * {@code map_Kd}, which is what a renderer by Lambert's law can show. The other statements of the
 * format (highlights, transparency, bumps) are passed over; anything else is an error that names
 * the file, the line, what was expected and what stands there.
 */
final class MtlReader {
    private static final Set<String> PASSED_OVER =
            Set.of(
                    "Ka",
                    "Ks",
                    "Ke",
                    "Ns",
                    "Ni",
                    "Tf",
                    "Tr",
                    "d",
                    "illum",
                    "sharpness",
                    "Pr",
                    "Pm",
                    "Ps",
                    "Pc",
                    "Pcr",
                    "aniso",
                    "anisor",
                    "map_Ka",
                    "map_Ks",
                    "map_Ke",
                    "map_Ns",
                    "map_Pr",
                    "map_Pm",
                    "map_d",
                    "map_bump",
                    "map_Bump",
                    "bump",
                    "disp",
                    "decal",
                    "refl",
                    "norm");

    /** How many words follow an option of a {@code map_} statement, at most. */
    private static final Map<String, Integer> OPTIONS =
            Map.ofEntries(
                    Map.entry("-blendu", 1),
                    Map.entry("-blendv", 1),
                    Map.entry("-boost", 1),
                    Map.entry("-cc", 1),
                    Map.entry("-clamp", 1),
                    Map.entry("-texres", 1),
                    Map.entry("-bm", 1),
                    Map.entry("-imfchan", 1),
                    Map.entry("-type", 1),
                    Map.entry("-mm", 2),
                    Map.entry("-o", 3),
                    Map.entry("-s", 3),
                    Map.entry("-t", 3));

    /** A surface: a colour that multiplies a picture. */
    record Surface(int rgb, Texture texture) {
        /** What a face wears whose material is not to be had. */
        static final Surface MISSING = new Surface(0xFFFFFF, Texture.missing());

        /** What a face wears that names no material. */
        static final Surface PLAIN = new Surface(0xD9D9D9, Texture.WHITE);
    }

    private final Path file;
    private final Consumer<String> problems;
    private final Map<String, Surface> surfaces = new LinkedHashMap<>();
    private String current = "";
    private int line;

    private MtlReader(Path file, Consumer<String> problems) {
        this.file = file;
        this.problems = problems;
    }

    /**
     * Reads a file.
     *
     * @param file where it is
     * @param problems hears of pictures that cannot be used, one line each; they are shown as
     *     {@link Texture#missing}
     * @return materials by name
     * @throws ObjFormatException if the file is missing or broken
     */
    static Map<String, Surface> read(Path file, Consumer<String> problems) {
        MtlReader reader = new MtlReader(file, problems);
        reader.run();
        return reader.surfaces;
    }

    private void run() {
        if (!Files.isRegularFile(file)) {
            throw new ObjFormatException(
                    file, 0, "expected an .mtl file, found nothing there", null);
        }
        try (BoundedLines in = new BoundedLines(file)) {
            String text;
            while ((text = in.next()) != null) {
                line++;
                statement(text);
            }
        } catch (IOException e) {
            throw new ObjFormatException(file, line, "expected a readable file, found: " + e, e);
        }
    }

    private void statement(String raw) {
        int hash = raw.indexOf('#');
        String text = (hash < 0 ? raw : raw.substring(0, hash)).strip();
        if (text.isEmpty()) {
            return;
        }
        String[] words = text.split("\\s+");
        switch (words[0]) {
            case "newmtl" -> {
                if (words.length < 2) {
                    throw error("a name after newmtl", "nothing");
                }
                current = text.substring("newmtl".length()).strip();
                surfaces.put(current, new Surface(0xFFFFFF, Texture.WHITE));
            }
            case "Kd" -> {
                Surface now = surface(words[0]);
                surfaces.put(current, new Surface(colour(words), now.texture()));
            }
            case "map_Kd" -> {
                Surface now = surface(words[0]);
                surfaces.put(current, new Surface(now.rgb(), picture(text, words)));
            }
            default -> {
                if (!PASSED_OVER.contains(words[0])) {
                    throw error(
                            "an .mtl statement (newmtl, Kd, map_Kd, Ns, ...)",
                            "'" + ObjReader.shown(words[0]) + "'");
                }
            }
        }
    }

    private Surface surface(String statement) {
        Surface now = surfaces.get(current);
        if (now == null) {
            throw error("newmtl before " + statement, "no material yet");
        }
        return now;
    }

    /** Red, green and blue from 0 to 1, taken as what the screen shows; one number is a grey. */
    private int colour(String[] words) {
        if (words.length != 4 && words.length != 2) {
            throw error("3 numbers from 0 to 1 after Kd", (words.length - 1) + " words");
        }
        int rgb = 0;
        for (int i = 0; i < 3; i++) {
            String word = words[words.length == 2 ? 1 : i + 1];
            double value;
            try {
                value = Double.parseDouble(word);
            } catch (NumberFormatException notANumber) {
                value = Double.NaN;
            }
            if (!(value >= 0 && value <= 1)) {
                throw error("numbers from 0 to 1 after Kd", "'" + ObjReader.shown(word) + "'");
            }
            rgb = rgb << 8 | (int) Math.round(255 * value);
        }
        return rgb;
    }

    private Texture picture(String text, String[] words) {
        int at = 1;
        while (at < words.length) {
            Integer most = OPTIONS.get(words[at]);
            if (most == null) {
                break;
            }
            at++;
            for (int i = 0; i < most && at < words.length - 1 && isValue(words[at], i); i++) {
                at++;
            }
        }
        if (at >= words.length) {
            throw error("the path of a picture after map_Kd", "'" + ObjReader.shown(text) + "'");
        }
        // A path may hold blanks.
        String path = text.split("\\s+", at + 1)[at].strip().replace('\\', '/');
        try {
            return Texture.read(file.resolveSibling(path));
        } catch (IllegalArgumentException unusable) {
            problems.accept(
                    file
                            + ":"
                            + line
                            + ": "
                            + (unusable instanceof InvalidPathException
                                    ? "expected a path, found '" + ObjReader.shown(path) + "'"
                                    : unusable.getMessage()));
            return Texture.missing();
        }
    }

    private static boolean isValue(String word, int index) {
        return index == 0 || word.matches("[-+.0-9eE]+");
    }

    private ObjFormatException error(String expected, String found) {
        return new ObjFormatException(
                file, line, "expected " + expected + ", found " + found, null);
    }
}
