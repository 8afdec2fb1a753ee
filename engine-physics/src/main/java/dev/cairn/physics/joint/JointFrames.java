package dev.cairn.physics.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Curve;
import dev.cairn.physics.internal.JointStore;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** From places and axes in the world to frames in the bodies. */
final class JointFrames {
    /** Lengths below this are none, m. */
    private static final double SMALL = 1e-9;

    private final Vector3d x = new Vector3d();
    private final Vector3d y = new Vector3d();
    private final Vector3d z = new Vector3d();
    private final Vector3d point = new Vector3d();
    private final Quaterniond frame = new Quaterniond();
    private final Quaterniond body = new Quaterniond();

    /** Distance of the two points of a joint, m. */
    double distance(Joint joint, BodyStore b, int slotA, int slotB) {
        double dx = at(joint, b, slotB, false, 0) - at(joint, b, slotA, true, 0);
        double dy = at(joint, b, slotB, false, 1) - at(joint, b, slotA, true, 1);
        double dz = at(joint, b, slotB, false, 2) - at(joint, b, slotA, true, 2);
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /** A coordinate of the point in a body: the centre of mass if none was given. */
    private static double at(Joint joint, BodyStore b, int slot, boolean isA, int k) {
        if (joint.isPlaced) {
            return isA ? joint.anchorA[k] : joint.anchorB[k];
        }
        return k == 0 ? b.positionX[slot] : k == 1 ? b.positionY[slot] : b.positionZ[slot];
    }

    /** Length of a pulley's rope, m. */
    double rope(Joint joint, BodyStore b, int slotA, int slotB) {
        double[] over = joint.parameters;
        double sum = 0;
        for (int side = 0; side < 2; side++) {
            boolean isA = side == 0;
            for (int k = 0; k < 3; k++) {
                double at = at(joint, b, isA ? slotA : slotB, isA, k);
                point.setComponent(k, at - over[3 * side + k]);
            }
            sum += (isA ? 1 : over[6]) * point.length();
        }
        return sum;
    }

    /**
     * Writes the frames in A and in B.
     *
     * @param parameters those of a rack are completed
     */
    void write(
            Joint joint,
            BodyStore b,
            int slotA,
            int slotB,
            double[] into,
            int o,
            double[] parameters) {
        x.set(joint.x);
        if (joint.kind.equals("gear")) {
            // marks of both gears are on the line of their centres
            y.set(joint.anchorB).sub(point.set(joint.anchorA));
            if (!(point.set(x).cross(y).length() > SMALL)) {
                throw new IllegalArgumentException(
                        "the centres of two gears lie on one axis; give two anchors beside each"
                                + " other, at a right angle to the axis");
            }
        } else if (joint.hasSecond) {
            y.set(joint.y);
        } else {
            // the world axis that is furthest from x
            double ax = Math.abs(x.x);
            double ay = Math.abs(x.y);
            double az = Math.abs(x.z);
            y.set(ax < ay && ax < az ? 1 : 0, ay <= ax && ay <= az ? 1 : 0, 0);
            y.z = y.x == 0 && y.y == 0 ? 1 : 0;
        }
        y.sub(z.set(x).mul(x.dot(y)));
        if (!(y.lengthSquared() > 1e-12)) {
            throw new IllegalArgumentException(
                    "second axis ("
                            + joint.y[0]
                            + ", "
                            + joint.y[1]
                            + ", "
                            + joint.y[2]
                            + ") lies along the axis; give another one, or none");
        }
        y.normalize();
        x.cross(y, z);
        frame.setFromNormalized(new Matrix3d(x, y, z));
        frame.normalize();
        write(joint, b, slotA, true, into, o);
        write(joint, b, slotB, false, into, o + 7);
        if (joint.kind.equals("rack")) {
            rack(joint, b, slotB, into, o + 7, parameters);
        }
    }

    /** A path's points, after {@link #write}: from the world to A's frame, three numbers each. */
    Curve curve(Joint joint, BodyStore b, int slotA) {
        double[] points = joint.curve().points();
        for (int i = 0; i < points.length; i += 3) {
            point.set(
                    points[i] - at(joint, b, slotA, true, 0),
                    points[i + 1] - at(joint, b, slotA, true, 1),
                    points[i + 2] - at(joint, b, slotA, true, 2));
            points[i] = point.dot(x);
            points[i + 1] = point.dot(y);
            points[i + 2] = point.dot(z);
        }
        return new Curve(joint.curve().isClosed(), points);
    }

    /** B's point in A's frame, after {@link #write}. */
    Vector3d apart(Joint joint, BodyStore b, int slotA, int slotB) {
        point.set(
                at(joint, b, slotB, false, 0) - at(joint, b, slotA, true, 0),
                at(joint, b, slotB, false, 1) - at(joint, b, slotA, true, 1),
                at(joint, b, slotB, false, 2) - at(joint, b, slotA, true, 2));
        return point.set(point.dot(x), point.dot(y), point.dot(z));
    }

    /** Radius of the pinion; the rack's point is where the two touch. */
    private void rack(
            Joint joint, BodyStore b, int slotB, double[] into, int o, double[] parameters) {
        point.set(joint.anchorB).sub(joint.anchorA[0], joint.anchorA[1], joint.anchorA[2]);
        parameters[0] = point.dot(z);
        if (!(Math.abs(parameters[0]) > SMALL)) {
            throw new IllegalArgumentException(
                    "the rack's point is beside the pinion's centre along the rack or the axis;"
                            + " give a point that is a radius away from it");
        }
        double along = point.dot(y);
        point.set(
                joint.anchorB[0] - along * y.x - b.positionX[slotB],
                joint.anchorB[1] - along * y.y - b.positionY[slotB],
                joint.anchorB[2] - along * y.z - b.positionZ[slotB]);
        write(b, slotB, point, into, o);
    }

    private void write(Joint joint, BodyStore b, int slot, boolean isA, double[] into, int o) {
        point.set(
                at(joint, b, slot, isA, 0) - b.positionX[slot],
                at(joint, b, slot, isA, 1) - b.positionY[slot],
                at(joint, b, slot, isA, 2) - b.positionZ[slot]);
        write(b, slot, point, into, o);
        Quaterniond local = body.mul(frame, new Quaterniond()).normalize();
        into[o + 3] = local.x;
        into[o + 4] = local.y;
        into[o + 5] = local.z;
        into[o + 6] = local.w;
    }

    /** Writes a point that is given relative to the centre of mass, in world axes. */
    void write(BodyStore b, int slot, Vector3d world, double[] into, int o) {
        read(b, slot).conjugate().transform(world);
        into[o] = world.x;
        into[o + 1] = world.y;
        into[o + 2] = world.z;
    }

    /** World point of a joint on one of its bodies. */
    Vector3d point(Joints joints, int j, boolean isA, Vector3d into) {
        BodyStore b = joints.bodies;
        int slot = isA ? joints.store.bodyA[j] : joints.store.bodyB[j];
        int o = JointStore.FRAME * j + (isA ? 0 : 7);
        double[] f = joints.store.frame;
        read(b, slot).transform(into.set(f[o], f[o + 1], f[o + 2]));
        return into.add(b.positionX[slot], b.positionY[slot], b.positionZ[slot]);
    }

    /** World orientation of a joint's frame in one of its bodies. */
    Quaterniond turn(Joints joints, int j, boolean isA, Quaterniond into) {
        int slot = isA ? joints.store.bodyA[j] : joints.store.bodyB[j];
        int o = JointStore.FRAME * j + (isA ? 3 : 10);
        double[] f = joints.store.frame;
        into.set(f[o], f[o + 1], f[o + 2], f[o + 3]);
        return into.premul(read(joints.bodies, slot));
    }

    private Quaterniond read(BodyStore b, int slot) {
        return body.set(
                b.orientationX[slot],
                b.orientationY[slot],
                b.orientationZ[slot],
                b.orientationW[slot]);
    }
}
