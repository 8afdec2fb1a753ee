package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.TriangleMesh;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A plate of 2 m, 0.4 m thick, of whose four lower corners one is higher: two triangles. */
class LevelCornerTest {
    /** Of the half height, 0.2 m, which is the inner radius. */
    @ParameterizedTest
    @CsvSource({
        "PLANE, 0, 4", "PLANE, 1e-6, 4", "PLANE, 0.005, 4", "PLANE, 0.5, 3",
        "SLAB, 0, 4", "SLAB, 1e-6, 4", "SLAB, 0.005, 4", "SLAB, 0.5, 3",
        "MESH, 0, 4", "MESH, 1e-6, 4", "MESH, 0.005, 4", "MESH, 0.5, 3",
    })
    void aPlateTouchesWithTheCornerThatIsLevelWithThree(String ground, double higher, int points) {
        double low = -0.2;
        double[] corners = {
            -1,
            low,
            -1,
            1,
            low,
            -1,
            1,
            low,
            1,
            -1,
            low + 0.2 * higher,
            1,
            -1,
            0.2,
            -1,
            1,
            0.2,
            -1,
            1,
            0.2,
            1,
            -1,
            0.2,
            1
        };
        double[] square = {-9, 0, -8, 9, 0, -9, 9, 0, 9, -9, 0, 9};
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).gravity(0, 0, 0).build()) {
            world.add(
                    switch (ground) {
                        case "PLANE" -> Body.fixed().shape(HalfSpace.of());
                        case "SLAB" -> Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0);
                        default ->
                                Body.fixed()
                                        .shape(
                                                TriangleMesh.of(
                                                        square, new int[] {0, 2, 1, 0, 3, 2}));
                    });
            world.add(Body.dynamic().shape(ConvexHull.of(corners)).at(0, 0.2, 0));
            world.step(1.0 / 60);
            Contacts contacts = world.contacts();
            assertEquals(1, contacts.count());
            assertEquals(points, contacts.pointCount(0));
        }
    }
}
