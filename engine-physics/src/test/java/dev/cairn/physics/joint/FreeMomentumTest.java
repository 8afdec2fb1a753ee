package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.ArrayList;
import java.util.List;

/**
 * What floats keeps its momentum to 1e-13 and its angular momentum to 1e-12, over half a minute: of
 * the sum of what the bodies have, each by itself, since that is what rounding is a share of.
 */
final class FreeMomentumTest {
    private static final double STEP = 1 / 60.0;

    /** Joints between boxes in a row along x, a metre apart. */
    enum Mechanism {
        BALLS {
            @Override
            void hold(PhysicsWorld world, List<BodyRef> b) {
                for (int i = 1; i < b.size(); i++) {
                    world.add(Joint.ball(b.get(i - 1), b.get(i)).at(i - 0.5, 0, 0));
                }
            }
        },
        HINGES {
            @Override
            void hold(PhysicsWorld world, List<BodyRef> b) {
                for (int i = 1; i < b.size(); i++) {
                    Joint hinge = Joint.hinge(b.get(i - 1), b.get(i)).at(i - 0.5, 0, 0);
                    world.add(hinge.axis(0, i % 2, 1).limits(-0.8, 0.8));
                }
            }
        },
        FIVE_KINDS {
            @Override
            void hold(PhysicsWorld world, List<BodyRef> b) {
                world.add(Joint.ball(b.get(0), b.get(1)).at(0.5, 0, 0).limits(0, 0.7));
                world.add(Joint.hinge(b.get(1), b.get(2)).at(1.5, 0, 0).axis(0, 1, 0));
                world.add(Joint.slider(b.get(2), b.get(3)).at(2.5, 0, 0).limits(-0.3, 0.3));
                world.add(Joint.universal(b.get(3), b.get(4)).at(3.5, 0, 0));
                world.add(Joint.rod(b.get(4), b.get(5)));
            }
        },
        MOTOR_AND_SPRINGS {
            @Override
            void hold(PhysicsWorld world, List<BodyRef> b) {
                Joint motor = Joint.hinge(b.get(0), b.get(1)).at(0.5, 0, 0).axis(0, 0, 1);
                world.add(motor.motor(2, 5));
                for (int i = 2; i < b.size(); i++) {
                    Joint hinge = Joint.hinge(b.get(i - 1), b.get(i)).at(i - 0.5, 0, 0);
                    world.add(hinge.axis(0, 1, 0).spring(0.3, 2, 0.1));
                }
            }
        },
        CLOSED_RING {
            @Override
            double y(int box) {
                return 1.2 * StrictMath.sin(Math.PI * box / 5);
            }

            @Override
            void hold(PhysicsWorld world, List<BodyRef> b) {
                for (int i = 0; i < b.size(); i++) {
                    world.add(Joint.rod(b.get(i), b.get((i + 1) % b.size())));
                }
            }
        };

        abstract void hold(PhysicsWorld world, List<BodyRef> boxes);

        double y(int box) {
            return 0;
        }
    }

    @ParameterizedTest
    @EnumSource
    void whatFloatsKeepsItsMomenta(Mechanism mechanism) {
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).sleeping(false).gravity(0, 0, 0).build()) {
            List<BodyRef> boxes = new ArrayList<>();
            for (int i = 0; i < 6; i++) {
                boxes.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.4, 0.1, 0.2))
                                        .mass(1 + i % 2)
                                        .at(i, mechanism.y(i), 0)
                                        .velocity(0.1, StrictMath.sin(i), 0.3 * (i % 3))
                                        .angularVelocity(0.3, 0.2, 1)));
            }
            world.collisions().setPairFilter((a, b) -> false);
            mechanism.hold(world, boxes);
            Kinetics then = world.kinetics();
            double worst = 0;
            double worstTurn = 0;
            for (int tick = 0; tick < 1800; tick++) {
                world.step(STEP);
                double size = 0;
                double reach = 1;
                for (BodyRef box : boxes) {
                    size += box.mass() * (box.velocity().length() + box.angularVelocity().length());
                    reach = Math.max(reach, box.position().length());
                }
                Kinetics now = world.kinetics();
                double p =
                        norm(
                                now.momentumX() - then.momentumX(),
                                now.momentumY() - then.momentumY(),
                                now.momentumZ() - then.momentumZ());
                double l =
                        norm(
                                now.angularMomentumX() - then.angularMomentumX(),
                                now.angularMomentumY() - then.angularMomentumY(),
                                now.angularMomentumZ() - then.angularMomentumZ());
                worst = Math.max(worst, p / size);
                worstTurn = Math.max(worstTurn, l / (size * reach));
            }
            String text = mechanism + ": momentum " + worst + ", angular " + worstTurn;
            System.out.println(text);
            assertTrue(worst < 1e-13, text);
            assertTrue(worstTurn < 1e-12, text);
        }
    }

    private static double norm(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
