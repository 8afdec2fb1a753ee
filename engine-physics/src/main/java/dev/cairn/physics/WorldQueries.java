package dev.cairn.physics;

import dev.cairn.physics.broadphase.AabbTree;
import dev.cairn.physics.broadphase.BoxWalk;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.RayWalk;
import dev.cairn.physics.broadphase.TreeWalk;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.query.Closest;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

/**
 * What a ray, a moving shape or a place meets among the bodies of a world. The answers are those of
 * {@link ShapeQueries} for each body alone; the broad phase only says whom to ask.
 *
 * <p>Between steps. Each thread may have its own, and ask while nobody changes the world. Answers
 * do not depend on workers or on the history of the trees: of equals, the body that was added first
 * (more exactly, the lowest slot) wins. Allocates only while its lists grow. The first question
 * after a step or a teleport looks at all bodies that move, some 50 ns each; the others take
 * logarithmic time.
 */
public final class WorldQueries {
    private static final int NONE = AabbTree.NONE;

    /** The dynamic tree, the static tree, colliders without end, those that went astray. */
    private static final int SOURCES = 4;

    private static final int TREES = 2;

    private final PhysicsWorld world;
    private final BodyTable table;
    private final ShapeQueries shapes = new ShapeQueries();
    private final RayWalk rayWalk = new RayWalk();
    private final BoxWalk boxWalk = new BoxWalk();
    private final Placement target = new Placement();
    private @Nullable Placement mover;
    private double originX, originY, originZ;
    private final Hit hit = new Hit(), best = new Hit();
    private final Closest closest = new Closest(), nearest = new Closest();
    private final double[] box = new double[6], tight = new double[6];

    /** Colliders that the trees do not know where they are: new, moved by the user, or hit. */
    private int[] astray = new int[16];

    private int astrayCount;
    private int[] found = new int[16];
    private int foundCount;
    private long places = -1;

    /** Where the candidates come from: see {@link #next}. */
    private int source;

    private int place;
    private @Nullable Predicate<BodyRef> filter;
    private @Nullable Filter bits;
    private boolean sensors;

    /** Receives all that a cast meets, or null if the first is enough. */
    private @Nullable List<Met> met;

    private @Nullable ColliderRef last;

    WorldQueries(PhysicsWorld world) {
        this.world = world;
        table = world.physics.table;
    }

    /**
     * Chooses whom the following questions are about.
     *
     * @param wanted false for bodies to look through; {@code null} for all bodies
     * @return this
     */
    public WorldQueries filter(@Nullable Predicate<BodyRef> wanted) {
        filter = wanted;
        return this;
    }

    /**
     * Chooses whom the following questions are about: colliders that one with this filter would
     * meet. It holds together with {@link #filter}.
     *
     * @param asks filter of who asks; {@code null} for all colliders, whatever theirs is
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

    /**
     * Follows a ray to the first body.
     *
     * @param fromX where the ray starts, world, m, finite
     * @param fromY see {@code fromX}
     * @param fromZ see {@code fromX}
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hit; unchanged when there is none
     * @return the body, or {@code null} if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero or the
     *     distance negative
     * @throws IllegalStateException if the world is closed or a step runs
     */
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

