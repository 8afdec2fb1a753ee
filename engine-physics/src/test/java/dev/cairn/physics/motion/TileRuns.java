package dev.cairn.physics.motion;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.PhysicsWorldBuilder;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.Random;

/** One body that crosses a floor, which is of tiles or one slab: the two must not differ. */
final class TileRuns {
    /**
     * What crosses: ball, cube, slab-like box, capsule, cylinders, hull, compound, cone on its
     * base, hull of corners anywhere.
     */
    static final String[] KINDS = {
        "ball", "cube", "brick", "capsule", "drum", "wheel", "hull", "compound", "cone", "rock"
    };

    /** Half the thickness of a floor, m. */
    private static final double THICK = 0.5;

    private TileRuns() {}

    /** A body about to cross. */
    record Start(
            String kind,
            double size,
            double speed,
            double headingRadians,
            double yawRadians,
            double spin,
            double friction,
            double startX,
            double startZ) {}

    /** In place of the size of tiles: one plane without end. */
    static final double PLANE = -1;

    /**
     * A floor of square tiles about an origin; a slab where the tiles are 0 m.
     *
     * @param bond by how much each row of tiles is shifted against the one before, as a share of a
     *     tile: with one that is no whole number an edge meets the middle of another
     */
    record Floor(double tile, double x, double y, double z, double bond) {
        Floor(double tile, double x, double y, double z) {
            this(tile, x, y, z, 0);
        }
    }

    /** State after each tick: place, velocity, angular velocity, nine numbers a tick. */
    static double[] run(Start start, Floor floor, int ticks, PhysicsWorldBuilder builder) {
        try (PhysicsWorld world = builder.build()) {
            floor(world, start, floor, ticks);
            BodyRef body = world.add(body(start, floor));
            double[] all = new double[9 * ticks];
            for (int t = 0; t < ticks; t++) {
                world.step(Scenes.STEP);
                Vector3d p = body.position().sub(floor.x, floor.y, floor.z);
                Vector3d v = body.velocity();
                Vector3d w = body.angularVelocity();
                double[] now = {p.x, p.y, p.z, v.x, v.y, v.z, w.x, w.y, w.z};
                System.arraycopy(now, 0, all, 9 * t, 9);
            }
            return all;
        }
    }

