package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.mesh.Grounds;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.tuning.Tuning;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Random;
import java.util.Set;

/**
 * Shapes on triangles that have hardly moved keep their contacts; against contacts that are found
 * anew, within the bounds that {@link SurfaceRecycler} states: of the move at any place, and of its
 * square where the same point touches along the same normal.
 */
class KeptOnSurfaceTest {
    private static final double STEP = 1.0 / 60;
    private static final long SEED = 20261126;

    private final Random random = new Random(SEED);
    private final Jobs jobs = Jobs.of(1);

    @AfterEach
    void close() {
        jobs.close();
    }

    /** A surface and a shape, and the rows of their contacts. */
    private final class Pair {
        final BodyStore bodies = new BodyStore();
        final ColliderStore colliders = new ColliderStore(bodies);
        final ContactStore rows = new ContactStore();
        final BoundsStage bounds = new BoundsStage(colliders, Tuning.DEFAULT);
        final PairGroups groups = new PairGroups();
        final PointStore points = new PointStore(colliders);
        final SurfaceStage stage = new SurfaceStage(colliders, bounds, points, groups);
        final int surface;
        final int shape;

        Pair(Shape ground, Shape solid, boolean surfaceFirst) {
            surface = surfaceFirst ? 0 : 1;
            shape = 1 - surface;
            bodies.ensureCapacity(2);
            bodies.slotCount = 2;
            colliders.attach(surface, ground);
            colliders.attach(shape, solid);
            bounds.ensureSlots(2);
            rows.beginGroups();
            rows.ensureCapacity(1);
            rows.count = 1;
            rows.activateAll();
            ContactMaterials.join(rows, 0, colliders, 0, 1);
            rows.group[0] = groups.open();
            points.use(rows);
        }

        void place(int slot, Vector3d at, Quaterniond q) {
            bodies.positionX[slot] = at.x;
            bodies.positionY[slot] = at.y;
            bodies.positionZ[slot] = at.z;
            bodies.orientationX[slot] = q.x;
            bodies.orientationY[slot] = q.y;
            bodies.orientationZ[slot] = q.z;
            bodies.orientationW[slot] = q.w;
        }

        void run() {
            stage.run(rows, STEP, STEP, jobs);
        }

        /** Runs, and tells whether the contacts of the last run were kept. */
        boolean runKept() {
            int[] names = rows.feature.clone();
            Arrays.fill(rows.feature, 0x3FFF_FFFF);
            run();
            boolean kept = true;
            for (int row = 0; row < rows.count; row++) {
                kept &= rows.pointCount[row] == 0 || rows.feature[4 * row] == 0x3FFF_FFFF;
            }
            if (kept) {
                System.arraycopy(names, 0, rows.feature, 0, names.length);
            }
            return kept;
        }

        /** How far a ball's points are from the line through its centre along the normal, m. */
        double beside(double radius) {
            double worst = 0;
            double sign = shape == 1 ? -1 : 1;
            for (int row = 0; row < rows.count; row++) {
                for (int p = 4 * row; p < 4 * row + rows.pointCount[row]; p++) {
                    double far = sign * (radius + rows.separation[p] / 2);
                    int at = ContactStore.anchor(p) + 3 * shape;
                    worst = Math.max(worst, Math.abs(rows.anchors[at] - far * rows.normalX(row)));
                    worst =
                            Math.max(
                                    worst,
                                    Math.abs(rows.anchors[at + 1] - far * rows.normalY(row)));
                }
            }
            return worst;
        }

        double deepest() {
            double least = Double.MAX_VALUE;
            for (int row = 0; row < rows.count; row++) {
                for (int p = 4 * row; p < 4 * row + rows.pointCount[row]; p++) {
                    least = Math.min(least, rows.separation[p]);
                }
            }
            return least;
        }
    }

    private final Vector3d surfaceAt = new Vector3d(), shapeAt = new Vector3d();
    private final Quaterniond surfaceTurn = new Quaterniond(), shapeTurn = new Quaterniond();

    private void place(Pair pair) {
        pair.place(pair.surface, surfaceAt, surfaceTurn);
        pair.place(pair.shape, shapeAt, shapeTurn);
    }

    private Vector3d direction() {
        return new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                .normalize();
    }

    /** Puts the shape so that its deepest point is a little in the ground. */
    private void settle(Pair pair, Shape solid) {
        surfaceAt.zero();
        surfaceTurn.identity();
        double x = 8 * random.nextDouble() - 4;
        double z = 8 * random.nextDouble() - 4;
        Vector3d axis = direction();
        shapeTurn.rotationAxis(random.nextInt(3) * .7, axis.x, axis.y, axis.z);
        shapeAt.set(x, Grounds.hills(x, z) + .8 * solid.outerRadius(), z);
        for (int i = 0; i < 60; i++) {
            Arrays.fill(pair.rows.keeps, false);
            place(pair);
            pair.run();
            double gap = pair.deepest();
            shapeAt.y -= gap == Double.MAX_VALUE ? .02 * solid.innerRadius() : .6 * gap + 1e-4;
        }
    }