    /**
     * Moves a shape, without turning it, to the first body that it touches.
     *
     * @param moving the shape where it starts; not a half-space
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hit; unchanged when there is none
     * @return the body, or {@code null} if there is none
     * @throws IllegalArgumentException if a number is not finite, the direction is zero, the
     *     distance negative, or the mover endless
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public @Nullable BodyRef shapeCast(
            Placement moving,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            Hit out) {
        mover = Checks.notNull("moving", moving);
        moving.bounds(box);
        for (double edge : box) {
            if (!Double.isFinite(edge)) {
                throw new IllegalArgumentException(
                        "moving is "
                                + moving.shape()
                                + ", which has no end; ask with the other shape, or with a box");
            }
        }
        return cast(directionX, directionY, directionZ, maxDistance, out);
    }

    private @Nullable BodyRef cast(double dx, double dy, double dz, double maxDistance, Hit out) {
        Checks.notNull("out", out);
        Checks.finite("directionX", dx);
        Checks.finite("directionY", dy);
        Checks.finite("directionZ", dz);
        Checks.between("maxDistance", maxDistance, 0, Double.POSITIVE_INFINITY);
        double most = Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz)));
        if (most == 0) {
            throw new IllegalArgumentException(
                    "direction is (0, 0, 0); it must point somewhere, its length does not matter");
        }
        double x = dx / most;
        double y = dy / most;
        double z = dz / most;
        double length = Math.sqrt(x * x + y * y + z * z);
        begin();
        double limit = maxDistance;
        int winner = NONE;
        for (source = 0; source < SOURCES; source++) {
            if (source < TREES) {
                rayWalk.start(tree(), box, x / length, y / length, z / length);
            }
            for (int c = next(rayWalk, limit); c != NONE; c = next(rayWalk, limit)) {
                if (!isWanted(c) || !meets(c, dx, dy, dz, limit)) {
                    continue;
                }
                double distance = hit.distance();
                if (met != null) {
                    Hit copy = new Hit();
                    copy.set(hit);
                    met.add(new Met(table.collision.ref(c), copy));
                    continue;
                }
                if (winner == NONE || distance < limit || (distance == limit && c < winner)) {
                    limit = distance;
                    winner = c;
                    best.set(hit);
                }
            }
        }
        if (winner == NONE) {
            return null;
        }
        out.set(best);
        return answer(winner);
    }

    private BodyRef answer(int winner) {
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

    /**
     * Follows a ray through all that it meets. Each collider is met once, where the ray first
     * touches it. Allocates a hit for each.
     *
     * @param fromX where the ray starts, world, m, finite
     * @param fromY see {@code fromX}
     * @param fromZ see {@code fromX}
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hits, the nearest first, of equals in slot order, after what it holds
     * @return how many there are
     */
    public int rayCastAll(
            double fromX,
            double fromY,
            double fromZ,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            List<? super Met> out) {
        List<Met> found = new ArrayList<>();
        met = found;
        try {
            rayCast(fromX, fromY, fromZ, directionX, directionY, directionZ, maxDistance, best);
        } finally {
            met = null;
        }
        return sorted(found, out);
    }

    /**
     * Moves a shape, without turning it, through all that it meets. As {@link #rayCastAll}.
     *
     * @param moving the shape where it starts; not a half-space
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hits, the nearest first, of equals in slot order, after what it holds
     * @return how many there are
     */
    public int shapeCastAll(
            Placement moving,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            List<? super Met> out) {
        List<Met> found = new ArrayList<>();
        met = found;
        try {
            shapeCast(moving, directionX, directionY, directionZ, maxDistance, best);
        } finally {
            met = null;
        }
        return sorted(found, out);
    }

    private static int sorted(List<Met> found, List<? super Met> out) {
        found.sort(
                Comparator.<Met>comparingDouble(one -> one.hit().distance())
                        .thenComparingInt(one -> one.collider().slot()));
        out.addAll(found);
        return found.size();
    }

