package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The javadoc of a module shows the packages that it exports, and no others. */
final class JavadocTest {
    private static final Path ROOT = root();
    private static final Pattern EXPORTS = Pattern.compile("exports\\s+([\\w.]+)\\s*;");
    private static final Pattern EXCLUDED =
            Pattern.compile("<excludePackageNames>([^<]*)</excludePackageNames>");

    private static Path root() {
        Path at = Path.of("").toAbsolutePath();
        while (!Files.exists(at.resolve("engine-core"))) {
            at = at.getParent();
        }
        return at;
    }

    @ParameterizedTest
    @ValueSource(strings = {"engine-core", "engine-physics", "engine-render"})
    void showsWhatIsExported(String module) throws IOException {
        Path main = ROOT.resolve(module).resolve("src").resolve("main");
        String descriptor = Files.readString(main.resolve("module").resolve("module-info.java"));
        Set<String> exported =
                EXPORTS.matcher(descriptor)
                        .results()
                        .map(found -> found.group(1))
                        .collect(Collectors.toCollection(TreeSet::new));
        assertTrue(exported.size() > 1, "nothing is exported: " + descriptor);
        String pom = Files.readString(ROOT.resolve(module).resolve("pom.xml"));
        Set<String> excluded =
                EXCLUDED.matcher(pom)
                        .results()
                        .flatMap(found -> Arrays.stream(found.group(1).strip().split(":")))
                        .collect(Collectors.toSet());
        Set<String> shown =
                packages(main.resolve("java")).stream()
                        .filter(name -> excluded.stream().noneMatch(some -> isIn(name, some)))
                        .collect(Collectors.toCollection(TreeSet::new));
        assertEquals(exported, shown);
    }

    private static boolean isIn(String name, String excluded) {
        return excluded.endsWith(".*")
                ? name.startsWith(excluded.substring(0, excluded.length() - 1))
                : name.equals(excluded);
    }

    private static Set<String> packages(Path sources) throws IOException {
        try (Stream<Path> files = Files.walk(sources)) {
            return files.filter(file -> file.getFileName().toString().equals("package-info.java"))
                    .map(file -> sources.relativize(file.getParent()).toString())
                    .map(name -> name.replace('\\', '.').replace('/', '.'))
                    .collect(Collectors.toSet());
        }
    }
}