    /** Moves both somewhere else, and the shape beside that by a share of what may be kept. */
    private void sway(Shape solid, double share) {
        double step = share * 0x1p-12 * solid.innerRadius();
        Vector3d axis = direction();
        shapeAt.fma(.5 * step, direction());
        double angle = .5 * step / solid.outerRadius();
        shapeTurn.premul(new Quaterniond().rotationAxis(angle, axis.x, axis.y, axis.z));
        shapeTurn.normalize();
        Vector3d other = direction();
        Quaterniond turn = new Quaterniond().rotationAxis(1, other.x, other.y, other.z);
        for (Vector3d v : new Vector3d[] {shapeAt, surfaceAt}) {
            turn.transform(v).add(1, 2, 3);
        }
        shapeTurn.premul(turn).normalize();
        surfaceTurn.premul(turn).normalize();
    }

    /**
     * Points of both that have the same normal and name, and are the same place of the shape: a
     * corner, or the lowest point of a ball.
     *
     * @return the worst difference of separations, m
     */
    private static double worst(Pair kept, Pair fresh, boolean isBall, int[] compared) {
        int corner = kept.surface == 0 ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A;
        double worst = 0;
        ContactStore c = kept.rows;
        ContactStore d = fresh.rows;
        for (int row = 0; row < c.count; row++) {
            for (int other = 0; other < d.count; other++) {
                double dot =
                        c.normalX(row) * d.normalX(other)
                                + c.normalY(row) * d.normalY(other)
                                + c.normalZ(row) * d.normalZ(other);
                for (int p = 4 * row; p < 4 * row + c.pointCount[row] && dot > 1 - 1e-12; p++) {
                    for (int q = 4 * other; q < 4 * other + d.pointCount[other]; q++) {
                        int kind = c.feature[p] & FeatureIds.CLOSEST;
                        if (c.feature[p] == d.feature[q] && (isBall || kind == corner)) {
                            worst = Math.max(worst, Math.abs(c.separation[p] - d.separation[q]));
                            compared[0]++;
                        }
                    }
                }
            }
        }
        return worst;
    }

    @Test
    void keptContactsAreThoseFoundAnew() {
        Shape ground = Grounds.hilly();
        int kept = 0;
        int[] compared = {0};
        Set<String> kinds = new HashSet<>();
        for (int i = 0; i < 1200; i++) {
            Shape solid = Grounds.kinds()[i % Grounds.kinds().length];
            if (random.nextInt(3) == 0) {
                solid = solid.moved(0, 0, 0, new Quaterniond().rotateXYZ(.4, 1, 2));
            }
            boolean surfaceFirst = i % 2 == 0;
            Pair pair = new Pair(ground, solid, surfaceFirst);
            settle(pair, solid);
            place(pair);
            Arrays.fill(pair.rows.keeps, false);
            pair.run();
            if (pair.deepest() == Double.MAX_VALUE) {
                continue;
            }
            for (int n = 0; n < 3; n++) {
                Vector3d at = new Vector3d(shapeAt);
                Quaterniond q = new Quaterniond(shapeTurn);
                sway(solid, .3);
                place(pair);
                if (!pair.runKept()) {
                    break;
                }
                kept++;
                kinds.add(solid.getClass().getSimpleName());
                Pair fresh = new Pair(ground, solid, surfaceFirst);
                place(fresh);
                fresh.run();
                String what = "seed " + SEED + ", pair " + i + ", " + solid;
                double inner = solid.innerRadius();
                assertEquals(fresh.deepest(), pair.deepest(), 2 * 0x1p-12 * inner, what);
                boolean isBall = i % 6 == 0;
                if (isBall || i % 6 >= 4) {
                    double square = 16 * 0x1p-24 * inner;
                    assertEquals(0, worst(pair, fresh, isBall, compared), square, what);
                }
                if (isBall) {
                    assertEquals(0, pair.beside(solid.outerRadius()), 1e-12, what);
                }
                assertFalse(at.equals(shapeAt) || q.equals(shapeTurn));
            }
        }
        assertTrue(kept > 2000, kept + " were kept");
        assertTrue(compared[0] > 1500, compared[0] + " points were compared");
        assertTrue(kinds.size() >= 6, kinds + " were kept");
    }

    @Test
    void whatMovesOrMayMoveIsCollidedAnew() {
        Shape ground = Grounds.hilly();
        for (int i = 0; i < 120; i++) {
            Shape solid = Grounds.kinds()[i % Grounds.kinds().length];
            Pair pair = new Pair(ground, solid, true);
            settle(pair, solid);
            place(pair);
            pair.run();
            if (pair.deepest() == Double.MAX_VALUE) {
                continue;
            }
            assertTrue(pair.runKept());
            shapeAt.fma(1.5 * 0x1p-12 * solid.innerRadius(), direction());
            place(pair);
            assertFalse(pair.runKept(), "moved");
            assertTrue(pair.runKept());
            pair.bodies.velocityX[pair.shape] = 1;
            pair.bounds.ahead[BoundsStage.AHEAD * pair.shape] = 1;
            assertFalse(pair.runKept(), "may be far beyond what was looked through");
            assertFalse(pair.runKept(), "will be elsewhere in the next tick");
        }
    }
}
