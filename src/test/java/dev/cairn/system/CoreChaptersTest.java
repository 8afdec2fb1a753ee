package dev.cairn.system;

import static com.tngtech.archunit.library.Architectures.layeredArchitecture;

import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The packages of the ECS are chapters: each knows the ones before it. */
@AnalyzeClasses(packages = "dev.cairn.core", importOptions = ShippedClasses.class)
final class CoreChaptersTest {
    private static final String ECS = "dev.cairn.core.ecs";

    /** The chapters of the ECS, from the last to the first. */
    @ArchTest
    static final ArchRule theEcsKnowsItsChaptersInOrder =
            layeredArchitecture()
                    .consideringOnlyDependenciesInAnyPackage(ECS + "..")
                    .layer("ecs")
                    .definedBy(ECS)
                    .layer("graph")
                    .definedBy(ECS + ".graph")
                    .layer("access")
                    .definedBy(ECS + ".access")
                    .layer("storage")
                    .definedBy(ECS + ".storage")
                    .layer("component")
                    .definedBy(ECS + ".component")
                    .whereLayer("ecs")
                    .mayNotBeAccessedByAnyLayer()
                    .whereLayer("graph")
                    .mayOnlyAccessLayers("access", "component")
                    .whereLayer("access")
                    .mayOnlyAccessLayers("component")
                    .whereLayer("storage")
                    .mayOnlyAccessLayers("component")
                    .whereLayer("component")
                    .mayNotAccessAnyLayer();
}
