package dev.cairn.physics.contact;

import dev.cairn.physics.Body;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A body of any make that rests, slides, rolls, spins, falls or is thrown above the plane y = 0, as
 * numbers, so that it can be had at another scale, of another density, and seen from a frame that
 * moves.
 */
final class RandomStart {
    private static final String[] KINDS = {
        "ball",
        "box",
        "cube",
        "capsule",
        "can",
        "cone",
        "rock",
        "wedge",
        "angle",
        "dumbbell",
        "table",
        "lump"
    };

    private static final String[] WAYS = {
        "rests", "slides", "spins", "rolls", "falls", "falls", "is thrown"
    };

    /** A shape at a scale of 1, and where it is on the body. */
    private record Part(String kind, double[] numbers, Vector3d at, Quaterniond turn) {
        Shape shape(double scale) {
            double[] n = new double[numbers.length];
            for (int i = 0; i < n.length; i++) {
                n[i] = scale * numbers[i];
            }
            return switch (kind) {
                case "ball" -> Sphere.of(n[0]);
                case "box" -> Box.ofHalfExtents(n[0], n[1], n[2]);
                case "capsule" -> Capsule.of(n[0], n[1]);
                case "can" -> Cylinder.of(n[0], n[1]);
                case "cone" -> Cone.of(n[0], n[1]);
                default -> ConvexHull.of(n);
            };
        }
    }

    private final SplittableRandom random;
    private final List<Part> parts = new ArrayList<>();
    private final Vector3d at = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private final Vector3d spin = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private final double friction, restitution, rollingArm;
    private final String text;

    /** About how large it is, m. */
    final double size;

    RandomStart(SplittableRandom random) {
        this.random = random;
        size = between(.15, .6);
        String kind = KINDS[random.nextInt(KINDS.length)];
        makeParts(kind);
        friction = random.nextInt(6) == 0 ? 0 : between(.05, 1);
        restitution = random.nextInt(3) == 0 ? between(.2, .9) : 0;
        rollingArm = random.nextInt(6) == 0 ? between(.001, .02) : 0;
        String way = WAYS[random.nextInt(WAYS.length)];
        move(way);
        text = "a " + kind + " that " + way;
    }

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    private void makeParts(String kind) {
        double s = size;
        double t = .3 * s;
        switch (kind) {
            case "angle" -> {
                add("box", 0, 0, s, t, t);
                add("box", t - s, t + .6 * s, t, .6 * s, t);
            }
            case "dumbbell" -> {
                add("ball", .7 * s, 0, .4 * s);
                add("ball", -.7 * s, 0, .4 * s);
                add("box", 0, 0, .7 * s, .1 * s, .1 * s);
            }
            case "table" -> {
                double leg = .12 * s;
                add("box", 0, .5 * s, s, leg, .8 * s);
                for (int i = 0; i < 4; i++) {
                    add("box", 0, -leg / 2, leg, .5 * s - leg / 2, leg);
                    parts.getLast().at.x = (i % 2 * 2 - 1) * (s - leg);
                    parts.getLast().at.z = (i / 2 * 2 - 1) * (.8 * s - leg);
                }
            }
            case "lump" -> {
                for (int i = random.nextInt(2); i < 3; i++) {
                    String part = KINDS[random.nextInt(6)];
                    add(part, between(-.5, .5) * s, between(-.5, .5) * s, .6 * s);
                    parts.getLast().turn.set(Scenes.turn(random));
                }
            }
            default -> add(kind, 0, 0, s);
        }
    }

    private void add(String kind, double x, double y, double... numbers) {
        double s = numbers[0];
        double[] n =
                numbers.length > 1
                        ? numbers
                        : switch (kind) {
                            case "ball" -> new double[] {s};
                            case "cube" -> new double[] {s, s, s};
                            case "box" -> edges(s);
                            case "rock" -> corners(s);
                            case "wedge" -> wedge(edges(s));
                            default -> new double[] {between(.3, 1) * s, between(.3, 1) * s};
                        };
        String shape = kind.equals("cube") ? "box" : kind;
        parts.add(new Part(shape, n, new Vector3d(x, y, 0), new Quaterniond()));
    }

