package dev.cairn.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** Leaves that come together: searches find what is there, and the tree stays low. */
final class BulkInsertsTest {
    private final AabbTree tree = new AabbTree();
    private final BulkInserts inserts = new BulkInserts(tree);
    private final List<double[]> boxes = new ArrayList<>();
    private final List<Integer> leaves = new ArrayList<>();

    /** Few and many at a time, beside a closed part; some move, and some go in between. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void findsWhatBruteForceFinds(long seed) {
        Random random = new Random(seed);
        ClosedTrees closed = new ClosedTrees(tree);
        for (int round = 0; round < 40; round++) {
            int wanted = random.nextInt(3) == 0 ? 3 * boxes.size() + 20 : random.nextInt(30);
            for (int i = 0; i < wanted && boxes.size() < 3000; i++) {
                double[] box = box(random);
                leaves.add(inserts.add(box, 0, boxes.size()));
                boxes.add(box);
            }
            inserts.run();
            tree.validate();
            if (round == 5) {
                closed.begin();
                for (int i = 0; i < 20; i++) {
                    closed.add(leaves.get(i));
                }
                closed.close();
            }
            for (int i = 20 + random.nextInt(9); i < boxes.size(); i += 9) {
                double[] box = box(random);
                boxes.set(i, box);
                tree.move(leaves.get(i), box, 0);
            }
            double[] probe = box(random);
            int[] found = Leaves.touching(tree, probe, 0);
            Arrays.sort(found);
            assertArrayEquals(touching(probe), found, "seed " + seed + ", round " + round);
        }
        assertEquals(boxes.size(), tree.leafCount());
    }

    /** Sizes and distances that double from box to box, all in one place, and in a line. */
    @Test
    void theTreeStaysLow() {
        for (int i = 0; i < 900; i++) {
            double at = Math.pow(2, i % 300);
            double[] box =
                    i < 300
                            ? new double[] {at, 0, 0, 1.5 * at, 1, 1}
                            : i < 600 ? new double[] {-at, -at, -at, at, at, at} : new double[6];
            inserts.add(box, 0, i);
        }
        inserts.run();
        assertEquals(899, tree.unions(), "one box made for each inner node: built at once");
        tree.validate();
        // each side has a quarter at least: log(900) / log(4/3)
        assertTrue(tree.height() <= 24, () -> "height " + tree.height());
    }

    /** What users do to bodies that have not been in a step yet. */
    @Test
    void bodiesAreMovedAndRemovedBeforeTheyAreLinked() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -10, 0).workers(1).build()) {
            List<BodyRef> floor = new ArrayList<>();
            for (int i = 0; i < 100; i++) {
                floor.add(
                        world.add(Body.fixed().shape(Box.ofHalfExtents(1, 1, 1)).at(2 * i, -1, 0)));
            }
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.5)).at(20, 1, 0));
            BodyRef other = world.add(Body.dynamic().shape(Sphere.of(0.5)).at(40, 1, 0));
            floor.get(10).teleport(20, -2, 0);
            floor.get(10).teleport(20, -1.5, 0);
            floor.get(20).remove();
            for (int tick = 0; tick < 60; tick++) {
                world.step(1.0 / 60);
                world.validate();
            }
            assertEquals(0, ball.position().y, 0.02, "it lies on the box that was lowered");
            assertTrue(other.position().y < -2, "it falls where the box was removed");
        }
    }

    private static double[] box(Random random) {
        double[] box = new double[6];
        double size = Math.pow(10, -2 + 3 * random.nextDouble());
        for (int k = 0; k < 3; k++) {
            // half of them on a grid, so that many centres are equal
            double at = random.nextBoolean() ? random.nextInt(8) : 8 * random.nextDouble();
            box[k] = at - size * random.nextDouble();
            box[k + 3] = at + size * random.nextDouble();
        }
        return box;
    }

    private int[] touching(double[] probe) {
        return IntStream.range(0, boxes.size())
                .filter(i -> AabbTree.overlap(boxes.get(i), 0, probe, 0))
                .toArray();
    }
}
