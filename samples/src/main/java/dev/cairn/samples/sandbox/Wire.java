package dev.cairn.samples.sandbox;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/** The edges of a body's shapes in its own frame, six numbers to a line: two ends, m. */
final class Wire {
    private static final int SIDES = 16;

    private final List<double[]> lines = new ArrayList<>();
    private final Vector3d a = new Vector3d();
    private final Vector3d b = new Vector3d();

    private Wire() {}

    /** Returns what is drawn of a body; nothing of grounds and meshes. */
    static double[] of(BodyRef body) {
        Wire wire = new Wire();
        for (ColliderRef collider : body.colliders()) {
            wire.add(collider.description().placed(), new Vector3d(), new Quaterniond());
        }
        double[] all = new double[6 * wire.lines.size()];
        for (int i = 0; i < wire.lines.size(); i++) {
            System.arraycopy(wire.lines.get(i), 0, all, 6 * i, 6);
        }
        return all;
    }

    private void add(Shape shape, Vector3d at, Quaterniond turn) {
        switch (shape) {
            case Box box -> box(box, at, turn);
            case Sphere ball -> {
                for (int axis = 0; axis < 3; axis++) {
                    ring(axis, 0, ball.radius(), at, turn);
                }
            }
            case Capsule c -> {
                tube(c.radius(), c.radius(), c.halfLength(), at, turn);
                for (int end = -1; end <= 1; end += 2) {
                    for (int axis = 0; axis < 3; axis += 2) {
                        Vector3d top = turn.transform(new Vector3d(0, end * c.halfLength(), 0));
                        ring(axis, 0, c.radius(), top.add(at), turn);
                    }
                }
            }
            case Cylinder c -> tube(c.radius(), c.radius(), c.halfHeight(), at, turn);
            case Cone c -> tube(c.radius(), 0, c.halfHeight(), at, turn);
            case ConvexHull hull -> {
                double[] v = hull.vertices();
                for (int[] loop : hull.faceLoops()) {
                    for (int k = 0; k < loop.length; k++) {
                        int from = loop[k];
                        int to = loop[(k + 1) % loop.length];
                        if (from < to) { // the face on the other side has it the other way round
                            a.set(v[3 * from], v[3 * from + 1], v[3 * from + 2]);
                            b.set(v[3 * to], v[3 * to + 1], v[3 * to + 2]);
                            line(at, turn);
                        }
                    }
                }
            }
            case Moved moved -> {
                Vector3d inner = turn.transform(moved.position(new Vector3d())).add(at);
                Quaterniond inside = turn.mul(moved.rotation(new Quaterniond()), new Quaterniond());
                add(moved.inner(), inner, inside);
            }
            default -> {
                // Grounds and levels stay where they are in every future.
            }
        }
    }

    private void box(Box box, Vector3d at, Quaterniond turn) {
        for (int corner = 0; corner < 8; corner++) {
            for (int bit = 1; bit < 8; bit <<= 1) {
                if ((corner & bit) == 0) {
                    corner(box, corner, a);
                    corner(box, corner | bit, b);
                    line(at, turn);
                }
            }
        }
    }

    private static void corner(Box box, int i, Vector3d to) {
        to.set(
                (i & 1) == 0 ? -box.halfX() : box.halfX(),
                (i & 2) == 0 ? -box.halfY() : box.halfY(),
                (i & 4) == 0 ? -box.halfZ() : box.halfZ());
    }

    private void tube(double lower, double upper, double half, Vector3d at, Quaterniond turn) {
        ring(1, -half, lower, at, turn);
        if (upper > 0) {
            ring(1, half, upper, at, turn);
        }
        for (int side = 0; side < 4; side++) {
            double x = side < 2 ? 1 - 2 * side : 0;
            double z = side < 2 ? 0 : 5 - 2 * side;
            a.set(lower * x, -half, lower * z);
            b.set(upper * x, half, upper * z);
            line(at, turn);
        }
    }

    /** A circle about an axis, so far along it. */
    private void ring(int axis, double along, double radius, Vector3d at, Quaterniond turn) {
        for (int i = 0; i < SIDES; i++) {
            onRing(axis, along, radius, i, a);
            onRing(axis, along, radius, i + 1, b);
            line(at, turn);
        }
    }

    private static void onRing(int axis, double along, double radius, int step, Vector3d to) {
        double angle = 2 * Math.PI * step / SIDES;
        double u = radius * Math.cos(angle);
        double v = radius * Math.sin(angle);
        if (axis == 0) {
            to.set(along, u, v);
        } else if (axis == 1) {
            to.set(v, along, u);
        } else {
            to.set(u, v, along);
        }
    }

    private void line(Vector3d at, Quaterniond turn) {
        turn.transform(a).add(at);
        turn.transform(b).add(at);
        lines.add(new double[] {a.x, a.y, a.z, b.x, b.y, b.z});
    }
}
