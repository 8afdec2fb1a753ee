package dev.cairn.physics.internal;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * All joints as columns: which bodies are bound where, and the rows that bind them. A joint is a
 * number that stays its own as long as it exists; freed numbers are used again, last freed first.
 *
 * <p>A joint has a frame in each of its bodies: an origin relative to the centre of mass, and a
 * quaternion, both in the body's axes. Its rows are scalar equations between these frames. Row
 * {@code r} says what is measured ({@link #law}), what is wanted ({@link #role}) and between which
 * bounds. Simulation thread, but for impulses, which the worker writes that solves the joint.
 */
public final class JointStore implements EdgeSource, Stateful {
    // What a row measures -------------------------------------------------------------------------

    /** Offset of B's origin from A's along A's axis 0, 1 or 2, m. */
    public static final byte SLIDE = 0;

    /** Twice the vector part of the relative quaternion, A's axis 0, 1 or 2: all three at once. */
    public static final byte TURN = 3;

    /** B's axis 0 along A's axis 1, or 2: 0 while the two axes 0 are parallel. */
    public static final byte ALIGN = 6;

    /** Angle of B about its own axis 0 against A, rad. */
    public static final byte TWIST = 8;

    /** Angle of B's axis 0 about A's axis 1, or 2, rad. */
    public static final byte SWING = 9;

    /** Angle between the two axes 0, rad. */
    public static final byte CONE = 11;

    /** B's axis 1 along A's axis 0: 0 in a universal joint. */
    public static final byte CROSS = 12;

    /** Distance of the origins, m. */
    public static final byte DISTANCE = 13;

    /** How far the teeth of two gears are out of mesh along the pitch circle, m. */
    public static final byte GEAR = 14;

    /** The same of a pinion, A, and a rack, B. */
    public static final byte RACK = 15;

    /** Length of a rope over two points of the world, m. */
    public static final byte PULLEY = 16;

    /** How far B's origin is beside a curve in A's frame, m: two rows. */
    public static final byte PATH = 17;

    /** Length of the curve from its first point to where B's origin is, m. */
    public static final byte ALONG = 19;

    // What a row wants ----------------------------------------------------------------------------

    /** It is 0. */
    public static final byte LOCK = 0;

    /** It is from {@link #lower} to {@link #upper}. */
    public static final byte LIMIT = 1;

    /** It changes at {@link #target} per second, with at most {@link #most}. */
    public static final byte MOTOR = 2;

    /** It is drawn to {@link #target} by a spring and damper, with at most {@link #most}. */
    public static final byte SPRING = 3;

    // Joints --------------------------------------------------------------------------------------

    /** One past the highest joint in use. */
    public int count;

    /** Whether the number is a joint's, and whether it acts. */
    public boolean[] isThere = {};

    public boolean[] isEnabled = {};

    /** Whether the bodies of the joint collide with each other. */
    public boolean[] collides = {};

    /** Whether {@link #most} of the springs along x, y and z is that of their sum's length. */
    public boolean[] isRound = {};

    /** Grows with each joint of the number. */
    public int[] stamp = {};

    /** Slots of the two bodies. */
    public int[] bodyA = {};

    public int[] bodyB = {};

    /** Numbers to a joint in {@link #frame}. */
    public static final int FRAME = 14;

    /** Origin and quaternion in A, then in B. */
    public double[] frame = {};

    /** Numbers to a joint in {@link #parameter}. */
    public static final int PARAMETERS = 7;

    /**
     * Of gears: teeth of A and of B; of a rack: the pinion's radius with sign; of a pulley: the
     * point above A, that above B, and how much more the part at B counts; of a path: where on the
     * curve B is, and the first normal there, in A's frame, which the solver brings up to date.
     */
    public double[] parameter = {};

    /** Of a path: the curve in A's frame. */
    public @Nullable Curve[] curve = {};

    /** First row of the joint and how many it has. */
    public int[] firstRow = {};

    public int[] rows = {};
    private int[] room = {};

    /** Force and torque at the origin on B, world, mean of the last sub-step; 6 to a joint. */
    public double[] reaction = {};

    /** Force and torque beyond which the joint breaks. */
    public double[] breakForce = {};

    public double[] breakTorque = {};

    /** Grows whenever a joint comes, goes or changes. */
    public long revision;

    // Rows ----------------------------------------------------------------------------------------

    /** Rows in use, those of freed joints included. */
    public int rowCount;

    public byte[] law = {};
    public byte[] role = {};
    public double[] lower = {};
    public double[] upper = {};
    public double[] target = {};

    /** Largest force, N or N m; may be infinite. */
    public double[] most = {};

    /** Frequency, Hz, and damping ratio, or stiffness and damping where {@link #isAbsolute}. */
    public double[] stiffness = {};

    public double[] damping = {};
    public boolean[] isAbsolute = {};

    /** Impulses of the last sub-step: before the bodies moved, and after. */
    public double[] before = {};

    public double[] after = {};

    /** How a limit or motor stood: -1 or 1 where it was held at a bound, else 0. */
    public byte[] held = {};

    private int[] free = {};
    private int freeCount;
    private final Columns.Kept kept = new Columns.Kept();

    /** Makes an empty store. */
    public JointStore() {}

    /**
     * Takes a number for a joint.
     *
     * @param rowsWanted how many rows it has
     * @return the number
     */
    public int add(int rowsWanted) {
        int j = freeCount > 0 ? free[--freeCount] : count++;
        ensureJoints(count);
        isThere[j] = true;
        stamp[j]++;
        isEnabled[j] = true;
        collides[j] = false;
        isRound[j] = false;
        curve[j] = null;
        Arrays.fill(reaction, 6 * j, 6 * j + 6, 0.0);
        resize(j, rowsWanted);
        return j;
    }

    /** Gives a joint a number of empty rows. */
    public void resize(int j, int rowsWanted) {
        if (room[j] < rowsWanted) {
            firstRow[j] = rowCount;
            room[j] = rowsWanted;
            rowCount += rowsWanted;
            ensureRows(rowCount);
        }
        rows[j] = rowsWanted;
        clear(j);
        revision++;
    }

    /** The joint ends, and its number is free. */
    public void remove(int j) {
        isThere[j] = false;
        isEnabled[j] = false;
        curve[j] = null;
        if (freeCount == free.length) {
            free = Arrays.copyOf(free, Math.max(16, 2 * freeCount));
        }
        free[freeCount++] = j;
        revision++;
    }

    /** Forgets the impulses of a joint. */
    public void clear(int j) {
        int from = firstRow[j];
        int to = from + rows[j];
        Arrays.fill(before, from, to, 0.0);
        Arrays.fill(after, from, to, 0.0);
        Arrays.fill(held, from, to, (byte) 0);
        Arrays.fill(reaction, 6 * j, 6 * j + 6, 0.0);
    }

    private void ensureJoints(int wanted) {
        if (wanted <= isThere.length) {
            return;
        }
        int n = Math.max(wanted, Math.max(16, isThere.length + (isThere.length >> 1)));
        columnsOfJoints(new Columns.Growth(n));
    }

    private void ensureRows(int wanted) {
        if (wanted <= law.length) {
            return;
        }
        int n = Math.max(wanted, Math.max(32, law.length + (law.length >> 1)));
        columnsOfRows(new Columns.Growth(n));
    }

    /** Declares the columns with one entry to a joint. */
    private void columnsOfJoints(Columns c) {
        isThere = c.column("isThere", isThere);
        isEnabled = c.column("isEnabled", isEnabled);
        collides = c.column("collides", collides);
        isRound = c.column("isRound", isRound);
        stamp = c.column("stamp", stamp);
        bodyA = c.column("bodyA", bodyA);
        bodyB = c.column("bodyB", bodyB);
        frame = c.column("frame", frame, FRAME);
        parameter = c.column("parameter", parameter, PARAMETERS);
        curve = c.column("curve", curve);
        firstRow = c.column("firstRow", firstRow);
        rows = c.column("rows", rows);
        room = c.column("room", room);
        reaction = c.column("reaction", reaction, 6);
        breakForce = c.column("breakForce", breakForce);
        breakTorque = c.column("breakTorque", breakTorque);
    }

    /** Declares the columns with one entry to a row. */
    private void columnsOfRows(Columns c) {
        law = c.column("law", law);
        role = c.column("role", role);
        lower = c.column("lower", lower);
        upper = c.column("upper", upper);
        target = c.column("target", target);
        most = c.column("most", most);
        stiffness = c.column("stiffness", stiffness);
        damping = c.column("damping", damping);
        isAbsolute = c.column("isAbsolute", isAbsolute);
        before = c.column("before", before);
        after = c.column("after", after);
        held = c.column("held", held);
    }

    @Override
    public void state(StateVisitor s) {
        s.section("joints", this);
        count = s.count("count", count);
        rowCount = s.count("rowCount", rowCount);
        revision = s.value("revision", revision);
        freeCount = s.value("freeCount", freeCount);
        free = s.array("free", free, freeCount);
        ensureJoints(count);
        ensureRows(rowCount);
        columnsOfJoints(kept.of(s, count, isThere.length, true));
        columnsOfRows(kept.of(s, rowCount, law.length, true));
    }

    // Edges ---------------------------------------------------------------------------------------

    @Override
    public int edges() {
        return count;
    }

    @Override
    public int capacity() {
        return bodyA.length;
    }

    @Override
    public int edgeRow(int i) {
        return i;
    }

    @Override
    public int edgeA(int i) {
        return isEnabled[i] ? bodyA[i] : -1;
    }

    @Override
    public int edgeB(int i) {
        return bodyB[i];
    }

    @Override
    public void leave(int slot) {
        for (int j = 0; j < count; j++) {
            if (isThere[j] && (bodyA[j] == slot || bodyB[j] == slot)) {
                remove(j);
            }
        }
    }

    @Override
    public void forget(int slot) {
        for (int j = 0; j < count; j++) {
            if (isThere[j] && (bodyA[j] == slot || bodyB[j] == slot)) {
                clear(j);
            }
        }
    }
}
