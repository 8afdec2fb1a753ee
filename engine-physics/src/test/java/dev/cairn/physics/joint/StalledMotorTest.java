package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * A limit is stronger than the motor of its axis, whatever force that has: the motor drives the
 * axis to its limit and no further, holds it there against loads, and drives it back when it is
 * turned round.
 */
final class StalledMotorTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;
    private static final double EDGE = 0.4;

    /** Kinds whose axis lies along y: what moves along it bears 3 G, what turns is level. */
    enum Driven {
        SLIDER(JointAxis.X) {
            @Override
            Joint make(BodyRef a, BodyRef b) {
                return Joint.slider(a, b).at(0, 0, 0).axis(0, 1, 0);
            }
        },
        CYLINDER_ALONG(JointAxis.X) {
            @Override
            Joint make(BodyRef a, BodyRef b) {
                return Joint.cylindrical(a, b).at(0, 0, 0).axis(0, 1, 0);
            }
        },
        GENERIC_ALONG(JointAxis.X) {
            @Override
            Joint make(BodyRef a, BodyRef b) {
                Joint joint = Joint.generic(a, b).at(0, 0, 0).axis(0, 1, 0);
                joint.locked(JointAxis.Y).locked(JointAxis.Z).locked(JointAxis.TWIST);
                return joint.locked(JointAxis.SWING_Y).locked(JointAxis.SWING_Z);
            }
        },
        HINGE(JointAxis.TWIST) {
            @Override
            Joint make(BodyRef a, BodyRef b) {
                return Joint.hinge(a, b).at(0, 0, 0).axis(0, 0, 1);
            }
        },
        CYLINDER_ROUND(JointAxis.TWIST) {
            @Override
            Joint make(BodyRef a, BodyRef b) {
                return Joint.cylindrical(a, b).at(0, 0, 0).axis(0, 0, 1);
            }
        },
        GENERIC_SWING(JointAxis.SWING_Z) {
            @Override
            Joint make(BodyRef a, BodyRef b) {
                Joint joint = Joint.generic(a, b).at(0, 0, 0).axis(1, 0, 0);
                joint.locked(JointAxis.X).locked(JointAxis.Y).locked(JointAxis.Z);
                return joint.locked(JointAxis.TWIST).locked(JointAxis.SWING_Y);
            }
        };

        final JointAxis axis;

        Driven(JointAxis axis) {
            this.axis = axis;
        }

        abstract Joint make(BodyRef a, BodyRef b);
    }

    private static final double[] MOSTS = {60, 1e3, 1e6, 1e12, Double.POSITIVE_INFINITY};

    @ParameterizedTest
    @EnumSource
    void theLimitWins(Driven driven) {
        for (double most : MOSTS) {
            for (double speed : new double[] {0.7, -0.7, 30, -30}) {
                run(driven, speed, most);
            }
        }
    }

    private static void run(Driven driven, double speed, double most) {
        String what = driven + ", " + speed + " with " + most;
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build()) {
            BodyRef peg = world.add(Body.fixed().shape(Sphere.of(0.05)).at(0, 0, 1));
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.2, 0.1, 0.3))
                                    .mass(3)
                                    .at(driven.axis.isAngle ? 0.5 : 0, 0, 0));
            Joint made = driven.make(peg, box).limits(driven.axis, -EDGE, EDGE);
            JointRef joint = world.add(made.motor(driven.axis, speed, most));
            double side = Math.signum(speed);
            watch(world, joint, driven, 120, what);
            assertEquals(side * EDGE, joint.value(driven.axis), 1e-7, what);
            double weight = joint.force(new Vector3d()).y;
            // a motor that presses with 1e12 N leaves as much rounding
            double rounding = most < 1e9 || most > 1e13 ? 1e-6 : 1e-12 * most;
            boolean isCylinder = driven == Driven.CYLINDER_ROUND;
            assertEquals(3 * G, weight, 3 * G * 1e-6 + rounding, what + ": force");
            // a blow against it is taken, too
            box.setVelocity(0, side * 20, 0);
            watch(world, joint, driven, 60, what + " struck");
            assertEquals(side * EDGE, joint.value(driven.axis), 1e-7, what + " struck");
            joint.motor(driven.axis, -speed, most);
            watch(world, joint, driven, 120, what + " back");
            assertEquals(-side * EDGE, joint.value(driven.axis), 1e-7, what + " back");
            assertTrue(isCylinder || joint.gap() < 1e-7, what + ": gap " + joint.gap());
        }
    }

    private static void watch(
            PhysicsWorld world, JointRef joint, Driven driven, int ticks, String what) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(STEP);
            double value = joint.value(driven.axis);
            assertTrue(Math.abs(value) < EDGE + 1e-7, what + ", tick " + tick + ": at " + value);
        }
    }
}
