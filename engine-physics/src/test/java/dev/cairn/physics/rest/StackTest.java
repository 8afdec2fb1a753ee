package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;
import dev.cairn.physics.tuning.Tunable;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What stands on what, at the default settings, with jitter: stacks, mass ratios, a load that goes;
 * and that load-proportional inertia does not show in what moves.
 */
class StackTest {
    private static final PhysicsSettings PLAIN =
            PhysicsSettings.DEFAULT.with(Tunable.LOAD_INERTIA, 0).with(Tunable.UNLOAD_SWEEPS, 0);

    /** Bounds in metres and m/s. */
    private static void stands(
            StackStudy study, double seconds, double pen, double drift, double speed) {
        try (study) {
            String report = study.rest(seconds);
            assertTrue(study.overlap() < pen, report);
            assertTrue(Math.abs(study.sag()) < 1e-4, report);
            assertTrue(study.drift() < drift, report);
            assertTrue(study.speed < speed, report);
        }
    }

    @Test
    void aStackOfTenStands() {
        stands(stack(StackStudy.equal(10, 1000)), 20, 1e-5, 5e-4, 1e-4);
    }

    @Test
    void aStackOfTwentyStands() {
        stands(stack(StackStudy.equal(20, 1000)), 20, 1e-5, 3e-3, 5e-3);
    }

    @Test
    void aTonneStandsOnAKilogram() {
        stands(stack(1, 1000), 20, 1e-5, 5e-4, 1e-4);
    }

    /** A load off the middle of a plank on two posts; positions after 2 s. */
    private static double[] plank(double mass) {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Scenes.ground(world);
            BodyRef[] bodies = {
                world.add(
                        Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(-1.5, .5, 0).mass(mass)),
                world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(1.5, .5, 0).mass(mass)),
                world.add(
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(2, .1, .5))
                                .at(0, 1.1, 0)
                                .mass(mass)),
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(.5))
                                .at(.7, 1.7, .1)
                                .mass(100 * mass))
            };
            double[] places = new double[3 * bodies.length];
            for (int tick = 0; tick < 120; tick++) {
                world.step(Scenes.STEP);
            }
            for (int i = 0; i < bodies.length; i++) {
                Vector3d at = bodies[i].position();
                places[3 * i] = at.x;
                places[3 * i + 1] = at.y;
                places[3 * i + 2] = at.z;
            }
            return places;
        }
    }

    /** Motion under gravity and friction does not know the unit of mass: not by one bit. */
    @ParameterizedTest
    @ValueSource(doubles = {0x1p-20, 0x1p-10, 0x1p20})
    void aLoadOnTwoSupportsIsTheSameInAnyUnitOfMass(double unit) {
        assertArrayEquals(plank(1), plank(unit), 0.0);
    }

    @Test
    void massesThatAlternateOneToAHundredStand() {
        stands(stack(StackStudy.alternating(10, 100)), 20, 1e-5, 1e-3, 1e-4);
    }

    @ParameterizedTest
    @ValueSource(doubles = {100, 1000})
    void aHeavyTopStands(double ratio) {
        stands(stack(StackStudy.top(10, ratio)), 20, 1e-5, 2e-3, 1e-4);
    }

    @Test
    void aPyramidStands() {
        stands(StackStudy.pyramid(PhysicsSettings.DEFAULT, 10), 10, 1e-4, 1e-3, 1e-3);
    }

    @Test
    void whatStoodUnderALoadStaysWhenItGoes() {
        StackStudy.Unloaded u = StackStudy.unloaded(PhysicsSettings.DEFAULT, 5, 100);
        assertTrue(u.up() < 0.01, u.toString());
        assertTrue(u.gap() < 2e-4, u.toString());
        assertTrue(u.drift() < 1e-3, u.toString());
    }

    @Test
    void aHeavyBoxThatFallsOnALightStackDoesNotCrushIt() {
        try (StackStudy s = StackStudy.heavyDropped(PhysicsSettings.DEFAULT)) {
            String report = s.rest(6);
            assertTrue(s.drift() < 0.02 && Math.abs(s.sag()) < 1e-3, report);
        }
    }

    @Test
    void aHitMovesTheStackAsWithoutLoads() {
        double with = StackStudy.hitMomentum(PhysicsSettings.DEFAULT, 1000);
        double without = StackStudy.hitMomentum(PLAIN, 1000);
        assertEquals(without, with, 0.03, "momentum of the stack over the projectile's");
    }

    /**
     * No friction: the plate is alone in the direction of the pull, v = F t / m; up to the tilt
     * that its load, a quarter of a metre off its middle at the end, gives soft contacts.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 60})
    void whatIsPulledUnderALoadAnswersWithItsOwnMass(int ticksOfRest) {
        Material smooth = new Material(0, 0, 1000);
        try (PhysicsWorld world =
                PhysicsWorld.builder().sleeping(false).gravity(0, -9.81, 0).workers(1).build()) {
            world.add(
                    Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0).material(smooth));
            BodyRef plate =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(2, 0.25, 2))
                                    .at(0, 0.25, 0)
                                    .mass(1)
                                    .material(smooth));
            world.add(
                    Body.dynamic()
                            .shape(Box.cubeOfHalfExtent(0.5))
                            .at(0, 1, 0)
                            .mass(10)
                            .material(smooth));
            for (int tick = 0; tick < ticksOfRest; tick++) {
                world.step(1.0 / 60);
            }
            for (int tick = 0; tick < 30; tick++) {
                plate.applyForce(2, 0, 0);
                world.step(1.0 / 60);
            }
            assertEquals(1, plate.velocity().x(), 2e-3);
        }
    }

    @Test
    void aCubeKickedOutFromUnderItsStackSlidesAsWithoutLoads() {
        double with = StackStudy.kickDistance(PhysicsSettings.DEFAULT);
        double without = StackStudy.kickDistance(PLAIN);
        assertEquals(without, with, 0.05 * without, "distance of the cube");
    }

    @Test
    void aStackThatLandsOverlapsNoMoreThanWithoutLoads() {
        double with = StackStudy.landing(PhysicsSettings.DEFAULT, 4, 1);
        double without = StackStudy.landing(PLAIN, 4, 1);
        assertTrue(with <= 1.02 * without, with + " against " + without);
    }

    @Test
    void bodiesThatCarryNothingDoNotKnowOfLoads() {
        try (StackStudy a = alone(PhysicsSettings.DEFAULT);
                StackStudy b = alone(PLAIN)) {
            a.run(3);
            b.run(3);
            Vector3d x = new Vector3d();
            Vector3d y = new Vector3d();
            for (int i = 0; i < a.bodies.size(); i++) {
                assertEquals(b.bodies.get(i).position(y), a.bodies.get(i).position(x), "body " + i);
            }
        }
    }

    private static StackStudy alone(PhysicsSettings settings) {
        StackStudy s = StackStudy.onGround(settings);
        for (int i = 0; i < 5; i++) {
            s.jittered(1, 3 * i, 0.5 + i, 0).setAngularVelocity(i, 1, 0);
        }
        return s;
    }

    @Test
    @Tag("soak")
    void aStackOfFortyStandsForAMinute() {
        stands(stack(StackStudy.equal(40, 1000)), 60, 1e-4, 0.05, 0.05);
    }

    @Test
    @Tag("soak")
    void aPyramidOfTwentyRowsStands() {
        stands(StackStudy.pyramid(PhysicsSettings.DEFAULT, 20), 20, 1e-5, 1e-3, 1e-4);
    }

    private static StackStudy stack(double... masses) {
        return StackStudy.stack(PhysicsSettings.DEFAULT, masses);
    }
}
