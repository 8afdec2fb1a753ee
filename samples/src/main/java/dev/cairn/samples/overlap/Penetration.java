package dev.cairn.samples.overlap;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Quaterniondc;
import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * How deep bodies overlap, measured from outside the engine: only poses and shapes go in, all in
 * double, and nothing of the engine's narrow phase is used.
 *
 * <p>The depth of two convex bodies is the shortest translation that parts them. For two polytopes
 * it lies along a face normal of either or along the cross product of an edge of each (the facets
 * of the Minkowski difference; Gottschalk's separating-axis theorem, 1996): for two boxes, 15 axes.
 * For spheres it is a closed form over the nearest point, for capsules, cylinders and cones the
 * best of many directions ({@link DirectionSearch}). Candidate pairs come from a sort along the
 * axis on which the bodies are spread widest. Stateless; allocates.
 */
public final class Penetration {
    /**
     * A cross product shorter than this is no direction: the edges are parallel, and the faces
     * cover the case.
     */
    private static final double PARALLEL = 1e-6;

    private Penetration() {}

    /**
     * The deepest overlap among bodies. Pairs of which neither is dynamic do not count, as none of
     * them answers, nor do those that a joint keeps from colliding.
     *
     * @param bodies any bodies; those that were removed are skipped
     * @param joints between them
     * @return metres, at least 0
     */
    public static double deepest(List<BodyRef> bodies, List<JointRef> joints) {
        Set<Partners> partners = new HashSet<>();
        for (JointRef joint : joints) {
            if (joint.isAlive() && !joint.collides()) {
                partners.add(new Partners(joint.entityA(), joint.entityB()));
                partners.add(new Partners(joint.entityB(), joint.entityA()));
            }
        }
        List<Entry> entries = new ArrayList<>();
        for (BodyRef body : bodies) {
            if (body.isAlive()) {
                add(body, entries);
            }
        }
        return deepestOf(entries, partners);
    }

    /**
     * All that a body is made of, but what only tells who is in it, and surfaces of triangles, in
     * which nothing can be deep.
     */
    private static void add(BodyRef body, List<Entry> entries) {
        for (ColliderRef part : body.colliders()) {
            Shape shape = part.description().placed();
            Shape inner = shape instanceof Moved m ? m.inner() : shape;
            boolean isSurface = inner instanceof TriangleMesh || inner instanceof HeightField;
            if (!part.isSensor() && !isSurface) {
                Solid solid = Solid.of(shape, body.position(), body.orientation());
                entries.add(new Entry(solid, body.type() != BodyType.DYNAMIC, body));
            }
        }
    }

    /**
     * The depth of one pair.
     *
     * @param a a shape
     * @param positionA where the origin of its frame is, world, m
     * @param rotationA unit quaternion, world from shape
     * @param b another shape
     * @param positionB where the origin of its frame is, world, m
     * @param rotationB unit quaternion, world from shape
     * @return metres; 0 if they only touch or are apart
     */
    public static double depth(
            Shape a,
            Vector3dc positionA,
            Quaterniondc rotationA,
            Shape b,
            Vector3dc positionB,
            Quaterniondc rotationB) {
        return depth(Solid.of(a, positionA, rotationA), Solid.of(b, positionB, rotationB));
    }

    private record Entry(Solid solid, boolean firm, BodyRef body) {}

    /** Two entities that may overlap. */
    private record Partners(long a, long b) {}

    private static double deepestOf(List<Entry> entries, Set<Partners> partners) {
        int axis = widestAxis(entries);
        entries.sort(Comparator.comparingDouble(entry -> entry.solid.low[axis]));
        double deepest = 0;
        List<Entry> open = new ArrayList<>();
        for (Entry entry : entries) {
            int kept = 0;
            for (int i = 0; i < open.size(); i++) {
                Entry other = open.get(i);
                if (other.solid.high[axis] < entry.solid.low[axis]) {
                    continue;
                }
                open.set(kept++, other);
                if (!(entry.firm && other.firm)
                        && entry.body != other.body
                        && entry.solid.mayTouch(other.solid)
                        && !partners.contains(
                                new Partners(entry.body.entity(), other.body.entity()))) {
                    deepest = Math.max(deepest, depth(entry.solid, other.solid));
                }
            }
            open.subList(kept, open.size()).clear();
            open.add(entry);
        }
        return deepest;
    }

    /** The axis with the largest variance of the centres of what moves. */
    private static int widestAxis(List<Entry> entries) {
        int best = 0;
        double widest = -1;
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            double squares = 0;
            int n = 0;
            for (Entry entry : entries) {
                if (!entry.firm) {
                    sum += entry.solid.centre[axis];
                    squares += entry.solid.centre[axis] * entry.solid.centre[axis];
                    n++;
                }
            }
            double variance = n == 0 ? 0 : squares / n - sum / n * (sum / n);
            if (variance > widest) {
                widest = variance;
                best = axis;
            }
        }
        return best;
    }

    private static double depth(Solid a, Solid b) {
        if (a.endless || b.endless) {
            Solid ground = a.endless ? a : b;
            double[] n = ground.planes;
            double lowest = (a.endless ? b : a).min(n[0], n[1], n[2]);
            return Math.max(0, n[3] - lowest);
        }
        if ((a.radius > 0 && b.discs.length > 0) || (b.radius > 0 && a.discs.length > 0)) {
            return DirectionSearch.depth(a, b);
        }
        if (a.radius > 0 && b.radius > 0) {
            double x = b.centre[0] - a.centre[0];
            double y = b.centre[1] - a.centre[1];
            double z = b.centre[2] - a.centre[2];
            return Math.max(0, a.radius + b.radius - Math.sqrt(x * x + y * y + z * z));
        }
        if (a.radius > 0) {
            return Math.max(0, a.radius - distance(b, a.centre));
        }
        if (b.radius > 0) {
            return Math.max(0, b.radius - distance(a, b.centre));
        }
        if (a.discs.length > 0 || b.discs.length > 0) {
            return DirectionSearch.depth(a, b);
        }
        return bySeparatingAxes(a, b);
    }

    /** Signed distance of a point from a polytope: negative inside. */
    private static double distance(Solid solid, double[] point) {
        double outermost = Double.NEGATIVE_INFINITY;
        for (int p = 0; p < solid.planes.length; p += 4) {
            outermost = Math.max(outermost, height(solid, p, point));
        }
        if (outermost <= 0) {
            return outermost;
        }
        double nearest = Double.POSITIVE_INFINITY;
        for (int f = 0; f < solid.faces.length; f++) {
            nearest = Math.min(nearest, distanceToFace(solid, f, point));
        }
        return nearest;
    }

    private static double height(Solid solid, int plane, double[] point) {
        return solid.planes[plane] * point[0]
                + solid.planes[plane + 1] * point[1]
                + solid.planes[plane + 2] * point[2]
                - solid.planes[plane + 3];
    }

    /**
     * Distance of a point from a convex polygon: to its plane if it projects inside, else to the
     * nearest edge.
     */
    private static double distanceToFace(Solid solid, int face, double[] point) {
        int plane = 4 * face;
        double nx = solid.planes[plane];
        double ny = solid.planes[plane + 1];
        double nz = solid.planes[plane + 2];
        int[] loop = solid.faces[face];
        double nearestSquare = Double.POSITIVE_INFINITY;
        boolean inside = true;
        for (int k = 0; k < loop.length; k++) {
            int a = 3 * loop[k];
            int b = 3 * loop[(k + 1) % loop.length];
            double ex = solid.vertices[b] - solid.vertices[a];
            double ey = solid.vertices[b + 1] - solid.vertices[a + 1];
            double ez = solid.vertices[b + 2] - solid.vertices[a + 2];
            double px = point[0] - solid.vertices[a];
            double py = point[1] - solid.vertices[a + 1];
            double pz = point[2] - solid.vertices[a + 2];
            // n x e points into the polygon.
            double inward =
                    (ny * ez - nz * ey) * px + (nz * ex - nx * ez) * py + (nx * ey - ny * ex) * pz;
            inside &= inward >= 0;
            double t =
                    Math.clamp(
                            (ex * px + ey * py + ez * pz) / (ex * ex + ey * ey + ez * ez),
                            0.0,
                            1.0);
            double dx = px - t * ex;
            double dy = py - t * ey;
            double dz = pz - t * ez;
            nearestSquare = Math.min(nearestSquare, dx * dx + dy * dy + dz * dz);
        }
        return inside ? Math.abs(height(solid, plane, point)) : Math.sqrt(nearestSquare);
    }

    private static double bySeparatingAxes(Solid a, Solid b) {
        double depth = Math.min(overFaces(a, b), overFaces(b, a));
        for (int i = 0; i < a.edges.length && depth > 0; i += 3) {
            for (int j = 0; j < b.edges.length && depth > 0; j += 3) {
                double x = a.edges[i + 1] * b.edges[j + 2] - a.edges[i + 2] * b.edges[j + 1];
                double y = a.edges[i + 2] * b.edges[j] - a.edges[i] * b.edges[j + 2];
                double z = a.edges[i] * b.edges[j + 1] - a.edges[i + 1] * b.edges[j];
                double length = Math.sqrt(x * x + y * y + z * z);
                if (length > PARALLEL) {
                    x /= length;
                    y /= length;
                    z /= length;
                    depth = Math.min(depth, a.max(x, y, z) - b.min(x, y, z));
                    depth = Math.min(depth, b.max(x, y, z) - a.min(x, y, z));
                }
            }
        }
        return Math.max(0, depth);
    }

    /** The least depth of b behind the faces of a. */
    private static double overFaces(Solid a, Solid b) {
        double depth = Double.POSITIVE_INFINITY;
        for (int p = 0; p < a.planes.length && depth > 0; p += 4) {
            depth =
                    Math.min(
                            depth,
                            a.planes[p + 3] - b.min(a.planes[p], a.planes[p + 1], a.planes[p + 2]));
        }
        return depth;
    }
}
