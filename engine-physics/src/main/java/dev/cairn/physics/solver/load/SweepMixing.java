package dev.cairn.physics.solver.load;

/**
 * Anderson's mixing for the sweeps over one island, see {@link StaticStart}.
 *
 * <p>Problem: a sweep hands a load on from contact to contact, and leaves a constant share of the
 * error, so that ten boxes on each other take thousands of them for 1e-12. The error has some few
 * directions that die so slowly, and the sweeps that were made tell which.
 *
 * <p>Let a sweep lead from x to g(x), and f = g(x) - x. With the differences {@code dg, df} between
 * neighbouring ones of the last sweeps, the next sweep starts from
 *
 * <pre>  x' = g - sum s_k dg_k,   with the s that make |f - sum s_k df_k| least,</pre>
 *
 * which would be the end if f were linear (GMRES in disguise). The numbers are all impulses of the
 * island and the velocities of its bodies, which are linear in impulses, so both stay in step. What
 * counts as the answer is still a sweep that changes nothing.
 *
 * <p>Source: D. G. Anderson, "Iterative procedures for nonlinear integral equations", Journal of
 * the ACM 12 (1965); H. F. Walker, P. Ni, "Anderson acceleration for fixed-point iterations", SIAM
 * J. Numer. Anal. 49 (2011).
 */
final class SweepMixing extends SweepLeaps {
    /**
     * Share of the square of a difference that is not along others, below which it tells nothing.
     */
    private static final double ALIKE = 1e-10;

    /**
     * Square of a leap over that of the last sweep's change, at most. What is left at the end is
     * rounding, and tells of leaps of any length where several points share a load.
     */
    private static final double FARTHEST = 1e6;

    private double[] change = {}, lastAfter = {}, lastChange = {};
    private final double[][] afters;
    private final double[][] changes;

    /** Products of differences: of k and l at {@code memory k + l}. */
    private final double[] product;

    private final double[] factor;
    private final double[] share;

    /** Differences that are remembered, at most. */
    private final int memory;

    /** Differences that are known, and where the newest is. */
    private int known, newest;

    private boolean isFirst;

    /**
     * For islands of one world.
     *
     * @param memory differences that are remembered, at most
     */
    SweepMixing(int memory) {
        this.memory = memory;
        afters = new double[memory][];
        changes = new double[memory][0];
        product = new double[memory * memory];
        factor = new double[memory * memory];
        share = new double[memory];
    }

    @Override
    void begin(int rowCount, int bodyCount) {
        super.begin(rowCount, bodyCount);
        known = 0;
        newest = 0;
        isFirst = true;
        if (change.length < before.length) {
            change = new double[before.length];
            lastAfter = new double[before.length];
            lastChange = new double[before.length];
            for (int k = 0; k < memory; k++) {
                afters[k] = new double[before.length];
            }
        }
        for (int k = 0; k < memory && changes[k].length < COUNTED * rowCount; k++) {
            changes[k] = new double[COUNTED * rowCount];
        }
    }

    @Override
    void leap(double largest) {
        int size = size();
        int counted = COUNTED * rows;
        for (int i = 0; i < size; i++) {
            change[i] = after[i] - before[i];
        }
        if (!isFirst) {
            remember(size, counted);
        }
        System.arraycopy(after, 0, lastAfter, 0, size);
        System.arraycopy(change, 0, lastChange, 0, size);
        isFirst = false;
        System.arraycopy(after, 0, before, 0, size);
        int used = solve(counted);
        for (int k = 0; k < used; k++) {
            double[] difference = afters[at(k)];
            double s = share[k];
            for (int i = 0; i < size; i++) {
                before[i] -= s * difference[i];
            }
        }
        shorten(size, counted);
    }

    /** The place of the difference that is so many sweeps older than the newest. */
    private int at(int age) {
        return (newest - age + memory) % memory;
    }

    private void remember(int size, int counted) {
        newest = (newest + 1) % memory;
        known = Math.min(memory, known + 1);
        double[] a = afters[newest];
        double[] c = changes[newest];
        for (int i = 0; i < size; i++) {
            a[i] = after[i] - lastAfter[i];
        }
        for (int i = 0; i < counted; i++) {
            c[i] = change[i] - lastChange[i];
        }
        for (int k = 0; k < known; k++) {
            int other = at(k);
            double p = dot(c, changes[other], counted);
            product[memory * newest + other] = p;
            product[memory * other + newest] = p;
        }
    }

    /**
     * Solves for the shares by Cholesky's factors of the products, the newest difference first; the
     * first that hardly differs from those before ends it, with all that are older.
     *
     * @return how many shares there are
     */
    private int solve(int counted) {
        int n = 0;
        for (int k = 0; k < known; k++) {
            double square = product[memory * at(k) + at(k)];
            double rest = square;
            for (int l = 0; l < k; l++) {
                double sum = product[memory * at(k) + at(l)];
                for (int i = 0; i < l; i++) {
                    sum -= factor[memory * k + i] * factor[memory * l + i];
                }
                double f = sum / factor[memory * l + l];
                factor[memory * k + l] = f;
                rest -= f * f;
            }
            if (!(rest > ALIKE * square)) {
                break;
            }
            factor[memory * k + k] = Math.sqrt(rest);
            double sum = dot(changes[at(k)], change, counted);
            for (int l = 0; l < k; l++) {
                sum -= factor[memory * k + l] * share[l];
            }
            share[k] = sum / factor[memory * k + k];
            n++;
        }
        for (int k = n - 1; k >= 0; k--) {
            double sum = share[k];
            for (int l = k + 1; l < n; l++) {
                sum -= factor[memory * l + k] * share[l];
            }
            share[k] = sum / factor[memory * k + k];
        }
        return n;
    }

    /** No normal impulse may become negative, nor may a leap be too long. */
    private void shorten(int size, int counted) {
        double most = 1;
        double square = 0;
        for (int i = 0; i < counted; i++) {
            double leap = before[i] - after[i];
            square += leap * leap;
            if (before[i] < 0 && isNormal(i)) {
                most = Math.min(most, after[i] / -leap);
            }
        }
        double farthest = FARTHEST * dot(change, change, counted);
        if (square > farthest) {
            most = Math.min(most, Math.sqrt(farthest / square));
        }
        if (most < 1) {
            for (int i = 0; i < size; i++) {
                before[i] = after[i] + most * (before[i] - after[i]);
            }
        }
    }

    /** In four sums, since each addition waits for the one before. */
    private static double dot(double[] x, double[] y, int n) {
        double a = 0;
        double b = 0;
        double c = 0;
        double d = 0;
        int i = 0;
        for (; i + 3 < n; i += 4) {
            a += x[i] * y[i];
            b += x[i + 1] * y[i + 1];
            c += x[i + 2] * y[i + 2];
            d += x[i + 3] * y[i + 3];
        }
        for (; i < n; i++) {
            a += x[i] * y[i];
        }
        return a + b + (c + d);
    }
}
