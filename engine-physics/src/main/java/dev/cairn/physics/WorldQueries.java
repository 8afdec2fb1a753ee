package dev.cairn.physics;

import dev.cairn.physics.broadphase.AabbTree;
import dev.cairn.physics.broadphase.Candidates;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.query.Closest;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Motion;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;
import dev.cairn.physics.query.VectorCasts;
import dev.cairn.physics.state.BodyRegistry;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

/**
 * What a ray, a moving shape or a place meets among the bodies of a world. The answers are those of
 * {@link ShapeQueries} for each body alone; the broad phase only says which bodies to ask.
 *
 * <p>Between steps. Each thread may have its own, and ask while nobody changes the world. Answers
 * do not depend on workers or on the history of the trees: of equals, the body that was added first
 * (more exactly, the lowest slot) wins. Allocates only while its lists grow. The first question
 * after a step or a teleport looks at all bodies that move, some 50 ns each; the others take
 * logarithmic time.
 */
public final class WorldQueries implements VectorCasts<BodyRef, WorldQueries.Met> {
    private static final int NONE = AabbTree.NONE;

    private final BodyTable table;
    private final PhysicsWorld world;
    private final Candidates candidates;
    private final ShapeQueries shapes = new ShapeQueries();
    private final Placement target = new Placement(), other = new Placement();
    private @Nullable Placement mover;
    private double originX, originY, originZ;
    private final Motion motionA = new Motion(), motionB = new Motion();
    private final Hit hit = new Hit(), best = new Hit();
    private final Closest closest = new Closest(), nearest = new Closest();
    private final double[] box = new double[6];
    private final Vector3d v = new Vector3d();

    private final BitSet found = new BitSet(); // slots of bodies

    /** Receives all that a cast meets, or null if the first is enough. */
    private @Nullable List<Met> met;

    private @Nullable ColliderRef last;
    private @Nullable Predicate<BodyRef> filter;
    private @Nullable Filter bits;
    private boolean sensors;

    WorldQueries(PhysicsWorld world) {
        table = world.physics.table;
        this.world = world;
        candidates = new Candidates(table.broadPhase, table.colliders, this::isWanted);
    }

    /**
     * Chooses the bodies that the following questions are about.
     *
     * @param wanted false for bodies to look through; {@code null} for all bodies
     * @return this
     */
    public WorldQueries filter(@Nullable Predicate<BodyRef> wanted) {
        filter = wanted;
        return this;
    }

    /**
     * Chooses what the following questions are about: colliders that one with this filter would
     * meet. It holds together with {@link #filter}.
     *
     * @param asks filter of the question; {@code null} for all colliders, whatever theirs is
     * @return this
     */
    public WorldQueries withFilter(@Nullable Filter asks) {
        bits = asks;
        return this;
    }

    /**
     * Says whether sensors are looked at too; by default they are not.
     *
     * @param value true to find sensors
     * @return this
     */
    public WorldQueries withSensors(boolean value) {
        sensors = value;
        return this;
    }

    @Override
    public @Nullable BodyRef rayCast(
            double fromX,
            double fromY,
            double fromZ,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            Hit out) {
        originX = Checks.finite("fromX", fromX);
        originY = Checks.finite("fromY", fromY);
        originZ = Checks.finite("fromZ", fromZ);
        mover = null;
        box[0] = box[3] = fromX;
        box[1] = box[4] = fromY;
        box[2] = box[5] = fromZ;
        return cast(directionX, directionY, directionZ, maxDistance, out);
    }

    @Override
    public @Nullable BodyRef shapeCast(
            Placement moving,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            Hit out) {
        mover = Checks.notNull("moving", moving);
        requireEnd(moving);
        return cast(directionX, directionY, directionZ, maxDistance, out);
    }

    /** Takes the box of a shape, which must have an end. */
    private void requireEnd(Placement moving) {
        moving.bounds(box);
        for (double edge : box) {
            if (!Double.isFinite(edge)) {
                throw new IllegalArgumentException(
                        "moving is "
                                + moving.shape()
                                + ", which has no end; ask with the other shape, or with a box");
            }
        }
    }

    private @Nullable BodyRef cast(double dx, double dy, double dz, double maxDistance, Hit out) {
        Checks.notNull("out", out);
        Checks.direction(dx, dy, dz);
        Checks.between("maxDistance", maxDistance, 0, Double.POSITIVE_INFINITY);
        begin();
        double limit = maxDistance;
        int winner = NONE;
        candidates.along(box, dx, dy, dz);
        for (int c = candidates.next(limit); c != NONE; c = candidates.next(limit)) {
            if (meets(c, dx, dy, dz, limit)
                    && !note(c)
                    && (winner == NONE || hit.distance() < limit || c < winner)) {
                limit = hit.distance();
                winner = c;
                best.set(hit);
            }
        }
        return answer(winner, out);
    }

