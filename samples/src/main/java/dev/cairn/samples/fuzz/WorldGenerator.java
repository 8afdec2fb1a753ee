package dev.cairn.samples.fuzz;

import dev.cairn.physics.Material;
import dev.cairn.render.camera.Light;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.BodySpec;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.LookSpec;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.SceneFile.TickSpec;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Draws worlds from a seed: the same seed and index give the same world, on every machine.
 *
 * <p>Nothing overlaps at the start, since pushing it out is energy that nobody put in: bodies are
 * placed by the balls around them, or stacked with gaps of zero. One thread; an object to a world.
 */
public final class WorldGenerator {
    private static final double G = 9.81;
    private static final double TAU = 2 * Math.PI;

    /** Size of the least machine, m: wheels of a millimetre are WIDE. */
    private static final double LEAST_MACHINE = 0.2;

    /** Of machines, rad/s. */
    private static final double MOST_MACHINE_SPIN = 10;

    /** Odd, so that neighbouring indices share no stream. */
    private static final long STRIDE = 0x9E3779B97F4A7C15L;

    private final long seed;
    private final long index;
    private final Family family;
    private final SplittableRandom random;
    private final Draws draws;
    private final List<EntitySpec> entities = new ArrayList<>();
    private final List<JointSpec> joints = new ArrayList<>();
    private final List<double[]> balls = new ArrayList<>();

    /** Above which bodies are placed, m. */
    private double low;

    private WorldGenerator(long seed, long index, Family family, SplittableRandom random) {
        this.seed = seed;
        this.index = index;
        this.family = family;
        this.random = random;
        draws = new Draws(random, family == Family.WIDE ? -4 : -1.7);
    }

    /**
     * Draws a world.
     *
     * @param seed any
     * @param index of the world among those of the seed, at least 0
     * @param only the family, or null for one at random
     * @return the world
     */
    public static FuzzWorld world(long seed, long index, @Nullable Family only) {
        SplittableRandom random = new SplittableRandom(seed * STRIDE + index).split();
        double u = random.nextDouble();
        return new WorldGenerator(seed, index, only == null ? drawn(u) : only, random).draw();
    }

    private static Family drawn(double u) {
        if (u < 0.6) {
            return u < 0.25 ? Family.HOUSE : u < 0.4 ? Family.ROOM : Family.LEVEL;
        }
        return u < 0.75 ? Family.MACHINE : u < 0.85 ? Family.SPACE : Family.WIDE;
    }

    private FuzzWorld draw() {
        boolean wide = family == Family.WIDE;
        boolean space =
                family == Family.SPACE
                        || ((wide || family == Family.MACHINE) && random.nextInt(4) == 0);
        boolean closed = !space && (family == Family.ROOM || (wide && random.nextInt(3) == 0));
        double size = wide ? draws.power(-3, 3) : draws.power(-1.7, 0.3);
        double base = wide && random.nextInt(3) == 0 ? draws.power(-3, -1.5) : 1.0 / 60;
        Pace pace = Pace.EVEN;
        int substeps = 4;
        if (wide) {
            substeps = 1 << random.nextInt(5);
            pace =
                    switch (random.nextInt(8)) {
                        case 5 -> Pace.TURNS;
                        case 6 -> Pace.HICCUP;
                        case 7 -> Pace.RANDOM;
                        default -> Pace.EVEN;
                    };
        }
        boolean sleeping = random.nextInt(4) == 0;
        int count = count();
        double restitution = restitution();
        boolean tower = !space && !closed && random.nextInt(8) == 0;
        double machine = family == Family.MACHINE ? Math.max(size, LEAST_MACHINE) : size;
        Grounds grounds = null;
        if (family == Family.LEVEL || (family == Family.MACHINE && !space)) {
            grounds = Grounds.draw(draws, machine);
            base(grounds, size);
        }
        if (family == Family.MACHINE) {
            machines(1 + random.nextInt(2), machine, space);
            scatter(random.nextInt(4), size, space, restitution, base);
        } else if (tower && family != Family.LEVEL) {
            tower(count, size);
        } else {
            scatter(count, size, space, restitution, base);
        }
        double room = Double.POSITIVE_INFINITY;
        double floor = Double.POSITIVE_INFINITY;
        Material ground = new Material(draws.friction(), restitution, 1000);
        if (closed) {
            room = closeRoom(ground);
        } else if (grounds != null) {
            grounds.entities().forEach(e -> entities.add(e.withMaterial(ground, null)));
            floor = grounds.half();
        } else if (!space) {
            floor = floor(ground, size);
        }
        int ticks = sleeping ? 360 : 90 + random.nextInt(90);
        SceneFile scene =
                new SceneFile(
                        "fuzz %d/%d".formatted(seed, index),
                        "%s, ticks %s".formatted(family, pace),
                        space ? Xyz.ZERO : new Xyz(0, -G, 0),
                        new TickSpec(base, substeps, ticks, 1),
                        camera(size),
                        Light.DAYLIGHT,
                        entities,
                        joints,
                        List.of(),
                        null);
        return new FuzzWorld(seed, index, family, scene, pace, sleeping, room, floor);
    }

