package dev.cairn.samples.scenefile;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.core.state.StateException;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.DegenerateShapeException;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.decomposition.Decomposer;
import dev.cairn.physics.shape.decomposition.Decomposition;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.input.Control;
import dev.cairn.render.input.Controllable;
import dev.cairn.render.mesh.ObjModel;
import dev.cairn.render.mesh.Texture;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;
import dev.cairn.samples.UsageException;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.ShapeSpec.As;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;

import org.joml.Quaterniond;
import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;

/**
 * Puts a scene file's contents into a world. One thread, the simulation's; one build per object.
 */
public final class SceneLoader {
    /** In place of an entity where a scene's has none in the world. */
    public static final long NOTHING = -1;

    /** Half the edge of the cube that collides and is drawn where a mesh cannot be used, m. */
    static final double PLACEHOLDER_HALF = 0.5;

    private final SceneBuilder into;
    private final Looks looks;
    private final Map<Shared, Shape> shapes;
    private final Map<Shared, Decomposition> solids;

    /** Entities of equal shape and scale share one collision shape, and so one mesh to draw. */
    private record Shared(ShapeSpec shape, Xyz scale) {}

    /**
     * What files held and shapes that were made, for scenes that are built again and again from one
     * folder. A file that changes is noticed by a new one of these only. One thread.
     */
    public static final class Assets {
        private final Map<String, @Nullable ObjModel> meshes = new HashMap<>();
        private final Map<String, @Nullable Texture> textures = new HashMap<>();
        private final Map<Shared, Shape> shapes = new HashMap<>();
        private final Map<Shared, Decomposition> solids = new HashMap<>();

        /** Nothing yet. */
        public Assets() {}

        /** Forgets broken files, so that each build tells of them, and shapes if they are many. */
        private void begin() {
            meshes.values().removeIf(Objects::isNull);
            textures.values().removeIf(Texture.missing()::equals);
            if (shapes.size() > MOST_SHAPES) {
                shapes.clear();
                solids.clear();
            }
        }
    }

    /** Shapes that are kept between builds: a scale that is dragged makes one a frame. */
    private static final int MOST_SHAPES = 4096;

    private SceneLoader(Path folder, SceneBuilder into, Assets assets) {
        this.into = into;
        looks = new Looks(folder, into, assets.meshes, assets.textures);
        shapes = assets.shapes;
        solids = assets.solids;
    }

    /**
     * A scene file as a scene among the others.
     *
     * @param file where it was read, for its id and its relative paths
     * @param scene what is in it
     * @return the scene
     */
    public static SampleScene sample(Path file, SceneFile scene) {
        Path whole = file.toAbsolutePath();
        Path parent = whole.getParent();
        Path folder = parent == null ? whole : parent;
        String name = String.valueOf(whole.getFileName()).replaceAll("\\.json$", "");
        return sample(name, "--scene-file " + file, folder, scene);
    }

    /**
     * A scene as one among the others.
     *
     * @param name from which its id follows
     * @param told how messages name it
     * @param folder what its paths are relative to
     * @param scene what is in it
     * @return the scene
     */
    public static SampleScene sample(String name, String told, Path folder, SceneFile scene) {
        return new SampleScene(
                id(name),
                scene.name().isEmpty() ? name : scene.name(),
                scene.description().isEmpty() ? "A scene file." : scene.description(),
                "files",
                List.of(),
                scene.tick().ticks(),
                scene.tick().pictureTick(),
                builder -> {
                    try {
                        long[] made = new long[scene.entities().size()];
                        build(scene, folder, builder, new Assets(), made);
                        begin(scene, folder, builder, made);
                    } catch (IllegalArgumentException refused) {
                        throw new UsageException(told + ": " + refused.getMessage(), refused);
                    }
                });
    }

    private static String id(String name) {
        String id =
                name.toLowerCase(Locale.ROOT)
                        .replaceAll("[^a-z0-9]+", "-")
                        .replaceAll("^-+|-+$", "");
        return id.isEmpty() ? "scene" : id;
    }

