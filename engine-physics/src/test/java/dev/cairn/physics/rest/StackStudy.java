package dev.cairn.physics.rest;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * The scenes behind the tables of {@code docs/notebook/stacks.md}, each seeded with jitter, so that
 * nothing stands by symmetry. {@link StackTables} prints them.
 */
final class StackStudy implements AutoCloseable {
    static final double TICK = 1.0 / 60;

    static long seed = 777;

    final PhysicsWorld world;
    final List<BodyRef> bodies = new ArrayList<>();
    private final List<Vector3d> start = new ArrayList<>();
    private final Random random = new Random(seed);
    private final Vector3d p = new Vector3d();
    private final Vector3d q = new Vector3d();
    private final double jitter;
    BodyRef ground;
    double speed;
    double nanos;
    double ticks;
    double contactTicks;

    StackStudy(PhysicsSettings settings, double jitter, double gx, double gy) {
        world =
                PhysicsWorld.builder()
                        .gravity(gx, gy, 0)
                        .workers(1)
                        .settings(settings.withSleeping(false))
                        .build();
        this.jitter = jitter;
    }

    static StackStudy onGround(PhysicsSettings settings) {
        StackStudy s = new StackStudy(settings, 1e-3, 0, -9.81);
        s.ground(0.6);
        return s;
    }

    static Material rough(double mu, double e) {
        return new Material(mu, e, 1000);
    }

