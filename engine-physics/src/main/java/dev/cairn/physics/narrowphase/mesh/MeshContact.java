package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.clip.Clipper;
import dev.cairn.physics.narrowphase.clip.CornerOrder;
import dev.cairn.physics.narrowphase.clip.LevelCorner;
import dev.cairn.physics.narrowphase.clip.Overlay;
import dev.cairn.physics.narrowphase.clip.Patch;
import dev.cairn.physics.narrowphase.clip.Reduction;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.mesh.MeshBuilder;
import dev.cairn.physics.shape.mesh.TriangleSet;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * All contacts of a convex shape with a surface of triangles, see the package's essay. One instance
 * per worker: it owns all scratch memory. Allocates only when there are more triangles than ever.
 */
public final class MeshContact {
    /** Of the smaller inner radius: how far a face goes on under what rises beside it. */
    private static final double UNDER = 0.02;

    private final Pair pair = new Pair();
    private final Patch patch = new Patch(), plane = new Patch();
    private final Overlay overlay = new Overlay();
    private final CornerOrder cornerOrder = new CornerOrder();
    private final Reduction reduction = new Reduction();
    private final Manifold result = new Manifold();
    private final TriangleSet.Found found = new TriangleSet.Found();
    private final FaceRegions faces = new FaceRegions();
    private final EdgePoints loose = new EdgePoints();
    private final RimSearch rim;
    private final MeshFrame frame = new MeshFrame();
    private final double[] box = new double[6], corner = new double[9];

    /** The shape: its orientation and centre in the mesh's frame. */
    private double qx, qy, qz, qw, cx, cy, cz;

    private Shape shape = HalfSpace.of();
    private double tolerance;
    private final Margin margin = new Margin();
    private final LevelCorner level = new LevelCorner();

    /** The triangle at hand: its unit normal towards the shape. */
    private double nx, ny, nz;

    /** Whether the centre is inside: the way out is through the triangle above, however far. */
    private boolean isInside;

    /** The deepest point of the contact at hand, m, and the triangle under it. */
    private double deepest;

    private int under;

    /** Of each point of a face the triangle under it. */
    private int[] below = new int[32];

    private TriangleSet set = MeshBuilder.nothing();

    /** Contacts of the last tick. */
    private final LastContacts last = new LastContacts();

    /**
     * Creates the scratch of one worker.
     *
     * @param narrowPhase collides single triangles
     */
    public MeshContact(NarrowPhase narrowPhase) {
        rim = new RimSearch(narrowPhase, faces, loose, margin);
    }

    /**
     * What the next pair's contacts were in the last tick; until the next {@link #collide}.
     *
     * @param normals from surface to shape, three numbers each, world axes
     * @param names as in {@link FeatureIds}, the surface's features as those of A
     */
    public void remember(double[] normals, int[] names, int count) {
        last.set(normals, names, count);
    }

    /**
     * Finds all contacts.
     *
     * @param triangles the surface
     * @param ax orientation of the surface, world from shape, unit quaternion
     * @param convex the other shape
     * @param bx its orientation
     * @param dx its centre minus the origin of the surface, world axes, m
     * @param vx how far it goes, seen from the surface, while points are looked for, world axes, m
     * @param within points up to this far apart are reported, and by so much farther as the shape
     *     comes nearer along their normal, m
     * @param face the same in all directions, of a face of which any point is reported, m
     * @param out receives the contacts, after what it holds
     */
    public void collide(
            TriangleSet triangles,
            double ax,
            double ay,
            double az,
            double aw,
            Shape convex,
            double bx,
            double by,
            double bz,
            double bw,
            double dx,
            double dy,
            double dz,
            double vx,
            double vy,
            double vz,
            double within,
            double face,
            ContactList out) {
        set = triangles;
        shape = frame.set(ax, ay, az, aw, convex, bx, by, bz, bw);
        qx = frame.qx;
        qy = frame.qy;
        qz = frame.qz;
        qw = frame.qw;
        frame.toMesh(vx, vy, vz);
        margin.set(within, frame.x, frame.y, frame.z, face);
        frame.toMesh(dx, dy, dz);
        cx = frame.x;
        cy = frame.y;
        cz = frame.z;
        shape.bounds(qx, qy, qz, qw, box, 0);
        for (int axis = 0; axis < 3; axis++) {
            double c = axis == 0 ? cx : axis == 1 ? cy : cz;
            box[axis] += c;
            box[axis + 3] += c;
        }
        margin.widen(box);
        int cover = set.above(cx, cy, cz);
        isInside = cover >= 0;
        if (isInside) {
            found.only(cover);
        } else {
            set.find(box, found);
        }
        if (found.count > 0) {
            pair.set(shape, shape, qx, qy, qz, qw, qx, qy, qz, qw, 0, 0, 0);
            tolerance = ContactTolerances.ON_PLANE * pair.inner;
            faces.clear();
            rim.begin(set, found);
            rim.place(shape, pair, qx, qy, qz, qw, cx, cy, cz, tolerance);
            for (int i = 0; i < found.count; i++) {
                look(found.triangle[i]);
            }
            for (int i = 0; !isInside && i < faces.count; i++) {
                rim.run(i);
            }
            for (int g = 0; g < faces.groups; g++) {
                face(g, out);
            }
            for (int g = 0; g < loose.groups; g++) {
                edge(g, out);
            }
        }
        last.clear();
    }

