package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.app.Blocks.Block;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** Between ticks a thing is where its two poses say; a snapshot is uploaded once. */
class MotionTest extends Drawing {
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void posesBetweenTicksAreInterpolatedTheShortWayRound(boolean flipSign) {
        Quaterniond from = new Quaterniond().rotateXYZ(0.3, 0.2, 0.1);
        Quaterniond to = new Quaterniond().rotateXYZ(0.9, -0.3, 0.5);
        Block start = new Block(-1.2, 0.2, 0, from, 0.9, 0.6, 0.4, 0x40C0F0);
        Block end = new Block(1.0, -0.4, 0.6, to, 0.9, 0.6, 0.4, 0x40C0F0);
        Quaterniond middle =
                new Quaterniond(from.x + to.x, from.y + to.y, from.z + to.z, from.w + to.w)
                        .normalize();
        Block between = new Block(-0.1, -0.1, 0.3, middle, 0.9, 0.6, 0.4, 0x40C0F0);
        double sign = flipSign ? -1 : 1;
        Camera camera = new Camera().lookAt(0.5, 1, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            long entity = stage.add(start, start.rgb());
            stage.publish();
            stage.set(
                    entity,
                    new Pose(
                            end.x(),
                            end.y(),
                            end.z(),
                            sign * to.x,
                            sign * to.y,
                            sign * to.z,
                            sign * to.w,
                            0));
            PoseSnapshot snapshot = stage.step();
            assertTrue(
                    blockPixels(
                                    compare(
                                            draw(snapshot, 0, camera, FLAT),
                                            camera,
                                            List.of(start),
                                            FLAT))
                            > 500);
            assertTrue(
                    blockPixels(
                                    compare(
                                            draw(snapshot, 0.5, camera, FLAT),
                                            camera,
                                            List.of(between),
                                            FLAT))
                            > 500);
            Picture last = draw(snapshot, 1, camera, SUNNY);
            assertTrue(
                    blockPixels(
                                    compare(
                                            draw(snapshot, 1, camera, FLAT),
                                            camera,
                                            List.of(end),
                                            FLAT))
                            > 500);
            // The end of one tick is the beginning of the next, bit for bit.
            PoseSnapshot next = stage.step();
            assertArrayEquals(last.argb(), draw(next, 0, camera, SUNNY).argb());
        }
    }

    @Test
    void teleportDoesNotSmear() {
        Block there = new Block(1, 0, 0, new Quaterniond(), 0.5, 0.5, 0.5, 0x40C0F0);
        Camera camera = new Camera().lookAt(0, 1, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            long entity =
                    stage.add(Pose.at(-2, 0, 0), Model.of(Meshes.CUBE).scale(0.5).color(0x40C0F0));
            stage.publish();
            stage.set(entity, new Pose(1, 0, 0, 0, 0, 0, 1, 1));
            assertTrue(
                    blockPixels(
                                    compare(
                                            draw(stage.step(), 0.5, camera, FLAT),
                                            camera,
                                            List.of(there),
                                            FLAT))
                            > 500);
        }
    }

    @Test
    void sameSnapshotIsUploadedOnceAndDrawnTheSame() {
        Camera camera = new Camera().lookAt(2, 2, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), Model.of(Meshes.CUBE));
            PoseSnapshot snapshot = stage.publish();
            Picture first = draw(snapshot, 1, camera, SUNNY);
            int uploads = view.uploads();
            assertArrayEquals(first.argb(), draw(snapshot, 1, camera, SUNNY).argb());
            assertEquals(uploads, view.uploads());
            draw(stage.step(), 1, camera, SUNNY);
            assertEquals(uploads + 1, view.uploads());
        }
    }

    @Test
    void cameraRidesOnAnEntity() {
        Block other = new Block(5, 2, -4, new Quaterniond(), 0.5, 0.5, 0.5, 0x40C0F0);
        Camera camera = new Camera();
        try (Stage stage = new Stage()) {
            stage.add(other, other.rgb());
            long carrier = stage.add(Pose.at(0, 2, 0), Model.of(Meshes.BALL).scale(0.1));
            camera.lookAt(0, 0, 4, 0, 0, 0).follow(carrier, 0, 0, 2, false);
            stage.publish();
            stage.set(carrier, Pose.at(10, 2, 0));
            PoseSnapshot snapshot = stage.step();
            draw(snapshot, 0.5, camera, FLAT);
            assertEquals(new Vector3d(5, 2, 2), camera.position(new Vector3d()));
            assertFalse(camera.followed() == Camera.NOTHING);
        }
    }
}
