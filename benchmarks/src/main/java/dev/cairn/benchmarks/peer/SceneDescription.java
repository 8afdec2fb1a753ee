package dev.cairn.benchmarks.peer;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Shape;
import dev.cairn.samples.SampleScene;

import org.joml.Matrix3d;
import org.joml.Matrix3dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.List;

/**
 * A scene as plain data: what every engine is given. SI units, y up. Immutable.
 *
 * @param bodies the bodies, fixed and movable, in the order in which the scene added them
 * @param gravity m/s² along -y
 * @param stepSeconds length of a tick, s
 */
public record SceneDescription(List<Solid> bodies, double gravity, double stepSeconds) {

    /** Copies the list. */
    public SceneDescription {
        bodies = List.copyOf(bodies);
    }

    /**
     * A body at the start.
     *
     * @param shape its shape; the centre of mass is that of the shape at uniform density
     * @param centre centre of mass, world, m
     * @param rotation unit quaternion worldFromBody
     * @param fixed true if nothing moves it
     * @param mass kg; 0 for a fixed body
     * @param inertia about the centre of mass, in the shape's axes, kg m²; 0 for a fixed body
     * @param velocity of the centre of mass, world, m/s
     * @param angularVelocity world, rad/s
     * @param friction Coulomb coefficient; that of a pair is the square root of the product
     * @param restitution coefficient of restitution; that of a pair is the larger one
     */
    public record Solid(
            Shape shape,
            Vector3dc centre,
            Quaterniondc rotation,
            boolean fixed,
            double mass,
            Matrix3dc inertia,
            Vector3dc velocity,
            Vector3dc angularVelocity,
            double friction,
            double restitution) {

        /**
         * Says whether the axes of the shape are principal axes, as for boxes and spheres.
         *
         * @return true if the inertia is diagonal to 1e-9 of its size
         */
        public boolean isDiagonal() {
            double size = inertia.m00() + inertia.m11() + inertia.m22();
            double off =
                    Math.abs(inertia.m01()) + Math.abs(inertia.m02()) + Math.abs(inertia.m12());
            return off <= 1e-9 * size;
        }
    }

    /**
     * Reads the bodies of a scene back from the world that its script built.
     *
     * @param bodies the bodies, before the first tick
     * @return what the other engines are given
     */
    public static SceneDescription of(List<BodyRef> bodies) {
        List<Solid> solids = new ArrayList<>();
        for (BodyRef body : bodies) {
            boolean fixed = body.isFixed();
            Quaterniond rotation = body.orientation();
            Matrix3d inertia = new Matrix3d().zero();
            if (!fixed) {
                // World axes to the shape's: R^T I R.
                Matrix3d r = new Matrix3d().rotation(rotation);
                Matrix3d world = body.inverseInertia(new Matrix3d()).invert();
                inertia = new Matrix3d(r).transpose().mul(world).mul(r);
            }
            solids.add(
                    new Solid(
                            body.shape(),
                            body.centreOfMass(new Vector3d()),
                            rotation,
                            fixed,
                            fixed ? 0 : body.mass(),
                            inertia,
                            fixed ? new Vector3d() : body.velocity(),
                            fixed ? new Vector3d() : body.angularVelocity(),
                            body.material().friction(),
                            body.material().restitution()));
        }
        return new SceneDescription(solids, SampleScene.GRAVITY, SampleScene.STEP_SECONDS);
    }

    /**
     * The number of bodies that move.
     *
     * @return at most the number of bodies
     */
    public int movable() {
        int count = 0;
        for (Solid solid : bodies) {
            count += solid.fixed() ? 0 : 1;
        }
        return count;
    }
}
