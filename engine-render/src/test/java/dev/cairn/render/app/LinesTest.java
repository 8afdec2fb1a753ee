package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.gl.DebugLines;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;

import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Debug lines lie where their ends are projected to, as wide as they say, faint where hidden. */
class LinesTest extends Drawing {
    private static final int RGB = 0xF0B030;
    private DebugLines lines;

    @BeforeEach
    void overlay() {
        lines = new DebugLines();
        view.overlay(lines);
    }

    @AfterEach
    void noOverlay() {
        view.overlay(null);
        lines.close();
    }

    /** In pixels from the upper left; by the camera's own axes and no matrix. */
    private static double[] project(Camera camera, Vector3d point) {
        Vector3d forward = camera.forward(new Vector3d());
        Vector3d right = new Vector3d(forward).cross(0, 1, 0).normalize();
        Vector3d up = new Vector3d(right).cross(forward);
        Vector3d to = new Vector3d(point).sub(camera.position(new Vector3d()));
        double unit = HEIGHT / 2.0 / Math.tan(camera.fieldOfView() / 2) / to.dot(forward);
        return new double[] {WIDTH / 2.0 + unit * to.dot(right), HEIGHT / 2.0 - unit * to.dot(up)};
    }

    /** How far a pixel's middle is from the segment, across and beyond its ends. */
    private static double[] away(double[] a, double[] b, int x, int y) {
        double dx = b[0] - a[0];
        double dy = b[1] - a[1];
        double length = Math.hypot(dx, dy);
        double px = x + 0.5 - a[0];
        double py = y + 0.5 - a[1];
        double along = (px * dx + py * dy) / length;
        return new double[] {
            Math.abs(px * dy - py * dx) / length, Math.max(-along, along - length)
        };
    }

