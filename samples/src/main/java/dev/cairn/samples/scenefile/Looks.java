package dev.cairn.samples.scenefile;

import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.Collider;
import dev.cairn.physics.shape.Shape;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ModelGroup;
import dev.cairn.render.mesh.ObjModel;
import dev.cairn.render.mesh.ObjReader;
import dev.cairn.render.mesh.Texture;
import dev.cairn.samples.Palette;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * How the entities of a scene file are drawn: models, colours, pictures. A file that cannot be used
 * is told once and drawn as a placeholder.
 */
final class Looks {
    private final Path folder;
    private final SceneBuilder into;
    private final Map<String, @Nullable ObjModel> meshes;
    private final Map<String, @Nullable Texture> textures;

    /**
     * Of one folder.
     *
     * @param folder that relative paths start at
     * @param into is told what is wrong
     * @param meshes that were read, null for broken ones
     * @param textures that were read
     */
    Looks(
            Path folder,
            SceneBuilder into,
            Map<String, @Nullable ObjModel> meshes,
            Map<String, @Nullable Texture> textures) {
        this.folder = folder;
        this.into = into;
        this.meshes = meshes;
        this.textures = textures;
    }

    /** Several colliders are drawn as they are. */
    Visual look(List<Collider> parts, LookSpec look, int index) {
        Integer rgb = look.rgb();
        int colour = rgb != null ? rgb : Palette.body(index);
        List<Model> models = new ArrayList<>();
        for (Collider part : parts) {
            models.add(textured(Model.of(part.placed()).color(colour), look, index));
        }
        return new Visual(models.size() == 1 ? models.get(0) : new ModelGroup(models));
    }

    Visual look(EntitySpec entity, @Nullable Shape shape, int index) {
        LookSpec look = entity.look();
        Xyz s = entity.scale();
        Integer rgb = look.rgb();
        String file =
                look.mesh() != null
                        ? look.mesh()
                        : entity.shape() instanceof MeshShape own ? own.file() : null;
        if (file == null) {
            if (shape == null) {
                throw new IllegalStateException("entity " + index + " has no shape");
            }
            Model model = Model.of(shape).color(rgb != null ? rgb : Palette.body(index));
            return new Visual(textured(model, look, index));
        }
        ObjModel mesh = mesh(file, index);
        if (mesh == null) {
            double half = SceneLoader.PLACEHOLDER_HALF;
            return new Visual(Model.placeholder().scale(half * s.x(), half * s.y(), half * s.z()));
        }
        Xyz m = look.meshScale();
        ModelGroup parts =
                mesh.look()
                        .map(part ->
                                textured(
                                                part.color(colour(mesh, part.rgb(), rgb, index)),
                                                look,
                                                index)
                                        .scale(m.x() * s.x(), m.y() * s.y(), m.z() * s.z()));
        return new Visual(parts.parts().size() == 1 ? parts.parts().get(0) : parts);
    }

    private Model textured(Model model, LookSpec look, int index) {
        String texture = look.texture();
        return texture == null
                ? model
                : model.texture(texture(texture, index).tiledEvery(look.tileMetres()));
    }

    /** The entity's colour tints the materials of its file; without materials it is the colour. */
    private static int colour(ObjModel mesh, int own, @Nullable Integer wanted, int index) {
        if (!mesh.hasMaterials()) {
            return wanted != null ? wanted : Palette.body(index);
        }
        if (wanted == null) {
            return own;
        }
        int rgb = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            int product = ((own >> shift) & 255) * ((wanted >> shift) & 255);
            rgb |= ((product + 127) / 255) << shift;
        }
        return rgb;
    }

    /** A file's mesh; null if it is broken, which is told. */
    @Nullable ObjModel mesh(String file, int index) {
        if (!meshes.containsKey(file)) {
            ObjModel mesh = null;
            try {
                mesh =
                        ObjReader.readModel(
                                AssetPath.of(folder, file, AssetPath.MESHES),
                                told -> complain(index, told));
            } catch (IllegalArgumentException broken) {
                complain(index, String.valueOf(broken.getMessage()));
            }
            meshes.put(file, mesh);
        }
        return meshes.get(file);
    }

    private Texture texture(String name, int index) {
        Texture builtIn = LookSpec.builtIn(name);
        if (builtIn != null) {
            return builtIn;
        }
        Texture known = textures.get(name);
        if (known == null) {
            try {
                known = Texture.read(AssetPath.of(folder, name, AssetPath.PICTURES));
            } catch (IllegalArgumentException broken) {
                complain(index, String.valueOf(broken.getMessage()));
                known = Texture.missing();
            }
            textures.put(name, known);
        }
        return known;
    }

    void complain(int index, String message) {
        into.remark(
                "entity %d shows a placeholder: %s"
                        .formatted(index, SceneFileException.shown(message)));
    }

    /** A mesh that was read, and is of no use after all. */
    void refuse(String file, int index, String why) {
        meshes.put(file, null);
        complain(index, file + why);
    }
}
