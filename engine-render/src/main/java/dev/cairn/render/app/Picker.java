package dev.cairn.render.app;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.physics.shape.Shape;
import dev.cairn.render.mesh.Mesh;
import dev.cairn.render.mesh.Model;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.Map;

/**
 * Finds what is under a place in the picture: the drawn triangles, at the interpolated poses at
 * which they are drawn. So it needs nothing but the snapshot, and hits whatever can be seen.
 *
 * <p>Ray and triangle by Möller and Trumbore, "Fast, minimum storage ray/triangle intersection"
 * (1997). Window thread.
 */
final class Picker {
    private static final int MOST_MESHES = 256;

    private static final class Triangles {
        private final float[] vertices;
        private final int[] indices;

        Triangles(Mesh mesh) {
            vertices = mesh.vertices();
            indices = mesh.indices();
        }
    }

    private final Map<Mesh, Triangles> meshes = new HashMap<>();
    private final Quaterniond from = new Quaterniond();
    private final Quaterniond to = new Quaterniond();
    private final Vector3d place = new Vector3d();
    private final Vector3d start = new Vector3d();
    private final Vector3d along = new Vector3d();

    @Nullable Pick pick(PoseSnapshot snapshot, double alpha, Vector3d eye, Vector3d direction) {
        double nearest = Double.POSITIVE_INFINITY;
        long entity = 0;
        Vector3d local = new Vector3d();
        for (int row = 0; row < snapshot.size(); row++) {
            Model model = modelOf(snapshot.model(row));
            if (model == null || model.texture().opacity() < 1) {
                continue;
            }
            pose(snapshot, row, alpha);
            start.set(eye).sub(place);
            if (misses(start, direction, model.radius())) {
                continue;
            }
            to.conjugate(from);
            from.transform(start);
            from.transform(along.set(direction));
            double distance = hit(model, nearest);
            if (distance < nearest) {
                nearest = distance;
                entity = snapshot.entity(row);
                local.set(along).mul(distance).add(start);
            }
        }
        return nearest == Double.POSITIVE_INFINITY
                ? null
                : new Pick(entity, nearest, local.x, local.y, local.z);
    }

    private static @Nullable Model modelOf(Object look) {
        return switch (look) {
            case Model model -> model;
            case Mesh mesh -> Model.of(mesh);
            case Shape shape -> Model.of(shape);
            default -> null;
        };
    }

    /** As the vertex shader does it: positions mixed, orientations mixed and normalised. */
    private void pose(PoseSnapshot snapshot, int row, double alpha) {
        double[] a = snapshot.previous();
        double[] b = snapshot.current();
        int at = row * PoseSnapshot.STRIDE;
        place.set(
                a[at] + alpha * (b[at] - a[at]),
                a[at + 1] + alpha * (b[at + 1] - a[at + 1]),
                a[at + 2] + alpha * (b[at + 2] - a[at + 2]));
        from.set(a[at + 3], a[at + 4], a[at + 5], a[at + 6]);
        to.set(b[at + 3], b[at + 4], b[at + 5], b[at + 6]);
        from.nlerp(to, alpha, to);
    }

    /** Whether a ray stays outside of a ball around the origin. */
    private static boolean misses(Vector3d rayStart, Vector3d direction, double radius) {
        double ahead = -rayStart.dot(direction);
        double square = rayStart.lengthSquared();
        return square > radius * radius && (ahead < 0 || square - ahead * ahead > radius * radius);
    }

    /** Distance to the nearest triangle of a model, in whose frame start and along are. */
    private double hit(Model model, double limit) {
        Triangles mesh = triangles(model.mesh());
        double ox = (start.x + model.originX()) / model.scaleX();
        double oy = (start.y + model.originY()) / model.scaleY();
        double oz = (start.z + model.originZ()) / model.scaleZ();
        double dx = along.x / model.scaleX();
        double dy = along.y / model.scaleY();
        double dz = along.z / model.scaleZ();
        double best = limit;
        float[] v = mesh.vertices;
        int[] index = mesh.indices;
        for (int i = 0; i < index.length; i += 3) {
            int a = index[i] * Mesh.FLOATS_PER_VERTEX;
            int b = index[i + 1] * Mesh.FLOATS_PER_VERTEX;
            int c = index[i + 2] * Mesh.FLOATS_PER_VERTEX;
            double ux = v[b] - v[a];
            double uy = v[b + 1] - v[a + 1];
            double uz = v[b + 2] - v[a + 2];
            double wx = v[c] - v[a];
            double wy = v[c + 1] - v[a + 1];
            double wz = v[c + 2] - v[a + 2];
            double px = dy * wz - dz * wy;
            double py = dz * wx - dx * wz;
            double pz = dx * wy - dy * wx;
            double determinant = ux * px + uy * py + uz * pz;
            if (determinant <= 0) {
                continue; // seen from behind, or edge on
            }
            double sx = ox - v[a];
            double sy = oy - v[a + 1];
            double sz = oz - v[a + 2];
            double s = sx * px + sy * py + sz * pz;
            double qx = sy * uz - sz * uy;
            double qy = sz * ux - sx * uz;
            double qz = sx * uy - sy * ux;
            double t = dx * qx + dy * qy + dz * qz;
            if (s < 0 || t < 0 || s + t > determinant) {
                continue;
            }
            double distance = (wx * qx + wy * qy + wz * qz) / determinant;
            if (distance > 0 && distance < best) {
                best = distance;
            }
        }
        return best;
    }

    private Triangles triangles(Mesh mesh) {
        Triangles known = meshes.get(mesh);
        if (known == null) {
            if (meshes.size() >= MOST_MESHES) {
                meshes.clear();
            }
            known = new Triangles(mesh);
            meshes.put(mesh, known);
        }
        return known;
    }
}
