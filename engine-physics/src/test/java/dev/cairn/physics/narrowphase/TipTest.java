package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.SplittableRandom;

/** The tip of a cone has a name of its own in each contact, and no other point of it has. */
class TipTest {
    private static final Cone CONE = Cone.of(.4, .5);

    private final NarrowPhase narrowPhase = new NarrowPhase();
    private final Manifold out = new Manifold();

    /** Points of a cone above another shape, in either order, that are its tip. */
    private int tips(Shape cone, Quaterniond q, double height, Shape below, Quaterniond p) {
        int tips = 0;
        for (int order = 0; order < 2; order++) {
            boolean second = order == 1;
            Quaterniond a = second ? p : q;
            Quaterniond b = second ? q : p;
            narrowPhase.collide(
                    second ? below : cone,
                    second ? cone : below,
                    a.x,
                    a.y,
                    a.z,
                    a.w,
                    b.x,
                    b.y,
                    b.z,
                    b.w,
                    0,
                    second ? height : -height,
                    0,
                    0.05,
                    0,
                    out);
            assertTrue(out.pointCount > 0, "they must touch");
            int here = 0;
            for (int i = 0; i < out.pointCount; i++) {
                here += Surface.isCorner(Surface.of(cone), out.feature[i], second) ? 1 : 0;
                assertFalse(
                        Surface.isCorner(Surface.of(cone), out.feature[i], !second),
                        "it is not the other shape's");
            }
            assertTrue(order == 0 || here == tips, "not in either order");
            tips = here;
        }
        return tips;
    }

    @Test
    void aTipIsToldWhateverItTouches() {
        Quaterniond down = new Quaterniond().rotationZ(Math.PI - 0.35);
        Quaterniond back = new Quaterniond().rotationXYZ(1, 2, 3);
        Shape turned = CONE.moved(1, 2, 3, back.conjugate(new Quaterniond()));
        // the apex is at 3/4 of the height from the centre, so this far above what it touches
        double up = 0.75 * StrictMath.cos(0.35);
        Quaterniond straight = new Quaterniond();
        List<Shape> flats =
                List.of(
                        Box.ofHalfExtents(2, .5, 2),
                        ConvexHull.of(
                                new double[] {
                                    -2, -1.5, -2, 2, -1.5, -2, -2, -1.5, 2, 2, -1.5, 2, -2, .5, -2,
                                    2, .5, -2, -2, .5, 2, 2, .5, 2
                                }));
        for (Shape cone : new Shape[] {CONE, turned}) {
            Quaterniond q = cone == CONE ? down : down.mul(back, new Quaterniond());
            Quaterniond over = cone == CONE ? straight : back;
            assertEquals(1, tips(cone, q, up, HalfSpace.of(), straight), "plane");
            for (Shape flat : flats) {
                double top = .5 + (flat == flats.get(0) ? 0 : -flat.centreOfMass(new Vector3d()).y);
                assertEquals(1, tips(cone, q, up + top, flat, straight), "face");
            }
            assertEquals(0, tips(cone, over, .25, HalfSpace.of(), straight), "base");
        }
    }

    /** On a box in any pose; where edges are crossed just at the tip, either name is right. */
    @Test
    void pointsAtTheTipAreToldAndNoOthers() {
        long seed = 20261124;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        Box box = Box.ofHalfExtents(.5, .4, .3);
        int there = 0;
        int wrong = 0;
        for (int n = 0; n < 60_000; n++) {
            Quaterniond q = Scene.turn(random);
            Quaterniond p = Scene.turn(random);
            Vector3d at = Scene.direction(random).mul(0.4 + 0.9 * random.nextDouble());
            narrowPhase.collide(
                    CONE, box, q.x, q.y, q.z, q.w, p.x, p.y, p.z, p.w, at.x, at.y, at.z, 0.05, 0,
                    out);
            Vector3d tip = q.transform(new Vector3d(0, 0.75, 0));
            for (int i = 0; i < out.pointCount; i++) {
                double half = 0.5 * out.separation[i];
                double x = out.pointX[i] - half * out.normalX;
                double y = out.pointY[i] - half * out.normalY;
                double z = out.pointZ[i] - half * out.normalZ;
                boolean isThere = tip.distance(x, y, z) < 1e-9;
                there += isThere ? 1 : 0;
                wrong += isThere != Surface.isCorner(Surface.TIPPED, out.feature[i], false) ? 1 : 0;
            }
        }
        assertTrue(there > 1000, "points at the tip: " + there);
        assertTrue(wrong <= 0.001 * there, wrong + " wrong of " + there);
    }
}
