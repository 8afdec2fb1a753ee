package dev.cairn.samples.scenefile;

import dev.cairn.render.mesh.Texture;

import org.jspecify.annotations.Nullable;

import java.util.List;

/** The textures that need no file, by name. */
final class Textures {
    static final String PREFIX = "builtin:";

    static final List<String> NAMES =
            List.of(
                    "builtin:plain",
                    "builtin:grid",
                    "builtin:panel",
                    "builtin:beach-ball",
                    "builtin:metal",
                    "builtin:glass");

    private Textures() {}

    /** The texture of a built-in name, or null if there is none. */
    static @Nullable Texture builtIn(String name) {
        return switch (name) {
            case "builtin:plain" -> Texture.WHITE;
            case "builtin:grid" -> Texture.grid();
            case "builtin:panel" -> Texture.panel();
            case "builtin:beach-ball" -> Texture.beachBall();
            case "builtin:metal" -> Texture.bareMetal();
            case "builtin:glass" -> Texture.glass();
            default -> null;
        };
    }

    /** The built-in name of a texture, whatever its tiling, or null if it is none of them. */
    static @Nullable String nameOf(Texture texture) {
        Texture untiled = texture.tiledEvery(0);
        for (String name : NAMES) {
            if (untiled.equals(builtIn(name))) {
                return name;
            }
        }
        return null;
    }
}
