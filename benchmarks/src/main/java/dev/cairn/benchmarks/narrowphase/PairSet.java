package dev.cairn.benchmarks.narrowphase;

import dev.cairn.benchmarks.peer.PairCalls;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.box.BoxContacts;
import dev.cairn.physics.narrowphase.hull.PairMemory;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.wide.BoxBatch;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.SplittableRandom;

/**
 * Pairs of one kind with their poses, made from a seed. Of a set that moves, each B slides along A
 * and turns a little from tick to tick, to and fro.
 */
public final class PairSet {
    /** Pairs in a set. */
    public static final int SIZE = 256;

    /** Points up to this far apart, of the smaller inner radius, are contacts: the default. */
    private static final double MARGIN = 0.02;

    /** What collides with what. */
    public enum Kind {
        /** Unit cubes half a cube beside the one below, on it within 0.1 mm. */
        STACKED_BOXES,
        /** Boxes of any sides from 0.5 to 1.5 m that touch or overlap by up to a tenth. */
        TUMBLED_BOXES,
        /** The same boxes, up to a metre apart. */
        BOXES_APART,
        /** Hulls of 32 points near a unit ball that touch or overlap by up to a tenth. */
        HULLS_32,
        /** The same hulls, as deep as a step leaves them: up to a hundredth. */
        HULLS_32_SHALLOW,
        /** A ball on a box. */
        BALL_ON_BOX,
        /** Two balls. */
        BALLS,
        /** A ball on a capsule. */
        BALL_ON_CAPSULE,
        /** Two capsules. */
        CAPSULES,
        /** A capsule on a box. */
        CAPSULE_ON_BOX
    }

    /** Ticks of the motion in one direction. */
    private static final int FRAMES = 8;

    /**
     * Of the smaller inner radius, and half as much of a radian, in a tick: 0.3 m/s and 0.3 rad/s
     * of a unit cube at 60 Hz. Stacked boxes turn by a fiftieth of that.
     */
    private static final double MOVE = 0.01;

    /** Scenes share shapes; a different hull for each body would measure the memory. */
    private static final int HULLS = 16;

    private final ConvexHull[] hulls = new ConvexHull[HULLS];
    final Shape[] a = new Shape[SIZE], b = new Shape[SIZE];
    final Quaterniond[] turnA = new Quaterniond[SIZE], turnB = new Quaterniond[SIZE];
    final Vector3d[] offset = new Vector3d[SIZE];
    private final Quaterniond[] framesB = new Quaterniond[FRAMES * SIZE];
    private final Vector3d[] frames = new Vector3d[FRAMES * SIZE];
    private final double[] margin = new double[SIZE];
    private final long[] memory = new long[PairMemory.SIZE * SIZE];

    /**
     * A set.
     *
     * @param kind of all pairs
     * @param seed of the poses
     */
    public PairSet(Kind kind, long seed) {
        SplittableRandom r = new SplittableRandom(seed);
        NarrowPhase narrowPhase = new NarrowPhase();
        for (int i = 0; i < HULLS; i++) {
            hulls[i] = hull(r);
        }
        for (int i = 0; i < SIZE; i++) {
            a[i] = shape(kind, r, true);
            b[i] = shape(kind, r, false);
            turnA[i] = turn(r);
            if (kind == Kind.STACKED_BOXES) {
                stack(i, r);
            } else {
                turnB[i] = turn(r);
                double far = 1.2 * (a[i].outerRadius() + b[i].outerRadius());
                offset[i] = direction(r).mul(far);
                bringTogether(i, kind, narrowPhase, r);
            }
            double inner = Math.min(a[i].innerRadius(), b[i].innerRadius());
            margin[i] = MARGIN * inner;
            distance(i, narrowPhase);
            Vector3d axis =
                    new Vector3d(narrowPhase.axisX(), narrowPhase.axisY(), narrowPhase.axisZ());
            Vector3d step = direction(r);
            step.fma(-step.dot(axis), axis).mul(MOVE * inner);
            Vector3d turn = direction(r).mul(kind == Kind.STACKED_BOXES ? .01 * MOVE : .5 * MOVE);
            for (int f = 0; f < FRAMES; f++) {
                frames[FRAMES * i + f] = new Vector3d(offset[i]).fma(f - FRAMES / 2.0, step);
                double by = f - FRAMES / 2.0;
                framesB[FRAMES * i + f] =
                        new Quaterniond(turnB[i]).rotateXYZ(by * turn.x, by * turn.y, by * turn.z);
            }
        }
    }

    /**
     * Hands all pairs to another engine's call.
     *
     * @param calls receives them
     */
    void addTo(PairCalls calls) {
        for (int i = 0; i < SIZE; i++) {
            calls.add(a[i], turnA[i], b[i], turnB[i], offset[i]);
        }
    }

    /**
     * Moves every B to its place in a tick.
     *
     * @param tick any
     */
    public void move(int tick) {
        int f = tick % (2 * FRAMES - 2);
        f = f < FRAMES ? f : 2 * FRAMES - 2 - f;
        for (int i = 0; i < SIZE; i++) {
            offset[i] = frames[FRAMES * i + f];
            turnB[i] = framesB[FRAMES * i + f];
        }
    }

    private Shape shape(Kind kind, SplittableRandom r, boolean first) {
        return switch (kind) {
            case STACKED_BOXES -> Box.cubeOfHalfExtent(.5);
            case TUMBLED_BOXES, BOXES_APART -> box(r);
            case HULLS_32, HULLS_32_SHALLOW -> hulls[r.nextInt(HULLS)];
            case BALL_ON_BOX -> first ? box(r) : Sphere.of(.2 + .5 * r.nextDouble());
            case BALLS -> Sphere.of(.2 + .5 * r.nextDouble());
            case BALL_ON_CAPSULE -> first ? capsule(r) : Sphere.of(.2 + .5 * r.nextDouble());
            case CAPSULES -> capsule(r);
            case CAPSULE_ON_BOX -> first ? box(r) : capsule(r);
        };
    }

