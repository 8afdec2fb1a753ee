package dev.cairn.system;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaFieldAccess;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

import java.util.Set;

/**
 * The house rules of the architecture: arrows run one way, and nothing in a step can break its
 * determinism.
 */
@AnalyzeClasses(packages = "dev.cairn", importOptions = ShippedClasses.class)
final class ArchitectureTest {
    /** Functions of {@link Math} whose result may differ between JVMs and processors. */
    private static final Set<String> PLATFORM_MATH =
            Set.of(
                    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "expm1", "log",
                    "log10", "log1p", "pow", "cbrt", "sinh", "cosh", "tanh", "hypot", "random");

    @ArchTest
    static final ArchRule coreKnowsNeitherPhysicsNorDrawing =
            noClasses()
                    .that()
                    .resideInAPackage("dev.cairn.core..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAnyPackage(
                            "dev.cairn.physics..",
                            "dev.cairn.render..",
                            "dev.cairn.samples..",
                            "org.lwjgl..",
                            "org.joml..");

    @ArchTest
    static final ArchRule physicsKnowsNoDrawing =
            noClasses()
                    .that()
                    .resideInAPackage("dev.cairn.physics..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAnyPackage("dev.cairn.render..", "dev.cairn.samples..", "org.lwjgl..");

    @ArchTest
    static final ArchRule renderKnowsNoSamples =
            noClasses()
                    .that()
                    .resideInAPackage("dev.cairn.render..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("dev.cairn.samples..");

    @ArchTest
    static final ArchRule renderSeesOnlyWhatPhysicsExports =
            noClasses()
                    .that()
                    .resideOutsideOfPackage("dev.cairn.physics..")
                    .should()
                    .dependOnClassesThat(
                            new DescribedPredicate<JavaClass>(
                                    "are internal to the physics module") {
                                @Override
                                public boolean test(JavaClass type) {
                                    String name = type.getPackageName();
                                    return name.startsWith("dev.cairn.physics.")
                                            && !ModulesTest.PHYSICS_EXPORTS.contains(name);
                                }
                            });

    @ArchTest
    static final ArchRule jomlStaysAtTheEdgeOfPhysics =
            noClasses()
                    .that()
                    .resideInAnyPackage(
                            "dev.cairn.physics.broadphase..",
                            "dev.cairn.physics.narrowphase..",
                            "dev.cairn.physics.contact..",
                            "dev.cairn.physics.solver..",
                            "dev.cairn.physics.sweep..",
                            "dev.cairn.physics.internal..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("org.joml..");

    @ArchTest
    static final ArchRule onlyRenderAndSamplesKnowLwjgl =
            noClasses()
                    .that()
                    .resideOutsideOfPackages("dev.cairn.render..", "dev.cairn.samples..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("org.lwjgl..");

    /**
     * Who may: the profiles, which only tell what they read, and the warm-ups of wide kernels,
     * which choose between two ways to the same bits.
     */
    @ArchTest
    static final ArchRule theSimulationDoesNotReadTheClock =
            noClasses()
                    .that()
                    .resideInAnyPackage("dev.cairn.physics..", "dev.cairn.core.ecs..")
                    .and()
                    .doNotHaveSimpleName("StepClock")
                    .and()
                    .doNotHaveSimpleName("SystemClock")
                    .and()
                    .haveSimpleNameNotEndingWith("WarmUp")
                    .should()
                    .callMethod(System.class, "nanoTime")
                    .orShould()
                    .callMethod(System.class, "currentTimeMillis");

    @ArchTest
    static final ArchRule theSimulationUsesNoPlatformMath =
            noClasses()
                    .that()
                    .resideInAnyPackage("dev.cairn.physics..", "dev.cairn.core..")
                    .should()
                    .callMethodWhere(
                            new DescribedPredicate<JavaMethodCall>(
                                    "Math functions that are not exactly defined") {
                                @Override
                                public boolean test(JavaMethodCall call) {
                                    return call.getTargetOwner().isEquivalentTo(Math.class)
                                            && PLATFORM_MATH.contains(call.getName());
                                }
                            });

    /**
     * Vectors of two sizes in one JVM mix the compiler's profiles of the Vector API, and then are
     * objects on the heap. The solver's kernels of a given number of lanes are classes of their
     * own.
     */
    @ArchTest
    static final ArchRule vectorsHaveOneSize =
            noClasses()
                    .that()
                    .resideInAPackage("dev.cairn..")
                    .and()
                    .doNotHaveSimpleName("LaneSpecies")
                    .should()
                    .accessFieldWhere(
                            new DescribedPredicate<JavaFieldAccess>(
                                    "a species other than SPECIES_PREFERRED") {
                                @Override
                                public boolean test(JavaFieldAccess access) {
                                    return access.getTargetOwner()
                                                    .getPackageName()
                                                    .equals("jdk.incubator.vector")
                                            && access.getName().startsWith("SPECIES_")
                                            && !access.getName().equals("SPECIES_PREFERRED");
                                }
                            });

    @ArchTest
    static final ArchRule stepsUseNoStreams =
            noClasses()
                    .that()
                    .resideInAnyPackage(
                            "dev.cairn.core.job..",
                            "dev.cairn.core.snapshot..",
                            "dev.cairn.physics.broadphase..",
                            "dev.cairn.physics.narrowphase..",
                            "dev.cairn.physics.contact..",
                            "dev.cairn.physics.solver..",
                            "dev.cairn.physics.sweep..",
                            "dev.cairn.physics.internal..")
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("java.util.stream..");

    @ArchTest
    static final ArchRule nobodyTouchesUnsafe =
            noClasses()
                    .should()
                    .dependOnClassesThat()
                    .resideInAnyPackage("sun.misc..", "jdk.internal..");

    @ArchTest
    static final ArchRule jctoolsComesAsVarHandles =
            noClasses()
                    .should()
                    .dependOnClassesThat()
                    .resideInAnyPackage("org.jctools.queues", "org.jctools.queues.atomic..");

    @ArchTest
    static final ArchRule everyPackageIsNullMarked =
            classes()
                    .that()
                    .haveSimpleName("package-info")
                    .should()
                    .beAnnotatedWith("org.jspecify.annotations.NullMarked");
}
