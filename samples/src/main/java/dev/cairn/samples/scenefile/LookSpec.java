package dev.cairn.samples.scenefile;

import dev.cairn.render.mesh.Texture;

import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * How an entity looks. Immutable.
 *
 * @param visible whether it is drawn
 * @param rgb colour that the texture is multiplied by, 0xRRGGBB in sRGB, or null for one of the
 *     palette, by the entity's place in the list
 * @param texture path of a {@code .png}, or a built-in one ({@code builtin:grid}, {@code
 *     builtin:panel}, {@code builtin:beach-ball}, {@code builtin:metal}, {@code builtin:glass},
 *     {@code builtin:plain}), or null for that of the shape
 * @param tileMetres the texture repeats after so many metres; 0 = the mesh's own coordinates
 * @param mesh path of an {@code .obj} that is drawn instead of the shape, or null
 * @param meshScale factors along the axes of that mesh, &gt; 0
 */
public record LookSpec(
        boolean visible,
        @Nullable Integer rgb,
        @Nullable String texture,
        double tileMetres,
        @Nullable String mesh,
        Xyz meshScale) {
    /** How the names of textures begin that need no file. */
    public static final String BUILT_IN = "builtin:";

    /** The textures that need no file, by name. */
    public static final List<String> TEXTURES =
            List.of(
                    "builtin:plain",
                    "builtin:grid",
                    "builtin:panel",
                    "builtin:beach-ball",
                    "builtin:metal",
                    "builtin:glass");

    /** As its shape looks, in a colour of the palette. */
    public static final LookSpec DEFAULT = new LookSpec(true, null, null, 0, null, Xyz.ONE);

    /** Checks scale and tile; a tile of -0 is 0. */
    public LookSpec {
        if (!(tileMetres >= 0) || Double.isInfinite(tileMetres)) {
            throw new IllegalArgumentException(
                    "tileMetres is " + tileMetres + ", expected at least 0 and finite");
        }
        tileMetres += 0.0;
        if (!(meshScale.x() > 0 && meshScale.y() > 0 && meshScale.z() > 0)) {
            throw new IllegalArgumentException(
                    "meshScale is " + meshScale + ", expected factors above 0");
        }
    }

    /**
     * The same in another colour.
     *
     * @param value 0xRRGGBB, or null for one of the palette
     * @return a copy
     */
    public LookSpec withRgb(@Nullable Integer value) {
        return new LookSpec(visible, value, texture, tileMetres, mesh, meshScale);
    }

    /**
     * Whether the texture is a file, whose path is relative to that of the scene.
     *
     * @return false for none and for built-in ones
     */
    public boolean hasTextureFile() {
        return texture != null && !texture.startsWith(BUILT_IN);
    }

    /**
     * The same with another texture.
     *
     * @param value path, {@code builtin:} name, or null
     * @param tile metres of one repetition, or 0
     * @return a copy
     */
    public LookSpec withTexture(@Nullable String value, double tile) {
        return new LookSpec(visible, rgb, value, tile, mesh, meshScale);
    }

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
        for (String name : TEXTURES) {
            if (untiled.equals(builtIn(name))) {
                return name;
            }
        }
        return null;
    }
}
