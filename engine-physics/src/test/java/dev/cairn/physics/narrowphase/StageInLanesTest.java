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
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.wide.BoxAxes;
import dev.cairn.physics.narrowphase.wide.BoxWarmUp;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.tuning.Tuning;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * The stage gives each row the same bits whether its rows go in one lot, which is large enough for
 * lanes, or in lots that are not; rows that hardly move, that move, and that are apart, mixed.
 */
@Tag("compiled")
class StageInLanesTest {
    private static final double STEP = 1.0 / 60.0;
    private static final int ROWS = 640;
    private static final int LOT = 160;
    private static final int TICKS = 12;

    /** Rows with their own bodies. */
    private static final class Lots {
        final BodyStore bodies = new BodyStore();
        final ColliderStore colliders = new ColliderStore(bodies);
        final ContactStore rows = new ContactStore();
        final BoundsStage bounds = new BoundsStage(colliders, Tuning.DEFAULT);
        final ManifoldStage stage = new ManifoldStage(colliders, bounds);
        final int lot;

        Lots(Scene[] scenes, int lot) {
            this.lot = lot;
            bodies.ensureCapacity(2 * ROWS);
            bodies.slotCount = 2 * ROWS;
            bounds.ensureSlots(2 * ROWS);
            rows.ensureCapacity(ROWS);
            rows.count = ROWS;
            for (int row = 0; row < ROWS; row++) {
                colliders.attach(2 * row, scenes[row].a);
                colliders.attach(2 * row + 1, scenes[row].b);
                ContactMaterials.join(rows, row, colliders, 2 * row, 2 * row + 1);
            }
        }

        void turn(int slot, Quaterniond q) {
            bodies.orientationX[slot] = q.x;
            bodies.orientationY[slot] = q.y;
            bodies.orientationZ[slot] = q.z;
            bodies.orientationW[slot] = q.w;
        }

        void run(Scene[] scenes, int first, Jobs jobs) {
            for (int row = 0; row < ROWS; row++) {
                Scene s = scenes[row];
                turn(2 * row, s.qa);
                turn(2 * row + 1, s.qb);
                bodies.positionX[2 * row + 1] = s.d.x;
                bodies.positionY[2 * row + 1] = s.d.y;
                bodies.positionZ[2 * row + 1] = s.d.z;
            }
            for (int begin = first; begin < ROWS; begin += lot) {
                rows.activeCount = Math.min(lot, ROWS - begin);
                for (int i = 0; i < rows.activeCount; i++) {
                    rows.active[i] = begin + i;
                }
                stage.run(rows, STEP, jobs);
            }
        }
    }

    private static Scene boxes(SplittableRandom r) {
        Box a = Scene.box(r);
        Box b = Scene.box(r);
        Scene s = new Scene(a, b);
        double beside = r.nextInt(3) * .4 * (2 * r.nextDouble() - 1);
        double inner = Math.min(a.innerRadius(), b.innerRadius());
        double gap = inner * (r.nextInt(5) == 0 ? .1 : -1e-3);
        s.at(beside * (a.halfX() + b.halfX()), a.halfY() + b.halfY() + gap, .2 * Scene.gauss(r));
        s.qb.rotateXYZ(1e-6 * Scene.gauss(r), r.nextInt(2) * .1, 1e-6 * Scene.gauss(r));
        Quaterniond turn = Scene.turn(r);
        turn.transform(s.d);
        s.qa.premul(turn);
        s.qb.premul(turn);
        return r.nextBoolean() ? s : s.swapped();
    }

    private static void sway(Scene s, SplittableRandom r, boolean rest) {
        double share = rest ? 1e-7 : 1e-3;
        Vector3d way = Scene.direction(r);
        s.d.fma(share * Math.min(s.a.innerRadius(), s.b.innerRadius()), way);
        s.qb.rotateXYZ(share * Scene.gauss(r), share * Scene.gauss(r), share * Scene.gauss(r));
        s.qb.normalize();
    }

    private static void same(ContactStore expected, ContactStore actual, int row, String where) {
        assertEquals(expected.pointCount[row], actual.pointCount[row], where);
        assertEquals(expected.cache[row], actual.cache[row], where);
        assertEquals(expected.keeps[row], actual.keeps[row], where);
        if (expected.pointCount[row] > 0) {
            assertEquals(expected.normalX(row), actual.normalX(row), 0.0, where);
            assertEquals(expected.normalY(row), actual.normalY(row), 0.0, where);
            assertEquals(expected.normalZ(row), actual.normalZ(row), 0.0, where);
        }
        int first = ContactStore.POINTS * row;
        for (int p = first; p < first + expected.pointCount[row]; p++) {
            assertEquals(expected.feature[p], actual.feature[p], where);
            assertEquals(expected.separation[p], actual.separation[p], 0.0, where);
            assertEquals(expected.normalImpulse[p], actual.normalImpulse[p], 0.0, where);
            for (int k = 0; k < ContactStore.ANCHORS; k++) {
                int at = ContactStore.anchor(p) + k;
                assertEquals(expected.anchors[at], actual.anchors[at], 0.0, where);
            }
        }
    }

    /** The first row of a lot is not always the first of a group that is kept together. */
    @Test
    void aLotInLanesIsTheSameAsSmallLots() {
        boolean compiled = BoxWarmUp.await();
        assertTrue(compiled || !BoxAxes.wide(), "the kernels were not compiled");
        SplittableRandom r = new SplittableRandom(81);
        Scene[] scenes = new Scene[ROWS];
        for (int row = 0; row < ROWS; row++) {
            scenes[row] = boxes(r);
        }
        Lots together = new Lots(scenes, ROWS);
        Lots apart = new Lots(scenes, LOT);
        int touching = 0;
        int kept = 0;
        try (Jobs jobs = Jobs.of(1)) {
            for (int tick = 0; tick < TICKS; tick++) {
                int first = tick % 7;
                together.run(scenes, first, jobs);
                apart.run(scenes, first, jobs);
                for (int row = first; row < ROWS; row++) {
                    String where = "seed 81 tick " + tick + " row " + row;
                    same(apart.rows, together.rows, row, where);
                    touching += together.rows.pointCount[row] > 0 ? 1 : 0;
                    kept += together.rows.keeps[row] ? 1 : 0;
                    for (int p = 0; p < ContactStore.POINTS; p++) {
                        int at = ContactStore.POINTS * row + p;
                        apart.rows.normalImpulse[at] = 1 + p;
                        together.rows.normalImpulse[at] = 1 + p;
                    }
                }
                for (int row = 0; row < ROWS; row++) {
                    sway(scenes[row], r, r.nextInt(20) > 0);
                }
            }
        }
        assertTrue(touching > 3000, touching + " contacts");
        assertTrue(kept > 3000, kept + " kept");
    }
}
