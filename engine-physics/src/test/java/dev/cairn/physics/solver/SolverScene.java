package dev.cairn.physics.solver;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import java.util.ArrayList;
import java.util.List;

/**
 * Bodies and contacts filled by hand, so that the solver is tested without any collision code: half
 * spaces, boxes and spheres on them, boxes on boxes' tops, spheres on spheres.
 */
final class SolverScene {
    /** The defaults, with all rows in double precision. */
    static final Tuning DOUBLES = Tuning.DEFAULT.with(Tunable.FLOATS_FROM, Integer.MAX_VALUE);

    static final double TICK = 1.0 / 60;

    interface Pair {
        void collide(ContactStore c, int row);
    }

    final BodyStore bodies = new BodyStore();
    final ContactStore contacts = new ContactStore();
    final List<Pair> pairs = new ArrayList<>();
    final List<double[]> half = new ArrayList<>();
    final ContactSolver solver;
    final Jobs jobs;
    double gx = 0;
    double gy = -9.81;
    double gz = 0;
    double margin = 0.5;

    SolverScene(Tuning settings, Jobs jobs) {
        this(new ContactSolver(settings), jobs);
    }

    SolverScene(ContactSolver solver, Jobs jobs) {
        bodies.curved = true; // contacts here have no shapes that would tell
        this.solver = solver;
        this.jobs = jobs;
    }

    SolverScene() {
        this(SolverScene.DOUBLES, Jobs.of(1));
    }

    int body(double mass, double ixx, double iyy, double izz) {
        int i = bodies.slotCount++;
        bodies.ensureCapacity(bodies.slotCount);
        bodies.kind[i] = mass > 0 ? BodyStore.DYNAMIC : BodyStore.STATIC;
        bodies.orientationW[i] = 1;
        if (mass > 0) {
            bodies.inverseMass[i] = 1 / mass;
            bodies.inertiaXX[i] = ixx;
            bodies.inertiaYY[i] = iyy;
            bodies.inertiaZZ[i] = izz;
            bodies.inverseInertiaXX[i] = 1 / ixx;
            bodies.inverseInertiaYY[i] = 1 / iyy;
            bodies.inverseInertiaZZ[i] = 1 / izz;
        }
        half.add(new double[3]);
        return i;
    }

    int fixed() {
        return body(0, 0, 0, 0);
    }

    int box(double mass, double hx, double hy, double hz, double x, double y, double z) {
        double k = mass / 3;
        int i =
                body(
                        mass,
                        k * (hy * hy + hz * hz),
                        k * (hx * hx + hz * hz),
                        k * (hx * hx + hy * hy));
        half.set(i, new double[] {hx, hy, hz});
        return at(i, x, y, z);
    }

    int sphere(double mass, double radius, double x, double y, double z) {
        double k = 0.4 * mass * radius * radius;
        int i = body(mass, k, k, k);
        half.set(i, new double[] {radius, radius, radius});
        return at(i, x, y, z);
    }

    int at(int i, double x, double y, double z) {
        bodies.positionX[i] = x;
        bodies.positionY[i] = y;
        bodies.positionZ[i] = z;
        return i;
    }

    void velocity(int i, double x, double y, double z) {
        bodies.velocityX[i] = x;
        bodies.velocityY[i] = y;
        bodies.velocityZ[i] = z;
    }

    void spin(int i, double x, double y, double z) {
        bodies.angularVelocityX[i] = x;
        bodies.angularVelocityY[i] = y;
        bodies.angularVelocityZ[i] = z;
    }

    void orient(int i, double ax, double ay, double az, double angle) {
        double n = Math.sqrt(ax * ax + ay * ay + az * az);
        double s = StrictMath.sin(angle / 2) / n;
        bodies.orientationX[i] = ax * s;
        bodies.orientationY[i] = ay * s;
        bodies.orientationZ[i] = az * s;
        bodies.orientationW[i] = StrictMath.cos(angle / 2);
    }

