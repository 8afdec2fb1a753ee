package dev.cairn.physics.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Ground of several materials: each triangle rubs and bounces as its own does. */
class GroundMaterialTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;
    private static final Material ROUGH = new Material(.5, 0, 1000);
    private static final Material ICE = new Material(0, 0, 1000);
    private static final Material RUBBER = new Material(.5, .8, 1000);

    /** 20 m by 20 m, flat: ice for z in 8..12, rubber for z in 15..20, else rough. */
    private static HeightField field() {
        return HeightField.of(21, 21, 1, 1, new double[21 * 21])
                .withMaterial(0, 8, 20, 4, 1)
                .withMaterial(0, 15, 20, 5, 2);
    }

    private static TriangleMesh mesh() {
        HeightField field = field();
        int[] numbers = new int[2 * 400];
        for (int t = 0; t < numbers.length; t++) {
            numbers[t] = field.material(t);
        }
        return field.toMesh().withMaterials(numbers);
    }

    private static BodyRef ground(PhysicsWorld world, Shape shape) {
        Collider collider = Collider.of(shape).material(ROUGH).materials(ICE, RUBBER);
        return world.add(Body.fixed().collider(collider));
    }

    private static BodyRef slider(PhysicsWorld world, double z) {
        return world.add(
                Body.dynamic()
                        .shape(Box.cubeOfHalfExtent(.2))
                        .material(ROUGH)
                        .at(2.1, .2, z)
                        .velocity(3, 0, 0));
    }

    private static double speed(BodyRef body) {
        return body.velocity(new Vector3d()).x;
    }

    private static PhysicsWorld world(int workers, int lanes) {
        return PhysicsWorld.builder()
                .gravity(0, -G, 0)
                .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                .workers(workers)
                .build();
    }

    /** Coulomb: v = v0 - mu g t, with the geometric mean of the coefficients. */
    @Test
    void eachTriangleRubsAsItsMaterial() {
        for (Shape shape : List.of(field(), mesh())) {
            try (PhysicsWorld world = world(1, 4)) {
                ground(world, shape);
                BodyRef rough = slider(world, 3.3);
                BodyRef ice = slider(world, 9.9);
                for (int t = 0; t < 30; t++) {
                    world.step(STEP);
                }
                assertEquals(3, speed(ice), 1e-9, "on ice, " + shape);
                assertEquals(3 - .5 * G * .5, speed(rough), 1e-4, "on the rough, " + shape);
                Contacts contacts = world.contacts();
                assertEquals(2, contacts.count());
                for (int i = 0; i < 2; i++) {
                    boolean isIce = contacts.bodyA(i) == ice || contacts.bodyB(i) == ice;
                    int triangle = contacts.triangle(i);
                    int material =
                            shape instanceof HeightField f
                                    ? f.material(triangle)
                                    : ((TriangleMesh) shape).material(triangle);
                    assertEquals(isIce ? 1 : 0, material, "triangle " + triangle);
                }
            }
        }
    }

    /** Of ground of several materials one runs along: what lies there is a conveyor's, no other. */
    @Test
    void aLaneOfTrianglesRunsAlong() {
        Material runs = ROUGH.withSurfaceVelocity(-1.25, 0, 0);
        for (Shape shape : List.of(field(), mesh())) {
            Set<Long> digests = new HashSet<>();
            for (int lanes : new int[] {1, 4, 8}) {
                try (PhysicsWorld world = world(1 + lanes / 4, lanes)) {
                    Collider collider = Collider.of(shape).material(ROUGH).materials(runs);
                    world.add(Body.fixed().collider(collider));
                    Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(.2)).material(ROUGH);
                    BodyRef beside = world.add(box.at(12.1, .2, 3.3));
                    BodyRef on = world.add(box.at(15.1, .2, 9.9));
                    for (int t = 0; t < 600; t++) {
                        world.step(STEP);
                    }
                    assertEquals(-1.25, speed(on), 1e-9, "on the lane, " + shape);
                    assertEquals(0, speed(beside), 1e-9, "beside it, " + shape);
                    digests.add(world.digest());
                }
            }
            assertEquals(1, digests.size());
        }
    }

    /** Over the border: it slows down until all of it is on ice, and then no more. */
    @Test
    void whatSlidesOntoIceGoesOn() {
        try (PhysicsWorld world = world(1, 4)) {
            ground(world, field());
            BodyRef body = slider(world, 5);
            body.setVelocity(0, 0, 6);
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
                Vector3d v = body.velocity(new Vector3d());
                // the row of the other material begins without impulses
                assertTrue(Math.abs(v.y) < 1e-3, "a kick at the border: " + v);
            }
            double z = body.position(new Vector3d()).z;
            double then = body.velocity(new Vector3d()).z;
            assertTrue(z > 8.3 && z < 11.7, "on ice at " + z);
            assertTrue(then * then < 36 - 2 * .5 * G * 2.7, "slowed down before: " + then);
            world.step(STEP);
            assertEquals(then, body.velocity(new Vector3d()).z, 1e-9);
        }
    }

    /** A ball leaves with 0.8 of its speed from rubber, and stays on the rest. */
    @Test
    void eachTriangleBouncesAsItsMaterialAndHitsNameIt() {
        try (PhysicsWorld world = world(1, 4)) {
            HeightField field = field();
            ground(world, field);
            world.contacts().setHitSpeed(1);
            BodyRef[] balls = new BodyRef[2];
            for (int i = 0; i < 2; i++) {
                balls[i] =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(.3))
                                        .material(ROUGH)
                                        .at(5.2, 2.3, i == 0 ? 3.4 : 17.3));
            }
            int hits = 0;
            for (int t = 0; t < 50; t++) {
                world.step(STEP);
                for (int h = 0; h < world.contacts().hits().count(); h++) {
                    hits++;
                    int triangle = world.contacts().hits().triangle(h);
                    boolean isRubber =
                            world.contacts().hits().bodyA(h) == balls[1]
                                    || world.contacts().hits().bodyB(h) == balls[1];
                    assertEquals(isRubber ? 2 : 0, field.material(triangle));
                    assertEquals(5 + 20 * (isRubber ? 17 : 3), triangle / 2, "the cell");
                }
            }
            assertTrue(hits >= 2, hits + " hits");
            double up = balls[1].velocity(new Vector3d()).y;
            double fall = Math.sqrt(2 * 2 / G);
            double truth = .8 * Math.sqrt(2 * G * 2) - G * (50 * STEP - fall);
            assertEquals(truth, up, .1);
            assertEquals(.3, balls[0].position(new Vector3d()).y, 2e-3);
        }
    }

    @Test
    void raysAndHooksTellTheTriangle() {
        try (PhysicsWorld world = world(1, 4)) {
            HeightField field = field();
            BodyRef ground = ground(world, field);
            Hit hit = new Hit();
            assertEquals(ground, world.queries().rayCast(7.75, 3, 9.25, 0, -1, 0, 10, hit));
            assertEquals(2 * (9 * 20 + 7) + 1, hit.triangle());
            assertEquals(1, field.material(hit.triangle()));
            BodyRef body = slider(world, 9.9);
            int[] seen = {-2};
            world.collisions().setHook(contact -> seen[0] = contact.triangle());
            world.step(STEP);
            assertEquals(1, field.material(seen[0]));
            assertTrue(body.isAlive());
        }
    }

    /** A patch of oil: from the next step on it slides. */
    @Test
    void paintedGroundIsAnotherOneFromTheNextStepOn() {
        try (PhysicsWorld world = world(1, 4)) {
            BodyRef ground = ground(world, field());
            BodyRef body = slider(world, 3.3);
            for (int t = 0; t < 10; t++) {
                world.step(STEP);
            }
            double then = speed(body);
            assertTrue(then < 3 - .5 * G * 9 * STEP);
            HeightField now = (HeightField) ground.shape();
            ground.setShape(now.withMaterial(0, 0, 20, 8, 1));
            world.step(STEP);
            assertEquals(then, speed(body), 1e-9);
        }
    }

    private static long[] digests(PhysicsWorld world, int ticks) {
        long[] digests = new long[ticks];
        for (int t = 0; t < ticks; t++) {
            world.step(STEP);
            digests[t] = world.digest();
        }
        return digests;
    }

    private static PhysicsWorld mixed(int workers, int lanes) {
        PhysicsWorld world = world(workers, lanes);
        ground(world, mesh());
        for (int i = 0; i < 12; i++) {
            world.add(
                    Body.dynamic()
                            .shape(Grounds.kinds()[i % 6])
                            .at(4 + .3 * i, 1, 7 + .8 * i)
                            .velocity(i % 3, 0, 2));
        }
        return world;
    }

    @Tag("compiled")
    @Test
    void theSameBitsForWorkersLanesAndAfterReadingBytes() throws IOException {
        try (PhysicsWorld world = mixed(1, 1);
                PhysicsWorld two = mixed(2, 8);
                PhysicsWorld read = PhysicsWorld.builder().workers(1).build()) {
            assertArrayEquals(digests(world, 40), digests(two, 40));
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            two.save().writeTo(out, PhysicsWorld.codecs());
            read.restore(
                    WorldState.read(
                            new ByteArrayInputStream(out.toByteArray()), PhysicsWorld.codecs()));
            long[] on = digests(world, 40);
            assertArrayEquals(on, digests(two, 40));
            assertArrayEquals(on, digests(read, 40), "read from bytes");
        }
    }

    @Test
    void numbersOutOfRangeAreTold() {
        TriangleMesh mesh = field().toMesh();
        String said = told(() -> mesh.withMaterials(new int[3]));
        assertTrue(said.contains("3 numbers of materials; give one to each of the 800"), said);
        int[] numbers = new int[800];
        numbers[7] = 255;
        said = told(() -> mesh.withMaterials(numbers));
        assertTrue(said.contains("material of triangle 7 is 255"), said);
        said = told(() -> field().withMaterial(0, 0, 1, 1, -1));
        assertTrue(said.contains("material is -1; numbers of materials are 0 to 254"), said);
        said = told(() -> Collider.of(mesh).materials(new Material[255]));
        assertTrue(said.contains("255 materials"), said);
        assertThrows(IndexOutOfBoundsException.class, () -> mesh.material(800));
        assertEquals(2, mesh().twoSided().scaled(-1, 1, 1).material(799), "kept by copies");
    }

    private static String told(Runnable mistake) {
        return String.valueOf(
                assertThrows(IllegalArgumentException.class, mistake::run).getMessage());
    }
}