    /** What the last turn of axes gave. */
    private double tx, ty, tz;

    // One triangle -------------------------------------------------------------------------------

    /**
     * Its face, if the shape is in front and not too far above, and which of its ridges are calm.
     */
    private void look(int t) {
        set.corners(t, corner);
        for (int c = 0; c < 9; c += 3) {
            corner[c] -= cx;
            corner[c + 1] -= cy;
            corner[c + 2] -= cz;
        }
        double twiceArea = normal();
        // above the plane is the centre
        double height = -(nx * corner[0] + ny * corner[1] + nz * corner[2]);
        double front = 1;
        if (isInside) {
            faces.add(t, 0, 0, 0, corner, nx, ny, nz, twiceArea, 1, tolerance);
            return;
        }
        if (height < 0) {
            if (!set.isTwoSided) {
                return;
            }
            front = -1;
            nx = -nx;
            ny = -ny;
            nz = -nz;
            height = -height;
        }
        if (height - rim.reach(nx, ny, nz) - pair.radiusA > margin.along(nx, ny, nz)) {
            return;
        }
        int edges = set.edges(t);
        int hollow = edges / (front > 0 ? TriangleSet.HOLLOW : TriangleSet.CONVEX);
        int material = set.material(t);
        faces.add(
                t,
                material,
                edges,
                hollow & TriangleSet.ALL,
                corner,
                nx,
                ny,
                nz,
                twiceArea,
                front,
                tolerance);
        rim.look(t, edges, corner, nx, ny, nz, front);
    }

    /** Writes the unit normal; returns twice the area. */
    private double normal() {
        double ux = corner[3] - corner[0];
        double uy = corner[4] - corner[1];
        double uz = corner[5] - corner[2];
        double vx = corner[6] - corner[0];
        double vy = corner[7] - corner[1];
        double vz = corner[8] - corner[2];
        nx = uy * vz - uz * vy;
        ny = uz * vx - ux * vz;
        nz = ux * vy - uy * vx;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        nx /= length;
        ny /= length;
        nz /= length;
        return length;
    }

    /** Into t, from the mesh's axes to the shape's. */
    private void toShape(double x, double y, double z) {
        tx = pair.w00 * x + pair.w10 * y + pair.w20 * z;
        ty = pair.w01 * x + pair.w11 * y + pair.w21 * z;
        tz = pair.w02 * x + pair.w12 * y + pair.w22 * z;
    }

    /** Into t, from the shape's axes to the mesh's. */
    private void fromShape(double x, double y, double z) {
        tx = pair.w00 * x + pair.w01 * y + pair.w02 * z;
        ty = pair.w10 * x + pair.w11 * y + pair.w12 * z;
        tz = pair.w20 * x + pair.w21 * y + pair.w22 * z;
    }

    // One contact --------------------------------------------------------------------------------

    /** The points of the shape over a plane's triangles, and of what stands out of these. */
    private void face(int g, ContactList out) {
        nx = faces.normal(g, 0);
        ny = faces.normal(g, 1);
        nz = faces.normal(g, 2);
        double height = faces.height(g, 0, 0, 0);
        toShape(nx, ny, nz);
        double ux = tx;
        double uy = ty;
        double uz = tz;
        deepest = Double.POSITIVE_INFINITY;
        under = faces.largest(g);
        Clipper c = overlay.out;
        boolean disc = false;
        if (pair.roundA) {
            disc = rounds(c, height, ux, uy, uz);
            keepOver(g, c);
        } else {
            c.count = 0;
            c.addCorners(pair.a, height, ux, uy, uz, margin.ofFace);
            keepOver(g, c);
            if (c.count > 1) {
                keepFlat(c, height, ux, uy, uz);
            }
        }
        noteDeepest(c);
        boolean whole = disc && c.count >= Manifold.POINTS;
        addLoose(g, c);
        finish(c, whole ? Patch.DISC_SHARE : 0, out);
    }

    /** The points of a solid of revolution on a plane; returns whether a disc lies on it. */
    private boolean rounds(Clipper c, double height, double ux, double uy, double uz) {
        patch.fill(pair, false, -ux, -uy, -uz);
        plane.ox = -height * ux;
        plane.oy = -height * uy;
        plane.oz = -height * uz;
        overlay.begin(pair, plane, patch, ux, uy, uz, 0);
        if (!patch.line && patch.flat == Patch.NONE) {
            double reach = pair.radiusA;
            c.add(-reach * ux, -reach * uy, -reach * uz, height - reach, FeatureIds.CLOSEST);
            return false;
        }
        patch.kind = FeatureIds.VERTEX_B;
        patch.nameP |= FeatureIds.VERTEX_B;
        patch.nameQ |= FeatureIds.VERTEX_B;
        if (patch.flat == Patch.DISC && patch.flatter) {
            overlay.discOnPlane();
            return true;
        }
        overlay.restOnPlane();
        return false;
    }

