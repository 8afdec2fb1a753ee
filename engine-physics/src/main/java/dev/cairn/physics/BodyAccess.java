package dev.cairn.physics;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.contact.StepLimits;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.state.RigidBody;
import dev.cairn.physics.state.SupportLoads;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;

import java.util.Locale;

/** What {@link BodyRef} reads and writes, by slot; the slot is alive. */
final class BodyAccess {
    /** Targets of a tick: speeds on the way stay far below what the step computes with. */
    private static final double FARTHEST = 1e50;

    private final BodyTable table;
    private final BodyStore bodies;
    private final double[] rotated = new double[3];
    private final Vector3d place = new Vector3d();

    BodyAccess(BodyTable table) {
        this.table = table;
        this.bodies = table.bodies;
    }

    boolean isFixed(int s) {
        return bodies.kind[s] == BodyStore.STATIC;
    }

    /** Whether forces and contacts do nothing to a body. */
    private boolean isUnmoved(int s) {
        return bodies.kind[s] == BodyStore.STATIC || bodies.kind[s] == BodyStore.KINEMATIC;
    }

    BodyType type(int s) {
        return switch (bodies.kind[s]) {
            case BodyStore.STATIC -> BodyType.FIXED;
            case BodyStore.KINEMATIC -> BodyType.KINEMATIC;
            default -> BodyType.DYNAMIC;
        };
    }

    Matrix3d inertia(int s, Matrix3d d) {
        BodyStore b = bodies;
        return d.set(
                b.inertiaXX[s],
                b.inertiaXY[s],
                b.inertiaXZ[s],
                b.inertiaXY[s],
                b.inertiaYY[s],
                b.inertiaYZ[s],
                b.inertiaXZ[s],
                b.inertiaYZ[s],
                b.inertiaZZ[s]);
    }

    boolean isAsleep(int s) {
        return bodies.kind[s] == BodyStore.ASLEEP;
    }

    void wake(int s) {
        table.sleepers.wake(s);
    }

    void sleep(int s) {
        table.sleep(s);
    }

    /** What changes nothing wakes no body. */
    private void wakeIf(boolean changes, int s) {
        if (changes) {
            wake(s);
        }
    }

    private void wakeUnlessZero(int s, double x, double y, double z) {
        wakeIf(x != 0 || y != 0 || z != 0, s);
    }

    Shape shape(int s) {
        return table.collision.spec(bodies.collider[s]).placed;
    }

    Material material(int s) {
        return table.collision.spec(bodies.collider[s]).material();
    }

    double mass(int s) {
        return isUnmoved(s) ? Double.POSITIVE_INFINITY : 1 / bodies.inverseMass[s];
    }

    /**
     * Another mass, centre and inertia. The body's frame stays where it is; the centre takes over
     * the velocity v + w x d of where it is now.
     */
    void setMass(int s, MassProperties p) {
        BodyStore b = bodies;
        Rotations.rotate(
                b.orientationX[s],
                b.orientationY[s],
                b.orientationZ[s],
                b.orientationW[s],
                p.comX() - table.registry.comX[s],
                p.comY() - table.registry.comY[s],
                p.comZ() - table.registry.comZ[s],
                rotated);
        table.registry.comX[s] = p.comX();
        table.registry.comY[s] = p.comY();
        table.registry.comZ[s] = p.comZ();
        b.move(s, rotated[0], rotated[1], rotated[2]);
        double wx = b.angularVelocityX[s];
        double wy = b.angularVelocityY[s];
        double wz = b.angularVelocityZ[s];
        b.velocityX[s] += wy * rotated[2] - wz * rotated[1];
        b.velocityY[s] += wz * rotated[0] - wx * rotated[2];
        b.velocityZ[s] += wx * rotated[1] - wy * rotated[0];
        double share = b.inverseMass[s] * p.mass();
        table.setMass(s, p, isUnmoved(s));
        if (share > 0 && share < 1 && !isUnmoved(s)) {
            SupportLoads.lighten(table.contacts, s, share);
        }
    }