    /** Notes what was met, if all is wanted. */
    private boolean note(int collider) {
        if (met != null) {
            Hit copy = new Hit();
            copy.set(hit);
            met.add(new Met(table.collision.ref(collider), copy));
        }
        return met != null;
    }

    private @Nullable BodyRef answer(int winner, Hit out) {
        if (winner != NONE) {
            out.set(best);
        }
        return answer(winner);
    }

    private @Nullable BodyRef answer(int winner) {
        if (winner == NONE) {
            return null;
        }
        last = table.collision.ref(winner);
        return last.body();
    }

    /**
     * The collider that the last ray, moving shape or question for the nearest body has found.
     *
     * @return the collider, or {@code null} before the first answer
     */
    public @Nullable ColliderRef collider() {
        return last;
    }

    /**
     * A collider that a ray or a moving shape has met.
     *
     * @param collider what was met
     * @param hit where
     */
    public record Met(ColliderRef collider, Hit hit) {}

    @Override
    public int rayCastAll(
            double fromX,
            double fromY,
            double fromZ,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            List<? super Met> out) {
        return all(
                () ->
                        rayCast(
                                fromX,
                                fromY,
                                fromZ,
                                directionX,
                                directionY,
                                directionZ,
                                maxDistance,
                                best),
                out);
    }

    @Override
    public int shapeCastAll(
            Placement moving,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            List<? super Met> out) {
        return all(
                () -> shapeCast(moving, directionX, directionY, directionZ, maxDistance, best),
                out);
    }

    /**
     * Moves and turns a shape to the first body that it touches. Bodies are taken as they stand.
     *
     * @param moving the shape where it starts; not a half-space
     * @param motion how it moves
     * @param seconds for how long, s, at least 0, finite
     * @param out receives the hit, with {@link Hit#seconds}; unchanged when there is none
     * @return the body, or {@code null} if there is none
     * @throws IllegalArgumentException if the time is negative or not finite, if the shape turns by
     *     more than 1e5 rad in it, or if the mover is endless
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public @Nullable BodyRef turningCast(Placement moving, Motion motion, double seconds, Hit out) {
        Checks.notNull("out", out);
        requireEnd(Checks.notNull("moving", moving));
        Checks.between("seconds", seconds, 0, Double.MAX_VALUE);
        begin();
        motion.bounds(moving, seconds, box);
        double limit = seconds;
        int winner = NONE;
        candidates.near(box);
        for (int c = candidates.next(0); c != NONE; c = candidates.next(0)) {
            candidates.aim(c, target);
            if (shapes.turningCast(moving, motion, limit, target, hit)
                    && !note(c)
                    && (winner == NONE || hit.seconds() < limit || c < winner)) {
                limit = hit.seconds();
                winner = c;
                best.set(hit);
            }
        }
        return answer(winner, out);
    }

    /**
     * Moves and turns a shape through all that it meets. Each collider is met once, when the shape
     * first touches it. Allocates a hit for each.
     *
     * @param moving the shape where it starts; not a half-space
     * @param motion how it moves
     * @param seconds for how long, s, at least 0, finite
     * @param out receives the hits, the earliest first, of equals in slot order, after what it
     *     holds
     * @return how many there are
     */
    public int turningCastAll(
            Placement moving, Motion motion, double seconds, List<? super Met> out) {
        return all(() -> turningCast(moving, motion, seconds, best), out);
    }

