package dev.cairn.samples.scenefile;

import dev.cairn.physics.Material;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.collider.Mix;
import dev.cairn.physics.joint.AxisState;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.input.Control;
import dev.cairn.render.input.Key;
import dev.cairn.samples.scenefile.ShapeSpec.As;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.FieldShape;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.MovedShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.ShapeSpec.SurfaceShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Scenes with everything that a file can hold, of sizes that a world can be made of. */
final class RandomScene {
    private static final List<String> LAYERS = List.of("ground", "crate", "ünï");

    private final SplittableRandom random;

    private RandomScene(long seed) {
        random = new SplittableRandom(seed);
    }

    static SceneFile of(long seed) {
        return new RandomScene(seed).scene();
    }

    private SceneFile scene() {
        List<EntitySpec> entities = new ArrayList<>();
        entities.add(
                EntitySpec.of("floor", BodyKind.FIXED, ground()).at(new Xyz(0, -1, 0), Turn.NONE));
        for (int i = random.nextInt(6); i > 0; i--) {
            entities.add(entity("thing " + i));
        }
        List<JointSpec> joints = new ArrayList<>();
        for (int i = entities.size() > 2 ? random.nextInt(3) : 0; i > 0; i--) {
            joints.add(joint(entities));
        }
        return SceneFile.empty("random")
                .withDescription(random.nextBoolean() ? "" : "line\n\"two\" \u2028")
                .withLayers(LAYERS)
                .withEntities(entities)
                .withJoints(joints);
    }

    private ShapeSpec ground() {
        return switch (random.nextInt(4)) {
            case 0 -> new GroundShape();
            case 1 -> {
                List<Double> heights = new ArrayList<>();
                for (int i = 0; i < 12; i++) {
                    heights.add(random.nextDouble());
                }
                yield new FieldShape(
                        4, 2, 2.5, 1, heights, List.of(new FieldShape.Cells(1, 0, 1, 1)));
            }
            case 2 ->
                    new SurfaceShape(
                            List.of(
                                    new Xyz(-9, 0, -9),
                                    new Xyz(9, 0, -9),
                                    new Xyz(9, 0, 9),
                                    new Xyz(-9, 0, 9)),
                            List.of(0, 2, 1, 0, 3, 2),
                            random.nextBoolean());
            default -> new BoxShape(new Xyz(9, 1, 9));
        };
    }

    private ShapeSpec solid() {
        double r = random.nextDouble(0.1, 0.6);
        return switch (random.nextInt(7)) {
            case 0 -> new SphereShape(r);
            case 1 -> new TurnedShape("capsule", r, 0.3);
            case 2 -> new TurnedShape("cylinder", r, 0.3);
            case 3 -> new TurnedShape("cone", r, 0.3);
            case 4 ->
                    new HullShape(
                            List.of(
                                    new Xyz(0, 0, 0),
                                    new Xyz(r, 0, 0),
                                    new Xyz(0, 1, 0),
                                    new Xyz(0, 0, r),
                                    new Xyz(r, 1, r)));
            case 5 -> new MovedShape(new SphereShape(r), new Xyz(0, r, 0), turn());
            default -> new BoxShape(new Xyz(r, 0.2, 0.3));
        };
    }

    private EntitySpec entity(String name) {
        ShapeSpec shape = solid();
        BodyKind kind = BodyKind.values()[random.nextInt(BodyKind.values().length)];
        if (random.nextInt(8) == 0) {
            shape = new MeshShape("tetra.obj", random.nextBoolean() ? As.HULL : As.PARTS, 4, 0.1);
        }
        EntitySpec made =
                EntitySpec.of(name, kind, shape)
                        .at(new Xyz(near(), random.nextDouble(0, 3), near()), turn())
                        .moving(new Xyz(near(), near(), near()), new Xyz(near(), 0, near()))
                        .withMaterial(
                                material(),
                                random.nextBoolean() ? null : (Double) random.nextDouble(1, 99))
                        .withLook(look())
                        .withDriven(driven());
        return random.nextBoolean() || shape instanceof MeshShape
                ? made
                : made.withPhysics(physics(shape));
    }

