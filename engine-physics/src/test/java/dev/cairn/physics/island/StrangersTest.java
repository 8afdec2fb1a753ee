package dev.cairn.physics.island;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Bodies go the same way, to the bit, whatever there is and happens in another place that they do
 * not touch: no switch of the world, thrown by somebody else, changes how they are solved.
 */
class StrangersTest {
    private static final double X = 400;
    private static final double Z = 300;
    private static final Shape CUBE = Box.cubeOfHalfExtent(.3);

    /** What else there is: all of it falls, so that it begins to touch within the run. */
    enum Stranger {
        STACK {
            @Override
            void join(PhysicsWorld world) {
                column(world, 6, CUBE, Material.WOOD);
            }
        },
        BOUNCING {
            @Override
            void join(PhysicsWorld world) {
                column(world, 3, CUBE, new Material(.5, .7, 1000));
            }
        },
        ROLLING {
            @Override
            void join(PhysicsWorld world) {
                column(world, 3, Sphere.of(.3), new Material(.5, 0, 1000, .01));
            }
        },
        ROUND {
            @Override
            void join(PhysicsWorld world) {
                column(world, 2, Cylinder.of(.3, .3), Material.WOOD);
                world.add(Body.dynamic().shape(Cone.of(.3, .4)).at(X, 5, Z));
            }
        },
        COMPOUND {
            @Override
            void join(PhysicsWorld world) {
                for (int i = 0; i < 2; i++) {
                    world.add(
                            Body.dynamic()
                                    .collider(Collider.of(CUBE).at(.4, 0, 0))
                                    .collider(Collider.of(Sphere.of(.3)).at(-.4, 0, 0))
                                    .at(X, 2 + i, Z));
                }
            }
        },
        SURFACE {
            @Override
            void join(PhysicsWorld world) {
                HeightField flat = HeightField.of(9, 9, 1, 1, new double[81]);
                world.add(Body.fixed().shape(flat).at(X - 4, 1, Z - 4));
                column(world, 3, CUBE, Material.WOOD);
            }
        },
        KINEMATIC {
            @Override
            void join(PhysicsWorld world) {
                world.add(
                        Body.kinematic()
                                .shape(Box.ofHalfExtents(1, .2, 1))
                                .at(X, 1, Z)
                                .velocity(.3, .1, 0)
                                .angularVelocity(0, 1, 0));
                column(world, 2, CUBE, Material.WOOD);
            }
        },
        JOINTED {
            @Override
            void join(PhysicsWorld world) {
                BodyRef a = world.add(Body.dynamic().shape(CUBE).at(X, 3, Z));
                BodyRef b = world.add(Body.dynamic().shape(CUBE).at(X + 1, 3, Z));
                world.add(Joint.ball(a, b).at(X + .5, 3, Z));
            }
        },
        FAST {
            @Override
            void join(PhysicsWorld world) {
                world.add(
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(.5, .02, .02))
                                .at(X, 3, Z)
                                .velocity(100, -200, 0)
                                .angularVelocity(30, 200, 100));
            }
        },
        FAR {
            @Override
            void join(PhysicsWorld world) {
                world.add(Body.dynamic().shape(CUBE).at(1e6, 3, Z));
            }
        },
        LOCKED {
            @Override
            void join(PhysicsWorld world) {
                world.add(Body.dynamic().shape(CUBE).at(X, 2, Z).lock(Lock.MOVE_X).damping(.1, .1));
            }
        },
        SQUEEZED {
            @Override
            void join(PhysicsWorld world) {
                world.add(Body.dynamic().shape(CUBE).at(X, .4, Z).mass(1));
                world.add(Body.dynamic().shape(CUBE).at(X, 2, Z).mass(1000));
            }
        };

        abstract void join(PhysicsWorld world);
    }

    private static void column(PhysicsWorld world, int count, Shape shape, Material material) {
        for (int i = 0; i < count; i++) {
            world.add(Body.dynamic().shape(shape).at(X + .05 * i, 1.8 + i, Z).material(material));
        }
    }

    /** Single bodies, some put down and some that fall, and a heap. */
    private static List<BodyRef> scene(PhysicsWorld world) {
        world.add(Body.fixed().shape(Box.ofHalfExtents(500, 1, 500)).at(0, -1, 0));
        List<BodyRef> bodies = new ArrayList<>();
        Random random = new Random(11);
        for (int i = 0; i < 24; i++) {
            bodies.add(world.add(Scenes.any(random, i).at(3 * i, .5 + .1 * (i % 7), 20)));
            bodies.add(world.add(Body.dynamic().shape(CUBE).at(3 * i, .3, 30)));
            bodies.add(world.add(Scenes.any(random, i)));
        }
        return bodies;
    }

    @ParameterizedTest
    @EnumSource
    void whatHappensElsewhereIsNotFelt(Stranger stranger) {
        try (PhysicsWorld alone = Scenes.awake().build();
                PhysicsWorld beside = Scenes.awake().build()) {
            List<BodyRef> some = scene(alone);
            List<BodyRef> same = scene(beside);
            stranger.join(beside);
            compare(alone, beside, some, same);
        }
    }

    /** The first two that touch each other change nothing for those that lie alone. */
    @Test
    void theFirstTouchOfAWorldIsNotFelt() {
        try (PhysicsWorld alone = Scenes.awake().build();
                PhysicsWorld beside = Scenes.awake().build()) {
            List<BodyRef> some = scene(alone);
            List<BodyRef> same = scene(beside);
            for (int i = 2; i < some.size(); i += 3) {
                some.get(i).remove();
                same.get(i).remove();
            }
            some.removeIf(body -> !body.isAlive());
            same.removeIf(body -> !body.isAlive());
            column(beside, 2, CUBE, Material.WOOD);
            compare(alone, beside, some, same);
        }
    }

    private static void compare(
            PhysicsWorld alone, PhysicsWorld beside, List<BodyRef> some, List<BodyRef> same) {
        for (int t = 0; t < 150; t++) {
            alone.step(Scenes.STEP);
            beside.step(Scenes.STEP);
            for (int i = 0; i < some.size(); i++) {
                BodyRef a = some.get(i);
                BodyRef b = same.get(i);
                String where = "tick " + t + ", " + a.shape();
                assertEquals(a.position(), b.position(), where);
                assertEquals(a.orientation(), b.orientation(), where);
                assertEquals(a.velocity(new Vector3d()), b.velocity(new Vector3d()), where);
                assertEquals(a.angularVelocity(), b.angularVelocity(), where);
            }
        }
    }
}
