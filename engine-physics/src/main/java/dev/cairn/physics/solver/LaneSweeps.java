package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.ConstraintRows.BLOCK;
import static dev.cairn.physics.solver.ConstraintRows.CHUNK;
import static dev.cairn.physics.solver.ConstraintRows.COLD;
import static dev.cairn.physics.solver.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.ConstraintRows.GAP;
import static dev.cairn.physics.solver.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.ConstraintRows.LEVER;
import static dev.cairn.physics.solver.ConstraintRows.LINK;
import static dev.cairn.physics.solver.ConstraintRows.MASS;
import static dev.cairn.physics.solver.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.ConstraintRows.MASS_B;
import static dev.cairn.physics.solver.ConstraintRows.POINT;
import static dev.cairn.physics.solver.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.ConstraintRows.REACH;
import static dev.cairn.physics.solver.ConstraintRows.SEPARATION;
import static dev.cairn.physics.solver.ConstraintRows.SUM;
import static dev.cairn.physics.solver.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.ConstraintRows.TOTAL;
import static dev.cairn.physics.solver.ConstraintRows.TWIST;
import static dev.cairn.physics.solver.ConstraintRows.TWIST_MASS;
import static dev.cairn.physics.solver.SolverBodies.LOADED;
import static dev.cairn.physics.solver.SolverBodies.P;

import dev.cairn.physics.internal.ContactStore;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;

/**
 * The sweeps with one row to a lane, by the Vector API. The arithmetic of a lane is that of {@link
 * ScalarSweeps}, operation by operation; what a lane has to do no more is masked.
 *
 * <p>The class is made once for each number of lanes, as a hidden class, so that its species is a
 * constant. Kernels call the Vector API directly and keep vectors in locals: a helper that takes or
 * returns one would box it as soon as it is not inlined. A chunk of rows is gathered by scalar
 * copies into scratch, solved there group by group, and scattered.
 */
final class LaneSweeps implements Sweeps {
    private static final VectorSpecies<Double> S = species();
    private static final int L = S.length();

    /** Scratch: velocities of A and B, movements of A and B, and marks of a lane. */
    private static final int VB = 6 * CHUNK;

    private static final int PA = 12 * CHUNK;
    private static final int PB = 18 * CHUNK;
    private static final int PRESSED = 24 * CHUNK;
    private static final int LANDS = 25 * CHUNK;
    private static final int RUBS = 26 * CHUNK;

    /**
     * Of one group that slips: squares of the impulses that stop its slide and its spin, their
     * limits, and the shares of them that it can give.
     */
    private static final int SLIDE = 27 * CHUNK;

    private static final int SPIN = SLIDE + L;
    private static final int LIMIT = SLIDE + 2 * L;
    private static final int BOUND = SLIDE + 3 * L;
    private static final int SLIDE_SHARE = SLIDE + 4 * L;
    private static final int SPIN_SHARE = SLIDE + 5 * L;

    /** Of one group: by point, 1 where it presses. */
    private static final int ACTIVE = SLIDE + 6 * L;

    private static final int ONES = Sweeps.ONES;

    private final RowFiller filler;

    /**
     * Sweeps beside a filler of the same number of lanes.
     *
     * @param filler fills the rows
     */
    LaneSweeps(RowFiller filler) {
        this.filler = filler;
    }

    private static VectorSpecies<Double> species() {
        try {
            int lanes = MethodHandles.classData(MethodHandles.lookup(), "_", Integer.class);
            return lanes == 4 ? DoubleVector.SPECIES_256 : DoubleVector.SPECIES_512;
        } catch (IllegalAccessException refused) {
            throw new ExceptionInInitializerError(refused);
        }
    }

    @Override
    public int lanes() {
        return L;
    }

