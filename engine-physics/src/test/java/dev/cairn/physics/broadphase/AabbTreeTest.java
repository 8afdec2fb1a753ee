package dev.cairn.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.Random;

class AabbTreeTest {

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void findsWhatBruteForceFindsThroughRandomChanges(long seed) {
        Random random = new Random(seed);
        AabbTree tree = new AabbTree();
        int n = 200;
        double[] boxes = new double[6 * n];
        int[] leaf = new int[n];
        Arrays.fill(leaf, AabbTree.NONE);
        for (int change = 0; change < 3000; change++) {
            int i = random.nextInt(n);
            if (leaf[i] == AabbTree.NONE) {
                randomBox(random, boxes, i);
                leaf[i] = tree.insert(boxes, 6 * i, i);
            } else if (random.nextInt(4) == 0) {
                tree.remove(leaf[i]);
                leaf[i] = AabbTree.NONE;
            } else {
                randomBox(random, boxes, i);
                tree.move(leaf[i], boxes, 6 * i);
            }
            if (change % 50 == 0) {
                tree.validate();
                double[] probe = new double[6];
                randomBox(random, probe, 0);
                int[] found = Leaves.touching(tree, probe, 0);
                Arrays.sort(found);
                int[] expected = bruteForce(boxes, leaf, probe);
                assertArrayEquals(expected, found, "seed " + seed + ", change " + change);
            }
        }
    }

    private static int[] bruteForce(double[] boxes, int[] leaf, double[] probe) {
        int[] found = new int[leaf.length];
        int count = 0;
        for (int i = 0; i < leaf.length; i++) {
            if (leaf[i] != AabbTree.NONE
                    && boxes[6 * i] <= probe[3]
                    && boxes[6 * i + 3] >= probe[0]
                    && boxes[6 * i + 1] <= probe[4]
                    && boxes[6 * i + 4] >= probe[1]
                    && boxes[6 * i + 2] <= probe[5]
                    && boxes[6 * i + 5] >= probe[2]) {
                found[count++] = i;
            }
        }
        return Arrays.copyOf(found, count);
    }

    static void randomBox(Random random, double[] boxes, int i) {
        for (int axis = 0; axis < 3; axis++) {
            double centre = 20 * random.nextDouble();
            double half = 0.1 + 2 * random.nextDouble() * random.nextDouble();
            boxes[6 * i + axis] = centre - half;
            boxes[6 * i + axis + 3] = centre + half;
        }
    }

    @Test
    void staysShallowWhenBoxesComeInARow() {
        AabbTree tree = new AabbTree();
        int n = 4096;
        for (int i = 0; i < n; i++) {
            tree.insert(new double[] {i, 0, 0, i + 0.9, 1, 1}, 0, i);
        }
        tree.validate();
        assertTrue(tree.height() <= 40, "height " + tree.height() + " for " + n + " boxes");
    }

    @Test
    void staysShallowWhenAllBoxesAreTheSame() {
        AabbTree tree = new AabbTree();
        int n = 4096;
        int[] leaf = new int[n];
        double[] box = {0, 0, 0, 1, 1, 1};
        for (int i = 0; i < n; i++) {
            leaf[i] = tree.insert(box, 0, i);
        }
        for (int i = 0; i < n; i++) {
            tree.move(leaf[i], box, 0);
        }
        tree.validate();
        assertTrue(tree.height() <= 40, "height " + tree.height() + " for " + n + " boxes");
    }

    @Test
    void staysShallowWhenBoxesAreNested() {
        AabbTree tree = new AabbTree();
        int n = 1000;
        for (int i = 0; i < n; i++) {
            double half = 1 + i;
            tree.insert(new double[] {-half, -half, -half, half, half, half}, 0, i);
        }
        tree.validate();
        assertTrue(tree.height() <= 200, "height " + tree.height() + " for " + n + " boxes");
    }

    @Test
    void keepsNothingAfterAllIsRemoved() {
        AabbTree tree = new AabbTree();
        int[] leaf = new int[10];
        for (int i = 0; i < 10; i++) {
            leaf[i] = tree.insert(new double[] {i, 0, 0, i + 2, 1, 1}, 0, i);
        }
        for (int i = 0; i < 10; i++) {
            tree.remove(leaf[i]);
            tree.validate();
        }
        assertEquals(0, tree.leafCount());
        assertEquals(0, Leaves.touching(tree, new double[] {-9, -9, -9, 99, 9, 9}, 0).length);
    }
}
