package dev.cairn.samples.scenes.level;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.decomposition.Decomposer;
import dev.cairn.physics.shape.decomposition.Decomposition;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * Rings, cups and horseshoes are poured through a funnel: concave bodies, convex parts of meshes
 * that are made here.
 *
 * <p>No closed form. What can be said: nothing passes the wall of the funnel.
 */
public final class Funnel {
    /** Segments of what is turned about an axis. */
    private static final int AROUND = 20;

    private static final double ERROR = 0.04;

    /** Radius above, radius and height of the neck, height of its upper end, m. */
    private static final double MOUTH = 3;

    private static final double NECK = 1.1;
    private static final double LOW = 1.6;
    private static final double HIGH = 4;

    private Funnel() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "funnel",
                "Concave bodies in a funnel",
                "Rings, cups and horseshoes, convex parts of meshes, are poured through a funnel.",
                "levels",
                List.of(
                        Parameter.count("bodies", 36, 1, 1000, "number of bodies"),
                        Parameter.real("friction", 0.2, 0, 2, "Coulomb coefficient")),
                600,
                110,
                Funnel::build);
    }

    /** A closed outline in the half plane x &gt; 0, counter-clockwise, turned about the y axis. */
    private static TriangleMesh turned(double[][] outline) {
        Surfaces s = new Surfaces();
        int n = outline.length;
        for (int i = 0; i < AROUND; i++) {
            double a = 2 * Math.PI * i / AROUND;
            for (double[] p : outline) {
                s.vertex(p[0] * StrictMath.cos(a), p[1], p[0] * StrictMath.sin(a));
            }
        }
        for (int i = 0; i < AROUND; i++) {
            int next = (i + 1) % AROUND;
            for (int k = 0; k < n; k++) {
                int up = (k + 1) % n;
                s.quad(i * n + k, i * n + up, next * n + up, next * n + k);
            }
        }
        return s.mesh();
    }

    private static TriangleMesh ring() {
        int n = 10;
        double[][] outline = new double[n][];
        for (int k = 0; k < n; k++) {
            double a = 2 * Math.PI * k / n;
            outline[k] = new double[] {0.34 + 0.11 * StrictMath.cos(a), 0.11 * StrictMath.sin(a)};
        }
        return turned(outline);
    }

    /** What is on the axis closes by itself: triangles without area are left out. */
    private static TriangleMesh cup() {
        return turned(
                new double[][] {
                    {0, 0}, {0.26, 0}, {0.34, 0.6}, {0.27, 0.6}, {0.2, 0.08}, {0, 0.08}
                });
    }

    /** Three quarters of a square frame: two legs and what joins them. */
    private static TriangleMesh horseshoe() {
        double[][] outline = {
            {-0.35, -0.35},
            {0.35, -0.35},
            {0.35, 0.35},
            {0.17, 0.35},
            {0.17, -0.15},
            {-0.17, -0.15},
            {-0.17, 0.35},
            {-0.35, 0.35}
        };
        int[][] faces = {{0, 1, 4, 5}, {1, 2, 3, 4}, {0, 5, 6, 7}};
        Surfaces s = new Surfaces();
        int n = outline.length;
        for (double z : new double[] {-0.09, 0.09}) {
            for (double[] p : outline) {
                s.vertex(p[0], p[1], z);
            }
        }
        for (int[] f : faces) {
            s.quad(n + f[0], n + f[1], n + f[2], n + f[3]);
            s.quad(f[3], f[2], f[1], f[0]);
        }
        for (int k = 0; k < n; k++) {
            int next = (k + 1) % n;
            s.quad(k, next, n + next, n + k);
        }
        return s.mesh();
    }

    /** The funnel from within: its sides face the axis. */
    private static TriangleMesh wall() {
        double[][] outline = {{NECK, LOW - 0.8}, {NECK, LOW}, {MOUTH, HIGH}, {MOUTH, HIGH + 7}};
        int around = 2 * AROUND;
        Surfaces s = new Surfaces();
        for (int i = 0; i < around; i++) {
            double a = 2 * Math.PI * i / around;
            for (double[] p : outline) {
                s.vertex(p[0] * StrictMath.cos(a), p[1], p[0] * StrictMath.sin(a));
            }
        }
        int n = outline.length;
        for (int i = 0; i < around; i++) {
            int next = (i + 1) % around;
            for (int k = 0; k + 1 < n; k++) {
                s.quad(i * n + k, next * n + k, next * n + k + 1, i * n + k + 1);
            }
        }
        return s.mesh();
    }

    private static void build(SceneBuilder scene) {
        double friction = scene.get("friction");
        scene.floor(12, 12, 0.6, 0);
        scene.add(
                wall(),
                Palette.STONE,
                Body.fixed().material(Palette.material(friction, 0)).name("funnel"));
        List<Decomposition> kinds = new ArrayList<>();
        for (TriangleMesh mesh : List.of(ring(), cup(), horseshoe())) {
            kinds.add(Decomposer.of(mesh).error(ERROR).parts(12).run());
        }
        List<BodyRef> poured = new ArrayList<>();
        for (int i = 0; i < scene.count("bodies"); i++) {
            Decomposition kind = kinds.get(i % kinds.size());
            MassProperties solid = kind.massProperties(1000);
            List<Collider> parts = new ArrayList<>();
            for (ConvexHull part : kind.parts()) {
                parts.add(Collider.of(part));
            }
            int column = i % 3;
            int row = i / 3 % 3;
            int layer = i / 9;
            Body body =
                    Body.dynamic()
                            .massProperties(solid)
                            .at(
                                    1.6 * (column - 1) + scene.random(-0.1, 0.1),
                                    HIGH + 0.6 + 1.5 * layer,
                                    1.6 * (row - 1) + scene.random(-0.1, 0.1))
                            .rotation(
                                    new Quaterniond()
                                            .rotateXYZ(
                                                    scene.random(-3, 3),
                                                    scene.random(-3, 3),
                                                    scene.random(-3, 3)))
                            .material(Palette.material(friction, 0));
            poured.add(scene.addParts(parts, Palette.body(i), body));
        }
        scene.view(new SceneView(5.5, 7.5, 9, 0, 2.6, 0));
        scene.error("throughTheWall", () -> outside(poured));
    }

    /** How many bodies have their centre outside of the funnel, at the height of its wall. */
    private static double outside(List<BodyRef> poured) {
        int count = 0;
        for (BodyRef body : poured) {
            Vector3d c = body.position();
            double up = Math.min(1, Math.max(0, (c.y - LOW) / (HIGH - LOW)));
            double radius = NECK + up * (MOUTH - NECK);
            boolean isBeside = c.y > LOW - 0.4 && c.y < HIGH + 7;
            count += isBeside && c.x * c.x + c.z * c.z > radius * radius ? 1 : 0;
        }
        return count;
    }
}
