package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.contact.BoundsStage;
import dev.cairn.physics.contact.ManifoldStage;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.oracle.ConvexOracle;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedron;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * Pairs of boxes and hulls that have hardly moved keep their points without being collided again;
 * against brute force, and within the stated share of the smaller inner radius.
 */
class RecycledContactsTest {
    private static final double STEP = 1.0 / 60.0;

    /** What the engine states; see docs/narrow-phase.md. */
    private static final double SHARE = 0x1p-12;

    private static final int SENTINEL = 0x3FFF_FFFF;

    private final BodyStore bodies = new BodyStore();
    private final ColliderStore colliders = new ColliderStore(bodies);
    private final ContactStore rows = new ContactStore();
    private final BoundsStage bounds = new BoundsStage(colliders, Tuning.DEFAULT);
    private final ManifoldStage stage = new ManifoldStage(colliders, bounds);
    private final Jobs jobs = Jobs.of(1);

    RecycledContactsTest() {
        bodies.ensureCapacity(2);
        bodies.slotCount = 2;
        colliders.attach(0, Box.cubeOfHalfExtent(1));
        colliders.attach(1, Box.cubeOfHalfExtent(1));
        bounds.ensureSlots(2);
        rows.ensureCapacity(1);
    }

    @AfterEach
    void close() {
        jobs.close();
    }

    private void begin(Scene s) {
        rows.count = 1;
        rows.activateAll();
        ContactMaterials.join(rows, 0, colliders, 0, 1);
        rows.pointCount[0] = 0;
        rows.cache[0] = 0;
        rows.keeps[0] = false;
        shape(0, s.a);
        shape(1, s.b);
        run(s);
    }

    private void shape(int slot, Shape shape) {
        colliders.shape[slot] = shape;
        colliders.innerRadius[slot] = shape.innerRadius();
        colliders.outerRadius[slot] = shape.outerRadius();
    }

    private void run(Scene s) {
        turn(0, s.qa);
        turn(1, s.qb);
        bodies.positionX[1] = s.d.x;
        bodies.positionY[1] = s.d.y;
        bodies.positionZ[1] = s.d.z;
        stage.run(rows, STEP, jobs);
    }

    private void turn(int slot, Quaterniond q) {
        bodies.orientationX[slot] = q.x;
        bodies.orientationY[slot] = q.y;
        bodies.orientationZ[slot] = q.z;
        bodies.orientationW[slot] = q.w;
    }

    /** Collides, and tells whether the points of the last run stayed. */
    private boolean recycled(Scene s) {
        int name = rows.feature[0];
        rows.feature[0] = SENTINEL;
        run(s);
        boolean stayed = rows.feature[0] == SENTINEL;
        if (stayed) {
            rows.feature[0] = name;
        }
        return stayed;
    }

    private double deepest() {
        double least = Double.MAX_VALUE;
        for (int p = 0; p < rows.pointCount[0]; p++) {
            least = Math.min(least, rows.separation[p]);
        }
        return least;
    }

    private static double truth(Scene s) {
        double axes = ConvexOracle.separatingAxes(s.placedA(), s.placedB());
        return axes <= 0 ? axes : ConvexOracle.distance(s.placedA(), s.placedB());
    }

    private static double inner(Scene s) {
        return Math.min(s.a.innerRadius(), s.b.innerRadius());
    }

    private static Scene stacked(SplittableRandom r, double tilt) {
        Scene s = new Scene(Scene.box(r), Scene.box(r));
        double beside = .8 * (2 * r.nextDouble() - 1);
        double up = ((Box) s.a).halfY() + ((Box) s.b).halfY() - 1e-3 * inner(s);
        s.at(beside * (((Box) s.a).halfX() + ((Box) s.b).halfX()), up, .1 * Scene.gauss(r));
        s.qb.rotateXYZ(tilt * Scene.gauss(r), r.nextInt(2) * Scene.gauss(r), tilt * Scene.gauss(r));
        Quaterniond turn = Scene.turn(r);
        turn.transform(s.d);
        s.qa.premul(turn);
        s.qb.premul(turn);
        return r.nextBoolean() ? s : s.swapped();
    }