    /**
     * When two bodies meet that go on as they move now: their centres of mass straight, turning at
     * their angular velocities. No force, gravity or other body is looked at, nor filters; sensors
     * count only with {@link #withSensors}.
     *
     * @param a a body
     * @param b another body
     * @param seconds for how long, s, at least 0, finite
     * @param out receives the hit, with {@link Hit#seconds}, the point where they touch then and
     *     the outward normal of b; unchanged when there is none
     * @return whether there is one; {@link #collider} then is the one of b
     * @throws IllegalArgumentException if a body is gone, if the time is negative or not finite, or
     *     if a body turns by more than 1e5 rad in it
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public boolean timeOfImpact(BodyRef a, BodyRef b, double seconds, Hit out) {
        Checks.notNull("out", out);
        Checks.between("seconds", seconds, 0, Double.MAX_VALUE);
        begin();
        ColliderStore k = table.colliders;
        int slotA = move(a, motionA), slotB = move(b, motionB);
        double limit = seconds;
        int winner = NONE;
        for (int c = k.bodies.collider[slotA]; c != NONE; c = k.next[c]) {
            for (int d = k.bodies.collider[slotB]; d != NONE; d = k.next[d]) {
                candidates.aim(c, other);
                candidates.aim(d, target);
                if ((sensors || !(k.sensor[c] || k.sensor[d]))
                        && shapes.timeOfImpact(other, motionA, target, motionB, limit, hit)
                        && (winner == NONE || hit.seconds() < limit)) {
                    limit = hit.seconds();
                    winner = d;
                    best.set(hit);
                }
            }
        }
        return answer(winner, out) != null;
    }

    /** Takes how a body moves; returns its slot. */
    private int move(BodyRef body, Motion motion) {
        int slot = body.slot();
        motion.clear().velocity(body.velocity(v)).angularVelocity(body.angularVelocity(v));
        BodyStore s = table.bodies;
        motion.about(s.positionX[slot], s.positionY[slot], s.positionZ[slot]);
        return slot;
    }

    private int all(Runnable question, List<? super Met> out) {
        List<Met> found = new ArrayList<>();
        met = found;
        try {
            question.run();
        } finally {
            met = null;
        }
        found.sort(
                Comparator.<Met>comparingDouble(one -> one.hit().seconds())
                        .thenComparingDouble(one -> one.hit().distance())
                        .thenComparingInt(one -> one.collider().slot()));
        out.addAll(found);
        return found.size();
    }

    private boolean meets(int collider, double dx, double dy, double dz, double limit) {
        candidates.aim(collider, target);
        return mover == null
                ? shapes.rayCast(target, originX, originY, originZ, dx, dy, dz, limit, hit)
                : shapes.shapeCast(mover, dx, dy, dz, limit, target, hit);
    }

    /**
     * Finds the body that is nearest to a place.
     *
     * @param shape the place
     * @param within how far away it may be at most, m, at least 0, may be infinite
     * @param out receives nearest points, normal and signed distance, the place first; unchanged
     *     when there is no body. Of bodies that overlap the place, the deepest is the nearest
     * @return the body, or {@code null} if none is near enough
     * @throws IllegalArgumentException if {@code within} is negative or not a number
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public @Nullable BodyRef closest(Placement shape, double within, Closest out) {
        Checks.notNull("out", out);
        Checks.between("within", within, 0, Double.POSITIVE_INFINITY);
        Checks.notNull("shape", shape).bounds(box);
        begin();
        double limit = within;
        int winner = NONE;
        candidates.near(box);
        // What overlaps is entered at 0, however deep it is.
        for (int c = candidates.next(Math.max(limit, 0));
                c != NONE;
                c = candidates.next(Math.max(limit, 0))) {
            candidates.aim(c, target);
            double distance = shapes.closest(shape, target, closest);
            if (distance < limit || (distance == limit && (winner == NONE || c < winner))) {
                limit = distance;
                winner = c;
                nearest.set(closest);
            }
        }
        if (winner != NONE) {
            out.set(nearest);
        }
        return answer(winner);
    }

    /**
     * Finds all bodies that touch or overlap a place.
     *
     * @param shape the place
     * @param out receives the bodies, in slot order, after what it holds already
     * @return how many there are
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public int overlaps(Placement shape, List<? super BodyRef> out) {
        Checks.notNull("out", out);
        Checks.notNull("shape", shape).bounds(box);
        begin();
        found.clear();
        candidates.near(box);
        for (int c = candidates.next(0); c != NONE; c = candidates.next(0)) {
            candidates.aim(c, target);
            if (shapes.overlaps(shape, target)) {
                found.set(table.colliders.body[c]);
            }
        }
        int count = 0;
        for (int slot = found.nextSetBit(0); slot >= 0; slot = found.nextSetBit(slot + 1)) {
            out.add(table.refs[slot]);
            count++;
        }
        return count;
    }

    private void begin() {
        world.requireBetweenSteps("a query");
        BodyRegistry registry = table.registry;
        candidates.begin(registry.places, registry.unplaced, registry.unplacedCount);
    }

    private boolean isWanted(int collider) {
        BodyRef body = table.refs[table.colliders.body[collider]];
        return (!table.colliders.sensor[collider] || sensors)
                && (bits == null || bits.meets(table.colliders.filter[collider]))
                && body.isAlive()
                && (filter == null || filter.test(body));
    }
}
