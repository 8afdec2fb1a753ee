package dev.cairn.physics;

import dev.cairn.physics.shape.Shape;
import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;

/** The bodies of a world behind {@link BodyRef}. */
final class BodyTable {
    boolean isAlive(int slot, long entity) {
        throw new UnsupportedOperationException();
    }

    boolean isFixed(int slot) {
        throw new UnsupportedOperationException();
    }

    Shape shape(int slot) {
        throw new UnsupportedOperationException();
    }

    Material material(int slot) {
        throw new UnsupportedOperationException();
    }

    double mass(int slot) {
        throw new UnsupportedOperationException();
    }

    Matrix3d inverseInertia(int slot, Matrix3d d) {
        throw new UnsupportedOperationException();
    }

    Vector3d position(int slot, Vector3d d) {
        throw new UnsupportedOperationException();
    }

    Vector3d centreOfMass(int slot, Vector3d d) {
        throw new UnsupportedOperationException();
    }

    Quaterniond orientation(int slot, Quaterniond d) {
        throw new UnsupportedOperationException();
    }

    Vector3d velocity(int slot, Vector3d d) {
        throw new UnsupportedOperationException();
    }

    Vector3d angularVelocity(int slot, Vector3d d) {
        throw new UnsupportedOperationException();
    }

    void applyForce(int slot, double fx, double fy, double fz) {}

    void applyForceAt(int slot, double fx, double fy, double fz, double px, double py, double pz) {}

    void applyTorque(int slot, double tx, double ty, double tz) {}

    void applyImpulse(int slot, double x, double y, double z) {}

    void applyImpulseAt(int slot, double x, double y, double z, double px, double py, double pz) {}

    void applyAngularImpulse(int slot, double x, double y, double z) {}

    void setVelocity(int slot, double x, double y, double z) {}

    void setAngularVelocity(int slot, double x, double y, double z) {}

    void teleport(int slot, double x, double y, double z) {}

    void teleport(int slot, double x, double y, double z, Quaterniondc q) {}

    void remove(int slot) {}
}
