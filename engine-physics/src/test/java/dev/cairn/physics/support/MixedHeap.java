package dev.cairn.physics.support;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Boxes, balls, capsules and hulls of 0.1 to 1 m and 300 to 3000 kg/m³ that fall into a pit. */
public final class MixedHeap {
    /** Height of the walls over two, m. */
    private static final double WALL = 20;

    private MixedHeap() {}

    private static Shape shape(SplittableRandom random) {
        double size = .15 + .35 * random.nextDouble();
        double a = Scenes.part(size, random);
        double b = Scenes.part(size, random);
        double c = Scenes.part(size, random);
        return switch (random.nextInt(5)) {
            case 0 -> Sphere.of(.7 * size);
            case 1 -> Capsule.of(a, b);
            case 2 -> Box.ofHalfExtents(a, b, a);
            case 3 -> ConvexHull.of(new double[] {a, b, c, -a, b, -c, -a, -b, c, a, -b, -c});
            default -> Box.ofHalfExtents(a, b, c);
        };
    }

    private static void fix(
            PhysicsWorld world, Material material, Shape shape, double x, double y, double z) {
        world.add(Body.fixed().shape(shape).at(x, y, z).material(material));
    }

    /**
     * Drops them.
     *
     * @param side bodies of a layer along x and along z
     * @param layers how many are dropped above each other
     */
    public static List<BodyRef> drop(PhysicsWorld world, long seed, int side, int layers) {
        SplittableRandom random = new SplittableRandom(seed);
        double pit = (7 * side + 6) / 20.0;
        double friction = .2 + .7 * random.nextDouble();
        Material dry = new Material(friction, 0, 1000);
        fix(world, dry, Box.ofHalfExtents(pit + 1, .5, pit + 1), 0, -.5, 0);
        for (int sign = -1; sign <= 1; sign += 2) {
            fix(world, dry, Box.ofHalfExtents(.5, WALL, pit + 1), sign * (pit + .5), WALL, 0);
            fix(world, dry, Box.ofHalfExtents(pit + 1, WALL, .5), 0, WALL, sign * (pit + .5));
        }
        List<BodyRef> bodies = new ArrayList<>();
        for (int i = 0; i < side * side * layers; i++) {
            double density = 300 * Math.pow(10, random.nextDouble());
            double x = .6 * (i % side - (side - 1) * .5) + .2 * (random.nextDouble() - .5);
            double z = .6 * (i / side % side - (side - 1) * .5) + .2 * (random.nextDouble() - .5);
            double y = .6 + .7 * (i / (side * side));
            bodies.add(
                    world.add(
                            Body.dynamic()
                                    .shape(shape(random))
                                    .at(x, y, z)
                                    .rotation(Scenes.turn(random))
                                    .material(new Material(friction, 0, density))));
        }
        return bodies;
    }
}
