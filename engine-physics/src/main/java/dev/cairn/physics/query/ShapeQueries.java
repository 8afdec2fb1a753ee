package dev.cairn.physics.query;

import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.mesh.TriangleSet;

import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

/**
 * Rays, moving shapes, distances and overlaps of single shapes. Owns scratch memory: one per
 * thread. Allocates nothing.
 */
public final class ShapeQueries {
    private static final int MOST_STEPS = 64;

    /** So small a ball that it is a point: its radius is lost in the rounding of any coordinate. */
    private static final Sphere POINT = Sphere.of(1e-50);

    private final NarrowPhase narrowPhase = new NarrowPhase();
    private final Manifold manifold = new Manifold();
    private final Placement moving = new Placement();

    private static final Motion REST = new Motion();

    /** Made when it is needed first. */
    private @Nullable MeshQueries meshQueries;

    /** Made when it is needed first. */
    private @Nullable Sweeps sweeps;

    /** Creates the scratch of one thread. */
    public ShapeQueries() {}

    /**
     * The signed distance of two shapes.
     *
     * @param a first shape
     * @param b second shape
     * @return m; negative when they overlap, see {@link Closest#distance}; of a surface of
     *     triangles that of the triangle with the least one, and infinite for two surfaces
     */
    public double distance(Placement a, Placement b) {
        TriangleSet surface = MeshQueries.triangles(a.shape);
        if (surface != null) {
            return meshes().distance(a, surface, b);
        }
        surface = MeshQueries.triangles(b.shape);
        if (surface != null) {
            return meshes().distance(b, surface, a);
        }
        return convexDistance(a, b);
    }

    private MeshQueries meshes() {
        if (meshQueries == null) {
            meshQueries = new MeshQueries(narrowPhase);
        }
        return meshQueries;
    }

    private double convexDistance(Placement a, Placement b) {
        return narrowPhase.distance(
                a.shape, b.shape, a.qx, a.qy, a.qz, a.qw, b.qx, b.qy, b.qz, b.qw, b.x - a.x,
                b.y - a.y, b.z - a.z);
    }

    /**
     * Whether two shapes touch or overlap.
     *
     * @param a first shape
     * @param b second shape
     * @return true when their signed distance is not positive
     */
    public boolean overlaps(Placement a, Placement b) {
        return distance(a, b) <= 0;
    }

    /**
     * The nearest points of two shapes.
     *
     * @param a first shape
     * @param b second shape
     * @param out receives points, normal and signed distance
     * @return the signed distance, m
     */
    public double closest(Placement a, Placement b, Closest out) {
        out.triangle = -1;
        TriangleSet surface = MeshQueries.triangles(a.shape);
        if (surface != null) {
            return meshes().closest(a, surface, b, manifold, out);
        }
        surface = MeshQueries.triangles(b.shape);
        if (surface != null) {
            double d = meshes().closest(b, surface, a, manifold, out);
            out.swap();
            return d;
        }
        double d =
                narrowPhase.closest(
                        a.shape, b.shape, a.qx, a.qy, a.qz, a.qw, b.qx, b.qy, b.qz, b.qw, b.x - a.x,
                        b.y - a.y, b.z - a.z, manifold);
        double half = d / 2;
        out.distance = d;
        out.normalX = manifold.normalX;
        out.normalY = manifold.normalY;
        out.normalZ = manifold.normalZ;
        double x = manifold.pointX[0];
        double y = manifold.pointY[0];
        double z = manifold.pointZ[0];
        out.ax = a.x + (x - half * out.normalX);
        out.ay = a.y + (y - half * out.normalY);
        out.az = a.z + (z - half * out.normalZ);
        out.bx = a.x + (x + half * out.normalX);
        out.by = a.y + (y + half * out.normalY);
        out.bz = a.z + (z + half * out.normalZ);
        return d;
    }

