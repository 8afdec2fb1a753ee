package dev.cairn.physics.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;

/** Worlds on a height field: over holes, under edits, saved and restored. */
class GroundEditTest {
    private static final double STEP = 1 / 60.0;
    private static final int SAMPLES = 41;

    /** 40 m wide, one metre to a cell, its middle at the origin. */
    private static HeightField flat() {
        return HeightField.of(SAMPLES, SAMPLES, 1, 1, new double[SAMPLES * SAMPLES]);
    }

    private static BodyRef ground(PhysicsWorld world) {
        return world.add(Body.fixed().shape(flat()).at(-20, 0, -20));
    }

    private static HeightField field(BodyRef ground) {
        return (HeightField) ground.shape();
    }

    /** All samples of a rectangle at one height. */
    private static void level(BodyRef ground, int x, int z, int wide, int deep, double height) {
        double[] heights = new double[wide * deep];
        Arrays.fill(heights, height);
        ground.setShape(field(ground).withHeights(x, z, wide, heights));
    }

    private static void step(PhysicsWorld world, int ticks) {
        for (int t = 0; t < ticks; t++) {
            world.step(STEP);
        }
    }

    private static BodyRef box(PhysicsWorld world, double x, double z) {
        return world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.25)).at(x, .25, z));
    }

    private static double y(BodyRef body) {
        return body.position(new Vector3d()).y;
    }

    @Test
    void holesLetThrough() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef ground = ground(world);
            ground.setShape(field(ground).withHole(18, 18, 4, 4, true));
            BodyRef in = world.add(Body.dynamic().shape(Sphere.of(.4)).at(0, 1, 0));
            BodyRef beside = world.add(Body.dynamic().shape(Sphere.of(.4)).at(3.5, 1, 0));
            step(world, 90);
            assertTrue(y(in) < -3, "fell to " + y(in));
            assertEquals(.4, y(beside), 1e-3);
            ground.setShape(field(ground).withHole(18, 18, 4, 4, false));
            BodyRef late = world.add(Body.dynamic().shape(Sphere.of(.4)).at(0, 1, 0));
            step(world, 90);
            assertEquals(.4, y(late), 1e-3, "over the hole that is closed");
        }
    }

    @Test
    void whoSleepsWhereItIsDugWakesAndNobodyElse() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef ground = ground(world);
            BodyRef here = box(world, 5, 5);
            BodyRef far = box(world, -9, 5);
            step(world, 120);
            assertTrue(here.isAsleep() && far.isAsleep());
            level(ground, 23, 23, 5, 5, -.5);
            assertFalse(here.isAsleep(), "where it is dug");
            assertTrue(far.isAsleep(), "14 m away");
            step(world, 120);
            assertEquals(-.25, y(here), 1e-3);
            assertTrue(far.isAsleep(), "14 m away, later");
            assertEquals(.25, y(far), 1e-3);
            level(ground, 0, 0, 5, 5, 7);
            assertTrue(here.isAsleep() && far.isAsleep(), "far from both");
        }
    }

    @Test
    void whatIsHeapedUpLiftsWhatItCovers() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef ground = ground(world);
            BodyRef little = box(world, 5, 5);
            BodyRef deep = box(world, -5, 5);
            step(world, 120);
            level(ground, 22, 22, 7, 7, .1);
            level(ground, 12, 22, 7, 7, .9); // its centre is covered by 0.65 m
            assertFalse(little.isAsleep() || deep.isAsleep());
            step(world, 240);
            assertEquals(.35, y(little), 1e-5);
            assertEquals(1.15, y(deep), 1e-5);
            assertTrue(little.isAsleep() && deep.isAsleep());
        }
    }

    /** What lies on ground that is not touched goes on to the bit as if there had been no edit. */
    @Test
    void elsewhereContactsGoOn() {
        double[][] ends = new double[2][];
        for (int edits = 0; edits < 2; edits++) {
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
                BodyRef ground = ground(world);
                BodyRef slides =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(.25))
                                        .at(-10, .25, .3)
                                        .velocity(4, 0, 1));
                for (int t = 0; t < 60; t++) {
                    if (edits > 0) {
                        level(ground, 30, 1 + t / 10, 3, 3, .01 * t);
                    }
                    world.step(STEP);
                }
                Vector3d at = slides.position(new Vector3d());
                ends[edits] = new double[] {at.x, at.y, at.z};
            }
        }
        assertArrayEquals(ends[0], ends[1]);
    }

    /** Four triangles of a leaf have the order of the field, so all bits are the same. */
    @Test
    void aFieldOfFourCellsIsItsMeshToTheBit() {
        HeightField field =
                HeightField.of(3, 3, 3, 4, new double[] {1, .5, 2, .3, 0, .4, 1.2, .8, 2})
                        .withThickness(0);
        Shape[] grounds = {field, field.toMesh()};
        long[][] digests = new long[2][60];
        for (int g = 0; g < 2; g++) {
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
                world.add(Body.fixed().shape(grounds[g]));
                for (int i = 0; i < 12; i++) {
                    world.add(
                            Body.dynamic()
                                    .shape(Grounds.kinds()[i % 6])
                                    .at(1 + i % 4 * 1.1, 2.5, 1 + i / 4 * 2.1)
                                    .rotation(new Quaterniond().rotateXYZ(i, 2 * i, .3)));
                }
                for (int t = 0; t < 60; t++) {
                    world.step(STEP);
                    digests[g][t] = world.digest();
                }
            }
        }
        assertArrayEquals(digests[1], digests[0]);
    }

    private static long[] digests(int workers, int lanes) {
        long[] digests = new long[80];
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                        .workers(workers)
                        .build()) {
            Grounds.drop(world, Grounds.hillyField(), 35, 11);
            for (int tick = 0; tick < digests.length; tick++) {
                world.step(STEP);
                digests[tick] = world.digest();
            }
        }
        return digests;
    }

    @Tag("compiled")
    @Test
    void theSameBitsForWorkersAndLanes() {
        long[] first = digests(1, 1);
        assertArrayEquals(first, digests(2, 1), "2 workers");
        assertArrayEquals(first, digests(1, 8), "8 lanes");
        assertArrayEquals(first, digests(2, 4), "2 workers, 4 lanes");
    }

    @Test
    void nothingFallsThroughHills() {
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(false).workers(1).build()) {
            List<BodyRef> bodies = Grounds.drop(world, Grounds.hillyField(), 80, 5);
            for (int tick = 0; tick < 400; tick++) {
                world.step(STEP);
                if (tick % 20 == 0) {
                    world.validate();
                }
                for (BodyRef body : bodies) {
                    Vector3d at = body.centreOfMass(new Vector3d());
                    double height = at.y - Grounds.hills(at.x, at.z);
                    assertTrue(height > 0, body + " is " + height + " m above in tick " + tick);
                }
            }
        }
    }

    /** Edits are state: what is restored has the ground that was saved, also from bytes. */
    @Test
    void whatIsRestoredHasTheGroundThatWasSaved() throws IOException {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
                PhysicsWorld other = PhysicsWorld.builder().workers(1).build()) {
            BodyRef ground = ground(world);
            box(world, 5, 5);
            box(world, -5, 5);
            step(world, 20);
            level(ground, 22, 22, 7, 7, .2);
            ground.setShape(field(ground).withHole(13, 23, 4, 4, true));
            WorldState saved = world.save();
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            saved.writeTo(out, PhysicsWorld.codecs());
            HeightField then = field(ground);
            level(ground, 0, 0, SAMPLES, SAMPLES, -3);
            step(world, 30);
            world.restore(saved);
            assertEquals(then, ground.shape(), "the very field, for it never changes");
            other.restore(
                    WorldState.read(
                            new ByteArrayInputStream(out.toByteArray()), PhysicsWorld.codecs()));
            HeightField read = field(other.bodies().get(0));
            assertTrue(read.isLike(then));
            assertFalse(read.differs(then, new double[6]), "samples and holes");
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
                other.step(STEP);
                assertEquals(world.digest(), other.digest(), "tick " + t);
            }
            assertTrue(y(world.bodies().get(2)) < -1, "through the hole");
        }
    }

    @Test
    void aDynamicBodyIsNoGround() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            String said =
                    String.valueOf(
                            assertThrows(
                                            IllegalArgumentException.class,
                                            () -> world.add(Body.dynamic().shape(flat())))
                                    .getMessage());
            assertTrue(said.contains("cannot be dynamic"), said);
        }
    }
}