    /** Small ones are more frequent: they say more plainly what is wrong. */
    private int count() {
        return switch (random.nextInt(4)) {
            case 0 -> 1;
            case 1 -> 2 + random.nextInt(3);
            case 2 -> 2 + random.nextInt(8);
            default -> 1 + random.nextInt(30);
        };
    }

    private double restitution() {
        int kind = random.nextInt(4);
        return kind < 2 ? 0 : kind == 2 ? random.nextDouble() : 1;
    }

    // Bodies -------------------------------------------------------------------------------------

    private void scatter(int count, double size, boolean space, double restitution, double tick) {
        boolean column = random.nextBoolean();
        double most = 0;
        for (int i = 0; i < count; i++) {
            double own = size * draws.power(-0.7, 0);
            EntitySpec thing = thing(own);
            double radius = Extent.outer(thing);
            most = Math.max(most, radius);
            double width = column ? 0.5 * most : 2 * most * Math.cbrt(count);
            Xyz at = free(radius, width, space);
            boolean peg = !space && random.nextInt(10) == 0;
            EntitySpec entity =
                    thing.withBody(peg ? BodyKind.FIXED : BodyKind.DYNAMIC)
                            .at(at, draws.turn())
                            .withMaterial(
                                    new Material(draws.friction(), restitution, draws.power(2, 4)),
                                    family == Family.WIDE ? draws.power(-3, 3) : null);
            entities.add(peg ? entity : moving(entity, at, radius, space, tick));
        }
    }

    /** In a level every second one is of several shapes. */
    private EntitySpec thing(double size) {
        if (family == Family.LEVEL && random.nextBoolean()) {
            List<PartSpec> parts = draws.parts(size);
            return EntitySpec.of("", BodyKind.DYNAMIC, parts.get(0).shape())
                    .withPhysics(BodySpec.DEFAULT.withParts(parts));
        }
        return EntitySpec.of("", BodyKind.DYNAMIC, draws.shape(size));
    }

    /** A place for a ball among those before, wider and higher until it is free. */
    private Xyz free(double radius, double width, boolean space) {
        double wide = width;
        while (true) {
            double x = wide * draws.signed();
            double z = wide * draws.signed();
            double y =
                    space
                            ? wide * draws.signed()
                            : low + radius * 1.02 + (wide + 2 * radius) * random.nextDouble();
            boolean isFree = true;
            for (double[] ball : balls) {
                double dx = x - ball[0];
                double dy = y - ball[1];
                double dz = z - ball[2];
                double reach = 1.01 * (radius + ball[3]);
                isFree &= dx * dx + dy * dy + dz * dz > reach * reach;
            }
            if (isFree) {
                balls.add(new double[] {x, y, z, radius});
                return new Xyz(x, y, z);
            }
            wide *= 1.05;
        }
    }

    /** In space bodies fly at the middle, so that they meet. */
    private EntitySpec moving(
            EntitySpec entity, Xyz at, double radius, boolean space, double tick) {
        double fast = family == Family.WIDE ? Math.sqrt(G * radius) * draws.power(-1, 1.5) : 10;
        if (family == Family.ROOM) {
            fast = 20;
        }
        double speed = random.nextInt(3) == 0 && !space ? 0 : fast * random.nextDouble();
        double away = Math.sqrt(at.x() * at.x() + at.y() * at.y() + at.z() * at.z()) + 1e-9;
        Xyz v =
                space
                        ? new Xyz(
                                speed * (0.3 * draws.signed() - at.x() / away),
                                speed * (0.3 * draws.signed() - at.y() / away),
                                speed * (0.3 * draws.signed() - at.z() / away))
                        : new Xyz(
                                speed * draws.signed(),
                                speed * draws.signed(),
                                speed * draws.signed());
        // house: rims up to 10 m/s; wide: up to several turns a tick
        double spin =
                random.nextInt(3) == 0
                        ? 0
                        : family == Family.WIDE
                                ? draws.power(-2, 0.5) * TAU / tick
                                : random.nextDouble() * 10 / radius;
        return entity.moving(
                v, new Xyz(spin * draws.signed(), spin * draws.signed(), spin * draws.signed()));
    }

    /** Boxes put on one another exactly, at rest. */
    private void tower(int count, double size) {
        double top = 0;
        double half = size;
        for (int i = 0; i < Math.min(count, 10); i++) {
            half *= 0.9 + 0.1 * random.nextDouble();
            double height = half * draws.power(-1, 0);
            EntitySpec box =
                    EntitySpec.of(
                                    "",
                                    BodyKind.DYNAMIC,
                                    new ShapeSpec.BoxShape(new Xyz(half, height, half)))
                            .at(
                                    new Xyz(0, top + height, 0),
                                    Turn.about(new Xyz(0, 1, 0), 20 * draws.signed()))
                            .withMaterial(new Material(0.3 + draws.friction(), 0, 1000), null);
            entities.add(box);
            top += 2 * height;
        }
    }

