package dev.cairn.physics;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.BodyMass;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.MassOverride;
import dev.cairn.physics.internal.Palettes;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.union.ConvexUnion;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * The description of a shape on a body, for {@link Body#collider} and {@link BodyRef#add}. What is
 * not said, material and filter, is the body's. Immutable: each call returns another description;
 * any thread.
 */
public final class Collider {
    final Shape shape;
    final double x, y, z, qx, qy, qz, qw;
    final @Nullable Material material;
    final @Nullable Filter filter;
    final @Nullable Object userData;
    final boolean sensor;

    /** Of triangles with the numbers 1, 2, ...; never written to. */
    private final List<Material> materials;

    /** Of these, as {@code Palettes} has them. */
    private final double[] palette;

    /** Of the surface, body axes, m/s; NaN for the material's. */
    private final double beltX, beltY, beltZ;

    /** The shape in the body's frame. */
    final Shape placed;

    /** How a collider becomes bytes. */
    static final StateCodec<Collider> CODEC =
            StateCodec.of(Collider.class, "collider", Collider::write, Collider::read);

    private void write(StateOutput out) {
        out.writeObject(shape);
        out.writeDoubles(pose());
        out.writeBoolean(material != null);
        if (material != null) {
            material.write(out);
        }
        out.writeObject(filter);
        out.writeObject(userData);
        out.writeBoolean(sensor);
        out.writeInt(materials.size());
        for (Material each : materials) {
            each.write(out);
        }
    }

    private static List<Material> many(StateInput in) {
        int count = in.readInt();
        if (count < 0 || count > 254) {
            throw new IllegalArgumentException("a collider of " + count + " materials");
        }
        List<Material> all = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            all.add(Material.read(in));
        }
        return List.copyOf(all);
    }

    private static Collider read(StateInput in) {
        Shape shape = in.readObject(Shape.class);
        double[] pose = in.readDoubles();
        Material material = in.readBoolean() ? Material.read(in) : null;
        Filter filter = in.readNullable(Filter.class);
        Object userData = in.readNullable(Object.class);
        return new Collider(shape, pose, material, filter, userData, in.readBoolean(), many(in));
    }

    private Collider(
            Shape shape,
            double[] pose,
            @Nullable Material material,
            @Nullable Filter filter,
            @Nullable Object userData,
            boolean sensor,
            List<Material> materials) {
        this.sensor = sensor;
        this.materials = materials;
        palette = palette(materials);
        beltX = pose[7];
        beltY = pose[8];
        beltZ = pose[9];
        this.shape = shape;
        x = pose[0];
        y = pose[1];
        z = pose[2];
        qx = pose[3];
        qy = pose[4];
        qz = pose[5];
        qw = pose[6];
        this.material = material;
        this.filter = filter;
        this.userData = userData;
        boolean isMoved = x != 0 || y != 0 || z != 0 || qx != 0 || qy != 0 || qz != 0;
        placed = isMoved ? shape.moved(x, y, z, new Quaterniond(qx, qy, qz, qw)) : shape;
    }

    /**
     * A shape at the origin of the body's frame.
     *
     * @param shape the shape; shared, not copied
     * @return a new description
     */
    public static Collider of(Shape shape) {
        double[] pose = {0, 0, 0, 0, 0, 0, 1, Double.NaN, Double.NaN, Double.NaN};
        return new Collider(
                Checks.notNull("shape", shape), pose, null, null, null, false, List.of());
    }

    /**
     * Places the origin of the shape's frame in the body's frame; (0, 0, 0) by default.
     *
     * @param bodyX m, finite
     * @param bodyY m, finite
     * @param bodyZ m, finite
     * @return a new description
     */
    public Collider at(double bodyX, double bodyY, double bodyZ) {
        Checks.finite("x", bodyX);
        Checks.finite("y", bodyY);
        Checks.finite("z", bodyZ);
        double[] pose = {bodyX, bodyY, bodyZ, qx, qy, qz, qw, beltX, beltY, beltZ};
        return new Collider(shape, pose, material, filter, userData, sensor, materials);
    }

    /**
     * Places the origin of the shape's frame in the body's frame.
     *
     * @param body m, finite
     * @return a new description
     */
    public Collider at(Vector3dc body) {
        Checks.notNull("body", body);
        return at(body.x(), body.y(), body.z());
    }

    /**
     * Turns the shape's frame in the body's frame; no rotation by default.
     *
     * @param bodyFromShape unit quaternion, its length within 1e-6 of 1
     * @return a new description
     * @throws IllegalArgumentException if it is not finite or not of unit length
     */
    public Collider rotation(Quaterniondc bodyFromShape) {
        Quaterniondc q = Checks.notNull("rotation", bodyFromShape);
        double f = Rotations.inverseLength("rotation", q.x(), q.y(), q.z(), q.w());
        double[] pose = {x, y, z, q.x() * f, q.y() * f, q.z() * f, q.w() * f, beltX, beltY, beltZ};
        return new Collider(shape, pose, material, filter, userData, sensor, materials);
    }

    /**
     * Sets friction, restitution and density; the body's by default.
     *
     * @param value the material
     * @return a new description
     */
    public Collider material(Material value) {
        Checks.notNull("material", value);
        return new Collider(shape, pose(), value, filter, userData, sensor, materials);
    }

    /**
     * Says what the collider collides with; the body's filter by default.
     *
     * @param value the filter
     * @return a new description
     */
    public Collider filter(Filter value) {
        Checks.notNull("filter", value);
        return new Collider(shape, pose(), material, value, userData, sensor, materials);
    }

    /**
     * Attaches anything of the user's, to be found again at {@link ColliderRef#userData}.
     *
     * @param value any object, or {@code null}
     * @return a new description
     */
    public Collider userData(@Nullable Object value) {
        return new Collider(shape, pose(), material, filter, value, sensor, materials);
    }

    /**
     * Says whether the collider only tells what is in it, see {@link Contacts#entered}; it pushes
     * nothing, weighs nothing beside colliders that are none, wakes no body, and does not see other
     * sensors. False by default.
     *
     * @param value true for a sensor
     * @return a new description
     * @throws IllegalArgumentException if it is a half-space, which has no end
     */
    public Collider sensor(boolean value) {
        if (value && shape instanceof HalfSpace) {
            throw new IllegalArgumentException(
                    "a half-space cannot be a sensor, for it has no end; use a large box");
        }
        return new Collider(shape, pose(), material, filter, userData, value, materials);
    }

    /**
     * Lets the surface run along, as that of a conveyor belt, while the body stays: what touches it
     * is dragged, by friction, up to this velocity against the body. A dynamic body is pushed the
     * other way. Of the velocity only what is along a contact acts. That of the material by
     * default, which is 0 for most, see {@link Material#withSurfaceVelocity}.
     *
     * @param bodyX body axes, m/s, finite
     * @param bodyY body axes, m/s, finite
     * @param bodyZ body axes, m/s, finite
     * @return a new description
     */
    public Collider surfaceVelocity(double bodyX, double bodyY, double bodyZ) {
        double[] pose = pose();
        pose[7] = Checks.finite("surfaceVelocity x", bodyX);
        pose[8] = Checks.finite("surfaceVelocity y", bodyY);
        pose[9] = Checks.finite("surfaceVelocity z", bodyZ);
        return new Collider(shape, pose, material, filter, userData, sensor, materials);
    }

    /**
     * Lets the surface run along, see {@link #surfaceVelocity(double, double, double)}.
     *
     * @param body axes of the body, m/s, finite
     * @return a new description
     */
    public Collider surfaceVelocity(Vector3dc body) {
        Checks.notNull("body", body);
        return surfaceVelocity(body.x(), body.y(), body.z());
    }

    private double[] pose() {
        return new double[] {x, y, z, qx, qy, qz, qw, beltX, beltY, beltZ};
    }

    /**
     * The same with more materials, for surfaces whose triangles have numbers ({@code
     * TriangleMesh.withMaterials}, {@code HeightField.withMaterial}): 0 is the material of the
     * collider, 1 the first of these, and so on. A number without one is as 0.
     *
     * @param others the materials of 1, 2, ...; at most 254
     * @return a copy
     * @throws IllegalArgumentException if there are more
     */
    public Collider materials(Material... others) {
        if (others.length > 254) {
            throw new IllegalArgumentException(
                    others.length + " materials; a surface has at most 254 beside its own");
        }
        return new Collider(shape, pose(), material, filter, userData, sensor, List.of(others));
    }

    /**
     * The materials of triangles with the numbers 1, 2, ....
     *
     * @return what {@link #materials(Material...)} was given; not to be changed
     */
    public List<Material> materials() {
        return materials;
    }

    /** As {@code Palettes} has them; not to be changed. */
    double[] palette() {
        return palette;
    }

    private static double[] palette(List<Material> materials) {
        double[] all = new double[Palettes.MATERIAL * materials.size()];
        for (int i = 0; i < materials.size(); i++) {
            Material m = materials.get(i);
            int at = Palettes.MATERIAL * i;
            all[at] = m.friction();
            all[at + 1] = m.restitution();
            all[at + 2] = m.rollingArm();
            all[at + 3] = rules(m);
            all[at + Palettes.BELT] = m.surfaceX();
            all[at + Palettes.BELT + 1] = m.surfaceY();
            all[at + Palettes.BELT + 2] = m.surfaceZ();
        }
        return all;
    }

    /** How the coefficients of a material are mixed, as {@code ColliderStore.mixing}. */
    static byte rules(Material m) {
        return (byte) (m.frictionMix().strength() | m.restitutionMix().strength() << 4);
    }

    /** The same with another shape. */
    Collider reshaped(Shape other) {
        return new Collider(other, pose(), material, filter, userData, sensor, materials);
    }

    /** Whether another one differs in its shape at most. */
    boolean isLike(Collider other) {
        return Arrays.equals(pose(), other.pose())
                && material().equals(other.material())
                && filter().equals(other.filter())
                && Objects.equals(userData, other.userData)
                && sensor == other.sensor
                && materials.equals(other.materials);
    }

    /** With a material and a filter, if none was said. */
    Collider orElse(Material otherMaterial, Filter otherFilter) {
        return new Collider(
                shape,
                pose(),
                material == null ? otherMaterial : material,
                filter == null ? otherFilter : filter,
                userData,
                sensor,
                materials);
    }

    /**
     * The shape.
     *
     * @return as it was given
     */
    public Shape shape() {
        return shape;
    }

    /**
     * The shape where it is in the body's frame.
     *
     * @return the shape, moved and turned
     */
    public Shape placed() {
        return placed;
    }

    /**
     * Where the origin of the shape's frame is in the body's.
     *
     * @param destination receives m
     * @return destination
     */
    public Vector3d localPosition(Vector3d destination) {
        return destination.set(x, y, z);
    }

    /**
     * How the shape's frame is turned in the body's.
     *
     * @param destination receives a unit quaternion
     * @return destination
     */
    public Quaterniond localRotation(Quaterniond destination) {
        return destination.set(qx, qy, qz, qw);
    }

    /**
     * The velocity at which the surface runs along: its own, or that of its material.
     *
     * @param destination receives m/s, body axes; 0 for most
     * @return destination
     */
    public Vector3d surfaceVelocity(Vector3d destination) {
        if (!Double.isNaN(beltX)) {
            return destination.set(beltX, beltY, beltZ);
        }
        return material == null ? destination.zero() : material.surfaceVelocity(destination);
    }

    /** The shape, neither moved nor turned. */
    Shape solid() {
        return Surface.unmoved(placed);
    }

    /** The pose of its centre in the body, from a centre of mass: m, unit quaternion. */
    double[] from(double centreX, double centreY, double centreZ) {
        MassProperties p = placed.massProperties(1);
        double[] pose = {p.comX() - centreX, p.comY() - centreY, p.comZ() - centreZ, 0, 0, 0, 1};
        if (placed instanceof Moved m) {
            pose[3] = m.rotationX();
            pose[4] = m.rotationY();
            pose[5] = m.rotationZ();
            pose[6] = m.rotationW();
        }
        return pose;
    }

    /** Mass, centre and inertia of the parts of a body, or what the user gave instead. */
    static MassProperties mass(List<Collider> parts, boolean fixed, MassOverride given) {
        for (Collider part : parts) {
            if (!fixed && Surface.isMeshed(part.shape())) {
                throw new IllegalArgumentException(
                        part.shape()
                                + " is a surface without an inside, so its body cannot be dynamic;"
                                + " make the body fixed or kinematic, or take ConvexHull.of its"
                                + " vertices, or several hulls as colliders of one body");
            }
        }
        if (parts.size() == 1) {
            Collider only = parts.get(0);
            MassProperties own = only.placed.massProperties(only.material().density());
            return BodyMass.of(only.placed, own, fixed, given);
        }
        List<MassProperties> all = new ArrayList<>();
        boolean solid = false;
        for (Collider part : parts) {
            solid |= !part.sensor;
        }
        Shape whole = whole(parts);
        if (whole != null) {
            all.add(whole.massProperties(parts.get(0).material().density()));
        }
        for (Collider part : parts) {
            if (whole == null && (!part.sensor || !solid)) {
                all.add(part.placed.massProperties(part.material().density()));
            }
        }
        return BodyMass.of(parts, BodyMass.sum(all), fixed, given);
    }

    /** What all parts make if they are of one density: it weighs what they do, rounded once. */
    private static @Nullable Shape whole(List<Collider> parts) {
        int[] like = new int[parts.size()];
        List<Shape> shapes = new ArrayList<>();
        List<double[]> poses = new ArrayList<>();
        double density = parts.get(0).material().density();
        for (Collider part : parts) {
            if (part.sensor || part.material().density() != density) {
                return null;
            }
            shapes.add(part.solid());
            poses.add(part.from(0, 0, 0));
        }
        List<ConvexUnion> unions = ConvexUnion.of(shapes, poses, like);
        if (unions.size() != 1 || unions.get(0).members().length < parts.size()) {
            return null;
        }
        return unions.get(0).placed();
    }

    Material material() {
        return material == null ? Material.DEFAULT : material;
    }

    Filter filter() {
        return filter == null ? Filter.ALL : filter;
    }

    @Override
    public String toString() {
        return "collider " + shape + " at (" + x + ", " + y + ", " + z + ")";
    }
}