    private static Box box(SplittableRandom r) {
        return Box.ofHalfExtents(
                .25 + .5 * r.nextDouble(), .25 + .5 * r.nextDouble(), .25 + .5 * r.nextDouble());
    }

    private static Capsule capsule(SplittableRandom r) {
        return Capsule.of(.2 + .3 * r.nextDouble(), .2 + .5 * r.nextDouble());
    }

    private static ConvexHull hull(SplittableRandom r) {
        double[] xyz = new double[3 * 32];
        for (int i = 0; i < 32; i++) {
            Vector3d p = direction(r);
            xyz[3 * i] = p.x;
            xyz[3 * i + 1] = p.y;
            xyz[3 * i + 2] = p.z;
        }
        return ConvexHull.of(xyz);
    }

    private static double gauss(SplittableRandom r) {
        return r.nextDouble() + r.nextDouble() + r.nextDouble() - 1.5;
    }

    private static Quaterniond turn(SplittableRandom r) {
        return new Quaterniond(gauss(r), gauss(r), gauss(r), gauss(r)).normalize();
    }

    private static Vector3d direction(SplittableRandom r) {
        return new Vector3d(gauss(r), gauss(r), gauss(r)).normalize();
    }

    /** As in a pyramid; small turns, as after some settling. */
    private void stack(int i, SplittableRandom r) {
        double side = r.nextBoolean() ? .505 : -.505;
        Vector3d d = new Vector3d(side, 1 - 1e-4 * r.nextDouble(), 1e-6 * gauss(r));
        offset[i] = turnA[i].transform(d);
        double small = 1e-6;
        turnB[i] =
                new Quaterniond(turnA[i])
                        .rotateXYZ(small * gauss(r), small * gauss(r), small * gauss(r));
    }

    /** Moves B along the axis of least distance until the wanted gap is left. */
    private void bringTogether(int i, Kind kind, NarrowPhase n, SplittableRandom r) {
        double inner = Math.min(a[i].innerRadius(), b[i].innerRadius());
        double deep = kind == Kind.HULLS_32_SHALLOW ? .01 : .1;
        double gap =
                kind == Kind.BOXES_APART ? .01 + r.nextDouble() : -deep * inner * r.nextDouble();
        for (int step = 0; step < 4; step++) {
            double d = distance(i, n);
            offset[i].fma(gap - d, new Vector3d(n.axisX(), n.axisY(), n.axisZ()));
        }
    }

    /**
     * The signed distance of a pair.
     *
     * @param i the pair
     * @param n computes it
     * @return m
     */
    public double distance(int i, NarrowPhase n) {
        Quaterniond p = turnA[i];
        Quaterniond q = turnB[i];
        Vector3d d = offset[i];
        return n.distance(a[i], b[i], p.x, p.y, p.z, p.w, q.x, q.y, q.z, q.w, d.x, d.y, d.z);
    }

    /**
     * The signed distance of a pair, from the features that were nearest before.
     *
     * @param i the pair
     * @param n computes it
     * @param word of the last tick, or 0
     * @return m
     */
    public double distance(int i, NarrowPhase n, long word) {
        Quaterniond p = turnA[i];
        Quaterniond q = turnB[i];
        Vector3d d = offset[i];
        return n.distance(a[i], b[i], p.x, p.y, p.z, p.w, q.x, q.y, q.z, q.w, d.x, d.y, d.z, word);
    }

    /**
     * The contact of a pair.
     *
     * @param i the pair
     * @param n computes it
     * @param word of the last tick, or 0
     * @param out receives it
     * @return the word for the next tick
     */
    public long collide(int i, NarrowPhase n, long word, Manifold out) {
        Quaterniond p = turnA[i];
        Quaterniond q = turnB[i];
        Vector3d d = offset[i];
        if (word != 0) {
            n.remember(memory, PairMemory.SIZE * i);
        }
        return n.collide(
                a[i], b[i], p.x, p.y, p.z, p.w, q.x, q.y, q.z, q.w, d.x, d.y, d.z, margin[i], word,
                out);
    }

    /**
     * The contacts of a batch of boxes.
     *
     * @param begin the first pair; {@link BoxBatch#CAPACITY} follow
     * @param contacts computes them
     * @param words of the last tick, replaced by those for the next one
     * @param out receives one after another
     * @return number of points
     */
    public int collideBoxes(int begin, BoxContacts contacts, long[] words, Manifold out) {
        for (int k = 0; k < BoxBatch.CAPACITY; k++) {
            int i = begin + k;
            Quaterniond p = turnA[i];
            Quaterniond q = turnB[i];
            Vector3d d = offset[i];
            Box first = (Box) a[i];
            Box second = (Box) b[i];
            double inner = Math.min(first.innerRadius(), second.innerRadius());
            contacts.put(
                    k, first, second, p.x, p.y, p.z, p.w, q.x, q.y, q.z, q.w, d.x, d.y, d.z, inner,
                    margin[i], words[i]);
        }
        contacts.run(BoxBatch.CAPACITY);
        int points = 0;
        for (int k = 0; k < BoxBatch.CAPACITY; k++) {
            int i = begin + k;
            words[i] = contacts.take(k, (Box) a[i], (Box) b[i], out);
            points += out.pointCount;
        }
        return points;
    }
}