    void ground(double mu) {
        ground =
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(400, 1, 400))
                                .at(0, -1, 0)
                                .material(rough(mu, 0)));
    }

    private double jit() {
        return jitter * (2 * random.nextDouble() - 1);
    }

    BodyRef box(double h, double mass, double x, double y, double z, double mu) {
        BodyRef b =
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(h))
                                .mass(mass)
                                .at(x, y, z)
                                .material(rough(mu, 0)));
        bodies.add(b);
        start.add(b.position(new Vector3d()));
        return b;
    }

    BodyRef jittered(double mass, double x, double y, double z) {
        BodyRef b =
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(0.5))
                                .mass(mass)
                                .at(x + jit(), y, z + jit())
                                .rotationAbout(0, 1, 0, 10 * jit())
                                .material(rough(0.6, 0)));
        bodies.add(b);
        start.add(b.position(new Vector3d()));
        return b;
    }

    static StackStudy stack(PhysicsSettings settings, double... masses) {
        StackStudy s = onGround(settings);
        for (int i = 0; i < masses.length; i++) {
            s.jittered(masses[i], 0, i + 0.5, 0);
        }
        return s;
    }

    static double[] equal(int n, double mass) {
        double[] m = new double[n];
        java.util.Arrays.fill(m, mass);
        return m;
    }

    static double[] alternating(int n, double ratio) {
        double[] m = equal(n, 1);
        for (int i = 1; i < n; i += 2) {
            m[i] = ratio;
        }
        return m;
    }

    static double[] top(int n, double ratio) {
        double[] m = equal(n, 1);
        m[n - 1] = ratio;
        return m;
    }

    static StackStudy pyramid(PhysicsSettings settings, int base) {
        StackStudy s = new StackStudy(settings, 0, 0, -9.81);
        s.ground(0.6);
        for (int i = 0; i < base; i++) {
            for (int j = i; j < base; j++) {
                s.box(0.5, 100, 0.5 + 0.5 * i + (j - i) - base / 2.0, i + 0.5, 0, 0.6);
            }
        }
        return s;
    }

    void tick() {
        long t = System.nanoTime();
        world.step(TICK);
        nanos += System.nanoTime() - t;
        ticks++;
        contactTicks += world.contacts().count();
    }

    void run(double seconds) {
        for (long n = Math.round(seconds / TICK); n > 0; n--) {
            tick();
        }
    }

    double overlap() {
        double d = 0;
        Contacts c = world.contacts();
        for (int i = 0; i < c.count(); i++) {
            for (int k = 0; k < c.pointCount(i); k++) {
                d = Math.max(d, -c.separation(i, k));
            }
        }
        return d;
    }

    double drift() {
        double d = 0;
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).position(p).sub(start.get(i));
            d = Math.max(d, Math.hypot(p.x, p.z));
        }
        return d;
    }

    double sag() {
        double d = -1;
        for (int i = 0; i < bodies.size(); i++) {
            d = Math.max(d, start.get(i).y - bodies.get(i).position(p).y);
        }
        return d;
    }

    double fastest() {
        double d = 0;
        for (BodyRef b : bodies) {
            d = Math.max(d, b.velocity(q).length());
        }
        return d;
    }

    /** Penetration, sag, drift in mm, rest speed in mm/s over the last two seconds. */
    String rest(double seconds) {
        run(seconds - 2);
        double v = 0;
        for (int i = 0; i < 120; i++) {
            tick();
            v = Math.max(v, fastest());
        }
        speed = v;
        boolean fell = sag() > 0.3 || drift() > 0.4;
        return String.format(
                Locale.ROOT,
                "%s pen %.4f sag %.3f drift %.3f speed %.1e ns %.0f",
                fell ? "FELL" : "ok",
                1e3 * overlap(),
                1e3 * sag(),
                1e3 * drift(),
                1e3 * v,
                nanos / contactTicks);
    }

    /** What follows the removal of a load: metres and m/s. */
    record Unloaded(double pen, double up, double gap, double drift) {
        @Override
        public String toString() {
            return String.format(
                    Locale.ROOT,
                    "pen %.4f up %.2f mm/s gap %.4f drift %.2f",
                    1e3 * pen,
                    1e3 * up,
                    1e3 * gap,
                    1e3 * drift);
        }
    }

    static Unloaded unloaded(PhysicsSettings settings, int n, double ratio) {
        try (StackStudy s = onGround(settings)) {
            for (int i = 0; i < n; i++) {
                s.jittered(1, 0, i + 0.5, 0);
            }
            BodyRef load =
                    s.world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .mass(ratio)
                                    .at(0, n + 0.5, 0)
                                    .material(rough(0.6, 0)));
            s.run(10);
            double pen = s.overlap();
            load.remove();
            double up = 0;
            double gap = 0;
            Vector3d v = new Vector3d();
            Vector3d below = new Vector3d();
            for (int t = 0; t < 300; t++) {
                s.tick();
                double last = -0.5;
                for (BodyRef b : s.bodies) {
                    up = Math.max(up, b.velocity(v).y);
                    b.position(below);
                    gap = Math.max(gap, below.y - last - 1);
                    last = below.y;
                }
            }
            return new Unloaded(pen, up, gap, s.drift());
        }
    }

    static double hitMomentum(PhysicsSettings settings, double mass) {
        try (StackStudy s = stack(settings, equal(10, 1000))) {
            s.run(1);
            s.world.add(
                    Body.dynamic()
                            .shape(Box.cubeOfHalfExtent(0.5))
                            .mass(mass)
                            .at(-1.2, 5.2, 0.1)
                            .velocity(8, 0, 0)
                            .material(rough(0.6, 0)));
            s.run(0.225);
            double px = 0;
            Vector3d v = new Vector3d();
            for (BodyRef b : s.bodies) {
                px += 1000 * b.velocity(v).x;
            }
            return px / (8 * mass);
        }
    }

    static double kickDistance(PhysicsSettings settings) {
        try (StackStudy s = stack(settings, equal(5, 1000))) {
            s.run(1);
            s.bodies.get(0).setVelocity(4, 0, 0);
            s.run(2);
            Vector3d a = s.bodies.get(0).position(new Vector3d());
            return a.x;
        }
    }

    /** Deepest overlap of a stack that falls, m. */
    static double landing(PhysicsSettings settings, int n, double height) {
        try (StackStudy s = onGround(settings)) {
            for (int i = 0; i < n; i++) {
                s.jittered(1000, 0, i + 0.5 + height, 0);
            }
            double peak = 0;
            for (int t = 0; t < 120; t++) {
                s.tick();
                peak = Math.max(peak, s.overlap());
            }
            return peak;
        }
    }

    static String drop(PhysicsSettings settings, int n, double height) {
        try (StackStudy s = onGround(settings)) {
            for (int i = 0; i < n; i++) {
                s.jittered(1000, 0, i + 0.5 + height, 0);
            }
            double peak = 0;
            for (int t = 0; t < 600; t++) {
                s.tick();
                peak = Math.max(peak, s.overlap());
            }
            return String.format(
                    Locale.ROOT,
                    "peak %.3f pen %.4f drift %.2f speed %.1e",
                    1e3 * peak,
                    1e3 * s.overlap(),
                    1e3 * s.drift(),
                    1e3 * s.fastest());
        }
    }

    static String incline(PhysicsSettings settings, double mu, double seconds) {
        double a = Math.toRadians(20);
        try (StackStudy s =
                new StackStudy(settings, 0, 9.81 * StrictMath.sin(a), -9.81 * StrictMath.cos(a))) {
            s.ground(mu);
            BodyRef b = s.box(0.5, 1000, 0, 0.5, 0, mu);
            s.run(seconds);
            double x = b.position(new Vector3d()).x;
            double acc = 9.81 * (StrictMath.sin(a) - mu * StrictMath.cos(a));
            return acc > 0
                    ? String.format(
                            Locale.ROOT, "error %.2e", x / (0.5 * acc * seconds * seconds) - 1)
                    : String.format(Locale.ROOT, "moved %.5f mm", 1e3 * x);
        }
    }

    static String hitTop(PhysicsSettings settings, double ratio) {
        try (StackStudy s = stack(settings, top(10, ratio))) {
            s.run(1);
            s.world.add(
                    Body.dynamic()
                            .shape(Box.cubeOfHalfExtent(0.2))
                            .mass(1)
                            .at(-0.75, 5.2, 0.1)
                            .velocity(3, 0, 0)
                            .material(rough(0.6, 0)));
            return s.rest(9);
        }
    }

    static StackStudy heavyDropped(PhysicsSettings settings) {
        StackStudy s = onGround(settings);
        for (int i = 0; i < 5; i++) {
            s.jittered(1, 0, i + 0.5, 0);
        }
        s.jittered(100, 0, 5.6, 0);
        s.start.get(5).y -= 0.1;
        return s;
    }

    /** 256 boxes poured into a shaft: overlap and kinetic energy of the last two seconds. */
    static String pile(PhysicsSettings settings, double seconds) {
        try (StackStudy s = new StackStudy(settings, 1e-3, 0, -9.81)) {
            s.ground(0.6);
            for (int sign = -1; sign <= 1; sign += 2) {
                s.world.add(Body.fixed().shape(Box.ofHalfExtents(1, 20, 4)).at(sign * 3.5, 20, 0));
                s.world.add(
                        Body.fixed().shape(Box.ofHalfExtents(2.5, 20, 1)).at(0, 20, sign * 3.5));
            }
            Random r = new Random(99 + seed);
            for (int i = 0; i < 256; i++) {
                double a = 0.2 + 0.2 * r.nextDouble();
                double b = 0.2 + 0.2 * r.nextDouble();
                double c = 0.2 + 0.2 * r.nextDouble();
                s.bodies.add(
                        s.world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(a, b, c))
                                        .at(
                                                (i % 4 - 1.5) * 1.2,
                                                0.8 + i / 16 * 1.2,
                                                (i / 4 % 4 - 1.5) * 1.2)
                                        .rotationAbout(
                                                r.nextDouble() - 0.5,
                                                r.nextDouble() - 0.5,
                                                r.nextDouble() - 0.5 + 1e-3,
                                                6.28 * r.nextDouble())
                                        .material(rough(0.6, 0))));
            }
            s.run(seconds - 2);
            double energy = 0;
            for (int t = 0; t < 120; t++) {
                s.tick();
                energy += s.world.kinetics().kineticEnergy() / 120;
            }
            double sum = 0;
            int n = 0;
            Contacts c = s.world.contacts();
            for (int i = 0; i < c.count(); i++) {
                double d = 0;
                for (int k = 0; k < c.pointCount(i); k++) {
                    d = Math.max(d, -c.separation(i, k));
                }
                if (d > 0) {
                    sum += d;
                    n++;
                }
            }
            return String.format(
                    Locale.ROOT,
                    "pen mean %.3f max %.2f KE %.2e ns %.0f",
                    1e3 * sum / n,
                    1e3 * s.overlap(),
                    energy,
                    s.nanos / s.contactTicks);
        }
    }

    /** Nine cubes leaning 4 cm past tipping: x of the seventh. */
    static String lean(PhysicsSettings settings) {
        try (StackStudy s = onGround(settings)) {
            for (int i = 0; i < 9; i++) {
                s.box(0.5, 1000, 0.135 * i, i + 0.5, 0, 0.6);
            }
            s.run(2.5);
            return String.format(
                    Locale.ROOT, "x of the 7th %.3f", s.bodies.get(6).position(new Vector3d()).x);
        }
    }

    /** Best time of a tick in a pyramid, with and without a part, in turns. */
    static String cost(PhysicsSettings with, PhysicsSettings without, int base) {
        try (StackStudy a = pyramid(with, base);
                StackStudy b = pyramid(without, base)) {
            a.run(2);
            b.run(2);
            double bestA = Double.MAX_VALUE;
            double bestB = Double.MAX_VALUE;
            for (int k = 0; k < 400; k++) {
                a.nanos = 0;
                a.tick();
                bestA = Math.min(bestA, a.nanos);
                b.nanos = 0;
                b.tick();
                bestB = Math.min(bestB, b.nanos);
            }
            int n = a.world.contacts().count();
            return String.format(
                    Locale.ROOT,
                    "%d contacts, ns per contact and tick: %.0f with, %.0f without, %+.1f %%",
                    n,
                    bestA / n,
                    bestB / n,
                    100 * (bestA / bestB - 1));
        }
    }

    @Override
    public void close() {
        world.close();
    }
}