    void material(int row, double friction, double restitution) {
        contacts.ensureCapacity(pairs.size());
        contacts.setFriction(row, friction);
        contacts.restitution[row] = restitution;
    }

    private int add(Pair pair, int a, int b, double friction, double restitution) {
        pairs.add(pair);
        int row = pairs.size() - 1;
        material(row, friction, restitution);
        contacts.bodyA[row] = a;
        contacts.bodyB[row] = b;
        contacts.count = pairs.size();
        contacts.activateAll();
        return row;
    }

    /**
     * The half space n.x <= offset of static body {@code plane}, under box {@code i}: its lowest
     * four corners.
     */
    int boxOnPlane(
            int plane,
            int i,
            double nx,
            double ny,
            double nz,
            double offset,
            double friction,
            double e) {
        return add(
                (c, row) -> {
                    double[] r = rotation(i);
                    double[] h = half.get(i);
                    double[] corner = new double[24];
                    double[] s = new double[8];
                    for (int k = 0; k < 8; k++) {
                        double lx = (k & 1) == 0 ? -h[0] : h[0];
                        double ly = (k & 2) == 0 ? -h[1] : h[1];
                        double lz = (k & 4) == 0 ? -h[2] : h[2];
                        for (int j = 0; j < 3; j++) {
                            corner[3 * k + j] =
                                    r[3 * j] * lx + r[3 * j + 1] * ly + r[3 * j + 2] * lz;
                        }
                        s[k] =
                                nx * (corner[3 * k] + bodies.positionX[i])
                                        + ny * (corner[3 * k + 1] + bodies.positionY[i])
                                        + nz * (corner[3 * k + 2] + bodies.positionZ[i])
                                        - offset;
                    }
                    // the face most against the normal
                    int axis = 0;
                    double best = -1;
                    double sign = 1;
                    for (int j = 0; j < 3; j++) {
                        double d = nx * r[j] + ny * r[3 + j] + nz * r[6 + j];
                        if (Math.abs(d) > best) {
                            best = Math.abs(d);
                            axis = j;
                            sign = d;
                        }
                    }
                    start(c, row, nx, ny, nz);
                    for (int k = 0; k < 8; k++) {
                        boolean low = ((k >> axis & 1) == 0) == (sign > 0);
                        if (low && s[k] < margin) {
                            double m = 0.5 * s[k];
                            point(
                                    c,
                                    row,
                                    k,
                                    corner[3 * k] + bodies.positionX[i] - m * nx,
                                    corner[3 * k + 1] + bodies.positionY[i] - m * ny,
                                    corner[3 * k + 2] + bodies.positionZ[i] - m * nz,
                                    s[k]);
                        }
                    }
                },
                plane,
                i,
                friction,
                e);
    }

    int sphereOnPlane(
            int plane,
            int i,
            double nx,
            double ny,
            double nz,
            double offset,
            double friction,
            double e) {
        return add(
                (c, row) -> {
                    double s =
                            nx * bodies.positionX[i]
                                    + ny * bodies.positionY[i]
                                    + nz * bodies.positionZ[i]
                                    - offset
                                    - half.get(i)[0];
                    start(c, row, nx, ny, nz);
                    if (s < margin) {
                        double m = half.get(i)[0] + 0.5 * s;
                        point(
                                c,
                                row,
                                0,
                                bodies.positionX[i] - m * nx,
                                bodies.positionY[i] - m * ny,
                                bodies.positionZ[i] - m * nz,
                                s);
                    }
                },
                plane,
                i,
                friction,
                e);
    }