    /**
     * Builds a scene. A mesh or picture that cannot be used is noted as a remark of the builder and
     * replaced by a placeholder.
     *
     * @param scene what to build
     * @param folder what relative paths are relative to
     * @param into an empty builder; its world gets the scene's gravity
     * @throws IllegalArgumentException if the world refuses an entity (a mass whose inverse
     *     overflows); the message names it
     */
    public static void build(SceneFile scene, Path folder, SceneBuilder into) {
        build(scene, folder, into, new Assets(), new long[scene.entities().size()]);
    }

    /**
     * Builds a scene with what earlier builds have read, and tells which entity became which.
     *
     * @param scene what to build
     * @param folder what relative paths are relative to, the same for all builds with these assets
     * @param into an empty builder; its world gets the scene's gravity
     * @param assets what was read
     * @param made receives the world's entity for each of the scene's; {@link #NOTHING} where none
     *     was made: not drawn, and without a part in the physics
     * @throws IllegalArgumentException if the world refuses an entity; those before it are there
     */
    public static void build(
            SceneFile scene, Path folder, SceneBuilder into, Assets assets, long[] made) {
        assets.begin();
        Arrays.fill(made, NOTHING);
        SceneLoader loader = new SceneLoader(folder, into, assets);
        into.world().setGravity(scene.gravity().x(), scene.gravity().y(), scene.gravity().z());
        into.stepSeconds(scene.tick().seconds());
        into.light(scene.light());
        CameraSpec camera = scene.camera();
        into.view(
                new SceneView(
                        camera.eye().x(),
                        camera.eye().y(),
                        camera.eye().z(),
                        camera.target().x(),
                        camera.target().y(),
                        camera.target().z(),
                        Math.toRadians(camera.fieldOfViewDegrees())));
        for (int i = 0; i < scene.entities().size(); i++) {
            EntitySpec entity = scene.entities().get(i);
            try {
                made[i] = loader.add(entity, i);
            } catch (IllegalArgumentException refused) {
                throw new IllegalArgumentException(
                        "$.entities[%d] \"%s\": %s"
                                .formatted(i, entity.name(), refused.getMessage()),
                        refused);
            }
        }
        for (int i = 0; i < scene.joints().size(); i++) {
            JointSpec joint = scene.joints().get(i);
            try {
                join(into.world(), scene, joint, made);
            } catch (IllegalArgumentException refused) {
                throw new IllegalArgumentException(
                        "$.joints[%d] \"%s\": %s".formatted(i, joint.name(), refused.getMessage()),
                        refused);
            }
        }
    }

    /**
     * Puts a scene that was just built to the moment that its {@code state} names, if it names one.
     * What the moment lacks of the scene, and the scene of the moment, is noted as a remark.
     *
     * @param scene what was built
     * @param folder what its path is relative to
     * @param into the builder, at tick 0; it counts on from the tick of the moment
     * @param made the world's entity for each of the scene's
     * @throws IllegalArgumentException if the file is no moment of a scene file, damaged, or
     *     outside; the world is as it was built
     */
    public static void begin(SceneFile scene, Path folder, SceneBuilder into, long[] made) {
        String name = scene.state();
        if (name == null) {
            return;
        }
        try {
            Path path = AssetPath.of(folder, name, AssetPath.MOMENTS);
            RunFile file = RunFile.open(path);
            if (file.sceneText().isEmpty()) {
                throw new IllegalArgumentException(
                        "%s is a moment of %s, expected one of this scene: play it, and press M"
                                .formatted(path, String.join(" ", file.arguments())));
            }
            SceneFile then = SceneReader.parse("the scene in " + path, file.sceneText());
            file.restore(into.world(), into);
            if (!then.entities().equals(scene.entities())
                    || !then.joints().equals(scene.joints())) {
                into.remark(
                        "the scene was edited since %s was saved: it begins as it was then"
                                .formatted(name));
            }
        } catch (IOException unreadable) {
            throw new IllegalArgumentException(
                    "$.state: \"%s\" cannot be read (%s); save a moment there, or leave it out"
                            .formatted(name, unreadable.getClass().getSimpleName()),
                    unreadable);
        } catch (IllegalArgumentException | StateException refused) {
            throw new IllegalArgumentException("$.state: " + refused.getMessage(), refused);
        }
        for (int i = 0; i < made.length; i++) {
            if (made[i] != NOTHING && !into.world().ecs().isAlive(made[i])) {
                into.remark(
                        "$.entities[%d] \"%s\" is not there in %s"
                                .formatted(i, scene.entities().get(i).name(), name));
            }
        }
    }

