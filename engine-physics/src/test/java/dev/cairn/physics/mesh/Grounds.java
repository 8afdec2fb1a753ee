package dev.cairn.physics.mesh;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Quaterniond;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** Planes at y = 0 made of triangles, and other surfaces for tests. */
public final class Grounds {
    private Grounds() {}

    /** A floor from -half to half, cut into n by n squares of two triangles each. */
    public static TriangleMesh regular(double half, int n) {
        return grid(half, half, n, n, 0, new Random(1));
    }

    /** The same with corners moved at random within the plane. */
    public static TriangleMesh irregular(double half, int n, long seed) {
        return grid(half, half, n, n, .35, new Random(seed));
    }

    /** Triangles a thousand times longer along z than wide. */
    public static TriangleMesh slivers(double half) {
        int n = 1000;
        return grid(half, half, n, 1, 0, new Random(1));
    }

    private static TriangleMesh grid(
            double halfX, double halfZ, int nx, int nz, double jitter, Random random) {
        double[] xyz = new double[3 * (nx + 1) * (nz + 1)];
        int at = 0;
        for (int j = 0; j <= nz; j++) {
            for (int i = 0; i <= nx; i++) {
                boolean inner = i > 0 && i < nx && j > 0 && j < nz;
                double dx = inner ? jitter * (2 * random.nextDouble() - 1) : 0;
                double dz = inner ? jitter * (2 * random.nextDouble() - 1) : 0;
                xyz[at++] = halfX * (2 * (i + dx) / nx - 1);
                xyz[at++] = 0;
                xyz[at++] = halfZ * (2 * (j + dz) / nz - 1);
            }
        }
        List<Integer> index = new ArrayList<>();
        for (int j = 0; j < nz; j++) {
            for (int i = 0; i < nx; i++) {
                int a = j * (nx + 1) + i;
                int b = a + 1;
                int c = a + nx + 1;
                int d = c + 1;
                index.addAll(
                        (i + j) % 2 == 0 ? List.of(a, c, d, a, d, b) : List.of(a, c, b, b, c, d));
            }
        }
        return TriangleMesh.of(xyz, index.stream().mapToInt(Integer::intValue).toArray());
    }

    /**
     * Hills and hollows within a rim that nothing leaves: how high the ground is at its corners.
     */
    public static double hills(double x, double z) {
        double r = Math.max(Math.abs(x), Math.abs(z));
        double rim = Math.max(0, r - 6);
        return .4 * StrictMath.sin(1.3 * x + .2) * StrictMath.cos(1.1 * z) + 1.5 * rim * rim;
    }

    /** The ground of {@link #hills}, 16 m wide, in squares of half a metre. */
    public static TriangleMesh hilly() {
        TriangleMesh flat = grid(8, 8, 32, 32, 0, new Random(1));
        double[] xyz = flat.vertices();
        for (int i = 0; i < xyz.length; i += 3) {
            xyz[i + 1] = hills(xyz[i], xyz[i + 2]);
        }
        return TriangleMesh.of(xyz, flat.indices());
    }

    /** The same ground as heights. */
    public static Shape hillyField() {
        double[] heights = new double[33 * 33];
        for (int k = 0; k < heights.length; k++) {
            heights[k] = hills(k % 33 * .5 - 8, k / 33 * .5 - 8);
        }
        return HeightField.of(33, 33, .5, .5, heights).moved(-8, 0, -8, new Quaterniond());
    }

    /** One shape of each kind, about a foot wide. */
    public static Shape[] kinds() {
        return new Shape[] {
            Sphere.of(.2),
            Capsule.of(.15, .2),
            Cylinder.of(.2, .15),
            Cone.of(.25, .2),
            Box.ofHalfExtents(.25, .15, .2),
            ConvexHull.of(
                    new double[] {
                        .25, 0, 0, -.25, 0, 0, 0, .25, 0, 0, -.25, 0, 0, 0, .25, 0, 0, -.25, .2, .2,
                        .2
                    }),
        };
    }

    /** The inside of a ball about the origin, as far as 1.2 rad from its lowest point. */
    public static TriangleMesh bowl(double radius, int facets) {
        int rings = (int) Math.ceil(1.2 * facets / (2 * Math.PI));
        double[] xyz = new double[3 * (1 + rings * facets)];
        xyz[1] = -radius;
        List<Integer> index = new ArrayList<>();
        for (int ring = 1; ring <= rings; ring++) {
            double out = radius * StrictMath.sin(1.2 * ring / rings);
            for (int i = 0; i < facets; i++) {
                int c = 1 + (ring - 1) * facets + i;
                int d = 1 + (ring - 1) * facets + (i + 1) % facets;
                xyz[3 * c] = out * StrictMath.cos(2 * Math.PI * i / facets);
                xyz[3 * c + 1] = -radius * StrictMath.cos(1.2 * ring / rings);
                xyz[3 * c + 2] = out * StrictMath.sin(2 * Math.PI * i / facets);
                if (ring == 1) {
                    index.addAll(List.of(0, d, c));
                } else {
                    index.addAll(List.of(c - facets, d - facets, d, c - facets, d, c));
                }
            }
        }
        return TriangleMesh.of(xyz, index.stream().mapToInt(Integer::intValue).toArray());
    }

    /** Drops so many bodies of all kinds over the ground of {@link #hills}. */
    public static List<BodyRef> drop(PhysicsWorld world, int count, long seed) {
        return drop(world, hilly(), count, seed);
    }

    /** The same over a ground that is made of something else. */
    public static List<BodyRef> drop(PhysicsWorld world, Shape ground, int count, long seed) {
        Random random = new Random(seed);
        world.add(Body.fixed().shape(ground).name("hills"));
        Shape[] kinds = kinds();
        List<BodyRef> bodies = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Quaterniond turn =
                    new Quaterniond(
                                    random.nextGaussian(),
                                    random.nextGaussian(),
                                    random.nextGaussian(),
                                    random.nextGaussian())
                            .normalize();
            Body body = Body.dynamic().rotation(turn).name("body " + i);
            if (i % 7 == 6) {
                body.collider(Collider.of(kinds[0]).at(.2, 0, 0))
                        .collider(Collider.of(kinds[4]).at(-.2, 0, 0));
            } else {
                body.shape(kinds[i % 7]);
            }
            bodies.add(
                    world.add(
                            body.at(
                                    10 * random.nextDouble() - 5,
                                    1.5 + 2 * random.nextDouble(),
                                    10 * random.nextDouble() - 5)));
        }
        return bodies;
    }

    /** Rows of squares, each row cut into one more than the last: corners lie on sides. */
    public static TriangleMesh tJoints(double half, int rows) {
        List<Double> xyz = new ArrayList<>();
        List<Integer> index = new ArrayList<>();
        for (int j = 0; j < rows; j++) {
            double z0 = half * (2.0 * j / rows - 1);
            double z1 = half * (2.0 * (j + 1) / rows - 1);
            int n = 3 + j;
            for (int i = 0; i < n; i++) {
                double x0 = half * (2.0 * i / n - 1);
                double x1 = half * (2.0 * (i + 1) / n - 1);
                int a = xyz.size() / 3;
                xyz.addAll(Arrays.asList(x0, 0., z0, x0, 0., z1, x1, 0., z1, x1, 0., z0));
                index.addAll(List.of(a, a + 1, a + 2, a, a + 2, a + 3));
            }
        }
        return TriangleMesh.of(
                xyz.stream().mapToDouble(Double::doubleValue).toArray(),
                index.stream().mapToInt(Integer::intValue).toArray());
    }
}
