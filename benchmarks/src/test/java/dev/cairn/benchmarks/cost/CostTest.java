package dev.cairn.benchmarks.cost;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.benchmarks.Marked;
import dev.cairn.physics.PhysicsSettings;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** The regression against a line by hand and against known prices; the counts of a known scene. */
class CostTest {
    /** y = 1, 3, 2, 5 over x = 0, 1, 2, 3: slope 1.1, intercept 1.1, residual sum 2.7. */
    @Test
    void straightLineByHand() {
        double[][] x = {{1, 0}, {1, 1}, {1, 2}, {1, 3}};
        LeastSquares fit =
                LeastSquares.fit(x, new double[] {1, 3, 2, 5}, new double[] {1, 1, 1, 1});
        assertEquals(1.1, fit.coefficients()[0], 1e-12);
        assertEquals(1.1, fit.coefficients()[1], 1e-12);
        // s² = 2.7 / 2, Sxx = 5: error of the slope sqrt(0.27), of the intercept sqrt(1.35 x 0.7).
        assertEquals(Math.sqrt(0.27), fit.errors()[1], 1e-12);
        assertEquals(Math.sqrt(1.35 * 0.7), fit.errors()[0], 1e-12);
        assertEquals(1 - 2.7 / 8.75, fit.rSquared(), 1e-12);
    }

    @Test
    void weightZeroIsNotThere() {
        double[][] x = {{1, 0}, {1, 1}, {1, 2}, {1, 5}};
        LeastSquares fit =
                LeastSquares.fit(x, new double[] {1, 2, 3, 99}, new double[] {1, 1, 1, 0});
        assertEquals(1, fit.coefficients()[0], 1e-12);
        assertEquals(1, fit.coefficients()[1], 1e-12);
    }

    @Test
    void findsKnownPricesUnderNoise() {
        SplittableRandom random = new SplittableRandom(3);
        double[] prices = {5, 0.2, 0, 0.7};
        double[][] x = new double[200][4];
        double[] y = new double[200];
        double[] weights = new double[200];
        for (int r = 0; r < y.length; r++) {
            x[r][0] = 1;
            for (int k = 1; k < 4; k++) {
                x[r][k] = random.nextInt(300);
            }
            for (int k = 0; k < 4; k++) {
                y[r] += prices[k] * x[r][k];
            }
            weights[r] = 1 / (y[r] * y[r]);
            y[r] *= 1 + 0.02 * random.nextGaussian();
        }
        LeastSquares fit = LeastSquares.fit(x, y, weights);
        for (int k = 0; k < 4; k++) {
            assertEquals(prices[k], fit.coefficients()[k], 4 * fit.errors()[k], "seed 3, " + k);
            assertTrue(fit.errors()[k] < 1, "error " + fit.errors()[k]);
        }
        assertTrue(fit.rSquared() > 0.98, "R² " + fit.rSquared());
    }

    @Test
    void dependentColumnsAreRefused() {
        double[][] x = {{1, 2}, {2, 4}, {3, 6}};
        double[] ones = {1, 1, 1};
        assertThrows(IllegalArgumentException.class, () -> LeastSquares.fit(x, ones, ones));
    }

    @Test
    void countsAreThoseOfTheScene() {
        Mix mix = new Mix(3, 4, 5, 6, 7, 8, 2, 0, 9, 0.6);
        double[] counts = mix.measure(PhysicsSettings.DEFAULT, new ThreadTime()).counts();
        assertEquals(3 + 2 * 5 + 6 + 7 + 8 + 3 * 2, counts[1]);
        assertEquals(4, counts[2]);
        assertEquals(9, counts[3]);
        assertEquals(5, counts[4]);
        assertEquals(6, counts[5]);
        assertEquals(7 + 8 + 3 * 2, counts[6]);
        assertEquals(6 + 4 * 7 + 2 * 8 + 4 * 3 * 2, counts[7]);
        assertEquals(counts[7], counts[8]);
        assertEquals(0, counts[9]);
    }

    @Test
    void intervalHoldsTheMedian() {
        List<Double> values = new ArrayList<>();
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 101; i++) {
            values.add(1 + 0.01 * random.nextGaussian());
        }
        double[] interval = Ladder.interval(values, new SplittableRandom(1));
        assertTrue(interval[0] <= interval[1] && interval[1] <= interval[2]);
        // 95 % of the median of 101: about 1.96 x 1.2533 x 0.01 / sqrt(101) = 0.0024 to each side.
        assertEquals(2 * 0.0024, interval[2] - interval[0], 0.003);
        assertEquals(2, Ladder.median(new double[] {3, 1, 2}));
        assertEquals(1.5, Ladder.median(new double[] {2, 1}));
    }

    @Test
    void tablesAreReplacedBetweenTheMarks() {
        String text = "a\n<!-- cost: begin -->\nold\n<!-- cost: end -->\nb\n";
        String replaced = new Marked("cost").replaced(text, "new");
        assertTrue(replaced.startsWith("a\n") && replaced.endsWith("b\n"));
        assertTrue(replaced.contains("new") && !replaced.contains("old"));
        assertEquals(replaced, new Marked("cost").replaced(replaced, "new"));
        assertThrows(
                IllegalArgumentException.class, () -> new Marked("cost").replaced("none", "new"));
    }

    @Test
    void aFileThatIsNotThereYetGetsTheTables(@TempDir Path folder) throws IOException {
        String page = new Marked("cost").page(folder.resolve("new.md"));
        assertTrue(new Marked("cost").replaced(page, "new").contains("new"), page);
    }
}
