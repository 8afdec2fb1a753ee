package dev.cairn.physics.collider;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** A body of several boxes touches as the box does that they make. */
class PatchTest {
    private static final int TICKS = 180;

    /** What may differ: rounding, of the height of what stands there. */
    private static final double ROUNDING = 1e-12;

    /** A box of 2 x 0.6 x 1 m, whole, or of two unlike halves, or of eight parts. */
    private static Body brick(int parts) {
        Body body = Body.dynamic();
        if (parts == 1) {
            return body.shape(Box.ofHalfExtents(1, .3, .5));
        }
        if (parts == 2) {
            Quaterniond half = new Quaterniond().rotateY(Math.PI);
            return body.collider(Collider.of(Box.ofHalfExtents(.3, .3, .5)).at(-.7, 0, 0))
                    .collider(
                            Collider.of(Box.ofHalfExtents(.7, .3, .5)).at(.3, 0, 0).rotation(half));
        }
        for (int i = 0; i < 8; i++) {
            body.collider(
                    Collider.of(Box.ofHalfExtents(.25, .3, .25))
                            .at(-.75 + .5 * (i % 4), 0, -.25 + .5 * (i / 4)));
        }
        return body;
    }

    private static void floor(PhysicsWorld world, String floor) {
        switch (floor) {
            case "plane" -> world.add(Body.fixed().shape(HalfSpace.of()));
            case "slab" ->
                    world.add(Body.fixed().shape(Box.ofHalfExtents(50, .5, 50)).at(0, -.5, 0));
            default -> {
                for (int i = 0; i < 64; i++) {
                    world.add(
                            Body.fixed()
                                    .shape(Box.ofHalfExtents(.45, .5, .45))
                                    .at(.9 * (i % 8) - 2.5, -.5, .9 * (i / 8) - 3.1));
                }
            }
        }
    }

    private static List<BodyRef> scene(PhysicsWorld world, String scene, int parts) {
        List<BodyRef> all = new ArrayList<>();
        Body brick = brick(parts);
        switch (scene) {
            case "rests" -> all.add(world.add(brick.at(0, .3, 0)));
            case "slides" ->
                    all.add(
                            world.add(
                                    brick.at(0, .3, 0).velocity(4, 0, 1).angularVelocity(0, 3, 0)));
            case "falls" ->
                    all.add(
                            world.add(
                                    brick.at(0, .8, 0).velocity(3, 0, 1).angularVelocity(0, 2, 0)));
            case "bears" -> {
                all.add(world.add(brick.at(0, .3, 0)));
                Body load = Body.dynamic().shape(Box.ofHalfExtents(.8, .2, .3));
                all.add(world.add(load.at(.1, .9, 0)));
            }
            case "lies" -> {
                Body table = Body.dynamic().shape(Box.ofHalfExtents(1.5, .2, .8));
                all.add(world.add(table.at(0, .2, 0)));
                all.add(world.add(brick.at(.1, .8, 0)));
            }
            default -> {
                for (int i = 0; i < 4; i++) {
                    all.add(world.add(brick(parts).at(.03 * (i % 3), .3 + .6 * i, 0)));
                }
            }
        }
        return all;
    }

    private static double[] run(String floor, String scene, int parts) {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            floor(world, floor);
            List<BodyRef> all = scene(world, scene, parts);
            double[] path = new double[7 * all.size() * TICKS];
            int at = 0;
            for (int t = 0; t < TICKS; t++) {
                world.step(Scenes.STEP);
                for (BodyRef body : all) {
                    Vector3d p = body.position();
                    Quaterniond q = body.orientation();
                    double[] now = {p.x, p.y, p.z, q.x, q.y, q.z, q.w};
                    System.arraycopy(now, 0, path, at, 7);
                    at += 7;
                }
            }
            world.validate();
            return path;
        }
    }

    @ParameterizedTest
    @CsvSource({
        "plane, rests", "plane, slides", "plane, falls", "plane, bears", "plane, lies",
        "slab, slides", "slab, falls", "tiles, rests", "tiles, slides", "tiles, falls",
        "tiles, bears", "tiles, lies", "plane, stands", "tiles, stands"
    })
    void partsMoveAsTheBoxThatTheyMake(String floor, String scene) {
        double[] whole = run(floor, scene, 1);
        for (int parts : new int[] {2, 8}) {
            double[] cut = run(floor, scene, parts);
            double most = 0;
            for (int i = 0; i < cut.length; i++) {
                most = Math.max(most, Math.abs(cut[i] - whole[i]));
            }
            assertEquals(0, most, ROUNDING, parts + " parts on " + floor);
        }
    }

    /** Each part tells of its touch, and together they bear the weight. */
    @Test
    void eachPartThatLiesFlatTouches() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            floor(world, "plane");
            BodyRef brick = world.add(brick(8).at(0, .3, 0));
            for (int i = 0; i < 60; i++) {
                world.step(Scenes.STEP);
            }
            Contacts contacts = world.contacts();
            Set<Integer> touching = new HashSet<>();
            double impulse = 0;
            for (int c = 0; c < contacts.count(); c++) {
                if (contacts.touching(c)) {
                    touching.add(c);
                }
                for (int p = 0; p < contacts.pointCount(c); p++) {
                    double one = contacts.normalImpulse(c, p);
                    assertTrue(one > 0, "each corner of each part bears some of it: " + one);
                    impulse += one;
                }
            }
            assertEquals(8, touching.size());
            double weight = brick.mass() * 9.81 * Scenes.STEP;
            assertEquals(weight, impulse, 1e-9 * weight);
        }
    }

    /**
     * An L of three cubes has five corners, so it stays three contacts; a table whose legs are all
     * it stands on has four. Neither may sink, slide or tip, even with its load at the edge.
     */
    @Test
    void anLAndATableStand() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            floor(world, "plane");
            Body l = Body.dynamic();
            l.collider(Collider.of(Box.cubeOfHalfExtent(.5)))
                    .collider(Collider.of(Box.cubeOfHalfExtent(.5)).at(1, 0, 0))
                    .collider(Collider.of(Box.cubeOfHalfExtent(.5)).at(0, 0, 1));
            Body table = Body.dynamic();
            table.collider(Collider.of(Box.ofHalfExtents(.6, .05, .4)).at(0, .75, 0));
            for (int leg = 0; leg < 4; leg++) {
                table.collider(
                        Collider.of(Box.ofHalfExtents(.04, .35, .04))
                                .at(leg % 2 * 1.1 - .55, .35, leg / 2 * .7 - .35));
            }
            BodyRef[] bodies = {
                world.add(l.at(0, .5, 0)),
                world.add(table.at(5, 0, 0)),
                world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.1)).at(5.48, .9, .28))
            };
            Vector3d[] start = new Vector3d[bodies.length];
            for (int i = 0; i < start.length; i++) {
                start[i] = bodies[i].position();
            }
            for (int t = 0; t < 600; t++) {
                world.step(Scenes.STEP);
            }
            for (int i = 0; i < start.length; i++) {
                assertEquals(0, bodies[i].position().distance(start[i]), 1e-4, "body " + i);
            }
        }
    }

    @Test
    void theSameBitsForWorkersAndLanes() {
        Scenes.assertSameBits(world -> {
            floor(world, "tiles");
            for (int i = 0; i < 24; i++) {
                world.add(brick(1 + i % 3).at(i % 4 * .2, .5 + .8 * i, i % 3 * .3));
            }
            for (int t = 0; t < 90; t++) {
                world.step(Scenes.STEP);
            }
        });
    }
}