    // Surroundings -------------------------------------------------------------------------------

    /**
     * What stands on the ground of a level: benches for every third, something kinematic for every
     * fifth, which comes by once a second. All else starts above it.
     */
    private void base(Grounds grounds, double size) {
        low = grounds.top();
        boolean isLevel = family == Family.LEVEL;
        if (isLevel && random.nextInt(3) == 0) {
            for (int i = 0; i < 3; i++) {
                ShapeSpec bench = new ShapeSpec.BoxShape(new Xyz(3 * size, size, 0.3 * size));
                Xyz at = new Xyz(4 * size * draws.signed(), low + 0.9 * size, 0);
                Turn turn = Turn.about(new Xyz(0, 1, 0), 360 * random.nextDouble());
                entities.add(EntitySpec.of("bench", BodyKind.FIXED, bench).at(at, turn));
            }
            low += 2 * size;
        } else if (isLevel && random.nextInt(4) == 0) {
            ShapeSpec bar = new ShapeSpec.BoxShape(new Xyz(2 * size, 0.5 * size, 0.2 * size));
            boolean turns = random.nextBoolean();
            Xyz at = new Xyz(0, low + 0.55 * size, turns ? 0 : -3 * size);
            entities.add(
                    EntitySpec.of("mover", BodyKind.KINEMATIC, bar)
                            .at(at, Turn.NONE)
                            .moving(
                                    turns ? Xyz.ZERO : new Xyz(0, 0, 2 * size),
                                    turns ? new Xyz(0, 4 * draws.signed(), 0) : Xyz.ZERO));
            low += 1.1 * size;
        }
    }

    /** Machines in rigid motion, or at rest. */
    private void machines(int count, double size, boolean space) {
        for (int i = 0; i < count; i++) {
            Machines machine = Machines.draw(draws, size * draws.power(-0.7, 0));
            double radius = machine.radius();
            Xyz at = free(radius, 2 * radius, space);
            Xyz velocity = Xyz.ZERO;
            Xyz spin = Xyz.ZERO;
            if (machine.isLoose()) {
                double fast = random.nextInt(3) == 0 ? 0 : 5;
                velocity =
                        new Xyz(
                                fast * draws.signed(),
                                fast * draws.signed(),
                                fast * draws.signed());
                double rim = Math.min(fast / radius, MOST_MACHINE_SPIN);
                spin = new Xyz(rim * draws.signed(), rim * draws.signed(), rim * draws.signed());
            }
            joints.addAll(machine.joints(at, entities.size()));
            entities.addAll(machine.bodies(at, velocity, spin));
        }
    }

    /** A floor without end, or a wide slab; half its width. */
    private double floor(Material ground, double size) {
        boolean isEndless = random.nextBoolean();
        double half = 1000 * size;
        EntitySpec floor =
                isEndless
                        ? EntitySpec.of("floor", BodyKind.FIXED, new ShapeSpec.GroundShape())
                        : slab(new Xyz(0, -size, 0), new Xyz(half, size, half));
        entities.add(floor.withMaterial(ground, null));
        return isEndless ? Double.POSITIVE_INFINITY : half;
    }

    private static EntitySpec slab(Xyz at, Xyz half) {
        return EntitySpec.of("wall", BodyKind.FIXED, new ShapeSpec.BoxShape(half))
                .at(at, Turn.NONE);
    }

    /** Six slabs around what is there; half its inner width. */
    private double closeRoom(Material ground) {
        double half = 0;
        for (double[] ball : balls) {
            half = Math.max(half, Math.abs(ball[0]) + 1.02 * ball[3]);
            half = Math.max(half, Math.abs(ball[2]) + 1.02 * ball[3]);
            half = Math.max(half, 0.5 * (ball[1] + 1.02 * ball[3]));
        }
        double thick = 0.5 * half;
        double far = half + 2 * thick;
        for (int side = -1; side <= 1; side += 2) {
            double out = side * (half + thick);
            entities.add(wall(out, half, 0, thick, far, far, ground));
            entities.add(wall(0, half + out, 0, far, thick, far, ground));
            entities.add(wall(0, half, out, far, far, thick, ground));
        }
        return half;
    }

    private static EntitySpec wall(
            double x, double y, double z, double hx, double hy, double hz, Material ground) {
        EntitySpec slab = slab(new Xyz(x, y, z), new Xyz(hx, hy, hz)).withMaterial(ground, null);
        return slab.withLook(new LookSpec(y < 0, null, null, 0, null, Xyz.ONE));
    }

    private CameraSpec camera(double size) {
        double far = 4 * size;
        for (double[] ball : balls) {
            far =
                    Math.max(
                            far,
                            2
                                    * Math.sqrt(
                                            ball[0] * ball[0]
                                                    + ball[1] * ball[1]
                                                    + ball[2] * ball[2]));
        }
        return new CameraSpec(new Xyz(0, 0.5 * far, 1.5 * far), new Xyz(0, 0.2 * far, 0), 50);
    }
}