    private static void join(PhysicsWorld world, SceneFile scene, JointSpec joint, long[] made) {
        for (int entity : new int[] {joint.a(), joint.b()}) {
            if (scene.entities().get(entity).body() == BodyKind.NONE) {
                throw new IllegalArgumentException(
                        "$.entities[%d] is only drawn; a joint holds two bodies".formatted(entity));
            }
        }
        BodyRef a = Objects.requireNonNull(world.bodyOf(made[joint.a()]), "body of a");
        BodyRef b = Objects.requireNonNull(world.bodyOf(made[joint.b()]), "body of b");
        JointRef ref = world.add(joint.joint(a, b));
        if (!joint.isOn()) {
            ref.setEnabled(false);
        }
    }

    private long add(EntitySpec entity, int index) {
        Shape shape = shape(entity.shape(), entity, index);
        List<Collider> parts = parts(entity, index);
        LookSpec look = entity.look();
        Visual visual = null;
        if (look.visible()) {
            visual =
                    entity.physics().parts().isEmpty() || look.mesh() != null
                            ? looks.look(entity, shape, index)
                            : looks.look(parts, look, index);
        }
        Turn turn = entity.rotation();
        Xyz at = entity.position();
        if (entity.body() == BodyKind.NONE) {
            if (visual == null) {
                return NOTHING;
            }
            Quaterniond q = new Quaterniond(turn.x(), turn.y(), turn.z(), turn.w()).normalize();
            return drive(
                    into.addVisual(new Pose(at.x(), at.y(), at.z(), q.x, q.y, q.z, q.w, 0), visual),
                    entity);
        }
        Body start =
                switch (entity.body()) {
                    case FIXED -> Body.fixed();
                    case KINEMATIC -> Body.kinematic();
                    default -> Body.dynamic();
                };
        Body body =
                start.at(at.x(), at.y(), at.z())
                        .rotation(new Quaterniond(turn.x(), turn.y(), turn.z(), turn.w()))
                        .material(entity.material())
                        .name(entity.name());
        Double mass = entity.mass();
        Decomposition solid = solids.get(new Shared(entity.shape(), entity.scale()));
        MassProperties own =
                solid == null ? null : MeshParts.mass(solid, entity.material().density(), mass);
        if (own != null) {
            body.massProperties(own);
        } else if (mass != null) {
            body.mass(mass);
        }
        Xyz v = entity.velocity();
        Xyz w = entity.angularVelocity();
        body.velocity(v.x(), v.y(), v.z()).angularVelocity(w.x(), w.y(), w.z());
        entity.physics().tell(body);
        if (!parts.isEmpty()) {
            parts.forEach(body::collider);
            return drive(into.add(body, visual).entity(), entity);
        }
        Shape collider = shape == null ? placeholderShape(entity) : shape;
        BodyRef made = into.add(body.shape(collider), visual);
        return drive(made.entity(), entity);
    }

    private long drive(long made, EntitySpec entity) {
        List<Control> controls = entity.driven().controls();
        if (!controls.isEmpty()) {
            into.world().ecs().add(made, new Controllable(controls));
        }
        CameraMount camera = entity.driven().camera();
        if (camera != null) {
            into.world().ecs().add(made, camera);
        }
        return made;
    }

