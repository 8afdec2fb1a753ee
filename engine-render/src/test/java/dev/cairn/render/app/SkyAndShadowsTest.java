package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The sky as light against integrals, and shadows near and far. */
class SkyAndShadowsTest extends Drawing {
    private static final double GREY = 0.5;

    @AfterEach
    void plainAgain() {
        view.effects(Effects.PLAIN);
    }

    private static Picture draw(String effects, Stage stage, Camera camera, Light light) {
        view.effects(Effects.named(effects));
        return draw(stage.publish(), 1, camera, light);
    }

    private static Model box(double x, double y, double z) {
        return Model.of(Box.ofHalfExtents(x, y, z)).texture(Texture.WHITE).color(0xBCBCBC);
    }

    private static int green(Picture picture, int x, int y) {
        return picture.at(x, y) >> 8 & 255;
    }

    /** The number on the screen of linear light. */
    private static double encoded(double linear) {
        return 255 * (1.055 * Math.pow(linear, 1 / 2.4) - 0.055);
    }

    /** A sky of one colour over a ground of another: the mean by the cosine is (1 + n.y) / 2. */
    @Test
    void anEvenSkyLightsAsTheHemisphereDoes() {
        Light even =
                new Light(
                        0, 1, 0, 0, 0, 0, 0.6, 0.5, 0.4, 0.2, 0.3, 0.1, 0xFFFFFF, 0xFFFFFF, 0,
                        false);
        Camera camera = new Camera().lookAt(3, 2, 4, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), box(1, 1, 1));
            Picture plain = draw("plain", stage, camera, even);
            Picture sky = draw("sky-light", stage, camera, even);
            for (int y = 0; y < HEIGHT; y++) {
                for (int x = 0; x < WIDTH; x++) {
                    int difference = Blocks.difference(plain.at(x, y), sky.at(x, y));
                    assertTrue(difference <= 4, difference + " at " + x + ", " + y);
                }
            }
        }
    }

    /** Bright at the horizon, dark above: L = exp(-3 y). A wall gets more of it than the ground. */
    @Test
    void aWallGetsTheLightOfTheHorizon() {
        Light light =
                new Light(0, 1, 0, 0, 0, 0, 0.6, 0.6, 0.6, 0, 0, 0, 0x000000, 0xFFFFFF, 0, false);
        double up = 0;
        double wall = 0;
        int steps = 10_000;
        for (int i = 0; i < steps; i++) {
            double y = (i + 0.5) / steps;
            // The integral over the azimuth is 2 pi y for the ground and 2 sqrt(1 - y^2) here.
            up += 2 * y * Math.exp(-3 * y) / steps;
            wall += 2 / Math.PI * Math.sqrt(1 - y * y) * Math.exp(-3 * y) / steps;
        }
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), box(2, 2, 2));
            Picture front = draw("sky-light", stage, new Camera().lookAt(0, 0, 8, 0, 0, 0), light);
            Picture top = draw("sky-light", stage, new Camera().lookAt(0, 8, 1e-3, 0, 0, 0), light);
            double expected = encoded(GREY * 0.6 * wall / up);
            assertEquals(expected, green(front, WIDTH / 2, HEIGHT / 2), 4);
            assertEquals(encoded(GREY * 0.6), green(top, WIDTH / 2, HEIGHT / 2), 4);
        }
    }

    /** A rough mirror that faces the horizon shows some of both, a smooth one what is there. */
    @Test
    void aRoughMirrorBlursTheEdgeBetweenSkyAndGround() {
        Light light = new Light(0, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0xFFFFFF, 0xFFFFFF, 0, false);
        int[] seen = new int[2];
        for (int i = 0; i < 2; i++) {
            try (Stage stage = new Stage()) {
                Texture metal = Texture.WHITE.finish(i == 0 ? 0.05 : 0.8, 1);
                stage.add(Pose.at(0, 0, 0), box(2, 2, 2).texture(metal).color(0xFFFFFF));
                // The ray to the middle comes from 10 degrees above, its mirror image goes down.
                Camera camera = new Camera().lookAt(0, 1.4, 8, 0, 0, 0);
                seen[i] =
                        green(
                                draw("reflections,sky-light", stage, camera, light),
                                WIDTH / 2,
                                HEIGHT / 2);
            }
        }
        assertTrue(seen[0] < 30, "a mirror shows the black ground: " + seen[0]);
        assertTrue(seen[1] > 80, "rough metal some sky: " + seen[1]);
    }

    /**
     * Metal that faces up, seen from above, under a sky L = exp(-3 y). Of the light along l it
     * sends D(h) G(l, v) / (4 n.l n.v) n.l to the eye; with v = n all depends on the angle t of h =
     * (l + v) / 2 alone, dl = 4 cos t dh, and the sum over h is that of L(cos 2t) G 2 pi D cos t
     * sin t dt. By that of a white sky, so that how much of all light the metal keeps is left out.
     */
    @Test
    void metalMirrorsTheSkyAsTheIntegralOverItsFacetsSays() {
        Light light = new Light(0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x000000, 0xFFFFFF, 0, false);
        for (double roughness : new double[] {0.05, 0.2, 0.35, 0.5, 0.65, 0.8}) {
            double a = roughness * roughness;
            double sum = 0;
            double white = 0;
            int steps = 100_000;
            for (int i = 0; i < steps; i++) {
                double t = Math.PI / 4 * (i + 0.5) / steps;
                double cos = Math.cos(t);
                double d = a / (cos * cos * (a * a - 1) + 1);
                double l = Math.cos(2 * t);
                // Smith for both ways, of facets whose heights are correlated; the eye's part is 1.
                double g = 2 * l / (l + Math.sqrt(a * a + (1 - a * a) * l * l));
                double share = 2 * d * d * cos * Math.sin(t) * Math.PI / 4 / steps;
                sum += Math.exp(-3 * l) * g * share;
                white += g * share;
            }
            double bright = linear(mirrored(roughness, light.background(0xFFFFFF, 0xFFFFFF)));
            int seen = mirrored(roughness, light);
            assertEquals(encoded(bright * sum / white), seen, 2, "roughness " + roughness);
        }
    }

    private static double linear(int value) {
        return Math.pow((value / 255.0 + 0.055) / 1.055, 2.4);
    }

    /** What a plate of white metal that faces up shows to an eye above it. */
    private static int mirrored(double roughness, Light light) {
        Texture metal = Texture.WHITE.finish(roughness, 1);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), box(2, 2, 2).texture(metal).color(0xFFFFFF));
            Camera above = new Camera().lookAt(0, 8, 1e-3, 0, 0, 0);
            Picture picture = draw("reflections,sky-light", stage, above, light);
            return green(picture, WIDTH / 2, HEIGHT / 2);
        }
    }

    private static int[] pixel(Camera camera, double x, double y, double z) {
        Vector3d eye = camera.position(new Vector3d());
        Vector3d forward = camera.forward(new Vector3d());
        Vector3d right = new Vector3d(1, 0, 0).rotateY(-camera.yaw());
        Vector3d up = new Vector3d(right).cross(forward);
        Vector3d arm = new Vector3d(x, y, z).sub(eye);
        double tan = arm.dot(forward) * Math.tan(camera.fieldOfView() / 2);
        return new int[] {
            (int) (0.5 * WIDTH + 0.5 * HEIGHT * arm.dot(right) / tan),
            (int) (0.5 * HEIGHT - 0.5 * HEIGHT * arm.dot(up) / tan)
        };
    }

    /** A tower 150 m away casts a shadow, and so does a pole of 20 cm that stands near. */
    @Test
    void shadowsReachFarAndAreFineNear() {
        Light light = SUNNY.from(1, 1, 0);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, -0.5, -100), box(400, 0.5, 400));
            stage.add(Pose.at(0, 9, -150), box(9, 9, 9));
            stage.add(Pose.at(0, 1, 0), box(0.1, 1, 0.1));
            Camera far = new Camera().lookAt(0, 40, 10, 0, 0, -150);
            int[] shaded = pixel(far, -16, 0, -150);
            int[] lit = pixel(far, 30, 0, -150);
            Picture plain = draw("plain", stage, far, light);
            Picture wide = draw("cascades", stage, far, light);
            assertEquals(green(plain, lit[0], lit[1]), green(plain, shaded[0], shaded[1]), 3);
            int dark = green(wide, shaded[0], shaded[1]);
            assertTrue(dark < green(wide, lit[0], lit[1]) - 40, "in the shadow: " + dark);

            Camera near = new Camera().lookAt(0, 4, 2, -1, 0, 0);
            int[] behind = pixel(near, -1, 0, 0);
            int[] beside = pixel(near, -1, 0, 0.5);
            Picture coarse = draw("plain", stage, near, light);
            int blurred = green(coarse, behind[0], behind[1]);
            assertTrue(blurred > green(coarse, beside[0], beside[1]) - 30, "plain: " + blurred);
            Picture fine = draw("cascades", stage, near, light);
            int thin = green(fine, behind[0], behind[1]);
            assertTrue(thin < green(fine, beside[0], beside[1]) - 40, thin + " behind the pole");
        }
    }
}
