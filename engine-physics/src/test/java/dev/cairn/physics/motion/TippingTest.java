package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.stream.Stream;

/**
 * What stands on its rim, its edge or its cap and falls over keeps touching the floor until the
 * other side comes down, and has no more energy than before, whatever its shape.
 */
class TippingTest {
    private static final double RADIUS = 0.2;
    private static final double HALF = 0.13;
    private static final HalfSpace FLOOR = HalfSpace.of();

    /** Three ways to say the same shape: alone, shifted and turned in its body, a part of it. */
    private enum Way {
        ALONE,
        MOVED,
        PART
    }

    record Case(Shape shape, double balance, Way way, double off, int substeps, int lanes) {}

    static Stream<Case> cases() {
        // tilt at which the centre of mass is above the point on which it stands
        double can = Math.atan2(RADIUS, HALF);
        double cone = Math.atan2(RADIUS, 0.5 * HALF);
        return Stream.of(Way.values())
                .flatMap(way ->
                        Stream.of(2.0, 20.0)
                                .flatMap(off ->
                                        Stream.of(
                                                new Case(
                                                        Box.ofHalfExtents(RADIUS, HALF, RADIUS),
                                                        can,
                                                        way,
                                                        off,
                                                        4,
                                                        1),
                                                new Case(
                                                        Cylinder.of(RADIUS, HALF),
                                                        can,
                                                        way,
                                                        off,
                                                        4,
                                                        1),
                                                new Case(
                                                        Cylinder.of(RADIUS, HALF),
                                                        can,
                                                        way,
                                                        off,
                                                        16,
                                                        8),
                                                new Case(
                                                        Cone.of(RADIUS, HALF),
                                                        cone,
                                                        way,
                                                        off,
                                                        4,
                                                        4),
                                                new Case(
                                                        Capsule.of(.05, RADIUS),
                                                        0,
                                                        way,
                                                        -off,
                                                        4,
                                                        1))));
    }

    private static Body body(Shape shape, Way way) {
        Quaterniond aside = new Quaterniond().rotateXYZ(.3, 1, -.4);
        return switch (way) {
            case ALONE -> Body.dynamic().shape(shape);
            case MOVED -> Body.dynamic().shape(shape.moved(.1, -.2, .3, aside));
            case PART ->
                    Body.dynamic()
                            .collider(Collider.of(shape).at(.1, -.2, .3).rotation(aside))
                            // well inside
                            .collider(Collider.of(Box.cubeOfHalfExtent(.01)).at(.1, -.2, .3));
        };
    }

    @ParameterizedTest
    @MethodSource("cases")
    void whatTipsOverStaysOnTheFloor(Case c) {
        double tilt = c.balance() - Math.toRadians(c.off());
        Quaterniond turn = new Quaterniond().rotateZ(tilt);
        Placement floor = new Placement().set(FLOOR, 0, 0, 0);
        Placement own = new Placement();
        ShapeQueries queries = new ShapeQueries();
        double height = queries.distance(floor, own.set(c.shape(), 0, 10, 0, 0, 0, turn.z, turn.w));
        Material rough = new Material(1, 0, 1000);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -9.81, 0)
                        .settings(
                                PhysicsSettings.DEFAULT
                                        .withSubsteps(c.substeps())
                                        .withSleeping(false)
                                        .withLanes(c.lanes()))
                        .build()) {
            world.add(Body.fixed().shape(FLOOR).material(rough));
            Quaterniond local =
                    c.way() == Way.ALONE
                            ? new Quaterniond()
                            : new Quaterniond().rotateXYZ(.3, 1, -.4);
            Quaterniond q = new Quaterniond(turn).mul(new Quaterniond(local).conjugate());
            Vector3d offset =
                    c.way() == Way.ALONE ? new Vector3d() : q.transform(new Vector3d(.1, -.2, .3));
            BodyRef body =
                    world.add(
                            body(c.shape(), c.way())
                                    .at(-offset.x, 10 - height - offset.y, -offset.z)
                                    .rotation(q)
                                    .material(rough));
            double before = world.kineticEnergy() + world.potentialEnergy();
            double most = 0;
            double gain = 0;
            boolean isDown = false;
            for (int tick = 0; tick < 300 && !isDown; tick++) {
                world.step(1 / 60.0);
                double energy = world.kineticEnergy() + world.potentialEnergy();
                gain = Math.max(gain, energy - before);
                isDown = energy < 0.99 * before;
                double gap = isDown ? 0 : gap(queries, floor, own, body, c.shape(), local);
                most = Math.max(most, Math.abs(gap));
            }
            assertTrue(isDown, c + " did not fall");
            // at 4 sub-steps of a tick of 1/60 s: the sag of a soft contact, 0.28 mm, is the most
            assertTrue(most < 4e-4, c + ": " + most + " m above or below the floor");
            assertEquals(0, gain / before, 1e-6, c.toString());
        }
    }

    private static double gap(
            ShapeQueries queries,
            Placement floor,
            Placement own,
            BodyRef body,
            Shape shape,
            Quaterniond local) {
        Quaterniondc now = body.orientation();
        Vector3dc at = body.position();
        Quaterniond q = new Quaterniond(now).mul(local);
        Vector3d p = new Vector3d();
        if (local.w != 1) {
            now.transform(new Vector3d(.1, -.2, .3), p);
        }
        return queries.distance(
                floor,
                own.set(shape, at.x() + p.x, at.y() + p.y, at.z() + p.z, q.x, q.y, q.z, q.w));
    }
}
