package dev.cairn.physics.narrowphase.axis;

import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * First-order optimality of a separating axis: whether it is the best of all near ones. The
 * separation
 *
 * <pre>
 *   s(n) = n . d - hA(n) - hB(-n)
 * </pre>
 *
 * <p>is concave but for the length of n, and its supergradients at n are the differences of the
 * support points of B and of A: n is optimal when zero is among them, that is when the support
 * features of both shapes overlap as seen along n. Of shapes that overlap, the length of n bends s
 * upwards, so their features have to overlap by more than that can make up for.
 */
final class OptimalityTest {
    /** Of the pair's scale: touching parts that miss each other by this are taken to meet. */
    private static final double SLACK = 0x1p-46;

    /** Sine of the angle between lines that cross nowhere for certain. */
    private static final double PARALLEL = 0x1p-40;

    /** Of the depth: what a change of the axis by 1e-3 gains when nothing else is lost. */
    private static final double INSET = 0x1p-11;

    /** Across the axis, from what touches of A to what touches of B. */
    double missX, missY, missZ;

    private final SupportFeature featureA, featureB;
    private double inset, nx, ny, nz;

    OptimalityTest(CandidateFeatures sideA, CandidateFeatures sideB) {
        featureA = new SupportFeature(sideA, false);
        featureB = new SupportFeature(sideB, true);
    }

    /** Whether the parts meet along the axis found; they are at places among the features. */
    boolean holds(AxisRefinement r, Pair pair, int placeA, int placeB) {
        double slack = SLACK * pair.scale;
        inset = Math.max(0, -INSET * r.separation);
        featureA.of(pair);
        featureB.of(pair);
        nx = r.axisX;
        ny = r.axisY;
        nz = r.axisZ;
        missX = 0;
        missY = 0;
        missZ = 0;
        if (r.kindA == AxisRefinement.ROUGH) {
            return false;
        }
        boolean flat = r.kindA == AxisRefinement.FLAT || r.kindB == AxisRefinement.FLAT;
        if (!flat && r.kindA == AxisRefinement.LINE) {
            featureA.segment(placeA, nx, ny, nz);
        }
        if (!flat && r.kindB == AxisRefinement.LINE) {
            featureB.segment(placeB, -nx, -ny, -nz);
        }
        if (r.kindA == AxisRefinement.LINE && r.kindB == AxisRefinement.LINE) {
            linesMiss();
        } else if (r.kindA == AxisRefinement.FLAT || (!flat && r.kindA == AxisRefinement.LINE)) {
            featureB.supportPoint(-nx, -ny, -nz);
            featureA.miss(r.kindA == AxisRefinement.FLAT, placeA, featureB, inset);
            add(featureA, 1);
        } else if (r.kindB == AxisRefinement.FLAT || r.kindB == AxisRefinement.LINE) {
            featureA.supportPoint(nx, ny, nz);
            featureB.miss(r.kindB == AxisRefinement.FLAT, placeB, featureA, inset);
            add(featureB, -1);
        } else {
            featureA.supportPoint(nx, ny, nz);
            featureB.supportPoint(-nx, -ny, -nz);
            missX = featureB.tx - featureA.tx;
            missY = featureB.ty - featureA.ty;
            missZ = featureB.tz - featureA.tz;
        }
        double along = missX * nx + missY * ny + missZ * nz;
        missX -= along * nx;
        missY -= along * ny;
        missZ -= along * nz;
        double miss = missX * missX + missY * missY + missZ * missZ;
        if (flat) {
            return miss <= slack * slack;
        }
        // Beyond the normals of its faces an edge is on their circle, but does not touch.
        if (!(Math.abs(along - r.separation) <= slack)) {
            return false;
        }
        if (miss > slack * slack) {
            // Near a rim's axis a rounding of n moves the point where the rim touches by much.
            slack += featureA.unsteady(nx, ny, nz) + featureB.unsteady(nx, ny, nz);
        }
        return miss <= slack * slack;
    }

    private void add(SupportFeature side, double sign) {
        missX += sign * side.missX;
        missY += sign * side.missY;
        missZ += sign * side.missZ;
    }

    /** With w from the middle of A's to that of B's: t = (w x v) . n / (u x v) . n. */
    private void linesMiss() {
        SupportFeature a = featureA;
        SupportFeature b = featureB;
        double det = triple(a.alongX, a.alongY, a.alongZ, b.alongX, b.alongY, b.alongZ);
        double wx = b.midX - a.midX;
        double wy = b.midY - a.midY;
        double wz = b.midZ - a.midZ;
        if (!(Math.abs(det) > PARALLEL)) {
            double t = wx * a.alongX + wy * a.alongY + wz * a.alongZ;
            double by = t - Math.signum(t) * Math.min(Math.abs(t), a.reach + b.reach);
            missX = wx + (by - t) * a.alongX;
            missY = wy + (by - t) * a.alongY;
            missZ = wz + (by - t) * a.alongZ;
            return;
        }
        double ofA = triple(wx, wy, wz, b.alongX, b.alongY, b.alongZ) / det;
        double ofB = triple(wx, wy, wz, a.alongX, a.alongY, a.alongZ) / det;
        a.beyond(ofA, inset);
        b.beyond(ofB, inset);
        double along = wx * nx + wy * ny + wz * nz;
        missX = along * nx;
        missY = along * ny;
        missZ = along * nz;
        add(a, 1);
        add(b, -1);
    }

    /** (w x v) . n. */
    private double triple(double wx, double wy, double wz, double vx, double vy, double vz) {
        return (wy * vz - wz * vy) * nx + (wz * vx - wx * vz) * ny + (wx * vy - wy * vx) * nz;
    }
}
