package dev.cairn.physics.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** From places and axes in the world to frames in the bodies. */
final class JointFrames {
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

    /** Writes the frames in A and in B. */
    void write(Joint joint, BodyStore b, int slotA, int slotB, double[] into, int o) {
        x.set(joint.x);
        if (joint.hasSecond) {
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