    private boolean meets(int collider, double dx, double dy, double dz, double limit) {
        aim(collider);
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
        for (source = 0; source < SOURCES; source++) {
            if (source < TREES) {
                boxWalk.start(tree(), box);
            }
            // What overlaps is entered at 0, however deep it is.
            for (int c = next(boxWalk, Math.max(limit, 0));
                    c != NONE;
                    c = next(boxWalk, Math.max(limit, 0))) {
                if (!isWanted(c)) {
                    continue;
                }
                aim(c);
                double distance = shapes.closest(shape, target, closest);
                if (distance < limit || (distance == limit && (winner == NONE || c < winner))) {
                    limit = distance;
                    winner = c;
                    nearest.set(closest);
                }
            }
        }
        if (winner == NONE) {
            return null;
        }
        out.set(nearest);
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
        foundCount = 0;
        for (source = 0; source < SOURCES; source++) {
            if (source < TREES) {
                boxWalk.start(tree(), box);
            }
            for (int c = next(boxWalk, 0); c != NONE; c = next(boxWalk, 0)) {
                if (isWanted(c)) {
                    aim(c);
                    if (shapes.overlaps(shape, target)) {
                        note(table.colliders.body[c]);
                    }
                }
            }
        }
        Arrays.sort(found, 0, foundCount);
        int count = 0;
        for (int i = 0; i < foundCount; i++) {
            if (i == 0 || found[i] != found[i - 1]) {
                out.add(table.refs[found[i]]);
                count++;
            }
        }
        return count;
    }

    private void note(int slot) {
        if (foundCount == found.length) {
            found = Arrays.copyOf(found, 2 * foundCount);
        }
        found[foundCount++] = slot;
    }

    // Whom to ask --------------------------------------------------------------------------------

    private AabbTree tree() {
        place = 0;
        return source == 0 ? table.broadPhase.dynamicTree() : table.broadPhase.staticTree();
    }

    /** The next collider of the trees, of those without end, or of those that went astray. */
    private int next(TreeWalk walk, double limit) {
        if (source < TREES) {
            return walk.next(limit);
        }
        BroadPhase known = table.broadPhase;
        int[] list = source == TREES ? known.endless() : astray;
        int count = source == TREES ? known.endlessCount() : astrayCount;
        if (place == count) {
            place = 0;
            return NONE;
        }
        return list[place++];
    }

    private boolean isWanted(int collider) {
        BodyRef body = table.refs[table.colliders.body[collider]];
        return (!table.colliders.sensor[collider] || sensors)
                && (bits == null || bits.meets(table.colliders.filter[collider]))
                && body.isAlive()
                && (filter == null || filter.test(body));
    }

    private void aim(int c) {
        Poses p = table.colliders.poses;
        target.setCentre(
                table.colliders.shape[c],
                p.positionX[c],
                p.positionY[c],
                p.positionZ[c],
                p.orientationX[c],
                p.orientationY[c],
                p.orientationZ[c],
                p.orientationW[c]);
    }

    /** Looks for colliders that are not within their fat box, once after each change of places. */
    private void begin() {
        world.requireBetweenSteps("a query");
        if (places == table.roster.places) {
            return;
        }
        places = table.roster.places;
        astrayCount = 0;
        for (int i = 0; i < table.roster.unplacedCount; i++) {
            // the others follow below
            if (table.bodies.kind[table.roster.unplaced[i]] == BodyStore.STATIC) {
                stray(table.roster.unplaced[i], false);
            }
        }
        byte[] kind = table.bodies.kind;
        for (int slot = 0; slot < table.bodies.slotCount; slot++) {
            if (kind[slot] != BodyStore.FREE && kind[slot] != BodyStore.STATIC) {
                stray(slot, true);
            }
        }
    }

    /** Notes the colliders of a body, or those that are not within their boxes. */
    private void stray(int slot, boolean outside) {
        ColliderStore k = table.colliders;
        for (int c = k.bodies.collider[slot]; c != NONE; c = k.next[c]) {
            if (outside && inFatBox(c)) {
                continue;
            }
            if (astrayCount == astray.length) {
                astray = Arrays.copyOf(astray, 2 * astrayCount);
            }
            astray[astrayCount++] = c;
        }
    }

    private boolean inFatBox(int c) {
        if (!table.broadPhase.contains(c)) {
            return false;
        }
        aim(c);
        target.bounds(tight);
        double[] fat = table.broadPhase.fatBoxes();
        for (int axis = 0; axis < 3; axis++) {
            if (!(fat[6 * c + axis] <= tight[axis] && tight[axis + 3] <= fat[6 * c + axis + 3])) {
                return false;
            }
        }
        return true;
    }
}