    /** R I⁻¹ Rᵀ. */
    Matrix3d inverseInertia(int s, Matrix3d d) {
        Matrix3d body =
                new Matrix3d(
                        bodies.inverseInertiaXX[s],
                        bodies.inverseInertiaXY[s],
                        bodies.inverseInertiaXZ[s],
                        bodies.inverseInertiaXY[s],
                        bodies.inverseInertiaYY[s],
                        bodies.inverseInertiaYZ[s],
                        bodies.inverseInertiaXZ[s],
                        bodies.inverseInertiaYZ[s],
                        bodies.inverseInertiaZZ[s]);
        Quaterniond q = orientation(s, new Quaterniond());
        d.rotation(q);
        Matrix3d transposed = d.transpose(new Matrix3d());
        return d.mul(body).mul(transposed);
    }

    Vector3d position(int s, Vector3d d) {
        Rotations.rotate(
                bodies.orientationX[s],
                bodies.orientationY[s],
                bodies.orientationZ[s],
                bodies.orientationW[s],
                table.registry.comX[s],
                table.registry.comY[s],
                table.registry.comZ[s],
                rotated);
        return d.set(
                bodies.positionX[s] - rotated[0],
                bodies.positionY[s] - rotated[1],
                bodies.positionZ[s] - rotated[2]);
    }

    Vector3d centreOfMass(int s, Vector3d d) {
        return d.set(bodies.positionX[s], bodies.positionY[s], bodies.positionZ[s]);
    }

    Quaterniond orientation(int s, Quaterniond d) {
        return d.set(
                bodies.orientationX[s],
                bodies.orientationY[s],
                bodies.orientationZ[s],
                bodies.orientationW[s]);
    }

    Vector3d velocity(int s, Vector3d d) {
        return d.set(bodies.velocityX[s], bodies.velocityY[s], bodies.velocityZ[s]);
    }

    Vector3d angularVelocity(int s, Vector3d d) {
        return d.set(
                bodies.angularVelocityX[s], bodies.angularVelocityY[s], bodies.angularVelocityZ[s]);
    }

    void setGravityScale(int s, double factor) {
        wakeIf(bodies.gravityScale[s] != Checks.finite("gravityScale", factor), s);
        double before = bodies.gravityScale[s];
        bodies.gravityScale[s] = factor;
        if (before > 0 && factor < before && !isUnmoved(s)) {
            SupportLoads.lighten(table.contacts, s, Math.max(0, factor / before));
        }
    }

    void setDamping(int s, double linear, double angular) {
        Checks.between("linear damping", linear, 0, 1e6);
        Checks.between("angular damping", angular, 0, 1e6);
        wakeIf(linear != bodies.linearDamping[s] || angular != bodies.angularDamping[s], s);
        bodies.linearDamping[s] = linear;
        bodies.angularDamping[s] = angular;
        restrain(s, bodies.motionFlags[s]);
    }

    void setSpeedLimit(int s, double metresPerSecond) {
        wakeIf(bodies.speedLimit[s] != Checks.limit("speedLimit", metresPerSecond), s);
        bodies.speedLimit[s] = metresPerSecond;
        restrain(s, bodies.motionFlags[s]);
    }

    void setLocks(int s, Lock... locks) {
        byte before = bodies.motionFlags[s];
        restrain(s, Lock.bits(locks));
        wakeIf(bodies.motionFlags[s] != before, s);
    }

    /** Sums up what holds a body back; of {@code locks} the bits of the axes count. */
    void restrain(int s, int locks) {
        int bits = locks & 63;
        if (bodies.linearDamping[s] != 0 || bodies.angularDamping[s] != 0) {
            bits |= BodyStore.DAMPED;
        }
        if (bodies.speedLimit[s] < Double.POSITIVE_INFINITY) {
            bits |= BodyStore.LIMITED;
        }
        bodies.motionFlags[s] = (byte) bits;
    }

