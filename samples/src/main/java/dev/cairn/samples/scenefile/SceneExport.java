package dev.cairn.samples.scenefile;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ModelGroup;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneView;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.SceneFile.TickSpec;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.FieldShape;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MovedShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.ShapeSpec.SurfaceShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * Turns what a script has built into a scene file: the bodies as they are before the first tick.
 * What a script does from tick to tick (systems, hooks, truths) is code and stays behind, and so do
 * objects that bodies carry; the description says so.
 */
public final class SceneExport {
    /** Ends the description of a scene that a file holds only a part of. */
    public static final String LEFT_OUT =
            "(What the original does from tick to tick is code, and not in this file.)";

    /** Ends the description of a scene whose bodies carry objects of a program. */
    public static final String NO_DATA =
            "(Objects that the original's bodies carry as user data are not in this file.)";

    /** Ends the description of a scene with ground of several materials. */
    public static final String ONE_MATERIAL =
            "(Materials of single triangles are not in this file.)";

    private final Path folder;

    private SceneExport(Path folder) {
        this.folder = folder;
    }

    /**
     * Builds a scene and describes it.
     *
     * @param scene which one
     * @param options values of its parameters
     * @param substeps sub-steps of the solver
     * @param folder what paths in the file become relative to
     * @return the file's contents
     */
    public static SceneFile of(SampleScene scene, SceneOptions options, int substeps, Path folder) {
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .systems(scene.systems(options))
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            Vector3d g = world.gravity(new Vector3d());
            SceneExport export = new SceneExport(folder.toAbsolutePath().normalize());
            List<EntitySpec> entities = new ArrayList<>();
            for (BodyRef body : built.bodies()) {
                entities.add(export.entity(world, body));
            }
            SceneView view = built.view();
            return new SceneFile(
                    scene.title(),
                    description(scene, options, built),
                    new Xyz(g.x, g.y, g.z),
                    new TickSpec(built.stepSeconds(), substeps, scene.ticks(), scene.pictureTick()),
                    new CameraSpec(
                            new Xyz(view.eyeX(), view.eyeY(), view.eyeZ()),
                            new Xyz(view.targetX(), view.targetY(), view.targetZ()),
                            Math.toDegrees(view.fieldOfView())),
                    built.light(),
                    entities,
                    joints(world, built.bodies()),
                    List.of(),
                    null);
        }
    }

    /** What the scene tells of itself, and what of it the file does not hold. */
    private static String description(SampleScene scene, SceneOptions options, SceneBuilder built) {
        boolean acts =
                built.actsBeforeTicks()
                        || scene.systems(options).length > 0
                        || built.world().collisions().hook() != null;
        boolean carries = built.bodies().stream().anyMatch(SceneExport::carriesObjects);
        boolean isPatched =
                built.bodies().stream()
                        .flatMap(body -> body.colliders().stream())
                        .anyMatch(collider -> !collider.description().materials().isEmpty());
        return scene.description()
                + (acts ? " " + LEFT_OUT : "")
                + (carries ? " " + NO_DATA : "")
                + (isPatched ? " " + ONE_MATERIAL : "");
    }

    /** Words and numbers are written; what else a body carries is not. */
    private static boolean carriesObjects(BodyRef body) {
        return (body.userData() != null && written(body.userData()) == null)
                || body.colliders().stream()
                        .map(ColliderRef::userData)
                        .anyMatch(data -> data != null && written(data) == null);
    }

    /** What a file holds of user data: words, and numbers that a double holds; else null. */
    private static @Nullable Object written(@Nullable Object data) {
        if (data instanceof Number number
                && (number instanceof Integer
                        || number instanceof Float
                        || number instanceof Double)
                && Double.isFinite(number.doubleValue())) {
            return number.doubleValue();
        }
        return data instanceof String ? data : null;
    }

    private static List<JointSpec> joints(PhysicsWorld world, List<BodyRef> bodies) {
        List<Long> ids = bodies.stream().map(BodyRef::entity).toList();
        List<JointSpec> joints = new ArrayList<>();
        for (JointRef joint : world.joints().all()) {
            int a = ids.indexOf(joint.entityA());
            int b = ids.indexOf(joint.entityB());
            joints.add(JointSpec.of(joint, a, b, bodies.get(a), bodies.get(b)));
        }
        return joints;
    }

    private EntitySpec entity(PhysicsWorld world, BodyRef body) {
        // The pose as it was given; the body itself keeps its centre of mass, which may round.
        Pose pose = world.ecs().get(body.entity(), Pose.COMPONENT);
        List<ColliderRef> colliders = body.colliders();
        Material material = colliders.get(0).material();
        double stated = body.statedMass();
        EntitySpec entity =
                EntitySpec.of(body.name(), kind(body), shape(colliders.get(0).shape()))
                        .at(
                                new Xyz(pose.x(), pose.y(), pose.z()),
                                new Turn(pose.qx(), pose.qy(), pose.qz(), pose.qw()))
                        .withMaterial(material, Double.isNaN(stated) ? null : (Double) stated)
                        .withPhysics(physics(body, colliders, material))
                        .withLook(look(world, body));
        if (world.ecs().has(body.entity(), CameraMount.COMPONENT)) {
            CameraMount mount = world.ecs().get(body.entity(), CameraMount.COMPONENT);
            entity = entity.withDriven(new EntitySpec.Driven(List.of(), mount));
        }
        if (body.isFixed()) {
            return entity;
        }
        Vector3d v = body.velocity();
        Vector3d w = body.angularVelocity();
        return entity.moving(new Xyz(v.x, v.y, v.z), new Xyz(w.x, w.y, w.z));
    }

    private static BodySpec physics(BodyRef body, List<ColliderRef> colliders, Material material) {
        Filter filter = colliders.get(0).filter();
        List<PartSpec> parts = new ArrayList<>();
        for (ColliderRef collider : colliders) {
            parts.add(part(collider, material, filter));
        }
        boolean isPlain =
                parts.size() == 1 && parts.get(0).equals(PartSpec.of(parts.get(0).shape()));
        Vector3d inertia = body.statedInertia(new Vector3d());
        Vector3d products = body.statedProducts(new Vector3d());
        Vector3d centre = body.statedCentreOfMass(new Vector3d());
        return new BodySpec(
                isPlain ? List.of() : parts,
                filter,
                Double.isNaN(inertia.x) ? null : new Xyz(inertia.x, inertia.y, inertia.z),
                new Xyz(products.x, products.y, products.z),
                Double.isNaN(centre.x) ? null : new Xyz(centre.x, centre.y, centre.z),
                body.gravityScale(),
                body.linearDamping(),
                body.angularDamping(),
                body.speedLimit(),
                List.of(body.locks()),
                body.canSleep(),
                written(body.userData()));
    }

    private static PartSpec part(ColliderRef ref, Material material, Filter filter) {
        Collider collider = ref.description();
        Vector3d at = collider.localPosition(new Vector3d());
        Quaterniond q = collider.localRotation(new Quaterniond());
        Vector3d run = collider.surfaceVelocity(new Vector3d());
        boolean isItsOwn = !run.equals(ref.material().surfaceVelocity(new Vector3d()));
        return new PartSpec(
                shape(collider.shape()),
                new Xyz(at.x, at.y, at.z),
                new Turn(q.x, q.y, q.z, q.w),
                ref.material().equals(material) ? null : ref.material(),
                ref.filter().equals(filter) ? null : ref.filter(),
                ref.isSensor(),
                isItsOwn ? new Xyz(run.x, run.y, run.z) : null,
                written(ref.userData()));
    }

    private static BodyKind kind(BodyRef body) {
        return switch (body.type()) {
            case FIXED -> BodyKind.FIXED;
            case KINEMATIC -> BodyKind.KINEMATIC;
            case DYNAMIC -> BodyKind.DYNAMIC;
        };
    }

    private static ShapeSpec shape(Shape shape) {
        return switch (shape) {
            case Box box -> new BoxShape(new Xyz(box.halfX(), box.halfY(), box.halfZ()));
            case Sphere sphere -> new SphereShape(sphere.radius());
            case ConvexHull hull -> new HullShape(points(hull.vertices()));
            case Capsule c -> new TurnedShape("capsule", c.radius(), c.halfLength());
            case Cylinder c -> new TurnedShape("cylinder", c.radius(), c.halfHeight());
            case Cone c -> new TurnedShape("cone", c.radius(), c.halfHeight());
            case HalfSpace _ -> new GroundShape();
            case TriangleMesh mesh ->
                    new SurfaceShape(
                            points(mesh.vertices()),
                            Arrays.stream(mesh.indices()).boxed().toList(),
                            mesh.isTwoSided());
            case HeightField field -> heights(field);
            case Moved moved -> {
                Vector3d at = moved.position(new Vector3d());
                yield new MovedShape(
                        shape(moved.inner()),
                        new Xyz(at.x, at.y, at.z),
                        new Turn(
                                moved.rotationX(),
                                moved.rotationY(),
                                moved.rotationZ(),
                                moved.rotationW()));
            }
        };
    }

    private static FieldShape heights(HeightField field) {
        List<FieldShape.Cells> holes = new ArrayList<>();
        for (int j = 0; j + 1 < field.samplesZ(); j++) {
            for (int i = 0; i + 1 < field.samplesX(); i++) {
                int first = i;
                while (i + 1 < field.samplesX() && field.isHole(i, j)) {
                    i++;
                }
                if (i > first) {
                    holes.add(new FieldShape.Cells(first, j, i - first, 1));
                }
            }
        }
        return new FieldShape(
                field.samplesX(),
                field.stepX(),
                field.stepZ(),
                field.thickness(),
                Arrays.stream(field.heights()).boxed().toList(),
                holes);
    }

    private static List<Xyz> points(double[] xyz) {
        List<Xyz> points = new ArrayList<>();
        for (int i = 0; i < xyz.length; i += 3) {
            points.add(new Xyz(xyz[i], xyz[i + 1], xyz[i + 2]));
        }
        return points;
    }

    private LookSpec look(PhysicsWorld world, BodyRef body) {
        if (!world.ecs().has(body.entity(), Visual.COMPONENT)) {
            return new LookSpec(false, null, null, 0, null, Xyz.ONE);
        }
        Object drawn = world.ecs().get(body.entity(), Visual.COMPONENT).model();
        if (drawn instanceof ModelGroup group && group.parts().size() == body.colliders().size()) {
            return LookSpec.DEFAULT.withRgb(group.parts().get(0).rgb());
        }
        if (!(drawn instanceof Model model)) {
            return new LookSpec(false, null, null, 0, null, Xyz.ONE);
        }
        Model own = Model.of(body.shape());
        LookSpec look = LookSpec.DEFAULT.withRgb(model.rgb());
        if (!model.texture().equals(own.texture())) {
            String name = LookSpec.nameOf(model.texture());
            look =
                    look.withTexture(
                            name != null ? name : relative(model.texture().name()),
                            model.texture().tileMetres());
        }
        if (!model.mesh().equals(own.mesh())) {
            return new LookSpec(
                    true,
                    look.rgb(),
                    look.texture(),
                    look.tileMetres(),
                    relative(model.mesh().name()),
                    new Xyz(model.scaleX(), model.scaleY(), model.scaleZ()));
        }
        return look;
    }

    private String relative(String file) {
        Path whole = Path.of(file).toAbsolutePath().normalize();
        boolean sameRoot = Objects.equals(whole.getRoot(), folder.getRoot());
        return (sameRoot ? folder.relativize(whole) : whole).toString().replace('\\', '/');
    }
}