    /** Moves B by up to a share of what may be kept, and both together by much more. */
    private static void sway(Scene s, SplittableRandom r, double share) {
        double step = share * inner(s);
        s.d.fma(step, Scene.direction(r));
        double angle = step / s.b.outerRadius() * r.nextDouble();
        Vector3d axis = Scene.direction(r);
        s.qb.premul(new Quaterniond().rotationAxis(angle, axis.x, axis.y, axis.z));
        Quaterniond turn = Scene.turn(r);
        turn.transform(s.d);
        s.qa.premul(turn).normalize();
        s.qb.premul(turn).normalize();
    }

    @Test
    void theDepthIsAsTrueAsItWasUpToTwiceTheMove() {
        SplittableRandom r = new SplittableRandom(31);
        int kept = 0;
        int turned = 0;
        for (int trial = 0; trial < 3000; trial++) {
            String where = "seed 31 trial " + trial;
            Scene s = stacked(r, trial % 2 * 1e-3);
            begin(s);
            double missed = Math.abs(deepest() - truth(s));
            for (int tick = 0; tick < 4 && rows.pointCount[0] > 0; tick++) {
                sway(s, r, .15 * SHARE);
                if (!recycled(s)) {
                    missed = Math.abs(deepest() - truth(s));
                    continue;
                }
                kept++;
                double now = Math.abs(deepest() - truth(s));
                double slack = 1e-13 * s.size();
                assertTrue(now <= missed + 2 * SHARE * inner(s) + slack, where + ": " + now + " m");
                turned += normalIsOfAFace(s, where) ? 1 : 0;
            }
        }
        assertTrue(kept > 3000, "only " + kept + " were kept");
        assertEquals(kept, turned);
    }

    /** Hulls of any faces, hulls on boxes, touching in any pose. */
    @Test
    void theDepthOfHullsIsAsTrueAsItWasUpToTwiceTheMove() {
        SplittableRandom r = new SplittableRandom(33);
        NarrowPhase n = new NarrowPhase();
        int kept = 0;
        int collided = 0;
        for (int trial = 0; trial < 600; trial++) {
            String where = "seed 33 trial " + trial;
            Shape a = trial % 3 == 0 ? Scene.box(r) : Scene.hull(r, 4 + r.nextInt(12), 1);
            Scene s = Scene.random(r, a, Scene.hull(r, 4 + r.nextInt(12), .7));
            s = r.nextBoolean() ? s : s.swapped();
            double gap = inner(s) * (trial % 5 == 0 ? .1 : -.01) * r.nextDouble();
            for (int k = 0; k < 3; k++) {
                double d = s.distance(n);
                s.d.fma(gap - d, EveryPairTest.axis(n));
            }
            begin(s);
            boolean apart = rows.pointCount[0] == 0;
            double missed = apart ? 0 : Math.abs(deepest() - truth(s));
            for (int tick = 0; tick < 4; tick++) {
                sway(s, r, .15 * SHARE);
                if (!recycled(s)) {
                    collided++;
                    apart = rows.pointCount[0] == 0;
                    missed = apart ? 0 : Math.abs(deepest() - truth(s));
                    continue;
                }
                kept++;
                if (apart) {
                    double margin = Tuning.DEFAULT.get(Tunable.SPECULATIVE_FRACTION) * inner(s);
                    assertTrue(truth(s) > margin, where + ": came within the margin unseen");
                    continue;
                }
                double now = Math.abs(deepest() - truth(s));
                double slack = 1e-13 * s.size();
                assertTrue(now <= missed + 2 * SHARE * inner(s) + slack, where + ": " + now + " m");
                assertTrue(crossesNoFace(s) < 2e-14, where + ": not the normal of a face");
            }
        }
        assertTrue(kept > 800 && collided > 400, kept + " kept, " + collided + " collided");
    }

    /** Sine of the angle between the normal and that of the nearest face of either shape. */
    private double crossesNoFace(Scene s) {
        Vector3d n = new Vector3d(rows.normalX(0), rows.normalY(0), rows.normalZ(0));
        double best = 1;
        for (int side = 0; side < 2; side++) {
            Shape shape = side == 0 ? s.a : s.b;
            Polyhedron h =
                    shape instanceof Box b ? Polyhedron.of(b) : Polyhedron.of((ConvexHull) shape);
            for (int f = 0; f < h.faceCount(); f++) {
                Vector3d e = new Vector3d(h.normalX(f), h.normalY(f), h.normalZ(f));
                (side == 0 ? s.qa : s.qb).transform(e);
                best = Math.min(best, n.cross(e, e).length());
            }
        }
        return best;
    }