    private static void expectLine(
            Picture picture, double[] a, double[] b, double width, int inside, int outside) {
        int sure = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                double[] d = away(a, b, x, y);
                String where = "pixel %d,%d shows %06x".formatted(x, y, picture.at(x, y));
                if (d[0] < width / 2 - 0.8 && d[1] < -0.8) {
                    sure++;
                    assertTrue(Blocks.difference(inside, picture.at(x, y)) <= 2, where);
                } else if (d[0] > width / 2 + 0.8 || d[1] > 0.8) {
                    assertTrue(Blocks.difference(outside, picture.at(x, y)) <= 1, where);
                }
            }
        }
        assertTrue(sure > 200, "sure of " + sure);
    }

    @Test
    void aLineLiesWhereItsEndsAreProjected() {
        double far = 3e5;
        Camera camera = new Camera().lookAt(far + 1, 2, 6, far, 0, 0);
        Vector3d a = new Vector3d(far - 1.7, -0.5, 0.5);
        Vector3d b = new Vector3d(far + 1.2, 1.1, -2);
        try (Stage stage = new Stage()) {
            // The anchor is not where the renderer has its own.
            lines.begin(new Vector3d(far + 3, 1, 4), 2);
            lines.line(a.x, a.y, a.z, b.x, b.y, b.z, RGB, 3);
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            expectLine(picture, project(camera, a), project(camera, b), 6, RGB, SKY);
        }
    }

    @Test
    void aDotIsASquareOfItsWidth() {
        Camera camera = new Camera().lookAt(0, 0, 6, 0, 0, 0);
        Vector3d at = new Vector3d(0.9, 0.5, 0.3);
        double[] middle = project(camera, at);
        try (Stage stage = new Stage()) {
            lines.begin(new Vector3d(), 1);
            lines.line(at.x, at.y, at.z, at.x, at.y, at.z, RGB, 15);
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            for (int y = 0; y < HEIGHT; y++) {
                for (int x = 0; x < WIDTH; x++) {
                    double d =
                            Math.max(Math.abs(x + 0.5 - middle[0]), Math.abs(y + 0.5 - middle[1]));
                    if (d < 6.7 || d > 8.3) {
                        assertTrue(
                                Blocks.difference(d < 7.5 ? RGB : SKY, picture.at(x, y)) <= 2,
                                "pixel %d,%d, %s from the middle".formatted(x, y, d));
                    }
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {DebugLines.HIDDEN, 0.85})
    void whatIsHiddenIsFaint(double share) {
        Camera camera = new Camera().lookAt(0, 0, 6, 0, 0, 0);
        int grey = 0x404040;
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 1), Model.of(Meshes.CUBE).scale(9, 9, 0.1).color(grey));
            lines.begin(new Vector3d(), 1);
            if (share != DebugLines.HIDDEN) {
                lines.hidden(share);
            }
            lines.line(-1, -0.5, 0, 1, 0.8, 0, RGB, 7);
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            // That share of the line's colour over what hides it.
            int faint = 0;
            for (int shift = 16; shift >= 0; shift -= 8) {
                faint |=
                        (int)
                                        Math.round(
                                                share * (RGB >> shift & 255)
                                                        + (1 - share) * (grey >> shift & 255))
                                << shift;
            }
            expectLine(
                    picture,
                    project(camera, new Vector3d(-1, -0.5, 0)),
                    project(camera, new Vector3d(1, 0.8, 0)),
                    7,
                    faint,
                    grey);
            lines.begin(new Vector3d(), 1);
            lines.line(-1, -0.5, 1.2, 1, 0.8, 1.2, RGB, 7);
            expectLine(
                    draw(stage.publish(), 1, camera, FLAT),
                    project(camera, new Vector3d(-1, -0.5, 1.2)),
                    project(camera, new Vector3d(1, 0.8, 1.2)),
                    7,
                    RGB,
                    grey);
        }
    }

    @Test
    void thePartBehindTheCameraIsCutOff() {
        Camera camera = new Camera().lookAt(0, 0, 6, 0, 0, 0);
        try (Stage stage = new Stage()) {
            for (int turned = 0; turned < 2; turned++) {
                // From a point ahead, past the camera on its right, to far behind it.
                Vector3d ahead = new Vector3d(0.2, 0.1, 0);
                Vector3d behind = new Vector3d(2.2, 0.6, 10);
                Vector3d a = turned == 0 ? ahead : behind;
                Vector3d b = turned == 0 ? behind : ahead;
                lines.begin(new Vector3d(), 1);
                lines.line(a.x, a.y, a.z, b.x, b.y, b.z, RGB, 5);
                Picture picture = draw(stage.publish(), 1, camera, FLAT);
                // In front of the camera it ends where the picture does.
                Vector3d leaves = new Vector3d(ahead).lerp(behind, 0.5);
                double[] from = project(camera, ahead);
                double[] to = project(camera, leaves);
                expectLine(picture, from, to, 5, RGB, SKY);
                assertTrue(to[0] > WIDTH, "the truth must leave the picture");
            }
        }
    }

    @Test
    void aBoxHasTwelveEdges() {
        lines.begin(new Vector3d(), 1);
        lines.box(new double[] {-1, -2, -3, 1, 2, 3}, 0, RGB, 3);
        assertEquals(12, lines.count());
        Camera camera = new Camera().lookAt(4, 5, 12, 0, 0, 0);
        try (Stage stage = new Stage()) {
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            for (int edge = 0; edge < 12; edge++) {
                // Middles of the edges: one coordinate is 0, the others are at an end each.
                Vector3d middle = new Vector3d(1, 2, 3);
                if ((edge & 1) != 0) {
                    middle.setComponent((edge / 4 + 1) % 3, -middle.get((edge / 4 + 1) % 3));
                }
                if ((edge & 2) != 0) {
                    middle.setComponent((edge / 4 + 2) % 3, -middle.get((edge / 4 + 2) % 3));
                }
                middle.setComponent(edge / 4, 0);
                double[] at = project(camera, middle);
                assertTrue(
                        Blocks.difference(RGB, picture.at((int) at[0], (int) at[1])) < 40,
                        "middle of an edge at " + middle);
            }
        }
    }
}
