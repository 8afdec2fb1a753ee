package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.body.BodyRemovedException;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.state.RigidBody;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

import java.util.List;
import java.util.function.DoubleConsumer;

/** A bad call is refused by a message that names value, bound or remedy; and it changes nothing. */
class BadInputTest {
    private static final double[] NOT_FINITE = {
        Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY
    };

    private PhysicsWorld world;
    private BodyRef crate;

    @BeforeEach
    void makeWorld() {
        world = PhysicsWorld.builder().workers(1).build();
        crate =
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(0.5))
                                .at(0, 9, 0)
                                .velocity(0, 0, 1));
        world.step(1.0 / 60);
    }

    @AfterEach
    void closeWorld() {
        world.close();
    }

    private <T extends Throwable> void refuses(Class<T> type, Executable call, String... parts) {
        long before = world.digest();
        long ecsBefore = world.ecs().digest();
        int bodies = world.bodyCount();
        T failure = assertThrows(type, call);
        for (String part : parts) {
            assertTrue(
                    String.valueOf(failure.getMessage()).contains(part),
                    "'" + failure.getMessage() + "' should say '" + part + "'");
        }
        assertEquals(before, world.digest(), "a refused call must change nothing");
        assertEquals(ecsBefore, world.ecs().digest(), "a refused call must change nothing");
        assertEquals(bodies, world.bodyCount());
    }

    private void refusesNotFinite(DoubleConsumer call, String name) {
        for (double bad : NOT_FINITE) {
            refuses(
                    IllegalArgumentException.class,
                    () -> call.accept(bad),
                    name,
                    Double.toString(bad));
        }
    }

    @Test
    @SuppressWarnings({"DataFlowIssue", "NullAway"})
    void nulls() {
        Class<IllegalArgumentException> type = IllegalArgumentException.class;
        refuses(type, () -> world.add((Body) null), "body", "null");
        refuses(type, () -> Body.dynamic().shape(null), "shape");
        refuses(type, () -> world.add(Body.dynamic()), "no shape", ".shape(");
        refuses(type, () -> world.add(Body.dynamic().name("x")), "'x'");
        refuses(type, () -> Body.dynamic().material(null), "material");
        refuses(type, () -> Body.dynamic().rotation(null), "rotation");
        refuses(type, () -> Body.dynamic().with((Record) null), "component");
        refuses(type, () -> Body.dynamic().name(null), "name");
        refuses(type, () -> crate.position(null), "destination");
        refuses(type, () -> crate.teleport(0, 0, 0, null), "rotation");
        refuses(type, () -> PhysicsWorld.builder().jobs(null), "jobs");
        refuses(type, () -> PhysicsWorld.builder().settings(null), "settings");
        refuses(type, () -> PhysicsWorld.builder().systems((WorldSystem) null), "system");
    }

    @Test
    void notFiniteAnywhere() {
        refusesNotFinite(v -> Body.dynamic().at(v, 0, 0), "x");
        refusesNotFinite(v -> Body.dynamic().at(0, v, 0), "y");
        refusesNotFinite(v -> Body.dynamic().at(0, 0, v), "z");
        refusesNotFinite(v -> Body.dynamic().velocity(0, v, 0), "vy");
        refusesNotFinite(v -> Body.dynamic().angularVelocity(0, 0, v), "wz");
        refusesNotFinite(v -> Body.dynamic().rotationAbout(v, 0, 0, 1), "axisX");
        refusesNotFinite(v -> Body.dynamic().rotationAbout(1, 0, 0, v), "radians");
        refusesNotFinite(v -> Body.dynamic().mass(v), "mass");
        refusesNotFinite(v -> PhysicsWorld.builder().gravity(0, v, 0), "gravity y");
        refusesNotFinite(v -> world.setGravity(0, 0, v), "gravity z");
        refusesNotFinite(v -> new Material(v, 0, 1), "friction");
        refusesNotFinite(v -> new Material(0, v, 1), "restitution");
        refusesNotFinite(v -> new Material(0, 0, v), "density");
        refusesNotFinite(v -> new Material(0, 0, 1, v), "rollingArm");
        refusesNotFinite(v -> crate.applyForce(v, 0, 0), "fx");
        refusesNotFinite(v -> crate.applyForceAt(0, 0, 0, 0, v, 0), "py");
        refusesNotFinite(v -> crate.applyTorque(0, 0, v), "tz");
        refusesNotFinite(v -> crate.applyImpulse(0, v, 0), "jy");
        refusesNotFinite(v -> crate.applyImpulseAt(1, 1, 1, 0, 0, v), "pz");
        refusesNotFinite(v -> crate.applyAngularImpulse(v, 0, 0), "lx");
        refusesNotFinite(v -> crate.setVelocity(v, 0, 0), "vx");
        refusesNotFinite(v -> crate.setAngularVelocity(0, v, 0), "wy");
        refusesNotFinite(v -> crate.teleport(0, v, 0), "y");
        refusesNotFinite(v -> world.step(v), "stepSeconds");
        refusesNotFinite(v -> Body.dynamic().rotation(new Quaterniond(v, 0, 0, 1)), "normalise");
    }

    @Test
    void outOfBounds() {
        Class<IllegalArgumentException> type = IllegalArgumentException.class;
        refuses(type, () -> Body.dynamic().mass(0), "mass is 0.0", "fixed()");
        refuses(type, () -> Body.dynamic().mass(-1), "mass is -1.0");
        refuses(type, () -> Box.ofHalfExtents(0, 1, 1), "0.0");
        refuses(type, () -> Sphere.of(-1), "-1.0");
        refuses(type, () -> new Material(-0.1, 0, 1), "-0.1");
        refuses(type, () -> new Material(0, 1.5, 1), "1.5", "1.0");
        refuses(type, () -> new Material(0, 0, 0), "density");
        refuses(type, () -> new Material(0, 0, 1, -1e-9), "rollingArm is -1.0E-9");
        refuses(type, () -> world.step(0), "0.0", "greater than 0");
        refuses(type, () -> world.step(-1), "-1.0");
        refuses(type, () -> Body.dynamic().rotation(new Quaterniond(0, 0, 0, 0)), "length 0.0");
        refuses(type, () -> Body.dynamic().rotation(new Quaterniond(0, 0, 0, 1.1)), "1.1");
        refuses(type, () -> crate.teleport(0, 0, 0, new Quaterniond(0, 0, 0, 2)), "2.0");
        refuses(type, () -> Body.dynamic().rotationAbout(0, 0, 0, 1), "axis is (0, 0, 0)");
        refuses(
                type,
                () -> world.add(Body.dynamic().shape(Sphere.of(1)).mass(Double.MIN_VALUE)),
                "mass");
        refuses(
                type,
                () -> world.add(Body.dynamic().shape(Sphere.of(1)).at(1e300, 0, 0)),
                "1.0E300",
                "1e60");
        refuses(type, () -> crate.teleport(0, -1e70, 0), "-1.0E70");
        refuses(type, () -> PhysicsWorld.builder().workers(0), "workers is 0", "1", "256");
        refuses(type, () -> PhysicsWorld.builder().workers(1000), "workers is 1000", "256");
        refuses(type, () -> PhysicsWorld.builder().substeps(0), "substeps is 0", "64");
        refuses(
                type,
                () -> world.add(Body.dynamic().shape(Sphere.of(1)).with(Pose.at(0, 0, 0))),
                "Pose");
    }

    @Test
    void aQuaternionThatIsUnitButForRoundingIsNormalised() {
        BodyRef body =
                world.add(
                        Body.dynamic()
                                .shape(Sphere.of(1))
                                .at(90, 0, 0)
                                .rotation(new Quaterniond(0, 0, 0, 1 + 5e-7)));
        assertEquals(1, body.orientation().w, 1e-15);
    }

    @Test
    void aFixedBodyHasNoVelocityToSetAndWhatPushesItIsTold() {
        BodyRef wall =
                world.add(
                        Body.fixed().shape(Box.cubeOfHalfExtent(1)).at(50, 0, 0).velocity(1, 1, 1));
        refuses(IllegalStateException.class, () -> wall.setVelocity(1, 0, 0), "fixed");
        refuses(IllegalStateException.class, () -> wall.setAngularVelocity(1, 0, 0), "fixed");
        BodyRef lift = world.add(Body.kinematic().shape(Box.cubeOfHalfExtent(1)).at(60, 0, 0));
        for (BodyRef body : List.of(wall, lift)) {
            String type = body == wall ? "fixed" : "kinematic";
            refuses(IllegalStateException.class, () -> body.applyForce(1, 2, 3), type);
            refuses(
                    IllegalStateException.class,
                    () -> body.applyForceAt(1, 2, 3, 4, 5, 6),
                    "applyForceAt moves dynamic bodies only");
            refuses(IllegalStateException.class, () -> body.applyTorque(1, 2, 3), type);
            refuses(IllegalStateException.class, () -> body.applyImpulse(1, 2, 3), type);
            refuses(
                    IllegalStateException.class,
                    () -> body.applyImpulseAt(1, 2, 3, 4, 5, 6),
                    "type()");
            refuses(IllegalStateException.class, () -> body.applyAngularImpulse(1, 2, 3), type);
        }
        world.step(1.0 / 60);
        assertEquals(new Vector3d(60, 0, 0), lift.position());
        assertEquals(new Vector3d(50, 0, 0), wall.position());
        assertEquals(new Vector3d(), wall.velocity());
        assertEquals(Double.POSITIVE_INFINITY, wall.mass());
    }

    @Test
    void aRemovedBodySaysSo() {
        crate.remove();
        assertFalse(crate.isAlive());
        assertEquals(0, world.bodyCount());
        assertThrows(BodyRemovedException.class, crate::position);
        assertThrows(BodyRemovedException.class, crate::remove);
        assertThrows(BodyRemovedException.class, () -> crate.applyForce(1, 0, 0));
        world.step(1.0 / 60);
        assertThrows(BodyRemovedException.class, () -> crate.setVelocity(1, 0, 0));
        BodyRef next = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)));
        assertTrue(next.isAlive());
        assertFalse(crate.isAlive(), "a body that reuses the slot is another one");
    }

    @Test
    void aClosedWorldSaysSo() {
        world.close();
        world.close();
        assertThrows(IllegalStateException.class, () -> world.step(1.0 / 60));
        assertThrows(
                IllegalStateException.class, () -> world.add(Body.dynamic().shape(Sphere.of(1))));
        assertThrows(IllegalStateException.class, () -> world.setPaused(true));
        assertThrows(BodyRemovedException.class, crate::position);
    }

    @Test
    void aSystemMustNotStepItsWorldOrAddToIt() {
        PhysicsWorld[] own = new PhysicsWorld[1];
        String[] messages = new String[2];
        WorldSystem intruder =
                new WorldSystem() {
                    @Override
                    public String name() {
                        return "intruder";
                    }

                    @Override
                    public void describe(Access access) {
                        access.before(PhysicsWorld.SYSTEM);
                    }

                    @Override
                    public void run(Tick tick) {
                        messages[0] =
                                assertThrows(
                                                IllegalStateException.class,
                                                () -> own[0].step(tick.stepSeconds()))
                                        .getMessage();
                        messages[1] =
                                assertThrows(
                                                IllegalStateException.class,
                                                () ->
                                                        own[0].add(
                                                                Body.dynamic().shape(Sphere.of(1))))
                                        .getMessage();
                    }
                };
        try (PhysicsWorld other = PhysicsWorld.builder().workers(1).systems(intruder).build()) {
            own[0] = other;
            other.step(1.0 / 60);
            assertTrue(messages[0].contains("during a step"), messages[0]);
            assertTrue(messages[1].contains("during a step"), messages[1]);
            assertFalse(other.hasFailed());
            assertEquals(0, other.bodyCount());
        }
    }

    @Test
    void aRigidBodyAddedByHandIsRefusedAtTheNextTick() {
        world.ecs().spawn(Pose.at(0, 0, 0), Velocity.ZERO, new RigidBody(0));
        IllegalStateException failure =
                assertThrows(IllegalStateException.class, () -> world.step(1.0 / 60));
        Throwable cause = failure.getCause() == null ? failure : failure.getCause();
        assertTrue(
                String.valueOf(cause.getMessage()).contains("PhysicsWorld.add"), cause.toString());
        assertTrue(world.hasFailed());
    }
}
