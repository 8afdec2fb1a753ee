package dev.cairn.physics.shape.union;

import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.polyhedron.Polyhedron;
import dev.cairn.physics.shape.union.ConvexUnion.Piece;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Polyhedra that make larger convex ones: all of them at once, or else by twos that have a face in
 * common, until no two do. Hulls are made only of pieces that face each other, so a body of pieces
 * that have nothing in common costs comparisons of faces.
 */
final class HullUnion {
    /** Square of the distance of unit vectors that are the same normal. */
    private static final double SAME = 0x1p-40;

    private final List<Piece> pieces;
    private final double tolerance;

    /**
     * By piece: its corners, and its faces as planes n . x = d with the places of their corners.
     */
    private final List<double[]> corners = new ArrayList<>();

    private final List<double[]> planes = new ArrayList<>();
    private final List<int[][]> loops = new ArrayList<>();

    private HullUnion(List<Piece> pieces, double tolerance) {
        this.pieces = pieces;
        this.tolerance = tolerance;
        for (Piece p : pieces) {
            note(p);
        }
    }

    /** Replaces pieces by what they make. */
    static void join(List<Piece> pieces, double tolerance) {
        if (pieces.size() < 2 || pieces.stream().allMatch(p -> p.shape instanceof Box)) {
            return;
        }
        HullUnion union = new HullUnion(pieces, tolerance);
        if (!union.joinAll()) {
            union.joinTwos();
        }
    }

    private void note(Piece p) {
        Polyhedron h = Polyhedron.of(p.shape);
        double[] q = p.pose;
        double[] v = new double[3];
        double[] at = new double[3 * h.vertexCount()];
        for (int i = 0; i < h.vertexCount(); i++) {
            Rotations.rotate(q[3], q[4], q[5], q[6], h.vertexX(i), h.vertexY(i), h.vertexZ(i), v);
            for (int axis = 0; axis < 3; axis++) {
                at[3 * i + axis] = v[axis] + q[axis];
            }
        }
        double[] of = new double[4 * h.faceCount()];
        for (int f = 0; f < h.faceCount(); f++) {
            Rotations.rotate(q[3], q[4], q[5], q[6], h.normalX(f), h.normalY(f), h.normalZ(f), v);
            System.arraycopy(v, 0, of, 4 * f, 3);
            of[4 * f + 3] = h.offset(f) + v[0] * q[0] + v[1] * q[1] + v[2] * q[2];
        }
        corners.add(at);
        planes.add(of);
        loops.add(h.faceLoops());
    }

    private boolean joinAll() {
        for (int i = 0; i < pieces.size(); i++) {
            boolean faces = false;
            for (int j = 0; j < pieces.size() && !faces; j++) {
                faces = j != i && facing(i, j, false);
            }
            if (!faces) {
                return false;
            }
        }
        int[] all = new int[pieces.size()];
        Arrays.setAll(all, i -> i);
        Piece whole = make(all);
        for (int i = 0; whole != null && i < all.length; i++) {
            for (int j = 0; j < i; j++) {
                if (!isApart(i, j) && !isApart(j, i)) {
                    return false;
                }
            }
        }
        if (whole == null) {
            return false;
        }
        pieces.clear();
        pieces.add(whole);
        return true;
    }

    private void joinTwos() {
        for (int i = 0; i < pieces.size(); i++) {
            for (int j = i + 1; j < pieces.size(); j++) {
                Piece both = facing(i, j, true) ? make(new int[] {i, j}) : null;
                if (both != null) {
                    drop(j);
                    drop(i);
                    pieces.add(i, both);
                    insert(i, both);
                    i = 0; // all are asked anew
                    j = 0;
                }
            }
        }
    }

    private void drop(int i) {
        pieces.remove(i);
        corners.remove(i);
        planes.remove(i);
        loops.remove(i);
    }

    private void insert(int i, Piece p) {
        note(p);
        int last = corners.size() - 1;
        corners.add(i, corners.remove(last));
        planes.add(i, planes.remove(last));
        loops.add(i, loops.remove(last));
    }

