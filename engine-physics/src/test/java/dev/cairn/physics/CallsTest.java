package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.body.BodyRemovedException;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;

/** Calls that come at the wrong time or with the wrong values are refused where they are made. */
class CallsTest {
    private static final List<Consumer<BodyRef>> CHANGES =
            List.of(
                    body -> body.applyForce(1, 0, 0),
                    body -> body.applyForceAt(1, 0, 0, 0, 0, 0),
                    body -> body.applyTorque(1, 0, 0),
                    body -> body.applyImpulse(1, 0, 0),
                    body -> body.applyImpulseAt(1, 0, 0, 0, 0, 0),
                    body -> body.applyAngularImpulse(1, 0, 0),
                    body -> body.setGravityScale(1),
                    body -> body.setDamping(0, 0),
                    body -> body.setSpeedLimit(10),
                    body -> body.setLocks(),
                    body -> body.setVelocity(0, 0, 0),
                    body -> body.setAngularVelocity(0, 0, 0),
                    body -> body.teleport(0, 1, 0),
                    BodyRef::wake,
                    BodyRef::sleep,
                    BodyRef::remove);

    /** The flag is set by hand: what is seen is that each call asks, not who wins a race. */
    @Test
    void changesAreRefusedWhileThePhysicsRuns() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.5)).at(0, 3, 0));
            world.physics.table.isStepping = true;
            for (int i = 0; i < CHANGES.size(); i++) {
                Consumer<BodyRef> change = CHANGES.get(i);
                String told =
                        assertThrows(
                                        IllegalStateException.class,
                                        () -> change.accept(ball),
                                        "change " + i)
                                .getMessage();
                assertTrue(told.contains("while the physics step runs"), told);
            }
            world.physics.table.isStepping = false;
            for (Consumer<BodyRef> change : CHANGES) {
                change.accept(ball);
            }
            assertFalse(ball.isAlive());
        }
    }

    /** Another thread that never stops asking: each call works or is refused, no step fails. */
    @Test
    void callsFromAnotherThreadAreRefusedDuringAStep() throws InterruptedException {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(2).build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            List<BodyRef> bodies = new ArrayList<>();
            for (int i = 0; i < 200; i++) {
                bodies.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.5, 0.5, 0.5))
                                        .at(2.0 * (i % 20), 0.5, 2.0 * (i / 20))));
            }
            AtomicBoolean seen = new AtomicBoolean();
            Thread meddler =
                    new Thread(() -> {
                        while (!seen.get()) {
                            if (world.physics.isRunning()) {
                                try {
                                    // on a body that is gone or there, asleep or awake
                                    bodies.get(7).applyForce(0, 0, 0);
                                } catch (IllegalStateException refused) {
                                    seen.set(true);
                                }
                            }
                            Thread.onSpinWait();
                        }
                    });
            meddler.start();
            // as many steps as it takes; some dozen
            for (int i = 0; i < 100_000 && !seen.get(); i++) {
                world.step(1 / 60.0);
            }
            boolean refused = seen.getAndSet(true);
            meddler.join();
            assertTrue(refused, "no call was refused in 100000 steps");
        }
    }

    @Test
    void bodyWithoutItsPoseIsGone() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.5)).at(0, 3, 0));
            BodyRef floor = world.add(Body.fixed().shape(HalfSpace.of()));
            world.ecs().remove(ball.entity(), Pose.COMPONENT);
            world.ecs().remove(floor.entity(), Pose.COMPONENT);
            assertFalse(ball.isAlive());
            assertFalse(floor.isAlive());
            BodyRef other = world.add(Body.dynamic().shape(Sphere.of(0.5)).at(0, 0, 0));
            world.step(1 / 60.0);
            world.step(1 / 60.0);
            // the floor is gone with its contacts: v = g t
            assertEquals(-9.81 / 30, other.velocity().y, 1e-12);
            assertThrows(BodyRemovedException.class, ball::position);
        }
    }

    @Test
    void placementTakesNoNullAndNoNaN() {
        Placement placement = new Placement();
        assertThrows(IllegalArgumentException.class, () -> placement.set(null, 0, 0, 0));
        assertThrows(
                IllegalArgumentException.class,
                () -> placement.setCentre(null, 0, 0, 0, 0, 0, 0, 1));
        double[] good = {0, 0, 0, 0, 0, 0, 1};
        for (int i = 0; i < good.length; i++) {
            for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
                double[] v = good.clone();
                v[i] = bad;
                Sphere ball = Sphere.of(1);
                assertThrows(
                        IllegalArgumentException.class,
                        () -> placement.set(ball, v[0], v[1], v[2], v[3], v[4], v[5], v[6]));
                assertThrows(
                        IllegalArgumentException.class,
                        () -> placement.setCentre(ball, v[0], v[1], v[2], v[3], v[4], v[5], v[6]));
            }
        }
    }
}