    void setVelocity(int s, double vx, double vy, double vz) {
        Checks.finite("vx", vx);
        Checks.finite("vy", vy);
        Checks.finite("vz", vz);
        needsMover(s, "velocity");
        if (bodies.kind[s] == BodyStore.KINEMATIC) {
            BodyTable.checkSpeed("velocity", vx, vy, vz, 1);
            table.registry.motion.forget(s);
        }
        // Asleep, it is at rest.
        wakeUnlessZero(s, vx, vy, vz);
        bodies.velocityX[s] = vx;
        bodies.velocityY[s] = vy;
        bodies.velocityZ[s] = vz;
    }

    void setAngularVelocity(int s, double wx, double wy, double wz) {
        Checks.finite("wx", wx);
        Checks.finite("wy", wy);
        Checks.finite("wz", wz);
        needsMover(s, "angular velocity");
        if (bodies.kind[s] == BodyStore.KINEMATIC) {
            BodyTable.checkSpeed("angular velocity", wx, wy, wz, bodies.outerRadius[s]);
            table.registry.motion.forget(s);
        }
        wakeUnlessZero(s, wx, wy, wz);
        bodies.angularVelocityX[s] = wx;
        bodies.angularVelocityY[s] = wy;
        bodies.angularVelocityZ[s] = wz;
    }

    void moveTo(int s, double x, double y, double z) {
        BodyStore b = bodies;
        aim(s, x, y, z, b.orientationX[s], b.orientationY[s], b.orientationZ[s], b.orientationW[s]);
    }

    void moveTo(int s, double x, double y, double z, Quaterniondc q) {
        double f = Rotations.inverseLength("rotation", q.x(), q.y(), q.z(), q.w());
        aim(s, x, y, z, q.x() * f, q.y() * f, q.z() * f, q.w() * f);
    }

    private void aim(
            int s, double x, double y, double z, double qx, double qy, double qz, double qw) {
        if (bodies.kind[s] != BodyStore.KINEMATIC) {
            throw new IllegalStateException(
                    table.refs[s]
                            + " is "
                            + type(s)
                            + ", and moveTo moves kinematic bodies; make it with Body.kinematic(),"
                            + " or use teleport");
        }
        Rotations.rotate(
                qx,
                qy,
                qz,
                qw,
                table.registry.comX[s],
                table.registry.comY[s],
                table.registry.comZ[s],
                rotated);
        double px = Checks.between("x", x + rotated[0], -FARTHEST, FARTHEST);
        double py = Checks.between("y", y + rotated[1], -FARTHEST, FARTHEST);
        double pz = Checks.between("z", z + rotated[2], -FARTHEST, FARTHEST);
        table.registry.motion.aim(s, px, py, pz, qx, qy, qz, qw);
    }

    private void needsMover(int s, String what) {
        if (isFixed(s)) {
            throw new IllegalStateException(
                    table.refs[s]
                            + " is fixed, so its "
                            + what
                            + " is 0; make it with Body.dynamic() or Body.kinematic() if it shall"
                            + " move");
        }
    }

    /**
     * To push a wall is a mistake: the wrong body, or the wrong type. To push a body that the world
     * has stopped is none; that is told by {@code quarantined()}.
     */
    void needsDynamic(int s, String call) {
        if (type(s) != BodyType.DYNAMIC && !table.isQuarantined(s)) {
            throw new IllegalStateException(
                    table.refs[s]
                            + " is "
                            + type(s).name().toLowerCase(Locale.ROOT)
                            + ", and "
                            + call
                            + " moves dynamic bodies only; ask type() first where any body may"
                            + " come, set a velocity to move a kinematic one, or make it with"
                            + " Body.dynamic()");
        }
    }