    /**
     * Follows a ray until it meets a shape.
     *
     * @param target the shape
     * @param originX where the ray starts, world, m, finite
     * @param originY see {@code originX}
     * @param originZ see {@code originX}
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hit; unchanged when there is none
     * @return whether there is one
     * @throws IllegalArgumentException if a number is not finite, the direction is zero or the
     *     distance negative
     */
    public boolean rayCast(
            Placement target,
            double originX,
            double originY,
            double originZ,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            Hit out) {
        Placement.finite("originX", originX);
        Placement.finite("originY", originY);
        Placement.finite("originZ", originZ);
        moving.setCentre(POINT, originX, originY, originZ, 0, 0, 0, 1);
        return cast(moving, directionX, directionY, directionZ, maxDistance, target, out);
    }

    /**
     * Moves a shape, without turning it, until it meets another.
     *
     * @param mover the shape that moves, where it starts
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param target the shape that stays
     * @param out receives the hit; unchanged when there is none
     * @return whether there is one
     * @throws IllegalArgumentException if a number is not finite, the direction is zero or the
     *     distance negative
     */
    public boolean shapeCast(
            Placement mover,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            Placement target,
            Hit out) {
        moving.setCentre(
                mover.shape, mover.x, mover.y, mover.z, mover.qx, mover.qy, mover.qz, mover.qw);
        return cast(moving, directionX, directionY, directionZ, maxDistance, target, out);
    }

    /**
     * Moves and turns a shape until it meets another.
     *
     * @param mover the shape that moves, where it starts
     * @param motion how it moves
     * @param seconds for how long, s, at least 0, finite
     * @param target the shape that stays
     * @param out receives the hit, with {@link Hit#seconds}; unchanged when there is none
     * @return whether there is one
     * @throws IllegalArgumentException if the time is negative or not finite, or if the shape turns
     *     by more than 1e5 rad in it
     */
    public boolean turningCast(
            Placement mover, Motion motion, double seconds, Placement target, Hit out) {
        return timeOfImpact(mover, motion, target, REST, seconds, out);
    }

    /**
     * Moves and turns two shapes until they meet: the first time at which they touch, to the
     * rounding of their places. No meeting is missed, however fast or often they turn. The time of
     * a search grows with the number of turns near each other.
     *
     * <p>Two surfaces of triangles do not meet here, as they have no distance. A triangle that has
     * one side is met from its front.
     *
     * <p>Shapes that stay nearer than 1e-6 of their size to each other for long without touching
     * are taken to touch after a few thousand looks; {@link Hit#capped} tells of it.
     *
     * @param a a shape, where it starts
     * @param motionA how it moves
     * @param b the other shape, where it starts
     * @param motionB how it moves
     * @param seconds for how long, s, at least 0, finite
     * @param out receives the hit, with {@link Hit#seconds}, the point where they touch then, and
     *     the outward normal of b; unchanged when there is none
     * @return whether there is one
     * @throws IllegalArgumentException if the time is negative or not finite, or if a shape turns
     *     by more than 1e5 rad in it
     */
    public boolean timeOfImpact(
            Placement a, Motion motionA, Placement b, Motion motionB, double seconds, Hit out) {
        if (sweeps == null) {
            sweeps = new Sweeps(narrowPhase, meshes());
        }
        return sweeps.meet(a, motionA, b, motionB, seconds, out);
    }

    /**
     * Follows a ray to a shape.
     *
     * @param target the shape
     * @param from where the ray starts, world, m
     * @param direction where it goes, any length above 0
     * @param maxDistance how far, m, at least 0
     * @param out receives the hit; unchanged when there is none
     * @return whether there is one
     */
    public boolean rayCast(
            Placement target, Vector3dc from, Vector3dc direction, double maxDistance, Hit out) {
        return rayCast(
                target,
                from.x(),
                from.y(),
                from.z(),
                direction.x(),
                direction.y(),
                direction.z(),
                maxDistance,
                out);
    }

    /**
     * Moves a shape, without turning it, to another one.
     *
     * @param mover the shape that moves
     * @param direction where it goes, any length above 0
     * @param maxDistance how far, m, at least 0
     * @param target the shape that it meets
     * @param out receives the hit; unchanged when there is none
     * @return whether there is one
     */
    public boolean shapeCast(
            Placement mover, Vector3dc direction, double maxDistance, Placement target, Hit out) {
        return shapeCast(
                mover, direction.x(), direction.y(), direction.z(), maxDistance, target, out);
    }

