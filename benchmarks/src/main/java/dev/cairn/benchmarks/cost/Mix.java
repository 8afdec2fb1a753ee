package dev.cairn.benchmarks.cost;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import java.util.List;
import java.util.SplittableRandom;

/**
 * A scene made of so many parts of each kind, each part on a square of its own: bodies that fly,
 * bodies that rest, pairs that fly side by side, balls that bounce, boxes that stand around.
 *
 * @param flyingSpheres spheres that touch nothing
 * @param flyingBoxes boxes with three different moments of inertia, spinning, that touch nothing
 * @param nearPairs two spheres each that fly a little apart: a pair without a contact point
 * @param restingSpheres on a plate: a pair with one point
 * @param restingCubes on a plate: a pair with four points
 * @param edgeCubes balanced on an edge: a pair with two points
 * @param columns of three cubes
 * @param bouncing elastic balls above a plate: events
 * @param fixed boxes far from everything
 * @param friction Coulomb coefficient of all, 0 for none
 * @param bounceHeight 1 for bounces of 0.06 to 0.6 s; higher ones are rarer
 * @param rollingArm of all, m, 0 for none
 * @param restitution of all but the balls that bounce
 * @param filtered whether each has a filter, which lets it meet all others
 * @param rods pairs that a rod holds, the first of those that fly side by side
 */