    int sphereOnSphere(int a, int b, double friction, double e) {
        return add(
                (c, row) -> {
                    double dx = bodies.positionX[b] - bodies.positionX[a];
                    double dy = bodies.positionY[b] - bodies.positionY[a];
                    double dz = bodies.positionZ[b] - bodies.positionZ[a];
                    double d = Math.sqrt(dx * dx + dy * dy + dz * dz);
                    start(c, row, dx / d, dy / d, dz / d);
                    double s = d - half.get(a)[0] - half.get(b)[0];
                    if (s < margin) {
                        double k = (half.get(a)[0] + 0.5 * s) / d;
                        point(
                                c,
                                row,
                                0,
                                bodies.positionX[a] + k * dx,
                                bodies.positionY[a] + k * dy,
                                bodies.positionZ[a] + k * dz,
                                s);
                    }
                },
                a,
                b,
                friction,
                e);
    }

    /** Box b on the top face of box a; both nearly upright. */
    int boxOnBox(int a, int b, double friction, double e) {
        return add(
                (c, row) -> {
                    double[] ra = rotation(a);
                    double[] rb = rotation(b);
                    double[] ha = half.get(a);
                    double[] hb = half.get(b);
                    double nx = ra[1];
                    double ny = ra[4];
                    double nz = ra[7];
                    start(c, row, nx, ny, nz);
                    for (int k = 0; k < 4; k++) {
                        double lx = (k & 1) == 0 ? -hb[0] : hb[0];
                        double ly = -hb[1];
                        double lz = (k & 2) == 0 ? -hb[2] : hb[2];
                        double[] p = new double[3];
                        p[0] =
                                bodies.positionX[b]
                                        - bodies.positionX[a]
                                        + rb[0] * lx
                                        + rb[1] * ly
                                        + rb[2] * lz;
                        p[1] =
                                bodies.positionY[b]
                                        - bodies.positionY[a]
                                        + rb[3] * lx
                                        + rb[4] * ly
                                        + rb[5] * lz;
                        p[2] =
                                bodies.positionZ[b]
                                        - bodies.positionZ[a]
                                        + rb[6] * lx
                                        + rb[7] * ly
                                        + rb[8] * lz;
                        double u = clamp(ra[0] * p[0] + ra[3] * p[1] + ra[6] * p[2], ha[0]);
                        double w = clamp(ra[2] * p[0] + ra[5] * p[1] + ra[8] * p[2], ha[2]);
                        // the point of b's bottom face at (u, w) of a's frame, along a's normal
                        double bx = ra[0] * u + ra[2] * w;
                        double by = ra[3] * u + ra[5] * w;
                        double bz = ra[6] * u + ra[8] * w;
                        double fx = rb[1];
                        double fy = rb[4];
                        double fz = rb[7];
                        double t =
                                (fx * (p[0] - bx) + fy * (p[1] - by) + fz * (p[2] - bz))
                                        / (fx * nx + fy * ny + fz * nz);
                        double s = t - ha[1];
                        if (s < margin) {
                            double m = ha[1] + 0.5 * s;
                            point(
                                    c,
                                    row,
                                    k,
                                    bodies.positionX[a] + bx + m * nx,
                                    bodies.positionY[a] + by + m * ny,
                                    bodies.positionZ[a] + bz + m * nz,
                                    s);
                        }
                    }
                },
                a,
                b,
                friction,
                e);
    }

    private static double clamp(double x, double bound) {
        return Math.max(-bound, Math.min(bound, x));
    }

    private final double[] oldImpulse = new double[8];
    private final double[] oldPreload = new double[8];

    private void start(ContactStore c, int row, double nx, double ny, double nz) {
        java.util.Arrays.fill(oldImpulse, 0);
        java.util.Arrays.fill(oldPreload, 0);
        for (int k = 0; k < c.pointCount[row]; k++) {
            oldImpulse[c.feature[4 * row + k]] = c.normalImpulse[4 * row + k];
            oldPreload[c.feature[4 * row + k]] = c.preload[4 * row + k];
        }
        c.pointCount[row] = 0;
        c.setNormal(row, nx, ny, nz);
    }

