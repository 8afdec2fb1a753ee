package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.io.File;
import java.lang.module.Configuration;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleFinder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The three engine modules also work on the module path, and export what users should see and
 * nothing else.
 */
final class ModulesTest {
    /** What users and other modules may know of the physics. */
    static final Set<String> PHYSICS_EXPORTS =
            Set.of(
                    "dev.cairn.physics",
                    "dev.cairn.physics.hand",
                    "dev.cairn.physics.joint",
                    "dev.cairn.physics.collider",
                    "dev.cairn.physics.body",
                    "dev.cairn.physics.component",
                    "dev.cairn.physics.profile",
                    "dev.cairn.physics.query",
                    "dev.cairn.physics.shape",
                    "dev.cairn.physics.shape.decomposition",
                    "dev.cairn.physics.time",
                    "dev.cairn.physics.tuning");

    private static final List<String> WANTED =
            List.of("engine-", "jctools", "joml", "lwjgl", "jspecify");

    private static ModuleFinder modules() {
        Path[] paths =
                Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                        .filter(p -> WANTED.stream().anyMatch(p::contains))
                        .filter(p -> !p.contains("natives"))
                        .filter(p ->
                                p.endsWith(".jar") || p.replace('\\', '/').endsWith("/classes"))
                        .map(Path::of)
                        .toArray(Path[]::new);
        return ModuleFinder.of(paths);
    }

    @Test
    void theRenderModuleResolvesWithAllThatItNeeds() {
        Configuration configuration =
                ModuleLayer.boot()
                        .configuration()
                        .resolve(modules(), ModuleFinder.of(), Set.of("dev.cairn.render"));

        Set<String> names =
                configuration.modules().stream().map(m -> m.name()).collect(Collectors.toSet());
        assertTrue(
                names.containsAll(
                        Set.of("dev.cairn.core", "dev.cairn.physics", "dev.cairn.render")),
                () -> "resolved only " + names);
    }

    @Test
    void theVectorModuleIsNotNeededAtRunTime() {
        ModuleDescriptor physics = modules().find("dev.cairn.physics").orElseThrow().descriptor();

        ModuleDescriptor.Requires vector =
                physics.requires().stream()
                        .filter(r -> r.name().equals("jdk.incubator.vector"))
                        .findFirst()
                        .orElseThrow();
        assertTrue(vector.modifiers().contains(ModuleDescriptor.Requires.Modifier.STATIC));
    }

    @Test
    void physicsExportsWhatUsersSeeAndNothingElse() {
        ModuleDescriptor physics = modules().find("dev.cairn.physics").orElseThrow().descriptor();

        assertEquals(
                PHYSICS_EXPORTS,
                physics.exports().stream().map(e -> e.source()).collect(Collectors.toSet()));
        assertFalse(physics.isOpen());
    }
}
