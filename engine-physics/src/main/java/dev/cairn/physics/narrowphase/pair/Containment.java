package dev.cairn.physics.narrowphase.pair;

import dev.cairn.physics.shape.polyhedron.Polyhedron;

/** How far points are inside polyhedra, and how deep a pair is because of that. */
public final class Containment {
    /** The face that the point of the last {@link #within} is nearest to. */
    public int nearest;

    /** How deep a point of the one shape is inside the other; minus infinity when it is not. */
    public double within(Polyhedron h, double x, double y, double z) {
        double least = Double.MAX_VALUE;
        int faces = h.faceCount();
        for (int f = 0; f < faces; f++) {
            double s = h.offset(f) - (h.normalX(f) * x + h.normalY(f) * y + h.normalZ(f) * z);
            if (s < least) {
                least = s;
                nearest = f;
            }
        }
        return least >= 0 ? least : Double.NEGATIVE_INFINITY;
    }

    /** How far inside all sides of a face the foot of a point is. */
    public static double face(Polyhedron h, int face, double x, double y, double z) {
        double least = Double.MAX_VALUE;
        int end = h.faceBegin(face + 1);
        for (int i = h.faceBegin(face); i < end; i++) {
            double s = h.sideOffset(i) - (h.sideX(i) * x + h.sideY(i) * y + h.sideZ(i) * z);
            least = s < least ? s : least;
        }
        return least;
    }

    /** The lower bound of the depth from a disc and the ball; see {@code WarmContact}. */
    public static double depth(Pair pair, double d, double r, double high, double beside) {
        double radii = pair.a.innerRadius() + pair.b.innerRadius();
        double k = (radii - r - beside) / (high + d);
        double least = Math.min(d, (r + k * d) / Math.sqrt(1 + k * k));
        return least <= high ? least : 0;
    }
}