    static void floor(PhysicsWorld world, Start s, Floor floor, int ticks) {
        Material surface = new Material(s.friction, 0, 1000);
        double way = s.speed * ticks * Scenes.STEP;
        double dx = StrictMath.cos(s.headingRadians) * way;
        double dz = StrictMath.sin(s.headingRadians) * way;
        if (floor.tile == PLANE) {
            world.add(
                    Body.fixed()
                            .shape(HalfSpace.of())
                            .material(surface)
                            .at(floor.x, floor.y, floor.z));
            return;
        }
        if (floor.tile == 0) {
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(64, THICK, 64))
                            .material(surface)
                            .at(floor.x, floor.y - THICK, floor.z));
            return;
        }
        double l = floor.tile;
        double reach = 3 * s.size + 2 * l;
        for (int j = (int) Math.floor((s.startZ + Math.min(0, dz) - reach) / l);
                j <= (s.startZ + Math.max(0, dz) + reach) / l;
                j++) {
            double shift = floor.bond * j;
            for (int i = (int) Math.floor((s.startX + Math.min(0, dx) - reach) / l - shift);
                    i <= (s.startX + Math.max(0, dx) + reach) / l - shift;
                    i++) {
                double cx = (i + .5 + shift) * l;
                double cz = (j + .5) * l;
                // within reach of the line of travel
                double along = way == 0 ? 0 : ((cx - s.startX) * dx + (cz - s.startZ) * dz) / way;
                double clamped = Math.max(-reach, Math.min(way + reach, along));
                double ox = cx - s.startX - (way == 0 ? 0 : clamped * dx / way);
                double oz = cz - s.startZ - (way == 0 ? 0 : clamped * dz / way);
                if (ox * ox + oz * oz < reach * reach) {
                    world.add(
                            Body.fixed()
                                    .shape(Box.ofHalfExtents(l / 2, THICK, l / 2))
                                    .material(surface)
                                    .at(floor.x + cx, floor.y - THICK, floor.z + cz));
                }
            }
        }
    }

    static Body body(Start s, Floor floor) {
        double r = s.size;
        Quaterniond q = new Quaterniond().rotationY(-s.yawRadians);
        Body body = Body.dynamic();
        double height = r;
        boolean rolls = false;
        switch (s.kind) {
            case "ball" -> {
                body.shape(Sphere.of(r));
                rolls = true;
            }
            case "cube" -> body.shape(Box.cubeOfHalfExtent(r));
            case "brick" -> {
                body.shape(Box.ofHalfExtents(1.2 * r, .3 * r, .7 * r));
                height = .3 * r;
            }
            case "capsule" -> {
                body.shape(Capsule.of(r, .8 * r));
                q.mul(new Quaterniond().rotationX(Math.PI / 2));
                rolls = true;
            }
            case "drum" -> body.shape(Cylinder.of(r, r));
            case "wheel" -> {
                body.shape(Cylinder.of(r, .4 * r));
                q.mul(new Quaterniond().rotationX(Math.PI / 2));
                rolls = true;
            }
            case "hull" -> {
                body.shape(hull(r));
                height = 0;
            }
            case "cone" -> body.shape(Cone.of(r, r));
            case "rock" -> {
                body.shape(rock(r));
                height = 0;
            }
            default -> {
                body.collider(Collider.of(Box.cubeOfHalfExtent(.5 * r)).at(-.5 * r, 0, 0));
                body.collider(Collider.of(Box.cubeOfHalfExtent(.5 * r)).at(.5 * r, 0, .2 * r));
                height = .5 * r;
            }
        }
        double vx = s.speed * StrictMath.cos(s.headingRadians);
        double vz = s.speed * StrictMath.sin(s.headingRadians);
        double wx = rolls ? vz / r : 0;
        double wz = rolls ? -vx / r : 0;
        if (rolls && !s.kind.equals("ball")) {
            // rolls along its heading only
            q =
                    new Quaterniond()
                            .rotationY(-s.headingRadians)
                            .mul(new Quaterniond().rotationX(Math.PI / 2));
        }
        // of more than four corners four bear, and which do is a choice: friction would tell
        double friction = s.kind.equals("rock") && corners(r) > 4 ? 0 : s.friction;
        return body.material(new Material(friction, 0, 1000))
                .at(floor.x + s.startX, floor.y + height, floor.z + s.startZ)
                .rotation(q)
                .velocity(vx, 0, vz)
                .angularVelocity(wx, rolls ? 0 : s.spin, wz);
    }

    /**
     * A block that stands on four corners, and has six above: what it stands on is not a choice.
     */
    private static Shape hull(double r) {
        double[] points = new double[3 * 10];
        int at = 0;
        for (int i = 0; i < 10; i++) {
            boolean low = i < 4;
            double a = low ? i * Math.PI / 2 + .3 : i * Math.PI / 3 + .1;
            double wide = low ? .9 * r : r;
            points[at++] = wide * StrictMath.cos(a) * (low && i % 2 == 0 ? .7 : 1);
            points[at++] = low ? 0 : r;
            points[at++] = wide * StrictMath.sin(a);
        }
        return ConvexHull.of(points);
    }

    /** On how many corners a rock stands: 3 to 8, by its size. */
    private static int corners(double r) {
        return 3 + (int) (1e6 * r) % 6;
    }

    /** Three to eight corners on the ground, anywhere on a circle, and as many anywhere above. */
    private static Shape rock(double r) {
        Random random = new Random(Double.doubleToLongBits(r));
        int low = corners(r);
        int all = 2 * low;
        double[] points = new double[3 * all];
        for (int i = 0; i < all; i++) {
            boolean stands = i < low;
            double a = 2 * Math.PI * (i + .8 * random.nextDouble()) / low;
            double wide = r * (stands ? 1 : random.nextDouble());
            points[3 * i] = wide * StrictMath.cos(a);
            points[3 * i + 1] = stands ? 0 : r * (.3 + random.nextDouble());
            points[3 * i + 2] = wide * StrictMath.sin(a);
        }
        return ConvexHull.of(points);
    }

    /**
     * Largest differences: of height, of place along the floor, of vertical speed, of speed, of
     * spin.
     */
    static double[] differences(double[] a, double[] b) {
        double[] most = new double[5];
        for (int i = 0; i < a.length; i += 9) {
            most[0] = Math.max(most[0], Math.abs(a[i + 1] - b[i + 1]));
            most[1] = Math.max(most[1], Math.hypot(a[i] - b[i], a[i + 2] - b[i + 2]));
            most[2] = Math.max(most[2], Math.abs(a[i + 4] - b[i + 4]));
            most[3] = Math.max(most[3], Math.hypot(a[i + 3] - b[i + 3], a[i + 5] - b[i + 5]));
            double w = 0;
            for (int k = 6; k < 9; k++) {
                w += (a[i + k] - b[i + k]) * (a[i + k] - b[i + k]);
            }
            most[4] = Math.max(most[4], Math.sqrt(w));
        }
        return most;
    }
}
