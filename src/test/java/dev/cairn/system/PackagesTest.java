package dev.cairn.system;

import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.Slice;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Each package is small enough to be a chapter, each file too, and no packages are in a circle. */
@AnalyzeClasses(packages = "dev.cairn", importOptions = ShippedClasses.class)
final class PackagesTest {
    /** Files that one folder may hold before it wants sections. */
    private static final int MOST_FILES = 25;

    /** Of a file that can be read in one go. */
    private static final int MOST_LINES = 500;

    @ArchTest
    static final ArchRule noPackagesInACircle =
            slices().matching("dev.cairn.(**)")
                    .that(
                            new DescribedPredicate<Slice>("belong to the engine") {
                                @Override
                                public boolean test(Slice slice) {
                                    return !slice.getNamePart(1).startsWith("samples");
                                }
                            })
                    .should()
                    .beFreeOfCycles();

    @Test
    void foldersAreSmall() throws IOException {
        Map<Path, Long> files =
                sources().stream()
                        .collect(Collectors.groupingBy(Path::getParent, Collectors.counting()));
        files.forEach((folder, count) ->
                assertTrue(count <= MOST_FILES, () -> folder + " holds " + count + " files"));
        assertTrue(files.size() > 150, "folders: " + files.size());
    }

    @Test
    void filesAreShort() throws IOException {
        for (Path file : sources()) {
            long lines = Files.readAllLines(DocsTest.ROOT.resolve(file)).size();
            assertTrue(lines <= MOST_LINES, () -> file + " has " + lines + " lines");
        }
    }

    /** What is compiled of all modules, tests among it. */
    private static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.walk(DocsTest.ROOT)) {
            return files.map(DocsTest.ROOT::relativize)
                    .filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> file.toString().replace('\\', '/').contains("src/"))
                    .toList();
        }
    }
}
