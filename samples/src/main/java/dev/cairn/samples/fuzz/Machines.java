package dev.cairn.samples.fuzz;

import dev.cairn.physics.Material;
import dev.cairn.physics.joint.AxisState;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.JointSpec.Axis;
import dev.cairn.samples.scenefile.JointSpec.Place;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Draws bodies that joints hold together: chains, loops, bodies with limbs, doors, carts, slides.
 * Nothing drives them, nothing is sprung and nothing is bent beyond its limits, so energy falls and
 * no joint has a gap. The frame of a machine is about its own origin and is turned as a whole.
 */
final class Machines {
    private static final Vector3d UP = new Vector3d(0, 1, 0);

    private final Draws draws;
    private final double size;
    private final Quaterniond turn;
    private final List<EntitySpec> bodies = new ArrayList<>();
    private final List<JointSpec> joints = new ArrayList<>();
    private final Material material;

    private Machines(Draws draws, double size) {
        this.draws = draws;
        this.size = size;
        material = new Material(draws.friction(), 0, draws.power(2, 4));
        Turn t = draws.turn();
        turn = new Quaterniond(t.x(), t.y(), t.z(), t.w());
    }

    /**
     * Draws a machine.
     *
     * @param draws the stream
     * @param size about the half length of a body, m
     */
    static Machines draw(Draws draws, double size) {
        Machines machine = new Machines(draws, size);
        switch (draws.random.nextInt(6)) {
            case 0, 1 -> machine.chain(2 + draws.random.nextInt(8));
            case 2 -> machine.loop(3 + draws.random.nextInt(4));
            case 3 -> machine.limbs(1 + draws.random.nextInt(6));
            case 4 -> machine.held();
            default -> machine.cart();
        }
        return machine;
    }

    /** Radius of the ball about its origin that holds it, m. */
    double radius() {
        double radius = 0;
        for (EntitySpec body : bodies) {
            radius = Math.max(radius, Extent.length(body.position()) + Extent.outer(body));
        }
        return radius;
    }

    /** Whether none of its bodies is fixed. */
    boolean isLoose() {
        return bodies.stream().allMatch(e -> e.body() == BodyKind.DYNAMIC);
    }

    /**
     * Its bodies, in the order in which they are to be added, in rigid motion.
     *
     * @param origin where its origin is
     * @param velocity of the origin, m/s
     * @param spin about the origin, rad/s
     */
    List<EntitySpec> bodies(Xyz origin, Xyz velocity, Xyz spin) {
        List<EntitySpec> placed = new ArrayList<>();
        for (EntitySpec body : bodies) {
            Xyz p = body.position();
            Vector3d v = new Vector3d(spin.x(), spin.y(), spin.z());
            v.cross(p.x(), p.y(), p.z()).add(velocity.x(), velocity.y(), velocity.z());
            EntitySpec at = body.at(sum(origin, p), body.rotation());
            boolean moves = body.body() == BodyKind.DYNAMIC;
            placed.add(moves ? at.moving(new Xyz(v.x, v.y, v.z), spin) : at);
        }
        return placed;
    }

    /**
     * Its joints.
     *
     * @param origin where its origin is
     * @param first index of its first body among the entities of the world
     */
    List<JointSpec> joints(Xyz origin, int first) {
        List<JointSpec> placed = new ArrayList<>();
        for (JointSpec joint : joints) {
            Place p = joint.place();
            Xyz a = sum(origin, Objects.requireNonNull(p.anchorA()));
            Xyz b = sum(origin, Objects.requireNonNull(p.anchorB()));
            placed.add(
                    joint.between(first + joint.a(), first + joint.b())
                            .withPlace(new Place(a, b, p.axis(), null)));
        }
        return placed;
    }

    private static Xyz sum(Xyz a, Xyz b) {
        return new Xyz(a.x() + b.x(), a.y() + b.y(), a.z() + b.z());
    }

