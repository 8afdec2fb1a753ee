package dev.cairn.system;

import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.Slice;

import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Each package is small enough to be a chapter, and no two of the engine know each other. */
@AnalyzeClasses(packages = "dev.cairn", importOptions = ShippedClasses.class)
final class PackagesTest {
    /** Files that one folder may hold before it wants sections. */
    private static final int MOST_FILES = 25;

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

    @ArchTest
    static void packagesAreSmall(JavaClasses all) {
        Map<String, Set<String>> files =
                all.stream()
                        .filter(type ->
                                !type.getSimpleName().startsWith("Single")
                                        || type.getSimpleName().startsWith("SingleContact"))
                        .collect(
                                Collectors.groupingBy(
                                        JavaClass::getPackageName,
                                        Collectors.mapping(
                                                PackagesTest::file,
                                                Collectors.toCollection(TreeSet::new))));
        files.forEach((name, of) ->
                assertTrue(of.size() <= MOST_FILES, () -> name + " holds " + of.size() + " files"));
    }

    private static String file(JavaClass type) {
        return type.getSource().flatMap(source -> source.getFileName()).orElse(type.getName());
    }
}
