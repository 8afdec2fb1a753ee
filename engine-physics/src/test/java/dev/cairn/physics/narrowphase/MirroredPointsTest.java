package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.box.BoxContacts;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.oracle.ShapeKind;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;

import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;

/**
 * The points of a contact in a mirror are the mirrored points, bit for bit, in any order: boxes and
 * hulls in every sort of pose, mirrored in x, y and z. But for concentric ones, of which opposite
 * faces are equally good and no rule that a mirror shares can tell one.
 */
class MirroredPointsTest {
    private static final int POSES = 4_000;

    /** One point: place and separation. */
    private record Point(double x, double y, double z, double separation) {}

    private final NarrowPhase narrowPhase = new NarrowPhase();
    private final BoxContacts batch = new BoxContacts(new NarrowPhase());

    static List<ShapeKind.Two> pairs() {
        return List.of(
                new ShapeKind.Two(ShapeKind.BOX, ShapeKind.BOX),
                new ShapeKind.Two(ShapeKind.BOX, ShapeKind.HULL),
                new ShapeKind.Two(ShapeKind.HULL, ShapeKind.BOX),
                new ShapeKind.Two(ShapeKind.HULL, ShapeKind.HULL));
    }

    private static double margin(Scene s) {
        return .02 * Math.min(s.a.innerRadius(), s.b.innerRadius());
    }

    private static List<Point> points(Manifold m, int axis) {
        List<Point> points = new ArrayList<>();
        for (int p = 0; p < m.pointCount; p++) {
            Vector3d v = new Vector3d(m.pointX[p], m.pointY[p], m.pointZ[p]);
            v = axis < 0 ? v : ShapeKind.mirrored(v, axis);
            // A zero more takes the sign of a zero off.
            points.add(new Point(v.x + 0.0, v.y + 0.0, v.z + 0.0, m.separation[p] + 0.0));
        }
        points.sort(
                Comparator.comparingDouble(Point::x)
                        .thenComparingDouble(Point::y)
                        .thenComparingDouble(Point::z)
                        .thenComparingDouble(Point::separation));
        return points;
    }

    private List<Point> single(Scene s, int axis) {
        Manifold m = new Manifold();
        s.collide(narrowPhase, margin(s), 0, m);
        return points(m, axis);
    }

    private List<Point> batched(Scene s, int axis, boolean lanes) {
        Manifold m = new Manifold();
        double inner = Math.min(s.a.innerRadius(), s.b.innerRadius());
        batch.put(
                0, (Box) s.a, (Box) s.b, s.qa.x, s.qa.y, s.qa.z, s.qa.w, s.qb.x, s.qb.y, s.qb.z,
                s.qb.w, s.d.x, s.d.y, s.d.z, inner, margin(s), 0);
        batch.useLanes(lanes);
        batch.run(1);
        batch.take(0, (Box) s.a, (Box) s.b, m);
        return points(m, axis);
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void pointsInAMirrorAreTheMirroredPoints(ShapeKind.Two kinds) {
        SplittableRandom r = new SplittableRandom(204);
        int several = 0;
        for (int i = 0; i < POSES; i++) {
            EveryPairTest.Sort sort = EveryPairTest.Sort.values()[i % 7];
            Scene s = sort.scene(r, kinds);
            if (sort == EveryPairTest.Sort.CONCENTRIC) {
                continue;
            }
            List<Point> points = single(s, -1);
            several += points.size() > 1 ? 1 : 0;
            for (int axis = 0; axis < 3; axis++) {
                Scene t = ShapeKind.mirrored(s, axis);
                String where = kinds + " " + sort + " seed 204 pose " + i + " axis " + axis;
                assertEquals(points, single(t, axis), where);
                if (s.a instanceof Box && s.b instanceof Box) {
                    assertEquals(points, batched(t, axis, i % 2 == 0), where + " in a batch");
                }
            }
        }
        assertTrue(several > POSES / 10, kinds + ": " + several + " contacts of several points");
    }
}
