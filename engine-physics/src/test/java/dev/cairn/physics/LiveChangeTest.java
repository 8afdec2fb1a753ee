package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Sub-steps and workers that change while the world runs. */
class LiveChangeTest {
    private static final double STEP = 1.0 / 60;

    private static List<BodyRef> stack(PhysicsWorld world) {
        world.add(Body.fixed().shape(Box.of(50, 1, 50)).at(0, -1, 0));
        List<BodyRef> boxes = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            boxes.add(world.add(Body.dynamic().shape(Box.cube(0.5)).at(0, 0.5 + i, 0)));
        }
        return boxes;
    }

    private static PhysicsWorld world(int workers, int substeps) {
        return PhysicsWorld.builder().workers(workers).substeps(substeps).sleeping(false).build();
    }

    @Test
    void aWorldWhoseSubStepsWereChangedIsLikeOneThatHadThemFromTheStart() {
        try (PhysicsWorld asBuilt = world(1, 9);
                PhysicsWorld changed = world(1, 4)) {
            stack(asBuilt);
            stack(changed);
            changed.setSubsteps(9);
            assertEquals(9, changed.settings().substeps());
            for (int i = 0; i < 60; i++) {
                asBuilt.step(STEP);
                changed.step(STEP);
            }
            assertEquals(asBuilt.digest(), changed.digest());
            changed.setSubsteps(2);
            asBuilt.step(STEP);
            changed.step(STEP);
            assertNotEquals(asBuilt.digest(), changed.digest());
        }
    }

    /** Warm impulses carry over: the weight is still carried in the tick after the change. */
    @Test
    void aStackStandsThroughChangesOfItsSubSteps() {
        try (PhysicsWorld world = world(1, 4)) {
            List<BodyRef> boxes = stack(world);
            int[] counts = {4, 16, 2, 8, 1, 4};
            for (int count : counts) {
                world.setSubsteps(count);
                for (int i = 0; i < 60; i++) {
                    world.step(STEP);
                    for (BodyRef box : boxes) {
                        double speed = box.velocity().length();
                        // A tick of free fall is 0.16 m/s; stiffer contacts push the sag out.
                        assertTrue(speed < 0.05, count + " sub-steps, tick " + i + ": " + speed);
                    }
                }
            }
            // The sixth box is 5.5 m up; soft contacts sag by parts of a millimetre.
            assertEquals(5.5, boxes.get(5).position().y, 0.01);
        }
    }

    @Test
    void theNumberOfWorkersMayChangeBetweenTicks() {
        try (PhysicsWorld one = world(1, 4);
                PhysicsWorld four = world(4, 4)) {
            stack(one);
            stack(four);
            Jobs jobs = four.ecs().jobs();
            for (int i = 0; i < 120; i++) {
                jobs.limit(1 + i / 7 % 4);
                one.step(STEP);
                four.step(STEP);
            }
            assertEquals(one.digest(), four.digest());
            assertThrows(IllegalArgumentException.class, () -> jobs.limit(5));
            assertThrows(IllegalArgumentException.class, () -> jobs.limit(0));
            assertThrows(IllegalArgumentException.class, () -> four.setSubsteps(0));
        }
    }
}
