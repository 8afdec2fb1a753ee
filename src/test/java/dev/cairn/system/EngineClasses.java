package dev.cairn.system;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.Location;

import dev.cairn.core.ecs.World;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.app.Application;
import dev.cairn.samples.SceneRegistry;

import java.net.URISyntaxException;
import java.net.URL;
import java.util.List;

/**
 * The rules of the architecture are about the modules themselves: what lies where their main
 * classes come from, however the build names its folders; tests do not.
 */
final class EngineClasses implements ImportOption {
    private static final List<Class<?>> MODULES =
            List.of(World.class, PhysicsWorld.class, Application.class, SceneRegistry.class);

    @Override
    public boolean includes(Location location) {
        return MODULES.stream().anyMatch(module -> location.contains(origin(module)));
    }

    private static String origin(Class<?> module) {
        URL url = module.getProtectionDomain().getCodeSource().getLocation();
        try {
            return url.toURI().getPath();
        } catch (URISyntaxException strange) {
            throw new IllegalStateException("origin of " + module + " is " + url, strange);
        }
    }
}
