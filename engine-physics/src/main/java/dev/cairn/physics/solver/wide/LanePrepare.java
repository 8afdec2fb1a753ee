package dev.cairn.physics.solver.wide;

import static dev.cairn.physics.solver.row.ConstraintRows.*;
import static dev.cairn.physics.solver.wide.LaneStaging.*;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.kernel.RowFiller;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RowPrefetch;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;

/**
 * Fills constraint rows with one row to a lane: the arithmetic of {@link PrepareRow}, operation by
 * operation. Contacts and bodies are copied to a {@link LaneStaging} area first, a group at a time.
 * Made once for each number of lanes, like {@link LaneSweep}; kernels work from array to array for
 * the same reason.
 */
final class LanePrepare implements RowFiller {
    private static final VectorSpecies<Double> S = LaneSpecies.doubles(MethodHandles.lookup());
    private static final int L = S.length();

    @Override
    public void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        double[] st = scratch.doubles;
        double scale = sub.fillScale;
        double[] d = rows.doubles;
        for (int j = from; j < to; j += L) {
            int o = START + j * FIELDS;
            if (j + L < to) {
                st[TOUCHED * L] = /*(float)*/
                        (RowPrefetch.contacts(rows, contacts, j + L, j + 2 * L)
                                + RowPrefetch.rows(rows, j + L, j + 2 * L));
            }
            int n = 0;
            boolean hasFriction = false;
            for (int l = 0; l < L; l++) {
                int count = rows.link[(j + l) * LINK + COUNT];
                if (count == 0) {
                    LaneStaging.pad(st, l, L);
                    continue;
                }
                int source = rows.link[(j + l) * LINK + SOURCE];
                n = Math.max(n, count);
                hasFriction |= contacts.friction(source) > 0;
                LaneStaging.stage(rows, bodies, contacts, sub, j + l, source, st, l, L);
            }
            n = n == 3 ? 4 : n; // the kernels sweep one, two or four points
            rows.points[j / L] = n;
            rows.hasFriction[j / L] = hasFriction;
            basis(d, o, st);
            points(d, o, st, n, scale);
            if (hasFriction) {
                centre(d, o, st, n);
                block(d, o, st);
                warm(d, o, st, scale);
            } else {
                clear(d, o, REACH, REACH + 4);
                clear(d, o, BLOCK, TOTAL + 3);
            }
            LaneStaging.scatter(rows, bodies, j, st, L);
        }
    }

    private static void clear(double[] d, int o, int field, int end) {
        for (int f = field; f < end; f++) {
            DoubleVector.zero(S).intoArray(d, o + f * L);
        }
    }

    /** Normal, masses, friction and tangents, see {@link PrepareRow}. */
    private static void basis(double[] d, int o, double[] st) {
        var nx = DoubleVector.fromArray(S, st, 0);
        var ny = DoubleVector.fromArray(S, st, L);
        var nz = DoubleVector.fromArray(S, st, 2 * L);
        nx.intoArray(d, o);
        ny.intoArray(d, o + L);
        nz.intoArray(d, o + 2 * L);
        DoubleVector.fromArray(S, st, INVERSE_A * L).intoArray(d, o + MASS_A * L);
        DoubleVector.fromArray(S, st, INVERSE_B * L).intoArray(d, o + MASS_B * L);
        DoubleVector.fromArray(S, st, MU * L).intoArray(d, o + FRICTION * L);
        var ax = nx.abs();
        var ay = ny.abs();
        var az = nz.abs();
        var first = ax.compare(VectorOperators.LE, ay).and(ax.compare(VectorOperators.LE, az));
        var second = az.compare(VectorOperators.LE, ay);
        var x = nz.neg().blend(ny, second).blend(0.0, first);
        var y = DoubleVector.zero(S).blend(nx.neg(), second).blend(nz, first);
        var z = nx.blend(0.0, second).blend(ny.neg(), first);
        var k = x.mul(x).add(y.mul(y)).add(z.mul(z)).sqrt();
        k = DoubleVector.broadcast(S, 1.0).div(k);
        x = x.mul(k);
        y = y.mul(k);
        z = z.mul(k);
        x.intoArray(d, o + TANGENT1 * L);
        y.intoArray(d, o + (TANGENT1 + 1) * L);
        z.intoArray(d, o + (TANGENT1 + 2) * L);
        ny.mul(z).sub(nz.mul(y)).intoArray(d, o + TANGENT2 * L);
        nz.mul(x).sub(nx.mul(z)).intoArray(d, o + (TANGENT2 + 1) * L);
        nx.mul(y).sub(ny.mul(x)).intoArray(d, o + (TANGENT2 + 2) * L);
    }

    /** Writes {@code L^T (r x u)}; root and r are staged, u is at {@code d[u]}. */
    private static void arm(double[] st, int root, int r, double[] d, int u, int out) {
        var rx = DoubleVector.fromArray(S, st, r);
        var ry = DoubleVector.fromArray(S, st, r + L);
        var rz = DoubleVector.fromArray(S, st, r + 2 * L);
        var ux = DoubleVector.fromArray(S, d, u);
        var uy = DoubleVector.fromArray(S, d, u + L);
        var uz = DoubleVector.fromArray(S, d, u + 2 * L);
        var x = ry.mul(uz).sub(rz.mul(uy));
        var y = rz.mul(ux).sub(rx.mul(uz));
        var z = rx.mul(uy).sub(ry.mul(ux));
        for (int k = 0; k < 3; k++) {
            int i = (root + k) * L;
            DoubleVector.fromArray(S, st, i)
                    .mul(x)
                    .add(DoubleVector.fromArray(S, st, i + 3 * L).mul(y))
                    .add(DoubleVector.fromArray(S, st, i + 6 * L).mul(z))
                    .intoArray(d, out + k * L);
        }
    }

    /** Writes {@code L^T n}. */
    private static void weighted(double[] st, int root, double[] d, int o, int out) {
        var x = DoubleVector.fromArray(S, d, o);
        var y = DoubleVector.fromArray(S, d, o + L);
        var z = DoubleVector.fromArray(S, d, o + 2 * L);
        for (int k = 0; k < 3; k++) {
            int i = (root + k) * L;
            DoubleVector.fromArray(S, st, i)
                    .mul(x)
                    .add(DoubleVector.fromArray(S, st, i + 3 * L).mul(y))
                    .add(DoubleVector.fromArray(S, st, i + 6 * L).mul(z))
                    .intoArray(d, out + k * L);
        }
    }

    private static void points(double[] d, int o, double[] st, int n, double scale) {
        var sum = DoubleVector.zero(S);
        for (int i = 0; i < n; i++) {
            int r = (STAGED + i * STAGED_FIELDS) * L;
            int q = o + (POINT + i * POINT_FIELDS) * L;
            arm(st, ROOT_A, r, d, o, q + ARM_A * L);
            arm(st, ROOT_B, r + 3 * L, d, o, q + ARM_B * L);
            var ux = DoubleVector.fromArray(S, d, q + ARM_A * L);
            var uy = DoubleVector.fromArray(S, d, q + (ARM_A + 1) * L);
            var uz = DoubleVector.fromArray(S, d, q + (ARM_A + 2) * L);
            var wx = DoubleVector.fromArray(S, d, q + ARM_B * L);
            var wy = DoubleVector.fromArray(S, d, q + (ARM_B + 1) * L);
            var wz = DoubleVector.fromArray(S, d, q + (ARM_B + 2) * L);
            var square =
                    ux.mul(ux)
                            .add(uy.mul(uy))
                            .add(uz.mul(uz))
                            .add(wx.mul(wx).add(wy.mul(wy)).add(wz.mul(wz)));
            var w =
                    DoubleVector.fromArray(S, st, INVERSE_A * L)
                            .add(DoubleVector.fromArray(S, st, INVERSE_B * L))
                            .add(square);
            var there =
                    DoubleVector.fromArray(S, st, POINTS * L)
                            .compare(VectorOperators.GT, (double) i)
                            .and(w.compare(VectorOperators.GT, 0.0));
            var mass = DoubleVector.zero(S).blend(DoubleVector.broadcast(S, 1.0).div(w), there);
            mass.intoArray(d, q + MASS * L);
            var k = mass.mul(DoubleVector.fromArray(S, st, STIFFNESS * L));
            var known = DoubleVector.fromArray(S, st, r + 8 * L).mul(scale);
            var offset =
                    DoubleVector.zero(S).blend(known.div(k), k.compare(VectorOperators.GT, 0.0));
            var gap = DoubleVector.fromArray(S, st, r + 6 * L).sub(offset);
            gap.intoArray(d, o + (GAP + i) * L);
            gap.intoArray(d, q + SEPARATION * L);
            var impulse = DoubleVector.fromArray(S, st, r + 7 * L).mul(scale);
            impulse.intoArray(d, q + IMPULSE * L);
            DoubleVector.zero(S).intoArray(d, o + (SUM + i) * L);
            turn(st, d, q + IMPULSE * L, q + ARM_A * L, q + ARM_B * L);
            sum = sum.add(impulse);
        }
        sum.intoArray(st, SUMMED * L);
        push(st, st, SUMMED * L, d, o);
    }

    /** Linear part of the impulse at {@code f[i]} along the direction at {@code d[u]}. */
    private static void push(double[] st, double[] f, int i, double[] d, int u) {
        var impulse = DoubleVector.fromArray(S, f, i);
        var ka = DoubleVector.fromArray(S, st, INVERSE_A * L).mul(impulse);
        var kb = DoubleVector.fromArray(S, st, INVERSE_B * L).mul(impulse);
        for (int k = 0; k < 3; k++) {
            var n = DoubleVector.fromArray(S, d, u + k * L);
            int a = (WARM_A + k) * L;
            int b = (WARM_B + k) * L;
            DoubleVector.fromArray(S, st, a).sub(ka.mul(n)).intoArray(st, a);
            DoubleVector.fromArray(S, st, b).add(kb.mul(n)).intoArray(st, b);
        }
    }

    /** Angular part of the impulse at {@code d[i]} with weighted arms at {@code ia}, {@code ib}. */
    private static void turn(double[] st, double[] d, int i, int ia, int ib) {
        var impulse = DoubleVector.fromArray(S, d, i);
        for (int k = 0; k < 3; k++) {
            int a = (WARM_A + 3 + k) * L;
            int b = (WARM_B + 3 + k) * L;
            DoubleVector.fromArray(S, st, a)
                    .sub(impulse.mul(DoubleVector.fromArray(S, d, ia + k * L)))
                    .intoArray(st, a);
            DoubleVector.fromArray(S, st, b)
                    .add(impulse.mul(DoubleVector.fromArray(S, d, ib + k * L)))
                    .intoArray(st, b);
        }
    }

    /** The patch's centre and how far its points are from it, see {@link PrepareRow}. */
    private static void centre(double[] d, int o, double[] st, int n) {
        int r = STAGED * L;
        var x0 = DoubleVector.fromArray(S, st, r);
        var y0 = DoubleVector.fromArray(S, st, r + L);
        var z0 = DoubleVector.fromArray(S, st, r + 2 * L);
        var spread = DoubleVector.zero(S);
        var count = DoubleVector.fromArray(S, st, POINTS * L);
        var least = DoubleVector.fromArray(S, st, r + 6 * L);
        for (int i = 1; i < n; i++) {
            int p = r + i * STAGED_FIELDS * L;
            var x = DoubleVector.fromArray(S, st, p).sub(x0);
            var y = DoubleVector.fromArray(S, st, p + L).sub(y0);
            var z = DoubleVector.fromArray(S, st, p + 2 * L).sub(z0);
            spread = spread.max(x.mul(x).add(y.mul(y)).add(z.mul(z)));
            var gap = DoubleVector.fromArray(S, st, p + 6 * L);
            least = least.min(gap.blend(least, count.compare(VectorOperators.LE, (double) i)));
        }
        var fixed = DoubleVector.fromArray(S, st, FIXED * L);
        var guided = fixed.compare(VectorOperators.GT, 1.0);
        var nearest = DoubleVector.zero(S).blend(least.max(0.0), guided);
        var fade = spread.sqrt().mul(PrepareRow.FADE);
        var none = fade.compare(VectorOperators.EQ, 0.0);
        var stands = fixed.compare(VectorOperators.GT, 0.0);
        var sum = DoubleVector.zero(S);
        var shift = DoubleVector.zero(S);
        for (int i = 0; i < n; i++) {
            var gap = DoubleVector.fromArray(S, st, r + (i * STAGED_FIELDS + 6) * L);
            var behind = gap.sub(nearest);
            var w =
                    DoubleVector.broadcast(S, 2.0)
                            .sub(behind.div(fade))
                            .max(1e-10)
                            .blend(1.0, behind.compare(VectorOperators.LE, fade).or(none));
            w = DoubleVector.zero(S).blend(w, count.compare(VectorOperators.GT, (double) i));
            w.intoArray(st, (WEIGHT + i) * L);
            sum = sum.add(w);
            shift = shift.add(w.mul(DoubleVector.zero(S).blend(gap, stands).mul(0.5)));
        }
        var k =
                DoubleVector.broadcast(S, 1.0)
                        .div(sum.blend(1.0, sum.compare(VectorOperators.EQ, 0.0)));
        shift = shift.mul(k);
        for (int f = 0; f < 6; f++) {
            var mean = DoubleVector.zero(S);
            for (int i = 0; i < n; i++) {
                mean =
                        mean.add(
                                DoubleVector.fromArray(S, st, (WEIGHT + i) * L)
                                        .mul(
                                                DoubleVector.fromArray(
                                                        S, st, r + (i * STAGED_FIELDS + f) * L)));
            }
            mean.mul(k).intoArray(st, (CENTRE + f) * L);
        }
        reach(d, o, st, n);
        for (int f = 0; f < 6; f++) {
            var aside = shift.mul(DoubleVector.fromArray(S, d, o + f % 3 * L));
            var mean = DoubleVector.fromArray(S, st, (CENTRE + f) * L);
            mean = f < 3 ? mean.sub(aside) : mean.add(aside);
            mean.intoArray(st, (CENTRE + f) * L);
        }
    }

    private static void reach(double[] d, int o, double[] st, int n) {
        var ax = DoubleVector.fromArray(S, st, CENTRE * L);
        var ay = DoubleVector.fromArray(S, st, (CENTRE + 1) * L);
        var az = DoubleVector.fromArray(S, st, (CENTRE + 2) * L);
        var count = DoubleVector.fromArray(S, st, POINTS * L);
        for (int i = 0; i < n; i++) {
            int p = (STAGED + i * STAGED_FIELDS) * L;
            var x = DoubleVector.fromArray(S, st, p).sub(ax);
            var y = DoubleVector.fromArray(S, st, p + L).sub(ay);
            var z = DoubleVector.fromArray(S, st, p + 2 * L).sub(az);
            var far =
                    x.mul(x)
                            .add(y.mul(y))
                            .add(z.mul(z))
                            .sqrt()
                            .mul(DoubleVector.fromArray(S, st, SHARE * L));
            DoubleVector.zero(S)
                    .blend(far, count.compare(VectorOperators.GT, (double) i))
                    .intoArray(d, o + (REACH + i) * L);
        }
    }

    /** Levers, tangent block and twist at the patch's centre. */
    private static void block(double[] d, int o, double[] st) {
        int v = o + LEVER * L;
        int t = o + TWIST * L;
        arm(st, ROOT_A, CENTRE * L, d, o + TANGENT1 * L, v);
        arm(st, ROOT_A, CENTRE * L, d, o + TANGENT2 * L, v + 3 * L);
        arm(st, ROOT_B, (CENTRE + 3) * L, d, o + TANGENT1 * L, v + 6 * L);
        arm(st, ROOT_B, (CENTRE + 3) * L, d, o + TANGENT2 * L, v + 9 * L);
        weighted(st, ROOT_A, d, o, t);
        weighted(st, ROOT_B, d, o, t + 3 * L);
        dot(d, v, v, v + 6 * L, v + 6 * L, st, DOTS * L);
        dot(d, v + 3 * L, v + 3 * L, v + 9 * L, v + 9 * L, st, (DOTS + 1) * L);
        dot(d, v, v + 3 * L, v + 6 * L, v + 9 * L, st, (DOTS + 2) * L);
        dot(d, t, t, t + 3 * L, t + 3 * L, st, (DOTS + 3) * L);
        var hasFriction = DoubleVector.fromArray(S, st, MU * L).compare(VectorOperators.GT, 0.0);
        var k12 =
                DoubleVector.fromArray(S, st, (DOTS + 2) * L)
                        .add(DoubleVector.fromArray(S, st, (DOTS + 6) * L));
        var sum =
                DoubleVector.fromArray(S, st, INVERSE_A * L)
                        .add(DoubleVector.fromArray(S, st, INVERSE_B * L));
        var k11 =
                sum.add(DoubleVector.fromArray(S, st, DOTS * L))
                        .add(DoubleVector.fromArray(S, st, (DOTS + 4) * L));
        var k22 =
                sum.add(DoubleVector.fromArray(S, st, (DOTS + 1) * L))
                        .add(DoubleVector.fromArray(S, st, (DOTS + 5) * L));
        var zero = DoubleVector.zero(S);
        var one = DoubleVector.broadcast(S, 1.0);
        var det = one.div(k11.mul(k22).sub(k12.mul(k12)));
        int k = o + BLOCK * L;
        zero.blend(k22.mul(det), hasFriction).intoArray(d, k);
        zero.blend(k12.neg().mul(det), hasFriction).intoArray(d, k + L);
        zero.blend(k11.mul(det), hasFriction).intoArray(d, k + 2 * L);
        var twist =
                DoubleVector.fromArray(S, st, (DOTS + 3) * L)
                        .add(DoubleVector.fromArray(S, st, (DOTS + 7) * L));
        var turns =
                twist.compare(VectorOperators.GT, 0.0)
                        .and(hasFriction)
                        .and(
                                DoubleVector.fromArray(S, st, POINTS * L)
                                        .compare(VectorOperators.GT, 1.0));
        zero.blend(one.div(twist), turns).intoArray(d, o + TWIST_MASS * L);
    }

    /** Writes the dot product of A's arms at i and j, and four fields on that of B's. */
    private static void dot(double[] d, int i, int j, int ib, int jb, double[] st, int out) {
        DoubleVector.fromArray(S, d, i)
                .mul(DoubleVector.fromArray(S, d, j))
                .add(DoubleVector.fromArray(S, d, i + L).mul(DoubleVector.fromArray(S, d, j + L)))
                .add(
                        DoubleVector.fromArray(S, d, i + 2 * L)
                                .mul(DoubleVector.fromArray(S, d, j + 2 * L)))
                .intoArray(st, out);
        DoubleVector.fromArray(S, d, ib)
                .mul(DoubleVector.fromArray(S, d, jb))
                .add(DoubleVector.fromArray(S, d, ib + L).mul(DoubleVector.fromArray(S, d, jb + L)))
                .add(
                        DoubleVector.fromArray(S, d, ib + 2 * L)
                                .mul(DoubleVector.fromArray(S, d, jb + 2 * L)))
                .intoArray(st, out + 4 * L);
    }

    /** The friction of the last sub-step, along the tangents of this one. */
    private static void warm(double[] d, int o, double[] st, double scale) {
        var x = DoubleVector.fromArray(S, st, OLD * L).mul(scale);
        var y = DoubleVector.fromArray(S, st, (OLD + 1) * L).mul(scale);
        var z = DoubleVector.fromArray(S, st, (OLD + 2) * L).mul(scale);
        var hasFriction = DoubleVector.fromArray(S, st, MU * L).compare(VectorOperators.GT, 0.0);
        int l = o + LAMBDA * L;
        for (int k = 0; k < 2; k++) {
            int t = o + (TANGENT1 + 3 * k) * L;
            var along =
                    x.mul(DoubleVector.fromArray(S, d, t))
                            .add(y.mul(DoubleVector.fromArray(S, d, t + L)))
                            .add(z.mul(DoubleVector.fromArray(S, d, t + 2 * L)))
                            .add(0.0);
            DoubleVector.zero(S).blend(along, hasFriction).intoArray(d, l + k * L);
        }
        var twist = DoubleVector.fromArray(S, st, (OLD + 3) * L).mul(scale).add(0.0);
        var turns =
                DoubleVector.fromArray(S, d, o + TWIST_MASS * L).compare(VectorOperators.GT, 0.0);
        DoubleVector.zero(S).blend(twist, turns).intoArray(d, l + 2 * L);
        clear(d, o, TOTAL, TOTAL + 3);
        int v = o + LEVER * L;
        push(st, d, l, d, o + TANGENT1 * L);
        push(st, d, l + L, d, o + TANGENT2 * L);
        turn(st, d, l, v, v + 6 * L);
        turn(st, d, l + L, v + 3 * L, v + 9 * L);
        turn(st, d, l + 2 * L, o + TWIST * L, o + (TWIST + 3) * L);
    }
}
