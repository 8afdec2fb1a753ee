package dev.cairn.samples.scenefile;

import dev.cairn.physics.Body;
import dev.cairn.samples.scenefile.ShapeSpec.As;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;

/**
 * What a file may not say of an entity though each of its values is possible by itself. The reader
 * and the editor ask the same, so that whatever was edited can be read again. Stateless.
 */
public final class EntityRules {
    /** What is expected where {@link #wantsSolid}. */
    static final String SOLID =
            "a solid shape for a dynamic body (a surface of triangles has no inside: \"body\":"
                    + " \"fixed\" or \"kinematic\")";

    /** What is expected where {@link #wantsOneShape}. */
    static final String ONE_SHAPE =
            "a collider of one shape (\"as\": \"parts\" is for the shape of an entity)";

    private EntityRules() {}

    /** Whether a part is a surface, and its body moves. */
    static boolean wantsSolid(EntitySpec entity, PartSpec part) {
        return entity.body() == BodyKind.DYNAMIC && part.shape().isSurface();
    }

    /** Whether a part is said to be several shapes, where there is room for one. */
    static boolean wantsOneShape(EntitySpec entity, PartSpec part) {
        return !entity.physics().parts().isEmpty()
                && part.shape() instanceof MeshShape mesh
                && mesh.as() == As.PARTS;
    }

    /** What is expected of a texture, or an empty text if it may be so. */
    static String texture(String name) {
        boolean isUnknown = name.startsWith(LookSpec.BUILT_IN) && LookSpec.builtIn(name) == null;
        return isUnknown ? "a file or one of " + String.join(", ", LookSpec.TEXTURES) : "";
    }

    /**
     * Checks an entity that was not read from a file. Broken mesh files are found when a scene is
     * shown.
     *
     * @param entity which one
     * @throws IllegalArgumentException if a file could not hold it, or the world refuses it
     */
    public static void check(EntitySpec entity) {
        for (PartSpec part : entity.parts()) {
            if (wantsSolid(entity, part)) {
                throw refusal(SOLID, part.shape().type());
            }
            if (wantsOneShape(entity, part)) {
                throw refusal(ONE_SHAPE, "parts");
            }
            if (!(part.shape() instanceof MeshShape)) {
                part.collider(part.shape().collider(entity.scale()), 1);
            }
        }
        String texture = entity.look().texture();
        String wanted = texture == null ? "" : texture(texture);
        if (!wanted.isEmpty()) {
            throw refusal(wanted, "\"" + texture + "\"");
        }
        entity.physics().tell(Body.dynamic());
    }

    private static IllegalArgumentException refusal(String expected, String found) {
        return new IllegalArgumentException("expected " + expected + ", found " + found);
    }
}
