package dev.cairn.samples.fuzz;

import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Draws numbers, shapes and bodies of several parts from one stream. */
final class Draws {
    final SplittableRandom random;

    /** Power of ten of the thinnest shape, as a share of its size. */
    private final double thinnest;

    Draws(SplittableRandom random, double thinnest) {
        this.random = random;
        this.thinnest = thinnest;
    }

    /** None for one of four, else up to 2. */
    double friction() {
        return random.nextInt(4) == 0 ? 0 : 2 * random.nextDouble();
    }

    /** Ten to a power between two. */
    double power(double least, double most) {
        return StrictMath.pow(10, least + (most - least) * random.nextDouble());
    }

    /** From -1 to 1. */
    double signed() {
        return 2 * random.nextDouble() - 1;
    }

    /** None for one of four, else any. */
    Turn turn() {
        return random.nextInt(4) == 0 ? Turn.NONE : anyTurn();
    }

    private Turn anyTurn() {
        return Turn.about(new Xyz(signed(), signed(), signed() + 1e-3), 360 * random.nextDouble());
    }

    /** A shape of one piece, whose half length along its longest axis is about {@code size}. */
    ShapeSpec shape(double size) {
        double thin = random.nextInt(3) == 0 ? size : size * power(thinnest, 0);
        double broad = random.nextBoolean() ? thin : thin + (size - thin) * random.nextDouble();
        return switch (random.nextInt(7)) {
            case 0 -> new ShapeSpec.SphereShape(size);
            case 1 -> new ShapeSpec.TurnedShape("capsule", thin, size);
            case 2 -> turned("cylinder", thin, size);
            case 3 -> turned("cone", thin, size);
            case 4 -> hull(thin, broad, size);
            default -> new ShapeSpec.BoxShape(shuffled(thin, broad, size));
        };
    }

    /** A rod or a disc. */
    private ShapeSpec turned(String type, double thin, double size) {
        return random.nextBoolean()
                ? new ShapeSpec.TurnedShape(type, thin, size)
                : new ShapeSpec.TurnedShape(type, size, thin);
    }

    private Xyz shuffled(double a, double b, double c) {
        return switch (random.nextInt(3)) {
            case 0 -> new Xyz(a, b, c);
            case 1 -> new Xyz(c, a, b);
            default -> new Xyz(b, c, a);
        };
    }

    /** Eight points, one in each octant, so that they are in no plane. */
    private ShapeSpec hull(double a, double b, double c) {
        Xyz half = shuffled(a, b, c);
        List<Xyz> points = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            points.add(
                    new Xyz(
                            ((k & 1) == 0 ? half.x() : -half.x())
                                    * (0.5 + 0.5 * random.nextDouble()),
                            ((k & 2) == 0 ? half.y() : -half.y())
                                    * (0.5 + 0.5 * random.nextDouble()),
                            ((k & 4) == 0 ? half.z() : -half.z())
                                    * (0.5 + 0.5 * random.nextDouble())));
        }
        return new ShapeSpec.HullShape(points);
    }

    /** Two to four pieces anywhere, which may overlap and need not touch. */
    List<PartSpec> parts(double size) {
        List<PartSpec> parts = new ArrayList<>();
        int count = 2 + random.nextInt(3);
        for (int i = 0; i < count; i++) {
            ShapeSpec shape = shape(size * (0.2 + 0.4 * random.nextDouble()));
            Xyz at = new Xyz(0.6 * size * signed(), 0.6 * size * signed(), 0.6 * size * signed());
            parts.add(PartSpec.of(shape).at(at).turned(anyTurn()));
        }
        return parts;
    }
}
