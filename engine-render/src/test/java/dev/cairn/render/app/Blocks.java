package dev.cairn.render.app;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.SplittableRandom;

/**
 * The oracle of the drawing tests: what a pixel must show, by tracing rays through turned blocks on
 * the CPU. A statement is made only where it also holds up to a pixel farther in all directions, so
 * that edges, which a rasteriser may round, are left out.
 */
final class Blocks {
    private Blocks() {}

    record Block(
            double x,
            double y,
            double z,
            Quaterniond turn,
            double hx,
            double hy,
            double hz,
            int rgb) {
        Pose pose() {
            return new Pose(x, y, z, turn.x, turn.y, turn.z, turn.w, 0);
        }
    }

    /** Where a ray enters a block: distance, and the outward normal there. */
    record Hit(Block block, double distance, Vector3d normal) {}

    static Quaterniond randomTurn(SplittableRandom random) {
        return new Quaterniond(
                        random.nextDouble(-1, 1),
                        random.nextDouble(-1, 1),
                        random.nextDouble(-1, 1),
                        random.nextDouble(-1, 1))
                .normalize();
    }

    /**
     * Direction through a place in the picture, in pixels from its upper left, by the camera's own
     * axes and no matrix.
     */
    static Vector3d ray(Camera camera, double px, double py, int width, int height) {
        Vector3d forward = camera.forward(new Vector3d());
        Vector3d right = new Vector3d(forward).cross(0, 1, 0).normalize();
        Vector3d up = new Vector3d(right).cross(forward);
        double tan = Math.tan(camera.fieldOfView() / 2);
        double across = (2 * px / width - 1) * tan * width / height;
        double upwards = (1 - 2 * py / height) * tan;
        return new Vector3d(forward).fma(across, right).fma(upwards, up).normalize();
    }

    static @Nullable Hit hit(Block b, Vector3d from, Vector3d direction, double grow) {
        Quaterniond inverse = new Quaterniond(b.turn()).conjugate();
        Vector3d o = inverse.transform(new Vector3d(from).sub(b.x(), b.y(), b.z()));
        Vector3d d = inverse.transform(new Vector3d(direction));
        double[] half = {b.hx() + grow, b.hy() + grow, b.hz() + grow};
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        int axis = -1;
        for (int i = 0; i < 3; i++) {
            double t1 = (-half[i] - o.get(i)) / d.get(i);
            double t2 = (half[i] - o.get(i)) / d.get(i);
            if (Math.min(t1, t2) > enter) {
                enter = Math.min(t1, t2);
                axis = i;
            }
            leave = Math.min(leave, Math.max(t1, t2));
        }
        if (enter > leave || enter <= 0) {
            return null;
        }
        Vector3d normal = new Vector3d();
        normal.setComponent(axis, d.get(axis) > 0 ? -1 : 1);
        return new Hit(b, enter, b.turn().transform(normal));
    }

    static @Nullable Hit nearest(
            List<Block> blocks, Vector3d from, Vector3d direction, double grow) {
        Hit best = null;
        for (Block block : blocks) {
            Hit hit = hit(block, from, direction, grow);
            if (hit != null && (best == null || hit.distance() < best.distance())) {
                best = hit;
            }
        }
        return best;
    }

    /** Whether something stands between a point on a block and the sun. */
    static boolean shaded(
            List<Block> blocks, Block own, Vector3d point, Vector3d sun, double grow) {
        for (Block block : blocks) {
            if (block != own && hit(block, point, sun, grow) != null) {
                return true;
            }
        }
        return false;
    }

    static double linear(int channel) {
        double c = (channel & 255) / 255.0;
        return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
    }

    static int encoded(double light) {
        double c = Math.clamp(light, 0.0, 1.0);
        return (int)
                Math.round(
                        255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * Math.pow(c, 1 / 2.4) - 0.055));
    }

    /** Lambert's law with the hemisphere light, as the javadoc of Light states it. */
    static int lit(int rgb, Vector3d n, Light light, boolean sunny) {
        Vector3d s = new Vector3d(light.sunX(), light.sunY(), light.sunZ()).normalize();
        double facing = sunny ? Math.max(0, n.dot(s)) : 0;
        double up = 0.5 + 0.5 * n.y;
        int r =
                encoded(
                        linear(rgb >> 16)
                                * (light.groundRed() * (1 - up)
                                        + light.skyRed() * up
                                        + light.sunRed() * facing));
        int g =
                encoded(
                        linear(rgb >> 8)
                                * (light.groundGreen() * (1 - up)
                                        + light.skyGreen() * up
                                        + light.sunGreen() * facing));
        int b =
                encoded(
                        linear(rgb)
                                * (light.groundBlue() * (1 - up)
                                        + light.skyBlue() * up
                                        + light.sunBlue() * facing));
        return r << 16 | g << 8 | b;
    }

    /** The greatest difference of two colours in a channel. */
    static int difference(int a, int b) {
        int red = Math.abs((a >> 16 & 255) - (b >> 16 & 255));
        int green = Math.abs((a >> 8 & 255) - (b >> 8 & 255));
        return Math.max(Math.max(red, green), Math.abs((a & 255) - (b & 255)));
    }
}
