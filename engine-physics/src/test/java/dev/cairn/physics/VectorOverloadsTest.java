package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.hand.Hand;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Motion;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Wherever three doubles are a vector, a vector of JOML's is taken too. */
class VectorOverloadsTest {
    private static final List<Class<?>> API =
            List.of(
                    PhysicsWorld.class,
                    PhysicsWorldBuilder.class,
                    Body.class,
                    BodyRef.class,
                    Collider.class,
                    ColliderRef.class,
                    Material.class,
                    WorldQueries.class,
                    Joint.class,
                    JointRef.class,
                    Hand.class,
                    Placement.class,
                    Motion.class,
                    ShapeQueries.class,
                    Box.class,
                    TriangleMesh.class);

    /**
     * Three doubles that are no vector: mass, frequency, ratio; and what the engine asks itself.
     */
    private static final List<String> OTHERS =
            List.of("spring", "stiffness", "setCentre", "bounds");

    private static boolean hasThreeDoubles(Method method) {
        int run = 0;
        for (Class<?> type : method.getParameterTypes()) {
            run = type == double.class ? run + 1 : 0;
            if (run == 3) {
                return true;
            }
        }
        return false;
    }

    @Test
    void threeDoublesHaveAVectorBesideThem() {
        List<String> without = new ArrayList<>();
        int seen = 0;
        for (Class<?> type : API) {
            for (Method method : type.getDeclaredMethods()) {
                if (!Modifier.isPublic(method.getModifiers())
                        || method.isSynthetic()
                        || OTHERS.contains(method.getName())
                        || !hasThreeDoubles(method)) {
                    continue;
                }
                seen++;
                boolean has =
                        Arrays.stream(type.getMethods())
                                .filter(other -> other.getName().equals(method.getName()))
                                .flatMap(other -> Arrays.stream(other.getParameterTypes()))
                                .anyMatch(Vector3dc.class::equals);
                if (!has) {
                    without.add(type.getSimpleName() + "." + method.getName());
                }
            }
        }
        assertEquals(List.of(), without);
        assertEquals(true, seen > 40, seen + " methods were looked at");
    }

    /** A world that is told in vectors is that of doubles. */
    @Test
    void bothSayTheSame() {
        assertEquals(play(false), play(true));
    }

    private static long play(boolean vectors) {
        PhysicsWorldBuilder builder = PhysicsWorld.builder().workers(1);
        Vector3d down = new Vector3d(0.25, -9, 0.5);
        try (PhysicsWorld world =
                (vectors ? builder.gravity(down) : builder.gravity(0.25, -9, 0.5)).build()) {
            Vector3d half = new Vector3d(9, 0.5, 8);
            world.add(
                    Body.fixed()
                            .shape(
                                    vectors
                                            ? Box.ofHalfExtents(half)
                                            : Box.ofHalfExtents(9, 0.5, 8)));
            Body box = Body.dynamic().shape(Box.ofEdges(0.5, 0.4, 0.3)).mass(3).at(0, 1, 0);
            if (vectors) {
                box.rotationAbout(new Vector3d(1, 2, 3), 0.3)
                        .inertia(new Vector3d(0.3, 0.2, 0.25))
                        .centreOfMass(new Vector3d(0.01, 0.02, 0.03));
            } else {
                box.rotationAbout(1, 2, 3, 0.3)
                        .inertia(0.3, 0.2, 0.25)
                        .centreOfMass(0.01, 0.02, 0.03);
            }
            BodyRef a = world.add(box);
            BodyRef b = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.2)).at(1, 1, 0));
            Joint hinge = Joint.hinge(a, b);
            world.add(
                    vectors
                            ? hinge.at(new Vector3d(0.5, 1, 0)).axis(new Vector3d(0, 1, 1))
                            : hinge.at(0.5, 1, 0).axis(0, 1, 1));
            for (int tick = 0; tick < 60; tick++) {
                if (tick == 30 && vectors) {
                    world.setGravity(new Vector3d(0, -5, 0));
                    a.setInertia(new Vector3d(0.2, 0.2, 0.2));
                    a.setCentreOfMass(new Vector3d());
                } else if (tick == 30) {
                    world.setGravity(0, -5, 0);
                    a.setInertia(0.2, 0.2, 0.2);
                    a.setCentreOfMass(0, 0, 0);
                }
                world.step(Scenes.STEP);
            }
            Hit hit = new Hit();
            Vector3d from = new Vector3d(0, 5, 0);
            BodyRef struck =
                    vectors
                            ? world.queries().rayCast(from, down, 99, hit)
                            : world.queries().rayCast(0, 5, 0, 0.25, -9, 0.5, 99, hit);
            long told = struck == null ? 0 : struck.name().hashCode();
            return world.digest() + 31 * Double.doubleToLongBits(hit.distance()) + told;
        }
    }
}
