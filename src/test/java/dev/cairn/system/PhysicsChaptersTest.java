package dev.cairn.system;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The packages of the physics are chapters: each knows the ones before it, and none in a circle.
 */
@AnalyzeClasses(packages = "dev.cairn.physics", importOptions = ShippedClasses.class)
final class PhysicsChaptersTest {
    /** Files that one folder may hold before it wants sections. */
    private static final int MOST_FILES = 25;

    private static final String SOLVER = "dev.cairn.physics.solver";

    @ArchTest
    static final ArchRule noPackagesInACircle =
            slices().matching("dev.cairn.(**)").should().beFreeOfCycles();

    /** What touches is told with the contact. */
    @ArchTest
    static final ArchRule solverAsksForNoShape =
            noClasses()
                    .that()
                    .resideInAPackage(SOLVER + "..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("dev.cairn.physics.shape..");

    /** The chapters of the solver, from the last to the first. */
    @ArchTest
    static final ArchRule solverKnowsItsChaptersInOrder =
            layeredArchitecture()
                    .consideringOnlyDependenciesInAnyPackage(SOLVER + "..")
                    .layer("solver")
                    .definedBy(SOLVER)
                    .layer("single")
                    .definedBy(SOLVER + ".single")
                    .layer("joint")
                    .definedBy(SOLVER + ".joint")
                    .layer("direct")
                    .definedBy(SOLVER + ".direct")
                    .layer("refresh")
                    .definedBy(SOLVER + ".refresh")
                    .layer("impact")
                    .definedBy(SOLVER + ".impact")
                    .layer("load")
                    .definedBy(SOLVER + ".load")
                    .layer("graph")
                    .definedBy(SOLVER + ".graph")
                    .layer("wide")
                    .definedBy(SOLVER + ".wide")
                    .layer("kernel")
                    .definedBy(SOLVER + ".kernel")
                    .layer("row")
                    .definedBy(SOLVER + ".row")
                    .layer("body")
                    .definedBy(SOLVER + ".body")
                    .whereLayer("solver")
                    .mayNotBeAccessedByAnyLayer()
                    .whereLayer("single")
                    .mayOnlyBeAccessedByLayers("solver")
                    .whereLayer("joint")
                    .mayOnlyBeAccessedByLayers("solver", "graph")
                    .whereLayer("direct")
                    .mayOnlyBeAccessedByLayers("solver")
                    .whereLayer("wide")
                    .mayOnlyBeAccessedByLayers("solver")
                    .whereLayer("refresh")
                    .mayOnlyBeAccessedByLayers("solver", "single", "joint")
                    .whereLayer("impact")
                    .mayOnlyBeAccessedByLayers("solver", "single")
                    .whereLayer("graph")
                    .mayOnlyBeAccessedByLayers("solver", "direct")
                    .whereLayer("load")
                    .mayOnlyBeAccessedByLayers("solver", "direct")
                    .whereLayer("kernel")
                    .mayOnlyAccessLayers("row", "body")
                    .whereLayer("row")
                    .mayOnlyAccessLayers("body")
                    .whereLayer("body")
                    .mayNotAccessAnyLayer();

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
                                                PhysicsChaptersTest::file, Collectors.toSet())));
        files.forEach((name, of) ->
                assertTrue(of.size() <= MOST_FILES, () -> name + " holds " + of.size() + " files"));
    }

    private static String file(JavaClass type) {
        return type.getSource().flatMap(source -> source.getFileName()).orElse(type.getName());
    }
}