    @Override
    public void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            double scale,
            int from,
            int to,
            double[] scratch) {
        filler.fill(rows, bodies, contacts, sub, scale, from, to, scratch);
    }

    @Override
    public void bias(
            ConstraintRows rows, double[] body, SubStep sub, int from, int to, double[] scratch) {
        gather(body, rows.link, from, to, scratch);
        for (int j = from; j < to; j += L) {
            int n = rows.points[j / L];
            int o = j * ConstraintRows.FIELDS;
            int more = sub.landing - sub.sweeps;
            cold(rows.row, o, n);
            if (!even(rows.row, o, scratch, j - from, n, sub, true)) {
                DoubleVector.zero(S).intoArray(scratch, PRESSED + j - from);
                continue;
            }
            if (soft(rows.row, o, scratch, j - from, n, sub, sub.sweeps, ONES) && more > 0) {
                soft(rows.row, o, scratch, j - from, n, sub, more, LANDS);
            }
        }
        scatter(body, rows.link, from, to, scratch);
        for (int j = from; j < to; j++) {
            if (scratch[PRESSED + j - from] > 0) {
                int a = rows.link[j * LINK];
                int b = rows.link[j * LINK + 1];
                body[a + LOADED] = a == 0 ? 0 : 1;
                body[b + LOADED] = b == 0 ? 0 : 1;
            }
        }
    }

    @Override
    public void relax(
            ConstraintRows rows, double[] body, SubStep sub, int from, int to, double[] scratch) {
        gather(body, rows.link, from, to, scratch);
        gatherMovement(body, rows.link, from, to, scratch);
        double[] d = rows.row;
        double inverse = sub.inverse;
        for (int j = from; j < to; j += L) {
            int n = rows.points[j / L];
            int o = j * ConstraintRows.FIELDS;
            int g = j - from;
            if (separations(d, o, scratch, g, n)) {
                continue;
            }
            even(d, o, scratch, g, n, sub, false);
            if (hard(d, o, scratch, g, n, inverse, sub.sweeps, ONES)) {
                hard(d, o, scratch, g, n, inverse, sub.landing - sub.sweeps, LANDS);
            }
            if (rows.rough[j / L]) {
                boolean again = friction(d, o, scratch, g, n, ONES);
                for (int round = 1; again && round < sub.coldRounds; round++) {
                    hard(d, o, scratch, g, n, inverse, sub.landing, RUBS);
                    again = friction(d, o, scratch, g, n, RUBS);
                }
            }
            total(d, o, n);
        }
        scatter(body, rows.link, from, to, scratch);
    }

    private static void gather(double[] body, int[] link, int from, int to, double[] st) {
        for (int j = from, l = 0; j < to; j++, l++) {
            int a = link[j * LINK];
            int b = link[j * LINK + 1];
            st[l] = body[a];
            st[CHUNK + l] = body[a + 1];
            st[2 * CHUNK + l] = body[a + 2];
            st[3 * CHUNK + l] = body[a + 3];
            st[4 * CHUNK + l] = body[a + 4];
            st[5 * CHUNK + l] = body[a + 5];
            st[VB + l] = body[b];
            st[VB + CHUNK + l] = body[b + 1];
            st[VB + 2 * CHUNK + l] = body[b + 2];
            st[VB + 3 * CHUNK + l] = body[b + 3];
            st[VB + 4 * CHUNK + l] = body[b + 4];
            st[VB + 5 * CHUNK + l] = body[b + 5];
        }
    }

    private static void gatherMovement(double[] body, int[] link, int from, int to, double[] st) {
        for (int j = from, l = 0; j < to; j++, l++) {
            int a = link[j * LINK] + P;
            int b = link[j * LINK + 1] + P;
            st[PA + l] = body[a];
            st[PA + CHUNK + l] = body[a + 1];
            st[PA + 2 * CHUNK + l] = body[a + 2];
            st[PA + 3 * CHUNK + l] = body[a + 3];
            st[PA + 4 * CHUNK + l] = body[a + 4];
            st[PA + 5 * CHUNK + l] = body[a + 5];
            st[PB + l] = body[b];
            st[PB + CHUNK + l] = body[b + 1];
            st[PB + 2 * CHUNK + l] = body[b + 2];
            st[PB + 3 * CHUNK + l] = body[b + 3];
            st[PB + 4 * CHUNK + l] = body[b + 4];
            st[PB + 5 * CHUNK + l] = body[b + 5];
        }
    }

    private static void scatter(double[] body, int[] link, int from, int to, double[] st) {
        for (int j = from, l = 0; j < to; j++, l++) {
            int a = link[j * LINK];
            int b = link[j * LINK + 1];
            if (a != 0) {
                body[a] = st[l];
                body[a + 1] = st[CHUNK + l];
                body[a + 2] = st[2 * CHUNK + l];
                body[a + 3] = st[3 * CHUNK + l];
                body[a + 4] = st[4 * CHUNK + l];
                body[a + 5] = st[5 * CHUNK + l];
            }
            if (b != 0) {
                body[b] = st[VB + l];
                body[b + 1] = st[VB + CHUNK + l];
                body[b + 2] = st[VB + 2 * CHUNK + l];
                body[b + 3] = st[VB + 3 * CHUNK + l];
                body[b + 4] = st[VB + 4 * CHUNK + l];
                body[b + 5] = st[VB + 5 * CHUNK + l];
            }
        }
    }

    /** Marks the lanes that start without an impulse. */
    private static void cold(double[] d, int o, int points) {
        var sum = DoubleVector.zero(S);
        for (int p = 0; p < points; p++) {
            sum =
                    sum.add(
                            DoubleVector.fromArray(
                                    S, d, o + (POINT + p * POINT_FIELDS + IMPULSE) * L));
        }
        DoubleVector.zero(S)
                .blend(1.0, sum.compare(VectorOperators.EQ, 0.0))
                .intoArray(d, o + COLD * L);
    }

    /**
     * The same change of impulse at all points that press, or begin to, see {@link ScalarSweeps}.
     *
     * @return whether a point of the group presses or closes
     */
    private static boolean even(
            double[] d, int o, double[] st, int g, int points, SubStep sub, boolean isSoft) {
        var nx = DoubleVector.fromArray(S, d, o);
        var ny = DoubleVector.fromArray(S, d, o + L);
        var nz = DoubleVector.fromArray(S, d, o + 2 * L);
        var ma = DoubleVector.fromArray(S, d, o + MASS_A * L);
        var mb = DoubleVector.fromArray(S, d, o + MASS_B * L);
        var avx = DoubleVector.fromArray(S, st, g);
        var avy = DoubleVector.fromArray(S, st, CHUNK + g);
        var avz = DoubleVector.fromArray(S, st, 2 * CHUNK + g);
        var bvx = DoubleVector.fromArray(S, st, VB + g);
        var bvy = DoubleVector.fromArray(S, st, VB + CHUNK + g);
        var bvz = DoubleVector.fromArray(S, st, VB + 2 * CHUNK + g);
        var avu = DoubleVector.fromArray(S, st, 3 * CHUNK + g);
        var avv = DoubleVector.fromArray(S, st, 4 * CHUNK + g);
        var avw = DoubleVector.fromArray(S, st, 5 * CHUNK + g);
        var bvu = DoubleVector.fromArray(S, st, VB + 3 * CHUNK + g);
        var bvv = DoubleVector.fromArray(S, st, VB + 4 * CHUNK + g);
        var bvw = DoubleVector.fromArray(S, st, VB + 5 * CHUNK + g);
        var vn = nx.mul(bvx.sub(avx)).add(ny.mul(bvy.sub(avy))).add(nz.mul(bvz.sub(avz)));
        var fixed = ma.min(mb).compare(VectorOperators.EQ, 0.0);
        var rate = DoubleVector.zero(S);
        var massScale = DoubleVector.broadcast(S, 1.0);
        if (isSoft) {
            rate = DoubleVector.broadcast(S, sub.rate).blend(sub.fixedRate, fixed);
            massScale = DoubleVector.broadcast(S, sub.massScale).blend(sub.fixedMassScale, fixed);
        }
        var impulseScale =
                DoubleVector.broadcast(S, sub.impulseScale).blend(sub.fixedImpulseScale, fixed);
        var cold = isSoft ? DoubleVector.fromArray(S, d, o + COLD * L) : DoubleVector.zero(S);
        double inverse = sub.inverse;
        double push = -sub.pushSpeed;
        var n = DoubleVector.zero(S);
        var miss = DoubleVector.zero(S);
        var scale = DoubleVector.zero(S);
        var give = DoubleVector.zero(S);
        var least = DoubleVector.broadcast(S, Double.MAX_VALUE);
        var ax = DoubleVector.zero(S);
        var ay = DoubleVector.zero(S);
        var az = DoubleVector.zero(S);
        var bx = DoubleVector.zero(S);
        var by = DoubleVector.zero(S);
        var bz = DoubleVector.zero(S);
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * L;
            var ux = DoubleVector.fromArray(S, d, q);
            var uy = DoubleVector.fromArray(S, d, q + L);
            var uz = DoubleVector.fromArray(S, d, q + 2 * L);
            var wx = DoubleVector.fromArray(S, d, q + ARM_B * L);
            var wy = DoubleVector.fromArray(S, d, q + (ARM_B + 1) * L);
            var wz = DoubleVector.fromArray(S, d, q + (ARM_B + 2) * L);
            var s = DoubleVector.fromArray(S, d, q + SEPARATION * L);
            var old = DoubleVector.fromArray(S, d, q + IMPULSE * L);
            var mass = DoubleVector.fromArray(S, d, q + MASS * L);
            var speed =
                    vn.add(wx.mul(bvu).add(wy.mul(bvv)).add(wz.mul(bvw)))
                            .sub(ux.mul(avu).add(uy.mul(avv)).add(uz.mul(avw)));
            var open = s.compare(VectorOperators.GT, 0.0);
            var k = massScale.blend(1.0, open);
            var r = k.mul(speed).add(s.mul(rate).max(push).blend(s.mul(inverse), open));
            // a point that is not there has no mass
            var there = mass.compare(VectorOperators.GT, 0.0);
            var begins = cold.compare(VectorOperators.GT, 0.0);
            var active =
                    old.compare(VectorOperators.GT, 0.0)
                            .or(begins.and(r.compare(VectorOperators.LT, 0.0)).and(there));
            var one = DoubleVector.zero(S).blend(1.0, active);
            one.intoArray(st, ACTIVE + p * L);
            n = n.add(one);
            miss = miss.add(DoubleVector.zero(S).blend(r, active));
            scale = scale.add(DoubleVector.zero(S).blend(k, active));
            least = least.blend(least.min(old), active);
            ax = ax.add(DoubleVector.zero(S).blend(ux, active));
            ay = ay.add(DoubleVector.zero(S).blend(uy, active));
            az = az.add(DoubleVector.zero(S).blend(uz, active));
            bx = bx.add(DoubleVector.zero(S).blend(wx, active));
            by = by.add(DoubleVector.zero(S).blend(wy, active));
            bz = bz.add(DoubleVector.zero(S).blend(wz, active));
            if (isSoft) {
                var leak =
                        DoubleVector.zero(S).blend(impulseScale.blend(0.0, open).div(mass), active);
                miss = miss.add(leak.mul(old));
                give = give.add(leak);
            }
        }
        var response =
                n.mul(n)
                        .mul(ma.add(mb))
                        .add(ax.mul(ax).add(ay.mul(ay)).add(az.mul(az)))
                        .add(bx.mul(bx).add(by.mul(by)).add(bz.mul(bz)));
        var floor = least.neg().blend(0.0, cold.compare(VectorOperators.GT, 0.0));
        var delta =
                DoubleVector.zero(S)
                        .blend(
                                miss.neg().div(response.mul(scale.div(n)).add(give)).max(floor),
                                n.compare(VectorOperators.GT, 1.0));
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS + IMPULSE) * L;
            DoubleVector.fromArray(S, d, q)
                    .add(delta.mul(DoubleVector.fromArray(S, st, ACTIVE + p * L)))
                    .intoArray(d, q);
        }
        var change = n.mul(delta);
        var px = change.mul(nx);
        var py = change.mul(ny);
        var pz = change.mul(nz);
        var back = delta.neg();
        avx.add(ma.neg().mul(px)).add(0.0).intoArray(st, g);
        avy.add(ma.neg().mul(py)).add(0.0).intoArray(st, CHUNK + g);
        avz.add(ma.neg().mul(pz)).add(0.0).intoArray(st, 2 * CHUNK + g);
        bvx.add(mb.mul(px)).add(0.0).intoArray(st, VB + g);
        bvy.add(mb.mul(py)).add(0.0).intoArray(st, VB + CHUNK + g);
        bvz.add(mb.mul(pz)).add(0.0).intoArray(st, VB + 2 * CHUNK + g);
        avu.add(back.mul(ax)).add(0.0).intoArray(st, 3 * CHUNK + g);
        avv.add(back.mul(ay)).add(0.0).intoArray(st, 4 * CHUNK + g);
        avw.add(back.mul(az)).add(0.0).intoArray(st, 5 * CHUNK + g);
        bvu.add(delta.mul(bx)).add(0.0).intoArray(st, VB + 3 * CHUNK + g);
        bvv.add(delta.mul(by)).add(0.0).intoArray(st, VB + 4 * CHUNK + g);
        bvw.add(delta.mul(bz)).add(0.0).intoArray(st, VB + 5 * CHUNK + g);
        return n.compare(VectorOperators.GT, 0.0).anyTrue();
    }

    /**
     * Soft normals of a group: of the lanes that are marked at {@code marks}.
     *
     * @return whether a lane that lands needs more sweeps
     */
    private static boolean soft(
            double[] d, int o, double[] st, int g, int points, SubStep sub, int sweeps, int marks) {
        var nx = DoubleVector.fromArray(S, d, o);
        var ny = DoubleVector.fromArray(S, d, o + L);
        var nz = DoubleVector.fromArray(S, d, o + 2 * L);
        var ma = DoubleVector.fromArray(S, d, o + MASS_A * L);
        var mb = DoubleVector.fromArray(S, d, o + MASS_B * L);
        var sum = ma.add(mb);
        var ax = DoubleVector.fromArray(S, st, 3 * CHUNK + g);
        var ay = DoubleVector.fromArray(S, st, 4 * CHUNK + g);
        var az = DoubleVector.fromArray(S, st, 5 * CHUNK + g);
        var bx = DoubleVector.fromArray(S, st, VB + 3 * CHUNK + g);
        var by = DoubleVector.fromArray(S, st, VB + 4 * CHUNK + g);
        var bz = DoubleVector.fromArray(S, st, VB + 5 * CHUNK + g);
        var avx = DoubleVector.fromArray(S, st, g);
        var avy = DoubleVector.fromArray(S, st, CHUNK + g);
        var avz = DoubleVector.fromArray(S, st, 2 * CHUNK + g);
        var bvx = DoubleVector.fromArray(S, st, VB + g);
        var bvy = DoubleVector.fromArray(S, st, VB + CHUNK + g);
        var bvz = DoubleVector.fromArray(S, st, VB + 2 * CHUNK + g);
        var vn = nx.mul(bvx.sub(avx)).add(ny.mul(bvy.sub(avy))).add(nz.mul(bvz.sub(avz)));
        var change = DoubleVector.zero(S);
        var fixed = ma.min(mb).compare(VectorOperators.EQ, 0.0);
        var rate = DoubleVector.broadcast(S, sub.rate).blend(sub.fixedRate, fixed);
        var massScale = DoubleVector.broadcast(S, sub.massScale).blend(sub.fixedMassScale, fixed);
        var leak = DoubleVector.broadcast(S, sub.impulseScale).blend(sub.fixedImpulseScale, fixed);
        double inverse = sub.inverse;
        double push = -sub.pushSpeed;
        var pressed = DoubleVector.zero(S);
        var active = DoubleVector.fromArray(S, st, marks + g).compare(VectorOperators.GT, 0.0);
        var moved = DoubleVector.zero(S);
        for (int sweep = 0; sweep < sweeps; sweep++) {
            moved = DoubleVector.zero(S);
            pressed = DoubleVector.zero(S);
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS) * L;
                var ux = DoubleVector.fromArray(S, d, q);
                var uy = DoubleVector.fromArray(S, d, q + L);
                var uz = DoubleVector.fromArray(S, d, q + 2 * L);
                var wx = DoubleVector.fromArray(S, d, q + ARM_B * L);
                var wy = DoubleVector.fromArray(S, d, q + (ARM_B + 1) * L);
                var wz = DoubleVector.fromArray(S, d, q + (ARM_B + 2) * L);
                var s = DoubleVector.fromArray(S, d, q + SEPARATION * L);
                var open = s.compare(VectorOperators.GT, 0.0);
                var b0 = s.mul(rate).max(push).blend(s.mul(inverse), open);
                var k = massScale.blend(1.0, open);
                var loss = leak.blend(0.0, open);
                var speed =
                        vn.add(change.mul(sum))
                                .add(wx.mul(bx).add(wy.mul(by)).add(wz.mul(bz)))
                                .sub(ux.mul(ax).add(uy.mul(ay)).add(uz.mul(az)));
                var old = DoubleVector.fromArray(S, d, q + IMPULSE * L);
                var mass = DoubleVector.fromArray(S, d, q + MASS * L);
                var next =
                        old.blend(
                                old.sub(mass.mul(k.mul(speed).add(b0))).sub(loss.mul(old)).max(0.0),
                                active);
                pressed = pressed.add(next);
                next.intoArray(d, q + IMPULSE * L);
                var delta = next.sub(old);
                moved = moved.max(delta.abs());
                change = change.add(delta);
                ax = ax.sub(delta.mul(ux));
                ay = ay.sub(delta.mul(uy));
                az = az.sub(delta.mul(uz));
                bx = bx.add(delta.mul(wx));
                by = by.add(delta.mul(wy));
                bz = bz.add(delta.mul(wz));
            }
            if (!moved.compare(VectorOperators.GT, 0.0).anyTrue()) {
                break;
            }
        }
        var px = change.mul(nx);
        var py = change.mul(ny);
        var pz = change.mul(nz);
        avx.add(ma.neg().mul(px)).add(0.0).intoArray(st, g);
        avy.add(ma.neg().mul(py)).add(0.0).intoArray(st, CHUNK + g);
        avz.add(ma.neg().mul(pz)).add(0.0).intoArray(st, 2 * CHUNK + g);
        bvx.add(mb.mul(px)).add(0.0).intoArray(st, VB + g);
        bvy.add(mb.mul(py)).add(0.0).intoArray(st, VB + CHUNK + g);
        bvz.add(mb.mul(pz)).add(0.0).intoArray(st, VB + 2 * CHUNK + g);
        ax.add(0.0).intoArray(st, 3 * CHUNK + g);
        ay.add(0.0).intoArray(st, 4 * CHUNK + g);
        az.add(0.0).intoArray(st, 5 * CHUNK + g);
        bx.add(0.0).intoArray(st, VB + 3 * CHUNK + g);
        by.add(0.0).intoArray(st, VB + 4 * CHUNK + g);
        bz.add(0.0).intoArray(st, VB + 5 * CHUNK + g);
        pressed.intoArray(st, PRESSED + g);
        var lands =
                DoubleVector.fromArray(S, d, o + COLD * L)
                        .compare(VectorOperators.GT, 0.0)
                        .and(moved.compare(VectorOperators.GT, 0.0));
        DoubleVector.zero(S).blend(1.0, lands).intoArray(st, LANDS + g);
        return lands.anyTrue();
    }

    /**
     * Where the points are after the movement of the sub-step.
     *
     * @return whether all are open without an impulse: then the pass has nothing to do, since the
     *     bias pass has left no negative zeros
     */
    private static boolean separations(double[] d, int o, double[] st, int g, int points) {
        var nx = DoubleVector.fromArray(S, d, o);
        var ny = DoubleVector.fromArray(S, d, o + L);
        var nz = DoubleVector.fromArray(S, d, o + 2 * L);
        var moved =
                nx.mul(
                                DoubleVector.fromArray(S, st, PB + g)
                                        .sub(DoubleVector.fromArray(S, st, PA + g)))
                        .add(
                                ny.mul(
                                        DoubleVector.fromArray(S, st, PB + CHUNK + g)
                                                .sub(
                                                        DoubleVector.fromArray(
                                                                S, st, PA + CHUNK + g))))
                        .add(
                                nz.mul(
                                        DoubleVector.fromArray(S, st, PB + 2 * CHUNK + g)
                                                .sub(
                                                        DoubleVector.fromArray(
                                                                S, st, PA + 2 * CHUNK + g))));
        // a mask that is carried round a loop would be an object; a number above 0 says the same
        var busy = DoubleVector.zero(S);
        var ax = DoubleVector.fromArray(S, st, PA + 3 * CHUNK + g);
        var ay = DoubleVector.fromArray(S, st, PA + 4 * CHUNK + g);
        var az = DoubleVector.fromArray(S, st, PA + 5 * CHUNK + g);
        var bx = DoubleVector.fromArray(S, st, PB + 3 * CHUNK + g);
        var by = DoubleVector.fromArray(S, st, PB + 4 * CHUNK + g);
        var bz = DoubleVector.fromArray(S, st, PB + 5 * CHUNK + g);
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * L;
            var ux = DoubleVector.fromArray(S, d, q);
            var uy = DoubleVector.fromArray(S, d, q + L);
            var uz = DoubleVector.fromArray(S, d, q + 2 * L);
            var wx = DoubleVector.fromArray(S, d, q + ARM_B * L);
            var wy = DoubleVector.fromArray(S, d, q + (ARM_B + 1) * L);
            var wz = DoubleVector.fromArray(S, d, q + (ARM_B + 2) * L);
            var s =
                    moved.add(DoubleVector.fromArray(S, d, o + (GAP + p) * L))
                            .add(wx.mul(bx).add(wy.mul(by)).add(wz.mul(bz)))
                            .sub(ux.mul(ax).add(uy.mul(ay)).add(uz.mul(az)));
            s.intoArray(d, q + SEPARATION * L);
            // a point that is not there has no mass
            var open =
                    s.compare(VectorOperators.GT, 0.0)
                            .and(
                                    DoubleVector.fromArray(S, d, q + IMPULSE * L)
                                            .compare(VectorOperators.EQ, 0.0));
            busy = busy.max(DoubleVector.fromArray(S, d, q + MASS * L).blend(0.0, open));
        }
        // friction of a lane whose points have all opened goes to zero first
        int l = o + LAMBDA * L;
        var last =
                DoubleVector.fromArray(S, d, l)
                        .abs()
                        .add(DoubleVector.fromArray(S, d, l + L).abs())
                        .add(DoubleVector.fromArray(S, d, l + 2 * L).abs());
        return busy.add(last).compare(VectorOperators.EQ, 0.0).allTrue();
    }

    /**
     * Hard normals of a group: of the lanes that are marked at {@code marks}.
     *
     * @return whether a lane that lands needs more sweeps
     */
    private static boolean hard(
            double[] d,
            int o,
            double[] st,
            int g,
            int points,
            double inverse,
            int sweeps,
            int marks) {
        var nx = DoubleVector.fromArray(S, d, o);
        var ny = DoubleVector.fromArray(S, d, o + L);
        var nz = DoubleVector.fromArray(S, d, o + 2 * L);
        var ma = DoubleVector.fromArray(S, d, o + MASS_A * L);
        var mb = DoubleVector.fromArray(S, d, o + MASS_B * L);
        var sum = ma.add(mb);
        var ax = DoubleVector.fromArray(S, st, 3 * CHUNK + g);
        var ay = DoubleVector.fromArray(S, st, 4 * CHUNK + g);
        var az = DoubleVector.fromArray(S, st, 5 * CHUNK + g);
        var bx = DoubleVector.fromArray(S, st, VB + 3 * CHUNK + g);
        var by = DoubleVector.fromArray(S, st, VB + 4 * CHUNK + g);
        var bz = DoubleVector.fromArray(S, st, VB + 5 * CHUNK + g);
        var avx = DoubleVector.fromArray(S, st, g);
        var avy = DoubleVector.fromArray(S, st, CHUNK + g);
        var avz = DoubleVector.fromArray(S, st, 2 * CHUNK + g);
        var bvx = DoubleVector.fromArray(S, st, VB + g);
        var bvy = DoubleVector.fromArray(S, st, VB + CHUNK + g);
        var bvz = DoubleVector.fromArray(S, st, VB + 2 * CHUNK + g);
        var vn = nx.mul(bvx.sub(avx)).add(ny.mul(bvy.sub(avy))).add(nz.mul(bvz.sub(avz)));
        var change = DoubleVector.zero(S);
        var active = DoubleVector.fromArray(S, st, marks + g).compare(VectorOperators.GT, 0.0);
        var moved = DoubleVector.zero(S);
        for (int sweep = 0; sweep < sweeps; sweep++) {
            moved = DoubleVector.zero(S);
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS) * L;
                var ux = DoubleVector.fromArray(S, d, q);
                var uy = DoubleVector.fromArray(S, d, q + L);
                var uz = DoubleVector.fromArray(S, d, q + 2 * L);
                var wx = DoubleVector.fromArray(S, d, q + ARM_B * L);
                var wy = DoubleVector.fromArray(S, d, q + (ARM_B + 1) * L);
                var wz = DoubleVector.fromArray(S, d, q + (ARM_B + 2) * L);
                var s = DoubleVector.fromArray(S, d, q + SEPARATION * L);
                var open = s.compare(VectorOperators.GT, 0.0);
                var speed =
                        vn.add(change.mul(sum))
                                .add(wx.mul(bx).add(wy.mul(by)).add(wz.mul(bz)))
                                .sub(ux.mul(ax).add(uy.mul(ay)).add(uz.mul(az)));
                var old = DoubleVector.fromArray(S, d, q + IMPULSE * L);
                var mass = DoubleVector.fromArray(S, d, q + MASS * L);
                var b0 = DoubleVector.zero(S).blend(s.mul(inverse), open);
                var next = old.sub(mass.mul(speed.add(b0))).max(0.0);
                next = next.blend(0.0, open.and(old.compare(VectorOperators.EQ, 0.0)));
                next = old.blend(next, active);
                next.intoArray(d, q + IMPULSE * L);
                var delta = next.sub(old);
                moved = moved.max(delta.abs());
                change = change.add(delta);
                ax = ax.sub(delta.mul(ux));
                ay = ay.sub(delta.mul(uy));
                az = az.sub(delta.mul(uz));
                bx = bx.add(delta.mul(wx));
                by = by.add(delta.mul(wy));
                bz = bz.add(delta.mul(wz));
            }
            if (!moved.compare(VectorOperators.GT, 0.0).anyTrue()) {
                break;
            }
        }
        var px = change.mul(nx);
        var py = change.mul(ny);
        var pz = change.mul(nz);
        avx.add(ma.neg().mul(px)).add(0.0).intoArray(st, g);
        avy.add(ma.neg().mul(py)).add(0.0).intoArray(st, CHUNK + g);
        avz.add(ma.neg().mul(pz)).add(0.0).intoArray(st, 2 * CHUNK + g);
        bvx.add(mb.mul(px)).add(0.0).intoArray(st, VB + g);
        bvy.add(mb.mul(py)).add(0.0).intoArray(st, VB + CHUNK + g);
        bvz.add(mb.mul(pz)).add(0.0).intoArray(st, VB + 2 * CHUNK + g);
        ax.add(0.0).intoArray(st, 3 * CHUNK + g);
        ay.add(0.0).intoArray(st, 4 * CHUNK + g);
        az.add(0.0).intoArray(st, 5 * CHUNK + g);
        bx.add(0.0).intoArray(st, VB + 3 * CHUNK + g);
        by.add(0.0).intoArray(st, VB + 4 * CHUNK + g);
        bz.add(0.0).intoArray(st, VB + 5 * CHUNK + g);
        var lands =
                DoubleVector.fromArray(S, d, o + COLD * L)
                        .compare(VectorOperators.GT, 0.0)
                        .and(moved.compare(VectorOperators.GT, 0.0));
        DoubleVector.zero(S).blend(1.0, lands).intoArray(st, LANDS + g);
        return lands.anyTrue();
    }

    /**
     * Twist and friction of a group: of the lanes that are marked at {@code marks}.
     *
     * @return whether a lane without a warm start presses, and so needs another round
     */
    private static boolean friction(double[] d, int o, double[] st, int g, int points, int marks) {
        var mu = DoubleVector.fromArray(S, d, o + FRICTION * L);
        var bound = DoubleVector.zero(S);
        var normal = DoubleVector.zero(S);
        for (int p = 0; p < points; p++) {
            var impulse =
                    DoubleVector.fromArray(S, d, o + (POINT + p * POINT_FIELDS + IMPULSE) * L);
            normal = normal.add(impulse);
            bound = bound.add(impulse.mul(DoubleVector.fromArray(S, d, o + (REACH + p) * L)));
        }
        int l = o + LAMBDA * L;
        // without any impulse, old or new, there is nothing to do
        var any =
                normal.add(DoubleVector.fromArray(S, d, l).abs())
                        .add(DoubleVector.fromArray(S, d, l + L).abs())
                        .add(DoubleVector.fromArray(S, d, l + 2 * L).abs());
        if (!any.compare(VectorOperators.GT, 0.0).anyTrue()) {
            return false;
        }
        bound = bound.mul(mu);
        var active = DoubleVector.fromArray(S, st, marks + g).compare(VectorOperators.GT, 0.0);
        var rubs =
                DoubleVector.fromArray(S, d, o + COLD * L)
                        .compare(VectorOperators.GT, 0.0)
                        .and(active)
                        .and(normal.compare(VectorOperators.GT, 0.0))
                        .and(mu.compare(VectorOperators.GT, 0.0));
        DoubleVector.zero(S).blend(1.0, rubs).intoArray(st, RUBS + g);
        var ax = DoubleVector.fromArray(S, st, 3 * CHUNK + g);
        var ay = DoubleVector.fromArray(S, st, 4 * CHUNK + g);
        var az = DoubleVector.fromArray(S, st, 5 * CHUNK + g);
        var bx = DoubleVector.fromArray(S, st, VB + 3 * CHUNK + g);
        var by = DoubleVector.fromArray(S, st, VB + 4 * CHUNK + g);
        var bz = DoubleVector.fromArray(S, st, VB + 5 * CHUNK + g);
        var avx = DoubleVector.fromArray(S, st, g);
        var avy = DoubleVector.fromArray(S, st, CHUNK + g);
        var avz = DoubleVector.fromArray(S, st, 2 * CHUNK + g);
        var bvx = DoubleVector.fromArray(S, st, VB + g);
        var bvy = DoubleVector.fromArray(S, st, VB + CHUNK + g);
        var bvz = DoubleVector.fromArray(S, st, VB + 2 * CHUNK + g);
        int t = o + TWIST * L;
        var tax = DoubleVector.fromArray(S, d, t);
        var tay = DoubleVector.fromArray(S, d, t + L);
        var taz = DoubleVector.fromArray(S, d, t + 2 * L);
        var tbx = DoubleVector.fromArray(S, d, t + 3 * L);
        var tby = DoubleVector.fromArray(S, d, t + 4 * L);
        var tbz = DoubleVector.fromArray(S, d, t + 5 * L);
        var oldTwist = DoubleVector.fromArray(S, d, l + 2 * L);
        var spin =
                tbx.mul(bx)
                        .add(tby.mul(by))
                        .add(tbz.mul(bz))
                        .sub(tax.mul(ax).add(tay.mul(ay)).add(taz.mul(az)));
        var twist =
                oldTwist.blend(
                        oldTwist.sub(DoubleVector.fromArray(S, d, o + TWIST_MASS * L).mul(spin))
                                .blend(0.0, bound.compare(VectorOperators.LE, 0.0)),
                        active);
        var turn = twist.sub(oldTwist);
        ax = ax.sub(turn.mul(tax));
        ay = ay.sub(turn.mul(tay));
        az = az.sub(turn.mul(taz));
        bx = bx.add(turn.mul(tbx));
        by = by.add(turn.mul(tby));
        bz = bz.add(turn.mul(tbz));
        var dx = bvx.sub(avx);
        var dy = bvy.sub(avy);
        var dz = bvz.sub(avz);
        int u = o + TANGENT1 * L;
        int v = o + LEVER * L;
        var t1x = DoubleVector.fromArray(S, d, u);
        var t1y = DoubleVector.fromArray(S, d, u + L);
        var t1z = DoubleVector.fromArray(S, d, u + 2 * L);
        var t2x = DoubleVector.fromArray(S, d, u + 3 * L);
        var t2y = DoubleVector.fromArray(S, d, u + 4 * L);
        var t2z = DoubleVector.fromArray(S, d, u + 5 * L);
        var a1x = DoubleVector.fromArray(S, d, v);
        var a1y = DoubleVector.fromArray(S, d, v + L);
        var a1z = DoubleVector.fromArray(S, d, v + 2 * L);
        var a2x = DoubleVector.fromArray(S, d, v + 3 * L);
        var a2y = DoubleVector.fromArray(S, d, v + 4 * L);
        var a2z = DoubleVector.fromArray(S, d, v + 5 * L);
        var b1x = DoubleVector.fromArray(S, d, v + 6 * L);
        var b1y = DoubleVector.fromArray(S, d, v + 7 * L);
        var b1z = DoubleVector.fromArray(S, d, v + 8 * L);
        var b2x = DoubleVector.fromArray(S, d, v + 9 * L);
        var b2y = DoubleVector.fromArray(S, d, v + 10 * L);
        var b2z = DoubleVector.fromArray(S, d, v + 11 * L);
        var v1 =
                dx.mul(t1x)
                        .add(dy.mul(t1y))
                        .add(dz.mul(t1z))
                        .add(b1x.mul(bx).add(b1y.mul(by)).add(b1z.mul(bz)))
                        .sub(a1x.mul(ax).add(a1y.mul(ay)).add(a1z.mul(az)));
        var v2 =
                dx.mul(t2x)
                        .add(dy.mul(t2y))
                        .add(dz.mul(t2z))
                        .add(b2x.mul(bx).add(b2y.mul(by)).add(b2z.mul(bz)))
                        .sub(a2x.mul(ax).add(a2y.mul(ay)).add(a2z.mul(az)));
        int k = o + BLOCK * L;
        var k11 = DoubleVector.fromArray(S, d, k);
        var k12 = DoubleVector.fromArray(S, d, k + L);
        var k22 = DoubleVector.fromArray(S, d, k + 2 * L);
        var old1 = DoubleVector.fromArray(S, d, l);
        var old2 = DoubleVector.fromArray(S, d, l + L);
        var f1 = old1.sub(k11.mul(v1).add(k12.mul(v2)));
        var f2 = old2.sub(k12.mul(v1).add(k22.mul(v2)));
        var limit = mu.mul(normal);
        var size = f1.mul(f1).add(f2.mul(f2));
        var square = twist.mul(twist);
        var scale = DoubleVector.zero(S).blend(1.0, limit.compare(VectorOperators.GT, 0.0));
        var twistScale = DoubleVector.zero(S).blend(1.0, bound.compare(VectorOperators.GT, 0.0));
        var l2 = limit.mul(limit);
        var b2 = bound.mul(bound);
        var slips =
                size.compare(VectorOperators.GT, l2)
                        .or(square.compare(VectorOperators.GT, b2))
                        .or(
                                size.mul(b2)
                                        .mul(9.0)
                                        .add(square.mul(l2).mul(16.0))
                                        .compare(VectorOperators.GT, l2.mul(b2).mul(9.0)));
        if (slips.anyTrue()) {
            size.intoArray(st, SLIDE);
            square.intoArray(st, SPIN);
            limit.intoArray(st, LIMIT);
            bound.intoArray(st, BOUND);
            slip(d, o, st);
            scale = DoubleVector.fromArray(S, st, SLIDE_SHARE);
            twistScale = DoubleVector.fromArray(S, st, SPIN_SHARE);
        }
        var newTwist = oldTwist.blend(twist.mul(twistScale).add(0.0), active);
        newTwist.intoArray(d, l + 2 * L);
        turn = newTwist.sub(twist);
        ax = ax.sub(turn.mul(tax));
        ay = ay.sub(turn.mul(tay));
        az = az.sub(turn.mul(taz));
        bx = bx.add(turn.mul(tbx));
        by = by.add(turn.mul(tby));
        bz = bz.add(turn.mul(tbz));
        f1 = old1.blend(f1.mul(scale).add(0.0), active);
        f2 = old2.blend(f2.mul(scale).add(0.0), active);
        f1.intoArray(d, l);
        f2.intoArray(d, l + L);
        var d1 = f1.sub(old1);
        var d2 = f2.sub(old2);
        var px = d1.mul(t1x).add(d2.mul(t2x));
        var py = d1.mul(t1y).add(d2.mul(t2y));
        var pz = d1.mul(t1z).add(d2.mul(t2z));
        var ma = DoubleVector.fromArray(S, d, o + MASS_A * L);
        var mb = DoubleVector.fromArray(S, d, o + MASS_B * L);
        avx.sub(ma.mul(px)).add(0.0).intoArray(st, g);
        avy.sub(ma.mul(py)).add(0.0).intoArray(st, CHUNK + g);
        avz.sub(ma.mul(pz)).add(0.0).intoArray(st, 2 * CHUNK + g);
        bvx.add(mb.mul(px)).add(0.0).intoArray(st, VB + g);
        bvy.add(mb.mul(py)).add(0.0).intoArray(st, VB + CHUNK + g);
        bvz.add(mb.mul(pz)).add(0.0).intoArray(st, VB + 2 * CHUNK + g);
        ax.sub(d1.mul(a1x).add(d2.mul(a2x))).add(0.0).intoArray(st, 3 * CHUNK + g);
        ay.sub(d1.mul(a1y).add(d2.mul(a2y))).add(0.0).intoArray(st, 4 * CHUNK + g);
        az.sub(d1.mul(a1z).add(d2.mul(a2z))).add(0.0).intoArray(st, 5 * CHUNK + g);
        bx.add(d1.mul(b1x).add(d2.mul(b2x))).add(0.0).intoArray(st, VB + 3 * CHUNK + g);
        by.add(d1.mul(b1y).add(d2.mul(b2y))).add(0.0).intoArray(st, VB + 4 * CHUNK + g);
        bz.add(d1.mul(b1z).add(d2.mul(b2z))).add(0.0).intoArray(st, VB + 5 * CHUNK + g);
        return rubs.anyTrue();
    }

    /** The shares of the impulses that the slipping lanes of a group can give, see {@link Rub}. */
    private static void slip(double[] d, int o, double[] st) {
        var slide = DoubleVector.fromArray(S, st, SLIDE);
        var spin = DoubleVector.fromArray(S, st, SPIN);
        var limit = DoubleVector.fromArray(S, st, LIMIT);
        var bound = DoubleVector.fromArray(S, st, BOUND);
        int k = o + BLOCK * L;
        var mass =
                DoubleVector.fromArray(S, d, k)
                        .add(DoubleVector.fromArray(S, d, k + 2 * L))
                        .mul(0.5);
        var inertia = DoubleVector.fromArray(S, d, o + TWIST_MASS * L);
        var reach = bound.div(limit);
        var r2 = reach.mul(reach).mul(Rub.REACH);
        var e =
                slide.mul(inertia.mul(inertia))
                        .div(spin.mul(r2.mul(mass.mul(mass))).add(Double.MIN_NORMAL));
        var one = DoubleVector.broadcast(S, 1.0);
        var inner = e.mul(e.mul(e.mul(e).mul(Rub.EIGHTH).add(Rub.FOURTH)).add(1.0)).add(1.0);
        var share =
                one.div(
                        e.mul(Rub.FAST)
                                .sub(Rub.LESS)
                                .blend(inner, e.compare(VectorOperators.LT, Rub.TURNING)));
        var whole = share.mul(Rub.NEAR).add(Rub.FAR).mul(r2).mul(limit);
        var across = share.mul(Rub.CLOSE).add(Rub.FAR).mul(r2).mul(spin);
        var give = DoubleVector.zero(S);
        for (int i = 0; i < Rub.STEPS; i++) {
            var u = mass.mul(give).add(limit);
            var w = inertia.mul(give).add(whole).add(Rub.LEAST);
            var p = slide.div(u.mul(u));
            var q = across.div(w.mul(w));
            var h = p.add(q);
            give =
                    give.add(
                                    h.mul(h.sqrt().sub(1.0))
                                            .div(p.mul(mass).div(u).add(q.mul(inertia).div(w))))
                            .max(0.0);
        }
        var l2 = limit.mul(limit);
        var b2 = bound.mul(bound);
        var holds =
                slide.compare(VectorOperators.LE, l2)
                        .and(spin.compare(VectorOperators.LE, b2))
                        .and(
                                slide.mul(b2)
                                        .mul(9.0)
                                        .add(spin.mul(l2).mul(16.0))
                                        .compare(VectorOperators.LE, l2.mul(b2).mul(9.0)));
        var rubs = limit.compare(VectorOperators.GT, 0.0);
        limit.div(mass.mul(give).add(limit))
                .blend(1.0, holds)
                .blend(0.0, rubs.not())
                .intoArray(st, SLIDE_SHARE);
        whole.div(inertia.mul(give).add(whole).add(Rub.LEAST))
                .blend(1.0, holds.and(bound.compare(VectorOperators.GT, 0.0)))
                .blend(0.0, bound.compare(VectorOperators.LE, 0.0))
                .intoArray(st, SPIN_SHARE);
    }

    private static void total(double[] d, int o, int points) {
        int t = o + TOTAL * L;
        int l = o + LAMBDA * L;
        for (int f = 0; f < 3; f++) {
            DoubleVector.fromArray(S, d, t + f * L)
                    .add(DoubleVector.fromArray(S, d, l + f * L))
                    .intoArray(d, t + f * L);
        }
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS + IMPULSE) * L;
            int s = o + (SUM + p) * L;
            DoubleVector.fromArray(S, d, s).add(DoubleVector.fromArray(S, d, q)).intoArray(d, s);
        }
    }
}