    /** Links in a row, hung up or free, with something heavy at the end for every third. */
    private void chain(int links) {
        double thin = size * draws.power(-1, -0.3);
        double length = 2 * (size + thin);
        int last = -1;
        double y = 0.5 * links * length;
        if (draws.random.nextBoolean()) {
            last = body(BodyKind.FIXED, new ShapeSpec.SphereShape(thin), 0, y, 0, UP, null);
        }
        String kind = List.of("ball", "universal", "hinge").get(draws.random.nextInt(3));
        for (int i = 0; i < links; i++) {
            double at = y - (i + 0.5) * length;
            ShapeSpec link =
                    draws.random.nextBoolean()
                            ? new TurnedShape("capsule", thin, size)
                            : new BoxShape(new Xyz(thin, 0.5 * length, thin));
            int next = body(BodyKind.DYNAMIC, link, 0, at, 0, UP, null);
            if (last >= 0) {
                join(kind, last, next, 0, at + 0.5 * length, 0, axis(), List.of());
            }
            last = next;
        }
        if (draws.random.nextInt(3) == 0) {
            double end = y - links * length;
            ShapeSpec ball = new ShapeSpec.SphereShape(size);
            int heavy = body(BodyKind.DYNAMIC, ball, 0, end - size, 0, UP, draws.power(0, 2));
            join("ball", last, heavy, 0, end, 0, axis(), List.of());
        }
    }

    /** Bars around a polygon, with hinges across it; of every second one bar is fixed. */
    private void loop(int bars) {
        double radius = size / StrictMath.sin(Math.PI / bars);
        double thin = size * draws.power(-1, -0.7);
        boolean isFixed = draws.random.nextBoolean();
        for (int i = 0; i < bars; i++) {
            double middle = 2 * Math.PI * (i + 0.5) / bars;
            double inner = radius * StrictMath.cos(Math.PI / bars);
            Vector3d along =
                    new Vector3d(-StrictMath.sin(middle), StrictMath.cos(middle), 0).normalize();
            body(
                    isFixed && i == 0 ? BodyKind.FIXED : BodyKind.DYNAMIC,
                    new BoxShape(new Xyz(thin, size, thin)),
                    inner * StrictMath.cos(middle),
                    inner * StrictMath.sin(middle),
                    0,
                    along,
                    null);
        }
        for (int i = 0; i < bars; i++) {
            double corner = 2 * Math.PI * (i + 1) / bars;
            join(
                    "hinge",
                    i,
                    (i + 1) % bars,
                    radius * StrictMath.cos(corner),
                    radius * StrictMath.sin(corner),
                    0,
                    new Vector3d(0, 0, 1),
                    List.of());
        }
    }

    /** A trunk with limbs on its six sides, which bend within limits. */
    private void limbs(int count) {
        int trunk =
                body(
                        BodyKind.DYNAMIC,
                        new BoxShape(new Xyz(size, size, size)),
                        0,
                        0,
                        0,
                        UP,
                        draws.power(-1, 1));
        double thin = size * draws.power(-0.7, -0.2);
        for (int side = 0; side < count; side++) {
            Vector3d out = new Vector3d();
            out.setComponent(side / 2, side % 2 == 0 ? 1 : -1);
            double middle = size + 1.05 * thin + size;
            ShapeSpec limb = new TurnedShape("capsule", thin, size);
            int made =
                    body(
                            BodyKind.DYNAMIC,
                            limb,
                            middle * out.x,
                            middle * out.y,
                            middle * out.z,
                            out,
                            null);
            boolean isBall = draws.random.nextBoolean();
            double bend = 0.1 + draws.random.nextDouble();
            join(
                    isBall ? "ball" : "hinge",
                    trunk,
                    made,
                    size * out.x,
                    size * out.y,
                    size * out.z,
                    isBall ? out : new Vector3d(out.y, out.z, out.x),
                    List.of(
                            isBall
                                    ? limited(JointAxis.CONE, 0, bend)
                                    : limited(JointAxis.TWIST, -bend, bend)));
        }
    }

