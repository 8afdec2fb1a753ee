package dev.cairn.benchmarks.compare.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;

/** Depths in a ground of triangles against those in planes, and against a spike. */
class GroundDepthTest {
    private static final int SIDE = 20;
    private static final double SLOPE = 0.5;

    private final PhysicsWorld world =
            PhysicsWorld.builder().settings(PhysicsSettings.DEFAULT.withLanes(1)).build();

    @AfterEach
    void close() {
        world.close();
    }

    /** The ground of some heights, 10 m by 10 m about the origin. */
    private GroundDepth ground(DoubleBinaryOperator height) {
        double[] heights = new double[(SIDE + 1) * (SIDE + 1)];
        double step = 10.0 / SIDE;
        for (int i = 0; i < heights.length; i++) {
            int column = i % (SIDE + 1);
            int row = i / (SIDE + 1);
            heights[i] = height.applyAsDouble(column * step - 5, row * step - 5);
        }
        HeightField field = HeightField.of(SIDE + 1, SIDE + 1, step, step, heights);
        BodyRef body = world.add(Body.fixed().shape(field).at(-5, 0, -5));
        return new GroundDepth(List.of(body));
    }

    /** On a plane y = x / 2 depth is the support along the plane's normal, whatever the pose. */
    @Test
    void isThatInAPlane() {
        GroundDepth slope = ground((x, _) -> SLOPE * x);
        Vector3d normal = new Vector3d(-SLOPE, 1, 0).normalize();
        Shape[] shapes = {
            Sphere.of(0.3),
            Capsule.of(0.2, 0.3),
            Box.ofHalfExtents(0.3, 0.2, 0.4),
            ConvexHull.of(new double[] {0, .4, 0, .3, 0, 0, -.2, -.1, .3, -.2, 0, -.4})
        };
        SplittableRandom random = new SplittableRandom(3);
        for (int trial = 0; trial < 400; trial++) {
            Shape shape = shapes[trial % shapes.length];
            Vector3d at = new Vector3d(random.nextDouble(-2, 2), 0, random.nextDouble(-2, 2));
            at.y = SLOPE * at.x + random.nextDouble(-0.4, 0.7);
            Quaterniond turn =
                    new Quaterniond()
                            .rotateXYZ(
                                    random.nextDouble(6),
                                    random.nextDouble(6),
                                    random.nextDouble(6));
            double lowest = normal.dot(at) - reach(shape, turn, normal);
            assertEquals(
                    Math.max(0, -lowest),
                    slope.depth(shape, at, turn),
                    1e-9,
                    "seed 3, trial " + trial + ", " + shape);
        }
    }

    private static double reach(Shape shape, Quaterniond turn, Vector3d normal) {
        Vector3d n = turn.transformInverse(normal, new Vector3d());
        return switch (shape) {
            case Sphere ball -> ball.radius();
            case Capsule capsule -> capsule.radius() + Math.abs(n.y) * capsule.halfLength();
            case Box box ->
                    Math.abs(n.x) * box.halfX()
                            + Math.abs(n.y) * box.halfY()
                            + Math.abs(n.z) * box.halfZ();
            case ConvexHull hull -> {
                double most = Double.NEGATIVE_INFINITY;
                for (int i = 0; i < hull.vertices().length; i += 3) {
                    most = Math.max(most, -n.dot(new Vector3d().set(hull.vertices(), i)));
                }
                yield most;
            }
            default -> throw new IllegalArgumentException(shape.toString());
        };
    }

    /** A spike that enters a box from below touches none of its corners. */
    @Test
    void seesASpikeInAFace() {
        GroundDepth spike = ground((x, z) -> x == 0 && z == 0 ? 1 : 0);
        Quaterniond level = new Quaterniond();
        Box box = Box.ofHalfExtents(2, 0.3, 2);
        assertEquals(0.07, spike.depth(box, new Vector3d(0, 1.23, 0), level), 1e-12);
        assertEquals(0, spike.depth(box, new Vector3d(0, 1.31, 0), level), 1e-12);
    }

    /** Far below is far too deep; beside the ground there is none. */
    @Test
    void fallingThroughIsNotOverlooked() {
        GroundDepth flat = ground((_, _) -> 0);
        Quaterniond level = new Quaterniond();
        assertEquals(4.3, flat.depth(Sphere.of(0.3), new Vector3d(0, -4, 0), level), 1e-9);
        assertEquals(0, flat.depth(Sphere.of(0.3), new Vector3d(9, -4, 0), level), 0);
        assertEquals(0, new GroundDepth(List.of()).deepest(List.of()), 0);
        Exception untaught =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> flat.depth(Cylinder.of(1, 1), new Vector3d(), level));
        assertTrue(String.valueOf(untaught.getMessage()).contains("Cylinder"));
    }
}
