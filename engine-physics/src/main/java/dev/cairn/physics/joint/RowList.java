package dev.cairn.physics.joint;

import dev.cairn.physics.internal.JointStore;

/** Turns what a joint does about its axes into rows. */
final class RowList {
    private static final int MOST = 32;

    int count;
    private final byte[] law = new byte[MOST];
    private final byte[] role = new byte[MOST];
    private final double[] lower = new double[MOST];
    private final double[] upper = new double[MOST];
    private final double[] target = new double[MOST];
    private final double[] most = new double[MOST];
    private final double[] stiffness = new double[MOST];
    private final double[] damping = new double[MOST];
    private final boolean[] isAbsolute = new boolean[MOST];

    /** Rows of some settings. */
    void compile(AxisSettings[] axes) {
        count = 0;
        for (int k = 0; k < 3; k++) {
            axis(axes[k], JointStore.SLIDE + k);
        }
        AxisSettings twist = axes[JointAxis.TWIST.index];
        AxisSettings swingY = axes[JointAxis.SWING_Y.index];
        AxisSettings swingZ = axes[JointAxis.SWING_Z.index];
        boolean isStiff = swingY.isLocked && swingZ.isLocked;
        if (isStiff && twist.isLocked) {
            for (int k = 0; k < 3; k++) {
                add(JointStore.TURN + k, JointStore.LOCK);
            }
        } else if (isStiff) {
            add(JointStore.ALIGN, JointStore.LOCK);
            add(JointStore.ALIGN + 1, JointStore.LOCK);
            axis(twist, JointStore.TWIST);
        } else {
            axis(twist, JointStore.TWIST);
            axis(swingY, JointStore.SWING);
            axis(swingZ, JointStore.SWING + 1);
        }
        axis(axes[JointAxis.CONE.index], JointStore.CONE);
        axis(axes[JointAxis.DISTANCE.index], JointStore.DISTANCE);
        if (axes[Joint.RAIL].isLocked) {
            add(JointStore.PATH, JointStore.LOCK);
            add(JointStore.PATH + 1, JointStore.LOCK);
        }
        axis(axes[JointAxis.PATH.index], JointStore.ALONG);
        axis(axes[Joint.CROSS], JointStore.CROSS);
        axis(axes[Joint.GEAR], JointStore.GEAR);
        axis(axes[Joint.RACK], JointStore.RACK);
        axis(axes[Joint.PULLEY], JointStore.PULLEY);
    }

    private int add(int lawWanted, byte roleWanted) {
        law[count] = (byte) lawWanted;
        role[count] = roleWanted;
        target[count] = 0;
        most[count] = Double.POSITIVE_INFINITY;
        lower[count] = Double.NEGATIVE_INFINITY;
        upper[count] = Double.POSITIVE_INFINITY;
        stiffness[count] = 0;
        damping[count] = 0;
        isAbsolute[count] = false;
        return count++;
    }

    private void axis(AxisSettings s, int of) {
        if (s.isLocked) {
            target[add(of, JointStore.LOCK)] = s.held;
            return;
        }
        if (s.isSprung) {
            int r = add(of, JointStore.SPRING);
            target[r] = s.target;
            stiffness[r] = s.stiffness;
            damping[r] = s.damping;
            isAbsolute[r] = s.isAbsolute;
            most[r] = s.springMost;
        }
        if (s.isDriven) {
            int r = add(of, JointStore.MOTOR);
            target[r] = s.speed;
            most[r] = s.motorMost;
        }
        if (s.isLimited) {
            int r = add(of, JointStore.LIMIT);
            lower[r] = s.lower;
            upper[r] = s.upper;
        }
    }

    /** Whether a joint has the same rows, but for numbers. */
    boolean fits(JointStore s, int j) {
        if (s.rows[j] != count) {
            return false;
        }
        int from = s.firstRow[j];
        for (int r = 0; r < count; r++) {
            if (s.law[from + r] != law[r] || s.role[from + r] != role[r]) {
                return false;
            }
        }
        return true;
    }

    /** Writes the rows; impulses stay. */
    void write(JointStore s, int j) {
        int from = s.firstRow[j];
        System.arraycopy(law, 0, s.law, from, count);
        System.arraycopy(role, 0, s.role, from, count);
        System.arraycopy(lower, 0, s.lower, from, count);
        System.arraycopy(upper, 0, s.upper, from, count);
        System.arraycopy(target, 0, s.target, from, count);
        System.arraycopy(most, 0, s.most, from, count);
        System.arraycopy(stiffness, 0, s.stiffness, from, count);
        System.arraycopy(damping, 0, s.damping, from, count);
        System.arraycopy(isAbsolute, 0, s.isAbsolute, from, count);
    }
}