record Mix(
        int flyingSpheres,
        int flyingBoxes,
        int nearPairs,
        int restingSpheres,
        int restingCubes,
        int edgeCubes,
        int columns,
        int bouncing,
        int fixed,
        double friction,
        double bounceHeight,
        double rollingArm,
        double restitution,
        boolean filtered,
        int rods) {
    /** From so many contacts on the solver may take its wide kernels. */
    private static final int WIDE_FROM = 256;

    /** What is counted, in the order of the table. */
    static final List<String> NAMES =
            List.of(
                    "a tick of a world",
                    "body with one moment of inertia (sphere, cube)",
                    "body with three moments",
                    "fixed body, touched by nothing",
                    "pair of neighbours, no point",
                    "touching pair, sphere and box",
                    "touching pair, box and box",
                    "contact point",
                    "friction at a point",
                    "event (touch begins or ends)");

    private static final Filter MEETS_ALL = new Filter(2, -1);
    private static final double STEP = 1.0 / 60;
    private static final double PITCH = 3;
    private static final int SETTLING = 20;
    private static final int TICKS = 40;

    /** A measured scene: CPU µs of a tick, and how many there were of each of {@link #NAMES}. */
    @SuppressWarnings("ArrayRecordComponent") // read, never compared
    record Sample(double micros, double[] counts) {}

    /** The same with bounces of 0.06 to 0.6 s, without rolling friction. */
    Mix(
            int flyingSpheres,
            int flyingBoxes,
            int nearPairs,
            int restingSpheres,
            int restingCubes,
            int edgeCubes,
            int columns,
            int bouncing,
            int fixed,
            double friction) {
        this(
                flyingSpheres,
                flyingBoxes,
                nearPairs,
                restingSpheres,
                restingCubes,
                edgeCubes,
                columns,
                bouncing,
                fixed,
                friction,
                1,
                0,
                0,
                false,
                0);
    }

    /** The same with rolling friction. */
    Mix withRollingArm(double metres) {
        return with(metres, restitution, filtered, rods);
    }

    /** The same with another restitution. */
    Mix withRestitution(double ratio) {
        return with(rollingArm, ratio, filtered, rods);
    }

    /** The same with a filter on each body. */
    Mix withFilters() {
        return with(rollingArm, restitution, true, rods);
    }

    /** The same with rods. */
    Mix withRods(int count) {
        return with(rollingArm, restitution, filtered, count);
    }

    private Mix with(double arm, double ratio, boolean filters, int joints) {
        return new Mix(
                flyingSpheres,
                flyingBoxes,
                nearPairs,
                restingSpheres,
                restingCubes,
                edgeCubes,
                columns,
                bouncing,
                fixed,
                friction,
                bounceHeight,
                arm,
                ratio,
                filters,
                joints);
    }

    /**
     * Draws a scene with few contacts, which the solver takes one by one, or with many, which it
     * takes several at once: the prices differ, and a fit over both would have a kink.
     */
    static Mix random(SplittableRandom random, boolean wide) {
        while (true) {
            // From nearly nothing, which tells the constant, to hundreds of each.
            double size = wide ? 1 : StrictMath.exp(random.nextDouble(-4, 0));
            Mix mix = random(random, size);
            int most = mix.resting() + mix.bouncing;
            if (wide ? mix.resting() > 1.2 * WIDE_FROM : most < 0.9 * WIDE_FROM) {
                return mix;
            }
        }
    }

    private static Mix random(SplittableRandom random, double size) {
        return new Mix(
                (int) (size * random.nextInt(300)),
                (int) (size * random.nextInt(300)),
                (int) (size * random.nextInt(150)),
                (int) (size * random.nextInt(200)),
                (int) (size * random.nextInt(200)),
                (int) (size * random.nextInt(200)),
                (int) (size * random.nextInt(60)),
                (int) (size * random.nextInt(200)),
                (int) (size * random.nextInt(400)),
                random.nextBoolean() ? 0.6 : 0,
                // As many balls, but more or fewer events: else the two could not be told apart.
                StrictMath.exp(random.nextDouble(-2, 3)),
                0,
                0,
                false,
                0);
    }

    /** Contacts that last. */
    private int resting() {
        return restingSpheres + restingCubes + edgeCubes + 3 * columns;
    }

    PhysicsWorld build(PhysicsSettings settings) {
        PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -9.81, 0).workers(1).settings(settings).build();
        Material material = new Material(friction, restitution, 1000, rollingArm);
        Grid grid = new Grid(world, material, filtered ? MEETS_ALL : Filter.ALL);
        Sphere ball = Sphere.of(0.5);
        Box cube = Box.cubeOfHalfExtent(0.5);
        Box brick = Box.ofHalfExtents(0.5, 0.2, 0.3);
        Box plate = Box.ofHalfExtents(1.2, 0.5, 1.2);
        for (int i = 0; i < flyingSpheres; i++) {
            grid.next().fly(ball, 0);
        }
        for (int i = 0; i < flyingBoxes; i++) {
            grid.next().fly(brick, 0);
        }
        for (int i = 0; i < nearPairs; i++) {
            BodyRef left = grid.next().flying(ball, -0.52);
            BodyRef right = grid.flying(ball, 0.52);
            if (i < rods) {
                world.add(Joint.rod(left, right));
            }
        }
        for (int i = 0; i < restingSpheres; i++) {
            grid.next().fix(plate).rest(ball, 0.5);
        }
        for (int i = 0; i < restingCubes; i++) {
            grid.next().fix(plate).rest(cube, 0.5);
        }
        for (int i = 0; i < edgeCubes; i++) {
            grid.next().fix(plate);
            world.add(
                    Body.dynamic()
                            .shape(cube)
                            .at(grid.x, StrictMath.sqrt(0.5), grid.z)
                            .rotationAbout(0, 0, 1, Math.PI / 4)
                            .material(material));
        }
        for (int i = 0; i < columns; i++) {
            grid.next().fix(plate).rest(cube, 0.5).rest(cube, 1.5).rest(cube, 2.5);
        }
        for (int i = 0; i < bouncing; i++) {
            grid.next().fix(plate);
            // Bounces last between 0.06 and 0.6 s, times the root of bounceHeight.
            double high = 0.005 * bounceHeight * (1 + i % 10) * (1 + i % 10);
            world.add(
                    Body.dynamic()
                            .shape(ball)
                            .at(grid.x, 0.5 + high, grid.z)
                            .material(material.withRestitution(1)));
        }
        for (int i = 0; i < fixed; i++) {
            grid.next().fix(cube);
        }
        return world;
    }

    Sample measure(PhysicsSettings settings, ThreadTime time) {
        try (PhysicsWorld world = build(settings)) {
            for (int tick = 0; tick < SETTLING; tick++) {
                world.step(STEP);
            }
            double[] sums = new double[NAMES.size()];
            long nanos = 0;
            for (int tick = 0; tick < TICKS; tick++) {
                long before = time.nanos();
                world.step(STEP);
                nanos += time.nanos() - before;
                count(world.contacts(), sums);
            }
            for (int k = 0; k < sums.length; k++) {
                sums[k] /= TICKS;
            }
            sums[0] = 1;
            sums[1] =
                    flyingSpheres
                            + 2.0 * nearPairs
                            + restingSpheres
                            + restingCubes
                            + edgeCubes
                            + 3.0 * columns
                            + bouncing;
            sums[2] = flyingBoxes;
            sums[3] = fixed;
            // The façade lists a pair only once it has a point.
            sums[4] += nearPairs;
            return new Sample(nanos / 1e3 / TICKS, sums);
        }
    }

    private void count(Contacts contacts, double[] sums) {
        for (int c = 0; c < contacts.count(); c++) {
            if (!contacts.touching(c)) {
                sums[4]++;
                continue;
            }
            boolean round =
                    contacts.bodyA(c).shape() instanceof Sphere
                            || contacts.bodyB(c).shape() instanceof Sphere;
            sums[round ? 5 : 6]++;
            int points = contacts.pointCount(c);
            sums[7] += points;
            sums[8] += friction > 0 ? points : 0;
        }
        sums[9] += contacts.began().count() + contacts.ended().count();
    }

    /** Hands out squares of a plane. */
    private static final class Grid {
        private static final int SIDE = 64;
        private final PhysicsWorld world;
        private final Material material;
        private final Filter filter;
        private int used = -1;
        private double x;
        private double z;

        Grid(PhysicsWorld world, Material material, Filter filter) {
            this.world = world;
            this.material = material;
            this.filter = filter;
        }

        Grid next() {
            used++;
            int line = used / SIDE;
            x = PITCH * (used % SIDE);
            z = PITCH * line;
            return this;
        }

        Grid fly(Shape shape, double aside) {
            flying(shape, aside);
            return this;
        }

        BodyRef flying(Shape shape, double aside) {
            return world.add(
                    Body.dynamic()
                            .shape(shape)
                            .at(x + aside, 50, z)
                            .angularVelocity(1, 2, 3)
                            .filter(filter)
                            .material(material));
        }

        Grid rest(Shape shape, double height) {
            world.add(
                    Body.dynamic().shape(shape).at(x, height, z).filter(filter).material(material));
            return this;
        }

        Grid fix(Box plate) {
            world.add(
                    Body.fixed()
                            .shape(plate)
                            .at(x, -plate.halfY(), z)
                            .filter(filter)
                            .material(material));
            return this;
        }
    }
}
