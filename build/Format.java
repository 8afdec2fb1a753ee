import com.google.googlejavaformat.java.Formatter;
import com.google.googlejavaformat.java.FormatterException;
import com.google.googlejavaformat.java.JavaFormatterOptions;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The one formatter of the house: {@code java -cp google-java-format.jar build/Format.java check|apply ROOT}.
 *
 * <p>Maven may start on a JDK that is too old for the formatter, so the build runs this file on the JDK of the
 * toolchain. {@code check} names the files that differ and exits with 1; {@code apply} rewrites them.
 */
public final class Format {
    public static void main(String[] arguments) throws IOException {
        boolean apply = arguments[0].equals("apply");
        Path root = Path.of(arguments[1]);
        Formatter formatter =
                new Formatter(JavaFormatterOptions.builder().style(JavaFormatterOptions.Style.AOSP).build());
        List<Path> sources;
        try (Stream<Path> walk = Files.walk(root)) {
            sources = walk.filter(Format::isSource).sorted().toList();
        }
        List<String> problems = new ArrayList<>(sources.parallelStream().flatMap(f -> format(f, formatter, apply)).toList());
        if (problems.isEmpty()) {
            return;
        }
        problems.forEach(System.err::println);
        System.err.println(problems.size() + " file(s) are not formatted; run: mvn -Pformat");
        System.exit(1);
    }

    private static boolean isSource(Path file) {
        String path = file.toString().replace('\\', '/');
        return path.endsWith(".java") && !path.contains("/target/") && !path.contains("/build/Format.java");
    }

    private static Stream<String> format(Path file, Formatter formatter, boolean apply) {
        try {
            String before = Files.readString(file);
            String after = formatter.formatSourceAndFixImports(before);
            if (apply) {
                // A long line that is broken once may need to be broken again.
                String again = formatter.formatSourceAndFixImports(after);
                while (!again.equals(after)) {
                    after = again;
                    again = formatter.formatSourceAndFixImports(after);
                }
            }
            if (after.equals(before)) {
                return Stream.empty();
            }
            if (apply) {
                Files.writeString(file, after);
                return Stream.empty();
            }
            return Stream.of("not formatted: " + file);
        } catch (FormatterException | IOException e) {
            return Stream.of(file + ": " + e.getMessage());
        }
    }
}