    /** A column of one of the rotations, as the present poses have it. */
    private boolean normalIsOfAFace(Scene s, String where) {
        Vector3d n = new Vector3d(rows.normalX(0), rows.normalY(0), rows.normalZ(0));
        assertEquals(1, n.length(), 4e-15, where);
        double best = 1;
        for (int k = 0; k < 3; k++) {
            Vector3d e = new Vector3d(k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0);
            best = Math.min(best, n.cross(s.qa.transform(e, new Vector3d()), e).length());
            e.set(k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0);
            best = Math.min(best, n.cross(s.qb.transform(e, new Vector3d()), e).length());
        }
        return best < 1e-14;
    }

    @Test
    void separationsAndAnchorsOfKeptPointsAreThoseOfThePresentPoses() {
        SplittableRandom r = new SplittableRandom(32);
        int kept = 0;
        for (int trial = 0; trial < 2000; trial++) {
            Scene s = stacked(r, 0);
            begin(s);
            double before = rows.separation[0];
            Vector3d n = new Vector3d(rows.normalX(0), rows.normalY(0), rows.normalZ(0));
            Vector3d at = new Vector3d(rows.anchorAX(0), rows.anchorAY(0), rows.anchorAZ(0));
            double step = .3 * SHARE * inner(s) * (2 * r.nextDouble() - 1);
            s.d.fma(step, n);
            if (rows.pointCount[0] == 0 || !recycled(s)) {
                continue;
            }
            kept++;
            String where = "seed 32 trial " + trial;
            // Midway between a face that moved and one that did not.
            at.fma(step / 2, n);
            assertEquals(at.x, rows.anchorAX(0), 1e-14 * s.size(), where);
            assertEquals(at.y, rows.anchorAY(0), 1e-14 * s.size(), where);
            assertEquals(at.z, rows.anchorAZ(0), 1e-14 * s.size(), where);
            for (int p = 0; p < rows.pointCount[0]; p++) {
                assertEquals(before + step, rows.separation[p], 1e-14 * s.size(), where);
                assertEquals(rows.anchorAX(p), rows.anchorBX(p) + s.d.x, 1e-15 * s.size(), where);
                assertEquals(rows.anchorAY(p), rows.anchorBY(p) + s.d.y, 1e-15 * s.size(), where);
                assertEquals(rows.anchorAZ(p), rows.anchorBZ(p) + s.d.z, 1e-15 * s.size(), where);
            }
        }
        assertTrue(kept > 1500, "only " + kept + " were kept");
    }

    @Test
    void aPairThatIsApartIsCollidedWhenItComesNear() {
        Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.ofHalfExtents(.4, .3, .2)).at(0, .85, 0);
        begin(s);
        assertEquals(0, rows.pointCount[0]);
        double margin = Tuning.DEFAULT.get(Tunable.SPECULATIVE_FRACTION) * inner(s);
        while (s.d.y > .79) {
            s.d.y -= 1e-5;
            run(s);
            double gap = s.d.y - .8;
            assertEquals(gap <= margin ? 4 : 0, rows.pointCount[0], "gap " + gap + " m");
        }
    }

    /** A cube slides over the edges of one below it, by small fractions of the share in a tick. */
    @Test
    void supportEndsWhereTheEdgeIs() {
        Scene s =
                new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5))
                        .at(-.01, 1 - 1e-5, .2);
        begin(s);
        double share = SHARE * .5;
        double onEdge = 1e-3 * .5;
        int kept = 0;
        int ticks = 0;
        for (; s.d.x < .02; s.d.x += share / 7, ticks++) {
            kept += recycled(s) ? 1 : 0;
            double high = -1;
            double low = 1;
            for (int p = 0; p < rows.pointCount[0]; p++) {
                high = Math.max(high, rows.anchorAX(p));
                low = Math.min(low, rows.anchorAX(p));
            }
            String where = "B at " + s.d.x + " m";
            assertEquals(4, rows.pointCount[0], where);
            assertEquals(Math.min(.5, s.d.x + .5), high, share + onEdge, where);
            assertEquals(Math.max(-.5, s.d.x - .5), low, share + onEdge, where);
        }
        assertTrue(kept > ticks / 2 && kept < ticks, kept + " of " + ticks);
    }
}