    private LookSpec look() {
        return new LookSpec(
                random.nextInt(4) > 0,
                random.nextBoolean() ? null : (Integer) random.nextInt(1 << 24),
                random.nextBoolean() ? null : "builtin:metal",
                random.nextBoolean() ? 0 : 2,
                random.nextInt(5) > 0 ? null : "tetra.obj",
                Xyz.ONE);
    }

    private EntitySpec.Driven driven() {
        if (random.nextInt(4) > 0) {
            return EntitySpec.Driven.NONE;
        }
        return new EntitySpec.Driven(
                List.of(Control.of(Key.UP, Control.Effect.PUSH, 0, 0, -9)),
                new CameraMount(0, 2, 5, true));
    }

    private BodySpec physics(ShapeSpec shape) {
        List<PartSpec> parts = new ArrayList<>();
        parts.add(PartSpec.of(shape));
        if (random.nextBoolean()) {
            parts.add(
                    new PartSpec(
                            solid(),
                            new Xyz(near(), near(), 0),
                            turn(),
                            random.nextBoolean() ? null : material(),
                            random.nextBoolean() ? null : new Filter(2, ~4L, -1),
                            random.nextBoolean(),
                            random.nextBoolean() ? null : new Xyz(1, 0, 0),
                            random.nextBoolean() ? null : "door"));
        }
        return new BodySpec(
                random.nextBoolean() ? List.of() : parts,
                new Filter(1, -1, random.nextInt(2)),
                random.nextBoolean() ? null : new Xyz(1, 1.5, 1.5),
                Xyz.ZERO,
                random.nextBoolean() ? null : new Xyz(0, 0.1, 0),
                random.nextInt(3) - 1,
                random.nextDouble(),
                random.nextDouble(),
                random.nextBoolean() ? Double.POSITIVE_INFINITY : 20,
                random.nextInt(4) > 0 ? List.of() : List.of(Lock.MOVE_Z, Lock.TURN_X),
                random.nextBoolean(),
                random.nextBoolean() ? null : (Object) 7.5);
    }

    private JointSpec joint(List<EntitySpec> entities) {
        String kind = JointSpec.KINDS.get(random.nextInt(JointSpec.KINDS.size()));
        int a = random.nextInt(entities.size());
        int b = (a + 1 + random.nextInt(entities.size() - 1)) % entities.size();
        for (int end : new int[] {a, b}) {
            BodyKind now = entities.get(end).body();
            if (end > 0 && now != BodyKind.DYNAMIC) { // a joint holds bodies that can move
                entities.set(end, entities.get(end).withBody(BodyKind.DYNAMIC));
            }
        }
        List<Double> numbers =
                switch (kind) {
                    case "gear" -> List.of(20.0, 30.0);
                    case "pulley" -> List.of(0.0, 5.0, 0.0, 1.0, 5.0, 0.0, 2.0);
                    case "path" -> List.of(0.0, -1.0, 1.0, 0.0, 0.0, 1.5, 0.0, 1.0, 1.0, 0.0);
                    default -> List.of();
                };
        Xyz at = new Xyz(near(), 1, near());
        AxisState free =
                new AxisState(false, true, -1, 1, true, 2, 50, true, 0.1, 2, 0.5, false, 99);
        JointSpec made =
                JointSpec.of(
                        kind,
                        a,
                        b,
                        numbers,
                        new JointSpec.Place(
                                at, at, new Xyz(0, 0, 1), random.nextBoolean() ? null : Xyz.ONE));
        return new JointSpec(
                made.kind(),
                "joint",
                a,
                b,
                numbers,
                made.place(),
                kind.equals("generic")
                        ? List.of(new JointSpec.Axis(JointAxis.TWIST, free))
                        : List.of(),
                0,
                random.nextBoolean(),
                500,
                random.nextBoolean() ? Double.POSITIVE_INFINITY : 500,
                random.nextInt(4) > 0);
    }

    private Material material() {
        return new Material(
                        random.nextDouble(), random.nextDouble(), random.nextDouble(100, 5000), 0)
                .withMix(Mix.AVERAGE, Mix.DEFAULT);
    }

    private Turn turn() {
        return random.nextBoolean()
                ? Turn.NONE
                : Turn.about(new Xyz(near(), 1, near()), random.nextDouble(-180, 180));
    }

    private double near() {
        return random.nextDouble(-2, 2);
    }
}
