package dev.cairn.physics.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.HashMap;
import java.util.Map;

/** A floor of triangles is a floor: what slides or rolls over it does as on a slab. */
class FloorOfTrianglesTest {
    private static final double HALF = 8;
    private static final Map<String, Path> SLABS = new HashMap<>();

    /** The floors. */
    enum Ground {
        REGULAR,
        IRREGULAR,
        SLIVERS,
        T_JOINTS,
        HEIGHTS,
        COARSE_HEIGHTS;

        Shape shape() {
            return switch (this) {
                case REGULAR -> Grounds.regular(HALF, 40);
                case IRREGULAR -> Grounds.irregular(HALF, 40, 7);
                case SLIVERS -> Grounds.slivers(HALF);
                case T_JOINTS -> Grounds.tJoints(HALF, 30);
                case HEIGHTS -> heights(41);
                case COARSE_HEIGHTS -> heights(4);
            };
        }
    }

    private static Shape heights(int samples) {
        double step = 2 * HALF / (samples - 1);
        double[] zero = new double[samples * samples];
        return atItsCorner(HeightField.of(samples, samples, step, step, zero));
    }

    private static Shape atItsCorner(Shape shape) {
        return shape.moved(-HALF, 0, -HALF, new Quaterniond());
    }

    /**
     * A slab of two triangles whose frame begins at a corner, as that of heights does. Where the
     * frame of a ground is decides last bits of single precision, of a box too: 2e-6 m here.
     */
    private static Shape slabAtItsCorner() {
        double w = 2 * HALF;
        double[] corners = {0, 0, 0, 0, 0, w, w, 0, w, w, 0, 0};
        return atItsCorner(TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3}));
    }

    /** What moves over them: a shape, how it lies, how high its origin is. */
    private record Mover(
            String name, Shape shape, Quaterniond turn, double height, boolean rolls) {}

    private static Mover[] movers() {
        Quaterniond no = new Quaterniond();
        Quaterniond down = new Quaterniond().rotateX(Math.PI / 2);
        return new Mover[] {
            new Mover("ball", Sphere.of(.25), no, .25, true),
            new Mover("box", Box.ofHalfExtents(.3, .2, .4), no, .2, false),
            new Mover(
                    "turned box",
                    Box.ofHalfExtents(.3, .2, .4),
                    new Quaterniond().rotateY(.3),
                    .2,
                    false),
            new Mover("capsule", Capsule.of(.2, .4), down, .2, true),
            new Mover("cylinder", Cylinder.of(.3, .2), no, .2, false),
            new Mover("roller", Cylinder.of(.3, .2), down, .3, true),
            new Mover("cone", Cone.of(.3, .2), no, .2, false),
            new Mover(
                    "hull",
                    ConvexHull.of(
                            new double[] {
                                -.3, 0, -.2, .3, 0, -.2, .35, 0, .3, -.2, 0, .3, 0, .4, 0
                            }),
                    no,
                    0,
                    false),
        };
    }

    private record Path(Vector3d end, Vector3d velocity, double mostUp) {}

    private static Path run(Mover mover, Shape mesh, int workers, int lanes) {
        Material material = new Material(.2, 0, 500);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                        .sleeping(false)
                        .workers(workers)
                        .build()) {
            world.add(
                    mesh == null
                            ? Body.fixed()
                                    .shape(Box.ofHalfExtents(HALF, 1, HALF))
                                    .at(0, -1, 0)
                                    .material(material)
                            : Body.fixed().shape(mesh).material(material));
            Body body =
                    Body.dynamic()
                            .shape(mover.shape)
                            .rotation(mover.turn)
                            .material(material)
                            .at(-3.1234, mover.height, .271)
                            .velocity(3, 0, .1);
            if (mover.rolls) {
                boolean isBall = mover.shape instanceof Sphere;
                body.angularVelocity(isBall ? .1 / mover.height : 0, 0, -3 / mover.height);
            }
            BodyRef ref = world.add(body);
            double most = 0;
            for (int tick = 0; tick < 90; tick++) {
                world.step(1 / 60.0);
                if (tick % 30 == 0) {
                    world.validate();
                }
                most = Math.max(most, Math.abs(ref.velocity(new Vector3d()).y));
            }
            return new Path(ref.position(new Vector3d()), ref.velocity(new Vector3d()), most);
        }
    }

    @ParameterizedTest
    @EnumSource(Ground.class)
    void whatSlidesAndRollsGoesAsOnASlab(Ground ground) {
        Shape mesh = ground.shape();
        for (Mover mover : movers()) {
            boolean atCorner = mesh instanceof Moved;
            Path slab =
                    SLABS.computeIfAbsent(
                            mover.name + atCorner,
                            name -> run(mover, atCorner ? slabAtItsCorner() : null, 1, 4));
            Path floor = run(mover, mesh, 1, 4);
            String what = mover.name + " over " + ground;
            assertTrue(floor.mostUp <= slab.mostUp + 1e-6, what);
            assertEquals(0, floor.end.distance(slab.end), 1e-6, what);
            assertEquals(0, floor.velocity.distance(slab.velocity), 1e-6, what);
        }
    }
}