    private boolean cast(
            Placement mover,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            Placement target,
            Hit out) {
        Checks.direction(directionX, directionY, directionZ);
        if (!(maxDistance >= 0)) {
            throw new IllegalArgumentException(
                    "maxDistance is " + maxDistance + " m; it must be at least 0");
        }
        double most =
                Math.max(
                        Math.abs(directionX), Math.max(Math.abs(directionY), Math.abs(directionZ)));
        double dx = directionX / most;
        double dy = directionY / most;
        double dz = directionZ / most;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        dx /= length;
        dy /= length;
        dz /= length;
        out.triangle = -1;
        out.seconds = 0;
        TriangleSet surface = MeshQueries.triangles(target.shape);
        if (surface != null) {
            return mover.shape == POINT
                    ? meshes().rayCast(target, surface, mover, dx, dy, dz, maxDistance, out)
                    : meshes().shapeCast(
                                    this, mover, dx, dy, dz, maxDistance, target, surface, out);
        }
        surface = MeshQueries.triangles(mover.shape);
        if (surface != null) {
            // seen from the surface, the other shape comes towards it
            Placement from = mover;
            boolean meets =
                    meshes().shapeCast(
                                    this, target, -dx, -dy, -dz, maxDistance, from, surface, out);
            if (meets) {
                out.back(dx, dy, dz);
            }
            return meets;
        }
        return castOne(mover, dx, dy, dz, maxDistance, target, out);
    }

    /**
     * Two convex shapes.
     *
     * @param start where the mover starts; stays
     * @param dx unit direction
     */
    boolean castOne(
            Placement start,
            double dx,
            double dy,
            double dz,
            double maxDistance,
            Placement target,
            Hit out) {
        Placement mover = moving;
        if (start != moving) {
            moving.setCentre(
                    start.shape, start.x, start.y, start.z, start.qx, start.qy, start.qz, start.qw);
        }
        double startX = mover.x;
        double startY = mover.y;
        double startZ = mover.z;
        double t = 0;
        for (int step = 0; ; step++) {
            double s = convexDistance(mover, target);
            double nx = narrowPhase.axisX();
            double ny = narrowPhase.axisY();
            double nz = narrowPhase.axisZ();
            // What the coordinates can tell apart.
            double reach =
                    Math.abs(mover.x - target.x)
                            + Math.abs(mover.y - target.y)
                            + Math.abs(mover.z - target.z);
            double touching = 0x1p-46 * (mover.size() + target.size()) + 0x1p-50 * (reach + t);
            if (s <= touching || step == MOST_STEPS) {
                out.capped = s > touching;
                out.inside = step == 0 && s <= 0;
                out.distance = t;
                out.normalX = -nx;
                out.normalY = -ny;
                out.normalZ = -nz;
                contactPoint(mover, target, out);
                return true;
            }
            // The plane at right angles to n is reached after s / (v . n), and not before.
            double approach = dx * nx + dy * ny + dz * nz;
            if (!(approach > 0) || t + s / approach > maxDistance) {
                return false;
            }
            double next = t + s / approach;
            if (next == t) {
                next = Math.nextUp(t);
            }
            t = next;
            mover.x = startX + t * dx;
            mover.y = startY + t * dy;
            mover.z = startZ + t * dz;
        }
    }

    /** A ray touches where it is; a shape at the nearest point of the target. */
    private void contactPoint(Placement mover, Placement target, Hit out) {
        if (mover.shape == POINT) {
            out.pointX = mover.x;
            out.pointY = mover.y;
            out.pointZ = mover.z;
            return;
        }
        double d =
                narrowPhase.closest(
                        mover.shape,
                        target.shape,
                        mover.qx,
                        mover.qy,
                        mover.qz,
                        mover.qw,
                        target.qx,
                        target.qy,
                        target.qz,
                        target.qw,
                        target.x - mover.x,
                        target.y - mover.y,
                        target.z - mover.z,
                        manifold);
        double half = d / 2;
        out.pointX = mover.x + manifold.pointX[0] + half * manifold.normalX;
        out.pointY = mover.y + manifold.pointY[0] + half * manifold.normalY;
        out.pointZ = mover.z + manifold.pointZ[0] + half * manifold.normalZ;
    }
}
