package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.mesh.Model;
import dev.cairn.samples.Palette;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

/**
 * An inclined plane through the origin that falls towards +x, and the frame that its scenes are
 * told in.
 *
 * <p>A point has the coordinates (along, above): metres down the slope from the origin, and metres
 * off the surface.
 */
final class Ramp {
    /** Where the ramp begins, metres up the slope from the origin. */
    private static final double BEHIND = 2;

    private static final double HALF_THICKNESS = 0.25;

    private final double radians;
    private final double sin;
    private final double cos;
    private final double length;

    /**
     * @param scene gets the ramp as a fixed body
     * @param degrees inclination
     * @param length metres from the origin to the lower end
     * @param halfWidth half its width along z, m
     */
    Ramp(
            SceneBuilder scene,
            double degrees,
            double length,
            double halfWidth,
            double friction,
            double restitution) {
        this.radians = StrictMath.toRadians(degrees);
        this.sin = StrictMath.sin(radians);
        this.cos = StrictMath.cos(radians);
        this.length = length;
        double middle = (length - BEHIND) / 2;
        Box slab = Box.ofHalfExtents((length + BEHIND) / 2, HALF_THICKNESS, halfWidth);
        scene.add(
                slab,
                Model.ground(slab),
                Body.fixed()
                        .at(x(middle, -HALF_THICKNESS), y(middle, -HALF_THICKNESS), 0)
                        .rotationAbout(0, 0, 1, -radians)
                        .material(Palette.material(friction, restitution))
                        .name("ramp"));
    }

    double sin() {
        return sin;
    }

    double cos() {
        return cos;
    }

    /** World x of a point. */
    double x(double along, double above) {
        return along * cos + above * sin;
    }

    /** World y of a point. */
    double y(double along, double above) {
        return -along * sin + above * cos;
    }

    /** Metres that a world point is down the slope. */
    double along(Vector3d point) {
        return point.x * cos - point.y * sin;
    }

    /** Says whether something that is this far along is still on the ramp. */
    boolean carries(double along, double margin) {
        return along < length - margin && along > margin - BEHIND;
    }

    /** Turns a body's axes into the ramp's. */
    Body align(Body body) {
        return body.rotationAbout(0, 0, 1, -radians);
    }

    /** Gives a body a velocity along the slope. */
    Body push(Body body, double speed) {
        return body.velocity(speed * cos, -speed * sin, 0);
    }

    /** Looks at a stretch of the slope from the side and a little above. */
    void look(SceneBuilder scene, double along, double distance) {
        double x = x(along, 0);
        double y = y(along, 0);
        scene.view(
                new SceneView(x + 0.25 * distance, y + 0.35 * distance, 0.9 * distance, x, y, 0));
    }

    /** A metric that is only known while its scene is within the reach of its closed form. */
    static final class Metric {
        private double value = Double.NaN;

        void set(double now) {
            value = now;
        }

        /** Keeps the largest value so far; at least 0. */
        void raise(double now) {
            value = Math.max(Double.isNaN(value) ? 0 : value, now);
        }

        double get() {
            return value;
        }
    }

    /** Reads where a body is along this ramp, without allocation. */
    final class Tracker {
        private final BodyRef body;
        private final Vector3d at = new Vector3d();
        private final double start;

        Tracker(BodyRef body) {
            this.body = body;
            this.start = along(body.centreOfMass(at));
        }

        /** Metres down the slope since the start. */
        double travelled() {
            return along(body.centreOfMass(at)) - start;
        }

        /** Metres down the slope from the origin. */
        double place() {
            return along(body.centreOfMass(at));
        }
    }
}