    /** Whether a face of one piece lies against one of another, of the same corners if so asked. */
    private boolean facing(int i, int j, boolean whole) {
        double[] a = planes.get(i);
        double[] b = planes.get(j);
        for (int f = 0; f < a.length; f += 4) {
            for (int g = 0; g < b.length; g += 4) {
                double x = a[f] + b[g];
                double y = a[f + 1] + b[g + 1];
                double z = a[f + 2] + b[g + 2];
                if (x * x + y * y + z * z <= SAME
                        && Math.abs(a[f + 3] + b[g + 3]) <= tolerance
                        && (!whole || (holds(i, f / 4, j, g / 4) && holds(j, g / 4, i, f / 4)))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether each corner of a face of i is one of a face of j. */
    private boolean holds(int i, int f, int j, int g) {
        double[] of = corners.get(i);
        double[] among = corners.get(j);
        for (int v : loops.get(i)[f]) {
            boolean found = false;
            for (int w : loops.get(j)[g]) {
                double x = of[3 * v] - among[3 * w];
                double y = of[3 * v + 1] - among[3 * w + 1];
                double z = of[3 * v + 2] - among[3 * w + 2];
                found |= x * x + y * y + z * z <= tolerance * tolerance;
            }
            if (!found) {
                return false;
            }
        }
        return true;
    }

    /** Whether a face of i has all of j before it. */
    private boolean isApart(int i, int j) {
        double[] plane = planes.get(i);
        double[] of = corners.get(j);
        for (int f = 0; f < plane.length; f += 4) {
            double least = Double.POSITIVE_INFINITY;
            for (int v = 0; v < of.length; v += 3) {
                double height =
                        plane[f] * of[v] + plane[f + 1] * of[v + 1] + plane[f + 2] * of[v + 2];
                least = Math.min(least, height - plane[f + 3]);
            }
            if (least >= -tolerance) {
                return true;
            }
        }
        return false;
    }

    /** The hull of pieces, if it has the volume of all of them. */
    private @Nullable Piece make(int[] group) {
        int count = 0;
        double volume = 0;
        List<Piece> of = new ArrayList<>();
        for (int i : group) {
            of.add(pieces.get(i));
            count += corners.get(i).length;
            volume += pieces.get(i).volume();
        }
        double[] points = new double[count];
        int at = 0;
        for (int i : group) {
            System.arraycopy(corners.get(i), 0, points, at, corners.get(i).length);
            at += corners.get(i).length;
        }
        ConvexHull hull = ConvexHull.of(points);
        if (Math.abs(hull.volume() - volume) > ConvexUnion.NO_VOLUME * volume) {
            return null;
        }
        return simplest(Piece.members(of), hull);
    }

    /** Without the corners that are inside of faces and edges; a box where it is one. */
    private Piece simplest(int[] members, ConvexHull hull) {
        double[] distinct = distinct(hull);
        double[] vertices = hull.vertices();
        double[] kept = new double[vertices.length];
        int count = 0;
        for (int v = 0; v < vertices.length; v += 3) {
            int on = 0;
            for (int p = 0; p < distinct.length; p += 4) {
                double height =
                        distinct[p] * vertices[v]
                                + distinct[p + 1] * vertices[v + 1]
                                + distinct[p + 2] * vertices[v + 2]
                                - distinct[p + 3];
                on += Math.abs(height) <= tolerance ? 1 : 0;
            }
            if (on > 2) {
                System.arraycopy(vertices, v, kept, count, 3);
                count += 3;
            }
        }
        kept = Arrays.copyOf(kept, count);
        Piece box = box(members, distinct, kept);
        if (box != null) {
            return box;
        }
        ConvexHull simple = ConvexHull.of(kept);
        Vector3d c = simple.centreOfMass(new Vector3d());
        return new Piece(members, simple, new double[] {c.x, c.y, c.z, 0, 0, 0, 1});
    }

    /** The planes of a hull's faces, each once. */
    private double[] distinct(ConvexHull hull) {
        Polyhedron h = Polyhedron.of(hull);
        Vector3d c = hull.centreOfMass(new Vector3d());
        double[] planes = new double[4 * h.faceCount()];
        int count = 0;
        for (int f = 0; f < h.faceCount(); f++) {
            double x = h.normalX(f);
            double y = h.normalY(f);
            double z = h.normalZ(f);
            boolean known = false;
            for (int p = 0; p < count; p += 4) {
                double dx = planes[p] - x;
                double dy = planes[p + 1] - y;
                double dz = planes[p + 2] - z;
                known |= dx * dx + dy * dy + dz * dz <= SAME;
            }
            if (!known) {
                planes[count++] = x;
                planes[count++] = y;
                planes[count++] = z;
                planes[count++] = h.offset(f) + x * c.x + y * c.y + z * c.z;
            }
        }
        return Arrays.copyOf(planes, count);
    }

    /** Three pairs of planes across each other, eight corners: a box. */
    private static @Nullable Piece box(int[] members, double[] planes, double[] vertices) {
        if (planes.length != 24 || vertices.length != 24) {
            return null;
        }
        int second = -1;
        for (int p = 4; p < planes.length; p += 4) {
            double cosine = dot(planes, 0, planes, p);
            if (cosine * cosine < SAME) {
                second = second < 0 ? p : second;
            } else if (cosine > -1 + SAME) {
                return null;
            }
        }
        double x = planes[0];
        double y = planes[1];
        double z = planes[2];
        double u = planes[second];
        double v = planes[second + 1];
        double w = planes[second + 2];
        double[] m = {x, u, y * w - z * v, y, v, z * u - x * w, z, w, x * v - y * u};
        double[] q = BoxUnion.nearest(quaternion(m));
        double[] pose = {0, 0, 0, q[0], q[1], q[2], q[3]};
        double[] centre = new double[3];
        double[] half = new double[3];
        double[] axis = new double[3];
        for (int k = 0; k < 3; k++) {
            Rotations.rotate(
                    q[0], q[1], q[2], q[3], k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0, axis);
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < vertices.length; i += 3) {
                double height = dot(axis, 0, vertices, i);
                least = Math.min(least, height);
                most = Math.max(most, height);
            }
            centre[k] = (least + most) / 2;
            half[k] = (most - least) / 2;
        }
        Rotations.rotate(q[0], q[1], q[2], q[3], centre[0], centre[1], centre[2], axis);
        System.arraycopy(axis, 0, pose, 0, 3);
        return new Piece(members, Box.ofHalfExtents(half[0], half[1], half[2]), pose);
    }

    private static double dot(double[] a, int i, double[] b, int j) {
        return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2];
    }

    /** Of a rotation matrix, row by row; by its largest component. */
    private static double[] quaternion(double[] m) {
        double[] squares = {
            1 + m[0] - m[4] - m[8],
            1 - m[0] + m[4] - m[8],
            1 - m[0] - m[4] + m[8],
            1 + m[0] + m[4] + m[8]
        };
        int k = 0;
        for (int i = 1; i < 4; i++) {
            k = squares[i] > squares[k] ? i : k;
        }
        double s = Math.sqrt(squares[k]);
        double f = 0.5 / s;
        double yz = m[7] - m[5];
        double zx = m[2] - m[6];
        double xy = m[3] - m[1];
        double[] q =
                switch (k) {
                    case 0 -> of(0.5 * s, f * (m[1] + m[3]), f * (m[2] + m[6]), f * yz);
                    case 1 -> of(f * (m[1] + m[3]), 0.5 * s, f * (m[5] + m[7]), f * zx);
                    case 2 -> of(f * (m[2] + m[6]), f * (m[5] + m[7]), 0.5 * s, f * xy);
                    default -> of(f * yz, f * zx, f * xy, 0.5 * s);
                };
        double scale = 1 / Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int i = 0; i < 4; i++) {
            q[i] *= scale;
        }
        return q;
    }

    private static double[] of(double x, double y, double z, double w) {
        return new double[] {x, y, z, w};
    }
}
