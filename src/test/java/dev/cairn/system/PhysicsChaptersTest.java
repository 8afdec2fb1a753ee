package dev.cairn.system;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;

import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The packages of the physics are chapters: each knows the ones before it. */
@AnalyzeClasses(packages = "dev.cairn.physics", importOptions = ShippedClasses.class)
final class PhysicsChaptersTest {
    private static final String SOLVER = "dev.cairn.physics.solver";

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
}