    /** Poses that were set in the ECS, by a command or between steps, are teleports. */
    void takePoses() {
        World ecs = table.world();
        for (int i = 0; i < ecs.setCount(); i++) {
            long entity = ecs.setEntity(i);
            if (ecs.isAlive(entity)
                    && ecs.has(entity, RigidBody.COMPONENT)
                    && ecs.has(entity, Pose.COMPONENT)) {
                int s = ecs.get(entity, RigidBody.COMPONENT).slot();
                if (table.isAlive(s, entity)) {
                    takePose(s, ecs.get(entity, Pose.COMPONENT));
                }
            }
        }
        ecs.forgetSet();
    }

    private void takePose(int s, Pose pose) {
        position(s, place);
        boolean same =
                place.x == pose.x()
                        && place.y == pose.y()
                        && place.z == pose.z()
                        && bodies.orientationX[s] == pose.qx()
                        && bodies.orientationY[s] == pose.qy()
                        && bodies.orientationZ[s] == pose.qz()
                        && bodies.orientationW[s] == pose.qw();
        if (same) {
            return;
        }
        try {
            double f =
                    Rotations.inverseLength("rotation", pose.qx(), pose.qy(), pose.qz(), pose.qw());
            put(
                    s,
                    pose.x(),
                    pose.y(),
                    pose.z(),
                    pose.qx() * f,
                    pose.qy() * f,
                    pose.qz() * f,
                    pose.qw() * f);
        } catch (IllegalArgumentException refusal) {
            throw new IllegalArgumentException(
                    "the Pose that was set for "
                            + table.refs[s]
                            + " is no place to put it: "
                            + refusal.getMessage(),
                    refusal);
        }
    }

    void teleport(int s, double x, double y, double z) {
        place(
                s,
                x,
                y,
                z,
                bodies.orientationX[s],
                bodies.orientationY[s],
                bodies.orientationZ[s],
                bodies.orientationW[s]);
    }

    void teleport(int s, double x, double y, double z, Quaterniondc q) {
        double f = Rotations.inverseLength("rotation", q.x(), q.y(), q.z(), q.w());
        place(s, x, y, z, q.x() * f, q.y() * f, q.z() * f, q.w() * f);
    }

    /** The ECS is written first: if it refuses (a step runs), nothing has changed. */
    private void place(
            int s, double x, double y, double z, double qx, double qy, double qz, double qw) {
        checkPlace(s, x, y, z, qx, qy, qz, qw);
        int jumps = table.registry.jumps[s] + 1;
        table.world().set(bodies.entity[s], new Pose(x, y, z, qx, qy, qz, qw, jumps));
        put(s, x, y, z, qx, qy, qz, qw);
    }

    /** Where the centre of mass would be, in {@link #rotated}. */
    private void checkPlace(
            int s, double x, double y, double z, double qx, double qy, double qz, double qw) {
        Rotations.rotate(
                qx,
                qy,
                qz,
                qw,
                table.registry.comX[s],
                table.registry.comY[s],
                table.registry.comZ[s],
                rotated);
        rotated[0] = Checks.between("x", x + rotated[0], -StepLimits.LARGEST, StepLimits.LARGEST);
        rotated[1] = Checks.between("y", y + rotated[1], -StepLimits.LARGEST, StepLimits.LARGEST);
        rotated[2] = Checks.between("z", z + rotated[2], -StepLimits.LARGEST, StepLimits.LARGEST);
    }

    private void put(
            int s, double x, double y, double z, double qx, double qy, double qz, double qw) {
        checkPlace(s, x, y, z, qx, qy, qz, qw);
        table.registry.jumps[s]++;
        table.registry.places++;
        wake(s);
        bodies.place(s, rotated[0], rotated[1], rotated[2]);
        bodies.orientationX[s] = qx;
        bodies.orientationY[s] = qy;
        bodies.orientationZ[s] = qz;
        bodies.orientationW[s] = qw;
        table.colliders.compose(s);
        if (isUnmoved(s)) {
            table.registry.motion.forget(s);
            table.registry.addUnplaced(s);
        }
    }

    void remove(int s) {
        table.world().delete(bodies.entity[s]);
    }
}
