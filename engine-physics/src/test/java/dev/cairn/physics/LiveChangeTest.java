package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.tuning.Tunable;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Sub-steps and workers that change while the world runs. */
class LiveChangeTest {
    private static final double STEP = 1.0 / 60;

    private static List<BodyRef> stack(PhysicsWorld world) {
        world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0));
        List<BodyRef> boxes = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            boxes.add(world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5 + i, 0)));
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

    /**
     * Warm impulses carry over: the weight is still carried in the tick after the change, so no box
     * falls. What moves the boxes is the sag. A soft contact is overdamped: of an overlap s it
     * leaves {@code s exp(-r t)} and so parts at {@code s r exp(-r t)}, with {@code r = w / (2 zeta
     * + h w), w = 2 pi hertz} (Catto, Solver2D). More sub-steps are stiffer contacts: from 4 to 16
     * the top of the stack, 1.7 mm low, is pushed out at up to {@code s r exp(-r tick)} = 34 mm/s;
     * 21 mm/s are seen, 20 to 29 mm/s with the boxes up to 5 cm aside (20 seeds), since the lowest
     * contacts are twice as stiff and are done sooner. All else stays below 20 mm/s: mostly the
     * stack that starts without impulses, an eighth of a tick of free fall.
     */
    @Test
    void aStackStandsThroughChangesOfItsSubSteps() {
        try (PhysicsWorld world = world(1, 4)) {
            List<BodyRef> boxes = stack(world);
            int[] counts = {4, 16, 2, 8, 1, 4};
            for (int count : counts) {
                double sag = Math.abs(5.5 - boxes.get(5).position().y);
                double bound = Math.max(0.02, sag * partingRate(world.settings(), count));
                world.setSubsteps(count);
                for (int i = 0; i < 60; i++) {
                    world.step(STEP);
                    for (BodyRef box : boxes) {
                        double speed = box.velocity().length();
                        String where = "%d sub-steps, tick %d: %.4f m/s, bound %.4f";
                        assertTrue(speed < bound, where.formatted(count, i, speed, bound));
                    }
                }
            }
            // The sixth box is 5.5 m up; soft contacts sag by parts of a millimetre.
            assertEquals(5.5, boxes.get(5).position().y, 0.001);
        }
    }

    /**
     * r exp(-r tick), 1/s: the speed of a contact after a tick, for an overlap of 1 m before it.
     */
    private static double partingRate(PhysicsSettings settings, int substeps) {
        double h = STEP / substeps;
        double w = 2 * Math.PI * settings.tuning().get(Tunable.CONTACT_STIFFNESS) / h;
        double rate = w / (2 * settings.tuning().get(Tunable.CONTACT_DAMPING_RATIO) + h * w);
        return rate * Math.exp(-rate * STEP);
    }

    /**
     * Contacts hold what they held: a stack that has come to rest hears nothing of it, though from
     * 16 to 2 sub-steps their stiffness becomes a 64th. Nothing: a hundredth of what gravity does
     * to a speed in a sub-step; 0.4 to 0.5 hundredths are seen, 7 where offsets take nothing over.
     */
    @Test
    void aStackAtRestHearsNothingOfFewerSubSteps() {
        for (int count : new int[] {8, 4, 2}) {
            try (PhysicsWorld world = world(1, 16)) {
                List<BodyRef> boxes = stack(world);
                for (int i = 0; i < 60; i++) {
                    world.step(STEP);
                }
                double before = fastest(boxes);
                world.setSubsteps(count);
                double after = 0;
                for (int i = 0; i < 60; i++) {
                    world.step(STEP);
                    after = Math.max(after, fastest(boxes));
                }
                double bound = 9.81 * STEP / count / 100;
                String where = "%d sub-steps: %.2e m/s, then %.2e";
                assertTrue(after < bound, where.formatted(count, before, after));
            }
        }
    }

    private static double fastest(List<BodyRef> boxes) {
        return boxes.stream().mapToDouble(b -> b.velocity().length()).max().orElseThrow();
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