    /** A body on another one, which is fixed for every second: door, slide, rope, rod, glue. */
    private void held() {
        double half = size * draws.power(-1, 0);
        BodyKind kind = draws.random.nextBoolean() ? BodyKind.FIXED : BodyKind.DYNAMIC;
        int post = body(kind, new BoxShape(new Xyz(half, size, half)), 0, 0, 0, UP, null);
        double broad = size * draws.power(-0.7, 0.3);
        double thin = size * draws.power(-1, 0);
        int leaf =
                body(
                        BodyKind.DYNAMIC,
                        new BoxShape(new Xyz(broad, 0.9 * size, thin)),
                        half + broad,
                        0,
                        0,
                        UP,
                        draws.power(-1, 1));
        double way = draws.random.nextDouble();
        switch (draws.random.nextInt(5)) {
            case 0 -> {
                List<Axis> limits = List.of(limited(JointAxis.TWIST, -way, 2 * way));
                join("hinge", post, leaf, half, 0, 0, UP, limits);
            }
            case 1 -> {
                List<Axis> limits = List.of(limited(JointAxis.X, -way * size, 2 * way * size));
                join("slider", post, leaf, half, 0, 0, UP, limits);
            }
            case 2 -> join("rope", post, leaf, 0, 0, 0, UP, List.of());
            case 3 -> join("rod", post, leaf, 0, 0, 0, UP, List.of());
            default -> join("fixed", post, leaf, half, 0, 0, UP, List.of());
        }
    }

    /** A box on two or four wheels. */
    private void cart() {
        Vector3d across = new Vector3d(0, 0, 1);
        double high = 0.3 * size;
        ShapeSpec box = new BoxShape(new Xyz(1.5 * size, high, 0.6 * size));
        int body = body(BodyKind.DYNAMIC, box, 0, 0, 0, UP, draws.power(-1, 1));
        double radius = size * (0.35 + 0.3 * draws.random.nextDouble());
        double wide = 0.1 * size;
        double z = 0.6 * size + 1.2 * wide;
        for (int wheel = 0; wheel < (draws.random.nextBoolean() ? 2 : 4); wheel++) {
            double x = wheel < 2 ? size : -size;
            double side = wheel % 2 == 0 ? z : -z;
            ShapeSpec disc = new TurnedShape("cylinder", radius, wide);
            int made = body(BodyKind.DYNAMIC, disc, x, -high, side, across, null);
            join("hinge", body, made, x, -high, side, across, List.of());
        }
    }

    private static Axis limited(JointAxis axis, double lower, double upper) {
        return new Axis(
                axis,
                new AxisState(false, true, lower, upper, false, 0, 0, false, 0, 0, 0, false, 0));
    }

    private Vector3d axis() {
        return new Vector3d(draws.signed(), draws.signed(), draws.signed() + 1e-3).normalize();
    }

    /**
     * Adds a body whose y axis is along a direction of the machine.
     *
     * @param factor of its mass by density, or null for that
     * @return its number among those of the machine
     */
    private int body(
            BodyKind kind,
            ShapeSpec shape,
            double x,
            double y,
            double z,
            Vector3d along,
            @Nullable Double factor) {
        Quaterniond q = new Quaterniond(turn).mul(new Quaterniond().rotationTo(UP, along));
        q.normalize();
        Material own =
                factor == null
                        ? material
                        : new Material(
                                material.friction(),
                                material.restitution(),
                                material.density() * factor);
        bodies.add(
                EntitySpec.of("", kind, shape)
                        .at(place(x, y, z), new Turn(q.x, q.y, q.z, q.w))
                        .withMaterial(own, null));
        return bodies.size() - 1;
    }

    private Xyz place(double x, double y, double z) {
        Vector3d p = turn.transform(new Vector3d(x, y, z));
        return new Xyz(p.x, p.y, p.z);
    }

    /** Joins two bodies at a place of the machine; a rope or rod goes from centre to centre. */
    private void join(
            String kind,
            int a,
            int b,
            double x,
            double y,
            double z,
            Vector3d axis,
            List<Axis> axes) {
        boolean isLine = kind.equals("rope") || kind.equals("rod");
        Xyz at = place(x, y, z);
        Xyz atA = isLine ? bodies.get(a).position() : at;
        Xyz atB = isLine ? bodies.get(b).position() : at;
        Vector3d turned = turn.transform(new Vector3d(axis));
        Place place = new Place(atA, atB, new Xyz(turned.x, turned.y, turned.z), null);
        joints.add(
                new JointSpec(
                        kind,
                        "",
                        a,
                        b,
                        List.of(),
                        place,
                        axes,
                        0,
                        false,
                        Double.POSITIVE_INFINITY,
                        Double.POSITIVE_INFINITY,
                        true));
    }
}
