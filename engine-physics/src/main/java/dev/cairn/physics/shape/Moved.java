package dev.cairn.physics.shape;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * A shape at another place and turned in the shape frame: what {@link Shape#moved} makes. The
 * centre of mass moves along, so that in the frame of the centre of mass, in which the engine
 * computes, only the rotation is left.
 */
public final class Moved implements Shape {
    private final Shape inner;
    private final double x, y, z;

    /** Unit quaternion: frame of this shape from frame of the inner one. */
    private final double qx, qy, qz, qw;

    /** Centre of mass in the frame of this shape, m. */
    private final double comX, comY, comZ;

    Moved(Shape inner, double x, double y, double z, double qx, double qy, double qz, double qw) {
        this.inner = inner;
        this.x = x;
        this.y = y;
        this.z = z;
        this.qx = qx;
        this.qy = qy;
        this.qz = qz;
        this.qw = qw;
        Vector3d com = inner.centreOfMass(new Vector3d());
        new Quaterniond(qx, qy, qz, qw).transform(com).add(x, y, z);
        comX = com.x;
        comY = com.y;
        comZ = com.z;
    }

    /**
     * Whether another one is at the same place, turned alike.
     *
     * @param other whatever it moves
     * @return whether all numbers are the same
     */
    public boolean isPlacedAs(Moved other) {
        return java.util.Arrays.equals(numbers(), other.numbers());
    }

    /** Place and turn, as the constructor takes them. */
    double[] numbers() {
        return new double[] {x, y, z, qx, qy, qz, qw};
    }

    static Shape of(Shape shape, double x, double y, double z, Quaterniond turn) {
        Checks.coordinate("x", x);
        Checks.coordinate("y", y);
        Checks.coordinate("z", z);
        double length =
                Math.sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z + turn.w * turn.w);
        if (!(Math.abs(length - 1) <= 1e-6)) {
            throw new IllegalArgumentException(
                    "turn has length "
                            + length
                            + "; it must be a unit quaternion, within 1e-6: call normalize()");
        }
        // What is of unit length up to rounding keeps its bits.
        if (Math.abs(length - 1) <= 0x1p-51) {
            length = 1;
        }
        Quaterniond q =
                new Quaterniond(turn.x / length, turn.y / length, turn.z / length, turn.w / length);
        if (shape instanceof HalfSpace) {
            throw new IllegalArgumentException(
                    "a half-space has no place of its own in a body; place and turn the body with"
                            + " Body.at and Body.rotation");
        }
        if (isNothing(x, y, z, q)) {
            return shape;
        }
        Vector3d at = new Vector3d(x, y, z);
        if (shape instanceof Moved m) {
            at.add(q.transform(new Vector3d(m.x, m.y, m.z)));
            q.mul(m.qx, m.qy, m.qz, m.qw).normalize();
            return place(m.inner, at, q);
        }
        return place(shape, at, q);
    }

    private static boolean isNothing(double x, double y, double z, Quaterniond q) {
        return x == 0 && y == 0 && z == 0 && q.x == 0 && q.y == 0 && q.z == 0;
    }

    /** What is moved back again is the shape itself. */
    private static Shape place(Shape inner, Vector3d at, Quaterniond q) {
        return isNothing(at.x, at.y, at.z, q)
                ? inner
                : new Moved(inner, at.x, at.y, at.z, q.x, q.y, q.z, q.w);
    }

    /**
     * The shape that was moved.
     *
     * @return never a moved one itself
     */
    public Shape inner() {
        return inner;
    }

    /**
     * Where the origin of the inner shape's frame is.
     *
     * @param dest receives the result, m
     * @return {@code dest}
     */
    public Vector3d position(Vector3d dest) {
        return dest.set(x, y, z);
    }

    /**
     * How the inner shape is turned: from its frame to this one's.
     *
     * @param dest receives the unit quaternion
     * @return {@code dest}
     */
    public Quaterniond rotation(Quaterniond dest) {
        return dest.set(qx, qy, qz, qw);
    }

    /**
     * Whether the inner shape is turned, and not only shifted.
     *
     * @return false if the rotation is the identity
     */
    public boolean isTurned() {
        return qx != 0 || qy != 0 || qz != 0;
    }

    /**
     * Imaginary part of the rotation, without allocation.
     *
     * @return x
     */
    public double rotationX() {
        return qx;
    }

    /**
     * See {@link #rotationX}.
     *
     * @return y
     */
    public double rotationY() {
        return qy;
    }

    /**
     * See {@link #rotationX}.
     *
     * @return z
     */
    public double rotationZ() {
        return qz;
    }

    /**
     * Real part of the rotation.
     *
     * @return w
     */
    public double rotationW() {
        return qw;
    }

    @Override
    public double volume() {
        return inner.volume();
    }

    /** The inner shape's tensor, turned: R I Rᵀ. */
    @Override
    public MassProperties massProperties(double density) {
        MassProperties p = inner.massProperties(density);
        Vector3d com = centreOfMass(new Vector3d());
        Matrix3d turn = new Matrix3d().rotation(rotation(new Quaterniond()));
        Matrix3d tensor =
                new Matrix3d(
                        p.ixx(), p.ixy(), p.ixz(), p.ixy(), p.iyy(), p.iyz(), p.ixz(), p.iyz(),
                        p.izz());
        Matrix3d i = new Matrix3d(turn).mul(tensor).mul(turn.transpose(new Matrix3d()));
        return new MassProperties(
                p.mass(),
                com.x,
                com.y,
                com.z,
                i.m00,
                i.m11,
                i.m22,
                0.5 * (i.m01 + i.m10),
                0.5 * (i.m02 + i.m20),
                0.5 * (i.m12 + i.m21));
    }

    @Override
    public double innerRadius() {
        return inner.innerRadius();
    }

    @Override
    public double outerRadius() {
        return inner.outerRadius();
    }

    @Override
    public Vector3d centreOfMass(Vector3d dest) {
        return dest.set(comX, comY, comZ);
    }

    @Override
    public void bounds(double bx, double by, double bz, double bw, double[] dest, int offset) {
        inner.bounds(
                bw * qx + bx * qw + by * qz - bz * qy,
                bw * qy - bx * qz + by * qw + bz * qx,
                bw * qz + bx * qy - by * qx + bz * qw,
                bw * qw - bx * qx - by * qy - bz * qz,
                dest,
                offset);
    }

    @Override
    public String toString() {
        return "Moved[" + inner + " to (" + x + ", " + y + ", " + z + ")]";
    }
}
