package dev.cairn.render.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class CameraTest {
    private static void assertNear(double x, double y, double z, Vector3d v) {
        assertEquals(
                0,
                v.distance(x, y, z),
                1e-12,
                () -> v + " instead of (" + x + ", " + y + ", " + z + ")");
    }

    @Test
    void headingsFollowTheirDefinition() {
        Camera camera = new Camera().lookAt(0, 0, 0, 0, 0, -5);
        assertEquals(0, camera.yaw(), 1e-15);
        camera.turn(Math.PI / 2, 0);
        assertNear(1, 0, 0, camera.forward(new Vector3d()));
        camera.turn(0, 10);
        assertTrue(camera.pitch() < Math.PI / 2 && camera.forward(new Vector3d()).y > 0.999);
        camera.lookAt(3, 4, 5, 3, 4, 6);
        assertNear(0, 0, 1, camera.forward(new Vector3d()));
        camera.lookAt(3, 4, 5);
        assertNear(0, 0, 1, camera.forward(new Vector3d()));
    }

    @Test
    void fliesAlongItsOwnAxes() {
        Camera camera = new Camera().lookAt(0, 0, 0, 1, 0, 0);
        camera.fly(2, 0, 0);
        assertNear(2, 0, 0, camera.position(new Vector3d()));
        camera.fly(0, 3, 0.5);
        assertNear(2, 0.5, 3, camera.position(new Vector3d()));
    }

    @Test
    void raysGoThroughThePicture() {
        Camera camera = new Camera().lookAt(1, 2, 3, -4, 1, 7);
        Vector3d forward = camera.forward(new Vector3d());
        assertNear(forward.x, forward.y, forward.z, camera.ray(0, 0, 1.5, new Vector3d()));
        Vector3d top = camera.ray(0, 1, 1.5, new Vector3d());
        assertEquals(camera.fieldOfView() / 2, top.angle(forward), 1e-9);
        assertTrue(top.y > forward.y);
        Vector3d right = new Vector3d(forward).cross(0, 1, 0);
        assertTrue(camera.ray(1, 0, 1.5, new Vector3d()).dot(right) > 0);
    }

    /** A quarter turn to the left: from behind it, the camera is behind it again. */
    @Test
    void aPassengerTurnsWithTheHeading() {
        Camera camera = new Camera().lookAt(0, 1, 4, 0, 1, -1).follow(7, 0, 1, 4, false);
        camera.turning(true).rideOn(0, 0, 0, 3);
        assertNear(0, 1, 4, camera.position(new Vector3d()));
        camera.rideOn(10, 0, 0, 3 + Math.PI / 2 - 2 * Math.PI);
        assertNear(14, 1, 0, camera.position(new Vector3d()));
        assertNear(-1, 0, 0, camera.forward(new Vector3d()));
        camera.follow(7, 0, 1, 4, false).rideOn(0, 0, 0, 0);
        assertNear(0, 1, 4, camera.position(new Vector3d()));
        camera.rideOn(0, 0, 0, 1);
        assertNear(0, 1, 4, camera.position(new Vector3d()));
    }

    @Test
    void followerKeepsItsOffsetAndCanBeMoved() {
        Camera camera = new Camera().lookAt(0, 0, 0, 0, 0, -1).follow(7, 0, 1, 4, true);
        camera.rideOn(10, 0, 0, 0);
        assertNear(10, 1, 4, camera.position(new Vector3d()));
        assertTrue(
                camera.forward(new Vector3d()).dot(new Vector3d(0, -1, -4).normalize())
                        > 1 - 1e-12);
        camera.fly(0, 0, 2);
        camera.rideOn(20, 0, 0, 0);
        assertNear(20, 3, 4, camera.position(new Vector3d()));
        camera.release().rideOn(0, 0, 0, 0);
        assertNear(20, 3, 4, camera.position(new Vector3d()));
        Camera copy = new Camera().set(camera);
        assertNear(20, 3, 4, copy.position(new Vector3d()));
    }

    @Test
    void badValuesAreNamedAndChangeNothing() {
        Camera camera = new Camera().lookAt(1, 2, 3, 0, 0, 0);
        assertThrows(IllegalArgumentException.class, () -> camera.moveTo(Double.NaN, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> camera.range(0, 10));
        assertThrows(IllegalArgumentException.class, () -> camera.fieldOfView(4));
        assertThrows(IllegalArgumentException.class, () -> camera.speed(-1));
        assertThrows(IllegalArgumentException.class, () -> Light.DAYLIGHT.from(0, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> Light.DAYLIGHT.strengths(-1, 0));
        assertNear(1, 2, 3, camera.position(new Vector3d()));
    }
}
