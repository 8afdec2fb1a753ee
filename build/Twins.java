import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Writes the solver's kernels a second time, in single precision.
 *
 * <p>Kernels that call the Vector API cannot be generic: a vector that crosses a type parameter is
 * boxed. So there is one text, in double, and this program makes the other one from it by rules
 * that hold for the whole text:
 *
 * <ul>
 *   <li>{@code double}, {@code DoubleVector}, {@code Double} become {@code float} and so on;
 *   <li>{@code .doubles} and {@code .state}, which there are two of, become {@code .floats};
 *   <li>literals get an f, square roots are rounded to float at once;
 *   <li>what is read from a contact or from the sub-step is rounded, and so is what stands behind
 *       {@code /*(float)*}{@code /};
 *   <li>{@code .root} and {@code .warm} become {@code .rootFloats} and {@code .warmFloats};
 *   <li>the classes of the list get {@code Single} in front of their names.
 * </ul>
 *
 * <p>Arguments: the folder of the solver's packages, the folder to write its twins to.
 */
final class Twins {
    private static final List<String> TWINS =
            List.of(
                    "LaneKernels",
                    "LanePrepare",
                    "LaneStaging",
                    "LaneStore",
                    "PrepareRow",
                    "WarmStart",
                    "StoreRow",
                    "Offsets",
                    "LaneBodies",
                    "LaneNormals",
                    "LaneFour",
                    "LaneFew",
                    "LaneFriction",
                    "LaneSweep",
                    "ScalarSweep",
                    "ScalarNormals",
                    "ScalarFour",
                    "ScalarFriction",
                    "RollingFriction",
                    "PatchFriction",
                    "RowArithmetic",
                    "StartSweep");

    /** What is read from a contact or from the sub-step. */
    private static final Pattern READ =
            Pattern.compile(
                    "\\b((?:c|contacts)\\.(?:normal[XYZ]|friction|anchor[AB][XYZ]|frictionImpulse[XYZ]"
                        + "|twistImpulse)\\([^()]*\\)"
                        + "|(?:c|contacts)\\.(?:anchors|separation|normalImpulse|totalNormalImpulse"
                        + "|preload|patch)\\[[^\\]]*\\](?!\\s*[-+*]?=[^=])"
                        + "|sub\\.(?:rate|fixedRate|massScale|fixedMassScale|inverse|pushSpeed"
                        + "|fillScale|offsetGain|still|stiffness\\([^()]*\\)))");

    private static final Pattern NUMBER =
            Pattern.compile(
                    "(?<![\\w.])(\\d+\\.\\d*(?:[eE][+-]?\\d+)?|\\d+[eE][+-]?\\d+)(?![\\w.])");

    private Twins() {}

    public static void main(String[] arguments) throws IOException {
        if (arguments.length != 2) {
            throw new IllegalArgumentException(
                    "Twins needs the folder of the sources and the folder to write to, but got "
                            + List.of(arguments));
        }
        Path from = Path.of(arguments[0]);
        Path to = Files.createDirectories(Path.of(arguments[1]));
        Map<Path, String> texts = new TreeMap<>();
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.toList()) {
                String name = file.getFileName().toString();
                if (name.endsWith(".java") && TWINS.contains(name.replace(".java", ""))) {
                    Path twin = to.resolve(from.relativize(file)).resolveSibling("Single" + name);
                    texts.put(twin, twin(Files.readString(file)));
                }
            }
        }
        if (texts.size() != TWINS.size()) {
            throw new IllegalStateException(
                    "Twins lists " + TWINS.size() + " classes, but found " + texts.keySet());
        }
        clean(to, texts);
        for (Map.Entry<Path, String> twin : texts.entrySet()) {
            Path file = twin.getKey();
            // an unchanged file keeps its time, so that nothing is compiled for it
            if (!Files.exists(file) || !Files.readString(file).equals(twin.getValue())) {
                Files.createDirectories(file.getParent());
                Files.writeString(file, twin.getValue());
            }
        }
    }

    /** Deletes the twins of classes that are no longer in the list, or elsewhere. */
    private static void clean(Path folder, Map<Path, String> texts) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                if (!texts.containsKey(file)) {
                    Files.delete(file);
                }
            }
        }
    }

    private static String twin(String source) {
        String text = source;
        for (String name : TWINS) {
            text = text.replaceAll("\\b" + name + "\\b", "Single" + name);
        }
        text = text.replace("/*(float)*/", "(float)");
        text = READ.matcher(text).replaceAll("(float) $1");
        text = text.replaceAll("\\.(root|warm)\\b", ".$1Floats");
        text = text.replaceAll("\\bdouble\\b", "float");
        text = text.replaceAll("\\.(doubles|state)\\b", ".floats");
        text = text.replaceAll("\\bDoubleVector\\b", "FloatVector");
        text = text.replaceAll("\\bDouble\\b", "Float");
        text = text.replaceAll("\\bMath\\.sqrt\\(", "(float) Math.sqrt(");
        return NUMBER.matcher(text)
                .replaceAll(found -> Matcher.quoteReplacement(found.group() + "f"));
    }
}
