package dev.cairn.physics.prediction;

import static dev.cairn.physics.internal.ContactColumns.ANCHORS;
import static dev.cairn.physics.internal.ContactColumns.HEAD;
import static dev.cairn.physics.internal.ContactColumns.KEPT;
import static dev.cairn.physics.internal.ContactColumns.POINTS;

import dev.cairn.core.state.StateColumns;
import dev.cairn.physics.internal.ContactColumns;
import dev.cairn.physics.shape.Shape;

/**
 * Predicts normal, anchors and separations of a row. With a and b the anchors of point p, s its
 * separation and n the normal: of a face of a polyhedron and what lies on it, {@link FacePoints}
 * makes all from the poses at the start of the tick. Otherwise a is kept, and as both anchors are
 * one point midway between the surfaces, of which one is a plane,
 *
 * <pre>
 *   b[p] = a[p] - (from A to B)   or   b[0] + (a[p] - a[0]), where the poses are not known
 *   s[p] ~ s[0] + 2 n . (a[p] - a[0])
 * </pre>
 *
 * but for rounding. What is kept is the difference of the bits of both sides. Each number is
 * guessed from ones that were found before it, so that the same walk goes both ways.
 */
final class ContactPredictor {
    private final StateColumns state;
    private final BodyColumns bodies;
    private final RowColumns rows;
    private final boolean packs;
    private final FacePoints face = new FacePoints();
    private final double[] normal = new double[3];
    private final double[] first = new double[ANCHORS];
    private final double[] point = new double[ANCHORS];

    /** From A's centre to B's at the start of the tick. */
    private final double[] apart = new double[3];

    ContactPredictor(StateColumns state, BodyColumns bodies, RowColumns rows, boolean packs) {
        this.state = state;
        this.bodies = bodies;
        this.rows = rows;
        this.packs = packs;
    }

    /** Packs or unpacks one. */
    void row(int row) {
        if (rows.points(row) == 0) {
            return;
        }
        int a = rows.colliderA(row);
        int b = rows.colliderB(row);
        Shape shapeA = bodies.shape(a);
        Shape shapeB = bodies.shape(b);
        boolean areKnown = shapeA != null && shapeB != null;
        for (int k = 0; areKnown && k < 3; k++) {
            apart[k] = bodies.began(b, k) - bodies.began(a, k);
        }
        boolean isFace =
                shapeA != null
                        && shapeB != null
                        && face.begin(
                                bodies,
                                a,
                                shapeA,
                                b,
                                shapeB,
                                apart,
                                rows.cache(row),
                                rows.feature(POINTS * row));
        for (int k = 0; k < 3; k++) {
            int i = HEAD * row + k;
            normal[k] = isFace ? next(rows.head, i, face.normal[k]) : state.number(rows.head, i);
        }
        friction(row);
        double firstGap = 0;
        for (int p = 0; p < rows.points(row); p++) {
            int i = ANCHORS * (POINTS * row + p);
            boolean isFound = isFace && find(row, p);
            double along = 0;
            for (int k = 0; k < 3; k++) {
                point[k] =
                        isFound
                                ? next(rows.anchors, i + k, face.point[k])
                                : state.number(rows.anchors, i + k);
                first[k] = p == 0 ? point[k] : first[k];
                double moved = point[k] - first[k];
                along += normal[k] * moved;
                double other = areKnown ? point[k] - apart[k] : first[k + 3] + moved;
                point[k + 3] = next(rows.anchors, i + k + 3, other);
                first[k + 3] = p == 0 ? point[k + 3] : first[k + 3];
            }
            double gap = isFound ? face.separation : firstGap + 2 * along;
            gap = next(rows.separation, POINTS * row + p, gap);
            firstGap = p == 0 ? gap : firstGap;
        }
    }

    private boolean find(int row, int p) {
        if (!rows.keeps(row)) {
            return face.find(rows.feature(POINTS * row + p));
        }
        int i = KEPT * row + ContactColumns.KEPT_POINT + 3 * p;
        face.keep(
                state.number(rows.kept, i),
                state.number(rows.kept, i + 1),
                state.number(rows.kept, i + 2));
        return true;
    }

    /** Of friction, which lies across the normal, the part along its largest component. */
    private void friction(int row) {
        double x = Math.abs(normal[0]);
        double y = Math.abs(normal[1]);
        double z = Math.abs(normal[2]);
        int k = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        int i = HEAD * row + ContactColumns.FRICTION_IMPULSE;
        int u = (k + 1) % 3;
        int v = (k + 2) % 3;
        double across =
                normal[u] * state.number(rows.head, i + u)
                        + normal[v] * state.number(rows.head, i + v);
        next(rows.head, i + k, -across / normal[k]);
    }

    private double next(int column, int i, double guess) {
        return PredictedValues.next(state, column, i, guess, packs);
    }
}