    /** The colliders of an entity of several; none if it is of one plain shape. */
    private List<Collider> parts(EntitySpec entity, int index) {
        List<Collider> parts = new ArrayList<>();
        if (entity.body() != BodyKind.NONE
                && entity.shape() instanceof MeshShape mesh
                && mesh.as() == As.PARTS) {
            Decomposition solid = solid(mesh, entity, index);
            return solid == null ? parts : solid.parts().stream().map(Collider::of).toList();
        }
        for (PartSpec part : entity.physics().parts()) {
            Shape shape = shape(part.shape(), entity, index);
            parts.add(
                    part.collider(
                            shape == null ? placeholderShape(entity) : shape, entity.scale().x()));
        }
        return parts;
    }

    private static Shape placeholderShape(EntitySpec entity) {
        Xyz s = entity.scale();
        return Box.ofHalfExtents(
                PLACEHOLDER_HALF * s.x(), PLACEHOLDER_HALF * s.y(), PLACEHOLDER_HALF * s.z());
    }

    /** The collision shape; null if there is none: a broken mesh, or one that is only drawn. */
    private @Nullable Shape shape(ShapeSpec spec, EntitySpec entity, int index) {
        Shared key = new Shared(spec, entity.scale());
        Shape known = shapes.get(key);
        if (known == null) {
            if (!(spec instanceof MeshShape mesh)) {
                known = spec.collider(entity.scale());
            } else if (mesh.as() == As.PARTS) {
                return null; // several, see parts
            } else if (entity.body() != BodyKind.NONE || !entity.physics().parts().isEmpty()) {
                known = fileShape(mesh.file(), mesh.as() == As.LEVEL, entity, index);
            }
            if (known != null) {
                shapes.put(key, known);
            }
        }
        return known;
    }

    private @Nullable Shape fileShape(String file, boolean isLevel, EntitySpec entity, int index) {
        ObjModel mesh = looks.mesh(file, index);
        if (mesh == null) {
            return null;
        }
        double[] points = mesh.mesh().points();
        double[] scale = {entity.scale().x(), entity.scale().y(), entity.scale().z()};
        for (int i = 0; i < points.length; i++) {
            points[i] *= scale[i % 3];
        }
        try {
            return isLevel
                    ? MeshParts.surface(mesh.mesh(), scale[0], scale[1], scale[2])
                    : ConvexHull.of(points);
        } catch (DegenerateShapeException flat) {
            String what = isLevel ? ": no surface: " : ": no convex hull of its points: ";
            looks.refuse(file, index, what + flat.getMessage());
            return null;
        }
    }

    /** The convex parts of a file; null if it is broken, which is told. */
    private @Nullable Decomposition solid(MeshShape spec, EntitySpec entity, int index) {
        Shared key = new Shared(spec, entity.scale());
        Decomposition known = solids.get(key);
        ObjModel mesh = known == null ? looks.mesh(spec.file(), index) : null;
        if (known != null || mesh == null) {
            return known;
        }
        Xyz s = entity.scale();
        try (Jobs jobs = Jobs.of(Jobs.defaultWorkers())) {
            Decomposition made =
                    Decomposer.of(MeshParts.surface(mesh.mesh(), s.x(), s.y(), s.z()))
                            .parts(spec.parts())
                            .error(spec.error())
                            .run(jobs);
            if (!made.isWithinAllowed()) {
                into.remark(
                        "entity %d: %d parts of %s go up to %.3g m beyond it, %.3g were allowed: allow more parts"
                                .formatted(
                                        index,
                                        made.parts().size(),
                                        SceneFileException.shown(spec.file()),
                                        made.beyondAtMost(),
                                        made.allowed()));
            }
            solids.put(key, made);
            return made;
        } catch (DegenerateShapeException flat) {
            looks.refuse(spec.file(), index, ": no solid: " + flat.getMessage());
            return null;
        }
    }
}
