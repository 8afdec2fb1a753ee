package dev.cairn.system;

import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.Slice;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Each package is small enough to be a chapter, each file too, and no packages are in a circle. */
@AnalyzeClasses(packages = "dev.cairn", importOptions = ShippedClasses.class)
final class PackagesTest {
    /** Files that one folder may hold before it wants sections. */
    private static final int MOST_FILES = 25;

    private static final int LARGEST_CIRCLE = 8;

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

    /**
     * Classes of the physics that know each other in a circle are few enough to be read together;
     * that a sealed type names what it permits is none.
     */
    @ArchTest
    static void circlesOfClassesAreSmall(JavaClasses all) {
        Map<String, Set<String>> known = new TreeMap<>();
        for (JavaClass type : all) {
            if (type.getPackageName().startsWith("dev.cairn.physics")) {
                Set<String> of = known.computeIfAbsent(outer(type), key -> new TreeSet<>());
                for (Dependency dependency : type.getDirectDependenciesFromSelf()) {
                    of.add(outer(dependency.getTargetClass()));
                }
            }
        }
        Map<String, Set<String>> reached = new TreeMap<>();
        known.forEach((type, of) -> reached.put(type, reached(type, known)));
        reached.forEach((type, of) -> {
            List<String> circle = of.stream().filter(b -> reached.get(b).contains(type)).toList();
            assertTrue(circle.size() <= LARGEST_CIRCLE, () -> "in a circle: " + circle);
        });
        assertTrue(known.size() > 300, "classes: " + known.size());
    }

    private static Set<String> reached(String from, Map<String, Set<String>> known) {
        Set<String> all = new TreeSet<>(Set.of(from));
        Deque<String> open = new ArrayDeque<>(all);
        while (!open.isEmpty()) {
            for (String next : known.get(open.pop())) {
                if (known.containsKey(next) && all.add(next)) {
                    open.push(next);
                }
            }
        }
        return all;
    }

    private static String outer(JavaClass type) {
        String name = type.getBaseComponentType().getName();
        return name.contains("$") ? name.substring(0, name.indexOf('$')) : name;
    }

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