    private void point(
            ContactStore c, int row, int feature, double x, double y, double z, double s) {
        int p = 4 * row + c.pointCount[row]++;
        int a = c.bodyA[row];
        int b = c.bodyB[row];
        c.setAnchors(
                p,
                x - bodies.positionX[a],
                y - bodies.positionY[a],
                z - bodies.positionZ[a],
                x - bodies.positionX[b],
                y - bodies.positionY[b],
                z - bodies.positionZ[b]);
        c.separation[p] = s;
        c.feature[p] = feature;
        c.normalImpulse[p] = oldImpulse[feature];
        c.preload[p] = oldPreload[feature];
    }

    /** Row-major rotation matrix worldFromBody. */
    double[] rotation(int i) {
        double x = bodies.orientationX[i];
        double y = bodies.orientationY[i];
        double z = bodies.orientationZ[i];
        double w = bodies.orientationW[i];
        return new double[] {
            1 - 2 * (y * y + z * z),
            2 * (x * y - w * z),
            2 * (x * z + w * y),
            2 * (x * y + w * z),
            1 - 2 * (x * x + z * z),
            2 * (y * z - w * x),
            2 * (x * z - w * y),
            2 * (y * z + w * x),
            1 - 2 * (x * x + y * y)
        };
    }

    void collide() {
        for (int c = 0; c < pairs.size(); c++) {
            pairs.get(c).collide(contacts, c);
        }
    }

    void tick(double dt) {
        collide();
        solver.step(bodies, contacts, gx, gy, gz, dt, jobs);
    }

    void run(double seconds) {
        long n = Math.round(seconds / TICK);
        for (long k = 0; k < n; k++) {
            tick(TICK);
        }
    }

    double deepest() {
        collide();
        double d = 0;
        for (int c = 0; c < contacts.count; c++) {
            for (int k = 0; k < contacts.pointCount[c]; k++) {
                d = Math.max(d, -contacts.separation[4 * c + k]);
            }
        }
        return d;
    }

    /** World angular momentum about the body's own centre. */
    double[] spinMomentum(int i) {
        double[] r = rotation(i);
        double[] w = {
            bodies.angularVelocityX[i], bodies.angularVelocityY[i], bodies.angularVelocityZ[i]
        };
        double[] l = new double[3];
        for (int k = 0; k < 3; k++) {
            l[k] = r[k] * w[0] + r[3 + k] * w[1] + r[6 + k] * w[2];
        }
        double[] m = {
            bodies.inertiaXX[i] * l[0] + bodies.inertiaXY[i] * l[1] + bodies.inertiaXZ[i] * l[2],
            bodies.inertiaXY[i] * l[0] + bodies.inertiaYY[i] * l[1] + bodies.inertiaYZ[i] * l[2],
            bodies.inertiaXZ[i] * l[0] + bodies.inertiaYZ[i] * l[1] + bodies.inertiaZZ[i] * l[2]
        };
        return new double[] {
            r[0] * m[0] + r[1] * m[1] + r[2] * m[2],
            r[3] * m[0] + r[4] * m[1] + r[5] * m[2],
            r[6] * m[0] + r[7] * m[1] + r[8] * m[2]
        };
    }

    double kinetic(int i) {
        double[] l = spinMomentum(i);
        double v2 =
                bodies.velocityX[i] * bodies.velocityX[i]
                        + bodies.velocityY[i] * bodies.velocityY[i]
                        + bodies.velocityZ[i] * bodies.velocityZ[i];
        return 0.5
                * (v2 / bodies.inverseMass[i]
                        + l[0] * bodies.angularVelocityX[i]
                        + l[1] * bodies.angularVelocityY[i]
                        + l[2] * bodies.angularVelocityZ[i]);
    }

    double energy() {
        double e = 0;
        for (int i = 0; i < bodies.slotCount; i++) {
            if (bodies.kind[i] == BodyStore.DYNAMIC) {
                e +=
                        kinetic(i)
                                - (gx * bodies.positionX[i]
                                                + gy * bodies.positionY[i]
                                                + gz * bodies.positionZ[i])
                                        / bodies.inverseMass[i];
            }
        }
        return e;
    }
}
