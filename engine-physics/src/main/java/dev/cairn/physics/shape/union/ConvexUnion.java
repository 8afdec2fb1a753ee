package dev.cairn.physics.shape.union;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedral;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Several boxes or hulls of a body whose union is convex, as one shape. Boxes that share axes are
 * put together first, see {@code BoxUnion}; what is left as polyhedra, see {@code HullUnion}. A
 * union is convex if its parts do not overlap and its hull has the volume of all of them.
 *
 * <p>Lengths that are 2^-20 of the smallest part's inner radius apart are equal. Immutable.
 */
public final class ConvexUnion {
    /** Of the inner radius of the smallest part: coordinates that were rounded. */
    static final double FLUSH = 0x1p-20;

    /** Share of a volume that is none. */
    static final double NO_VOLUME = 1e-9;

    /** Numbers of a pose. */
    private static final int POSE = 7;

    private final int[] members;
    private final Shape shape;
    private final double[] pose;

    private ConvexUnion(int[] members, Shape shape, double[] pose) {
        this.members = members;
        this.shape = shape;
        this.pose = pose;
    }

    /**
     * Which parts it is of.
     *
     * @return places in the lists, ascending; at least two; not to be changed
     */
    public int[] members() {
        return members;
    }

    /**
     * What they make.
     *
     * @return a box if it is one, or a hull, about its centre
     */
    public Shape shape() {
        return shape;
    }

    /**
     * Where its centre is, and how it is turned, as the parts' were told.
     *
     * @return m, unit quaternion; not to be changed
     */
    public double[] pose() {
        return pose;
    }

    /**
     * The shape where it is among the parts.
     *
     * @return moved and turned
     */
    public Shape placed() {
        double[] p = pose;
        boolean isMoved = false;
        for (int i = 0; i < POSE - 1; i++) {
            isMoved |= p[i] != 0;
        }
        Quaterniond turn = new Quaterniond(p[3], p[4], p[5], p[6]);
        Vector3d centre = shape.centreOfMass(new Vector3d());
        turn.transform(centre);
        return isMoved
                ? shape.moved(p[0] - centre.x, p[1] - centre.y, p[2] - centre.z, turn)
                : shape;
    }

    /**
     * Whether a shape is what this one is.
     *
     * @param other a union of before
     * @return whether no number of it differs
     */
    public boolean isOf(Shape other) {
        if (shape instanceof Box a && other instanceof Box b) {
            return a.halfX() == b.halfX() && a.halfY() == b.halfY() && a.halfZ() == b.halfZ();
        }
        return shape instanceof ConvexHull a
                && other instanceof ConvexHull b
                && Arrays.equals(a.vertices(), b.vertices());
    }

    /**
     * Finds unions. Allocates.
     *
     * @param shapes of the parts, neither moved nor turned
     * @param poses of their centres: m, unit quaternion
     * @param like parts of one number may be put together; negative: with none
     * @return those of two and more parts, in the order of their first ones; a part is in one at
     *     most
     */
    public static List<ConvexUnion> of(List<Shape> shapes, List<double[]> poses, int[] like) {
        List<ConvexUnion> found = new ArrayList<>();
        for (int kind = 0; kind < like.length; kind++) {
            List<Piece> pieces = new ArrayList<>();
            double least = Double.POSITIVE_INFINITY;
            for (int i = kind; i < like.length; i++) {
                if (like[i] == kind && isSolid(shapes.get(i))) {
                    pieces.add(new Piece(new int[] {i}, (Polyhedral) shapes.get(i), poses.get(i)));
                    least = Math.min(least, shapes.get(i).innerRadius());
                }
            }
            if (pieces.size() < 2) {
                continue;
            }
            BoxUnion.join(pieces, FLUSH * least);
            HullUnion.join(pieces, FLUSH * least);
            for (Piece p : pieces) {
                if (p.members.length > 1) {
                    int[] members = p.members.clone();
                    Arrays.sort(members);
                    found.add(new ConvexUnion(members, (Shape) p.shape, p.pose.clone()));
                }
            }
        }
        found.sort((a, b) -> Integer.compare(a.members[0], b.members[0]));
        return found;
    }

    /**
     * Whether a shape may be a part of a union.
     *
     * @param shape any
     * @return true for boxes, and hulls with an inside
     */
    public static boolean isSolid(Shape shape) {
        return shape instanceof Box || (shape instanceof ConvexHull hull && hull.volume() > 0);
    }

    /** A convex part, or what some make. */
    static final class Piece {
        final int[] members;
        final Polyhedral shape;
        final double[] pose;

        Piece(int[] members, Polyhedral shape, double[] pose) {
            assert pose.length == POSE : "a pose of " + pose.length + " numbers";
            this.members = members;
            this.shape = shape;
            this.pose = pose;
        }

        double volume() {
            return ((Shape) shape).volume();
        }

        static int[] members(List<Piece> all) {
            int[] members = {};
            for (Piece p : all) {
                int before = members.length;
                members = Arrays.copyOf(members, before + p.members.length);
                System.arraycopy(p.members, 0, members, before, p.members.length);
            }
            return members;
        }
    }
}