    private double[] edges(double s) {
        return new double[] {between(.3, 1) * s, between(.3, 1) * s, between(.3, 1) * s};
    }

    private double[] corners(double s) {
        double[] n = new double[3 * (5 + random.nextInt(10))];
        for (int i = 0; i < n.length; i += 3) {
            Vector3d corner = Scenes.turn(random).transform(new Vector3d(0, s, 0));
            n[i] = corner.x;
            n[i + 1] = corner.y;
            n[i + 2] = corner.z;
        }
        return n;
    }

    private static double[] wedge(double[] e) {
        double a = e[0];
        double b = e[1];
        double c = e[2];
        return new double[] {-a, -b, -c, a, -b, -c, -a, -b, c, a, -b, c, -a, b, -c, -a, b, c};
    }

    private void move(String way) {
        turn.rotationY(between(-3, 3));
        double above = random.nextInt(4) == 0 ? between(0, .3) : 0;
        switch (way) {
            case "slides" -> velocity.set(between(-4, 4), 0, between(-4, 4));
            case "spins" -> {
                velocity.set(between(-1, 1), 0, between(-1, 1));
                spin.set(0, between(-15, 15), 0);
            }
            case "rolls" -> {
                turn.rotateX(.5 * Math.PI);
                velocity.set(between(-4, 4), 0, between(-4, 4));
                double r = Math.max(.05, -lowest());
                spin.set(velocity.z / r, 0, -velocity.x / r);
            }
            case "falls", "is thrown" -> {
                double fast = way.equals("falls") ? 2 : 6;
                turn.set(Scenes.turn(random));
                velocity.set(between(-fast, fast), between(-fast, 1), between(-fast, fast));
                spin.set(between(-6, 6), between(-6, 6), between(-6, 6));
                above = between(.01, .8);
            }
            default -> {}
        }
        at.set(between(-1, 1), above - lowest(), between(-1, 1));
    }

    private double lowest() {
        double low = Double.POSITIVE_INFINITY;
        double[] box = new double[6];
        for (Part part : parts) {
            Shape shape = part.shape(1).moved(part.at.x, part.at.y, part.at.z, part.turn);
            shape.bounds(turn.x, turn.y, turn.z, turn.w, box, 0);
            low = Math.min(low, box[1] + turn.transform(shape.centreOfMass(new Vector3d())).y);
        }
        return low;
    }

    /**
     * The body.
     *
     * @param scale of lengths
     * @param slower of times
     * @param density kg/m³
     * @param frame velocity of what it is seen from, m/s
     * @param asPart whether one shape is told as a collider
     */
    Body body(double scale, double slower, double density, Vector3d frame, boolean asPart) {
        double speed = scale / slower;
        Body body =
                Body.dynamic()
                        .at(scale * at.x, scale * at.y, scale * at.z)
                        .rotation(turn)
                        .velocity(
                                speed * velocity.x + frame.x,
                                speed * velocity.y + frame.y,
                                speed * velocity.z + frame.z)
                        .angularVelocity(spin.x / slower, spin.y / slower, spin.z / slower)
                        .material(new Material(friction, restitution, density, scale * rollingArm));
        if (parts.size() == 1 && !asPart) {
            return body.shape(parts.getFirst().shape(scale));
        }
        for (Part part : parts) {
            body.collider(
                    Collider.of(part.shape(scale))
                            .at(scale * part.at.x, scale * part.at.y, scale * part.at.z)
                            .rotation(part.turn));
        }
        return body;
    }

    /** Whether it has no parts. */
    boolean isOneShape() {
        return parts.size() == 1;
    }

    @Override
    public String toString() {
        return text;
    }
}