    /** Of a polyhedron's corners those that it stands on, if any is there. */
    private void keepFlat(Clipper c, double height, double ux, double uy, double uz) {
        Polyhedron p = pair.a;
        int face = Axes.faceToward(p, p.support(-ux, -uy, -uz), -ux, -uy, -uz);
        int kind = FeatureIds.VERTEX_B;
        double inner = pair.inner;
        boolean more = level.find(p, face, ux, uy, uz, -height, inner, kind, lastNames());
        int kept = 0;
        for (int i = 0; i < c.count; i++) {
            int v = c.feature[i] & ~FeatureIds.VERTEX_B;
            if (LevelCorner.isCorner(p, face, v) || (more && v == level.vertex)) {
                below[kept] = below[i];
                CornerOrder.move(c, i, kept++);
            }
        }
        c.count = kept > 0 ? kept : c.count;
    }

    private void noteDeepest(Clipper c) {
        for (int i = 0; i < c.count; i++) {
            note(c.separation[i], below[i]);
        }
    }

    /**
     * Turns points into the mesh's axes, and keeps those that are over the triangles of a plane, or
     * will be when they meet it.
     */
    private void keepOver(int g, Clipper c) {
        double room = UNDER * pair.inner;
        double fall = margin.closing(nx, ny, nz);
        double most = margin.ofFace;
        int kept = 0;
        if (below.length < c.count) {
            below = new int[2 * c.count];
        }
        for (int i = 0; i < c.count; i++) {
            double separation = c.separation[i];
            if (separation > most) {
                continue;
            }
            fromShape(c.x[i], c.y[i], c.z[i]);
            double x = tx;
            double y = ty;
            double z = tz;
            int at = isInside ? under : faces.under(g, x, y, z, tolerance, room);
            if (at < 0 && separation > 0 && fall > 0) {
                double time = Math.min(1, separation / fall);
                at =
                        faces.under(
                                g,
                                x + time * margin.driftX,
                                y + time * margin.driftY,
                                z + time * margin.driftZ,
                                tolerance,
                                room);
            }
            if (at >= 0) {
                below[kept] = at;
                c.x[kept] = x;
                c.y[kept] = y;
                c.z[kept] = z;
                c.separation[kept] = separation;
                c.feature[kept++] = c.feature[i];
            }
        }
        c.count = kept;
    }

    /** Of a contact's points the deepest tells its triangle. */
    private void note(double separation, int triangle) {
        if (separation < deepest) {
            deepest = separation;
            under = triangle;
        }
    }

    /** The points of a group; of a plane's those at the rim of its triangles. */
    private void addLoose(int group, Clipper c) {
        for (int i = 0; i < loose.count; i++) {
            if (loose.group[i] == group && (group < 0 || !goesOn(group, i))) {
                note(loose.number[4 * i + 3], loose.triangle[i]);
                c.add(
                        loose.number[4 * i],
                        loose.number[4 * i + 1],
                        loose.number[4 * i + 2],
                        loose.number[4 * i + 3],
                        loose.name[i]);
            }
        }
    }

    private boolean goesOn(int group, int point) {
        double[] p = loose.number;
        int at = 4 * point;
        return faces.goesOn(group, p[at], p[at + 1], p[at + 2], nx, ny, nz, tolerance);
    }

    /** The points along a normal that is no face's. */
    private void edge(int g, ContactList out) {
        nx = loose.normal[3 * g];
        ny = loose.normal[3 * g + 1];
        nz = loose.normal[3 * g + 2];
        Clipper c = overlay.out;
        c.count = 0;
        deepest = Double.POSITIVE_INFINITY;
        addLoose(-1 - g, c);
        finish(c, 0, out);
    }

    /** At most four points, in world axes, midway between the surfaces. */
    private void finish(Clipper c, double share, ContactList out) {
        cornerOrder.sort(c, nx, ny, nz, margin.ofFace);
        if (c.count == 0) {
            return;
        }
        double hysteresis = ContactTolerances.HYSTERESIS * pair.inner;
        reduction.reduce(c, nx, ny, nz, 0.01 * hysteresis, hysteresis, lastNames());
        Manifold m = result;
        m.pointCount = 0;
        m.patch = c.count == Manifold.POINTS ? share : 0;
        for (int i = 0; i < c.count; i++) {
            double half = c.separation[i] / 2;
            frame.toWorld(c.x[i] - half * nx, c.y[i] - half * ny, c.z[i] - half * nz);
            m.insert(c.feature[i], c.separation[i], frame.x, frame.y, frame.z);
        }
        frame.toWorld(nx, ny, nz);
        m.normalX = frame.x;
        m.normalY = frame.y;
        m.normalZ = frame.z;
        out.add(m, set.source(under));
    }

    /** The names of the contact of the last tick whose normal was nearest to this one. */
    private int lastNames() {
        if (last.isEmpty()) {
            return 0;
        }
        frame.toWorld(nx, ny, nz);
        return last.nearest(frame.x, frame.y, frame.z);
    }
}
