package dev.cairn.benchmarks.peer;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneBuilder.ConstantForce;

import org.joml.Matrix3d;
import org.joml.Matrix3dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * A scene as plain data: what every engine is given. SI units, y up. Immutable.
 *
 * <p>Hulls are given about their centre of mass and turned into their principal axes, so that no
 * engine has to be told an offset or products of inertia. Meshes and height fields are given as
 * they are, about the origin of their body, which is then its centre here; peers take their {@link
 * Triangles}.
 *
 * @param bodies the bodies, fixed and movable, in the order in which the scene added them
 * @param links the joints between them
 * @param forces that act in every tick
 * @param gravity m/s² along -y
 * @param stepSeconds length of a tick, s
 */
public record SceneDescription(
        List<Solid> bodies,
        List<Link> links,
        List<ConstantForce> forces,
        double gravity,
        double stepSeconds) {

    /** Copies the lists. */
    public SceneDescription {
        bodies = List.copyOf(bodies);
        links = List.copyOf(links);
        forces = List.copyOf(forces);
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
     * @param sceneFromShape what the shape was turned by against the scene's own
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
            double restitution,
            Quaterniondc sceneFromShape) {

        /**
         * The vertices of a hull, as floats.
         *
         * @param hull the shape
         * @return x y z of each
         */
        static float[] points(ConvexHull hull) {
            double[] xyz = hull.vertices();
            float[] floats = new float[xyz.length];
            for (int i = 0; i < xyz.length; i++) {
                floats[i] = (float) xyz[i];
            }
            return floats;
        }
    }

    /**
     * Reads the bodies and joints of a scene back from the world that its script built.
     *
     * @param scene the scene, before the first tick
     * @return what the other engines are given
     * @throws IllegalArgumentException if a joint is more than the other engines are given
     */
    public static SceneDescription of(SceneBuilder scene) {
        List<Solid> solids = new ArrayList<>();
        IdentityHashMap<Shape, Turned> turned = new IdentityHashMap<>();
        Map<Long, Integer> indexOf = new HashMap<>();
        for (BodyRef body : scene.bodies()) {
            indexOf.put(body.entity(), solids.size());
            solids.add(solid(body, turned));
        }
        List<Link> links = new ArrayList<>();
        for (JointRef joint : scene.world().joints().all()) {
            links.add(Link.of(joint, indexOf, solids));
        }
        return new SceneDescription(
                solids, links, scene.forces(), SampleScene.GRAVITY, SampleScene.STEP_SECONDS);
    }

    private static Solid solid(BodyRef body, IdentityHashMap<Shape, Turned> known) {
        boolean fixed = body.isFixed();
        Quaterniond rotation = body.orientation();
        Matrix3d inertia = new Matrix3d().zero();
        if (!fixed) {
            // World axes to the shape's: R^T I R.
            Matrix3d world = body.inverseInertia(new Matrix3d()).invert();
            inertia = turnedInto(rotation, world);
        }
        Shape shape = body.shape();
        Quaterniond sceneFromShape = new Quaterniond();
        if (shape instanceof ConvexHull hull) {
            Matrix3d about = fixed ? new Matrix3d() : inertia;
            Turned principal = known.computeIfAbsent(shape, _ -> Turned.of(hull, about));
            shape = principal.hull();
            sceneFromShape.set(principal.sceneFromShape());
            rotation.mul(sceneFromShape);
            inertia = turnedInto(sceneFromShape, inertia);
        }
        return new Solid(
                shape,
                body.centreOfMass(new Vector3d()),
                rotation,
                fixed,
                fixed ? 0 : body.mass(),
                inertia,
                fixed ? new Vector3d() : body.velocity(),
                fixed ? new Vector3d() : body.angularVelocity(),
                body.material().friction(),
                body.material().restitution(),
                sceneFromShape);
    }

    private static Matrix3d turnedInto(Quaterniondc rotation, Matrix3d tensor) {
        Matrix3d r = new Matrix3d().rotation(rotation);
        return new Matrix3d(r).transpose().mul(tensor).mul(r);
    }

    /** A hull in its principal axes. */
    private record Turned(ConvexHull hull, Quaterniond sceneFromShape) {
        static Turned of(ConvexHull hull, Matrix3d inertia) {
            Quaterniond axes = Principal.axes(inertia);
            Vector3d centre = hull.centreOfMass(new Vector3d());
            double[] xyz = hull.vertices().clone();
            Vector3d p = new Vector3d();
            for (int i = 0; i < xyz.length; i += 3) {
                axes.transformInverse(p.set(xyz[i], xyz[i + 1], xyz[i + 2]).sub(centre));
                xyz[i] = p.x;
                xyz[i + 1] = p.y;
                xyz[i + 2] = p.z;
            }
            return new Turned(ConvexHull.of(xyz), axes);
        }
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
