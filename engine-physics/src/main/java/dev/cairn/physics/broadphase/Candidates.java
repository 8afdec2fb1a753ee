package dev.cairn.physics.broadphase;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.query.Placement;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntPredicate;

/**
 * The colliders that a question about a world is put to: colliders of both trees that a walk meets,
 * then those without end, then those that the trees do not know where they are. Each that is wanted
 * comes once.
 *
 * <p>One thread. Allocates only while its list grows.
 */
public final class Candidates {
    private static final int NONE = AabbTree.NONE;

    /** The dynamic tree, the static tree, colliders without end, those that went astray. */
    private static final int SOURCES = 4;

    private static final int TREES = 2;

    private final BroadPhase known;
    private final ColliderStore colliders;
    private final IntPredicate wanted;
    private final RayTraversal rayTraversal = new RayTraversal();
    private final BoxTraversal boxTraversal = new BoxTraversal();
    private final Placement at = new Placement();
    private final double[] from = new double[6], tight = new double[6];
    private double dx, dy, dz;
    private TreeTraversal walk = boxTraversal;

    /** Colliders that the trees do not know where they are: new, moved by the user, or hit. */
    private int[] astray = new int[16];

    private int astrayCount;

    /** The same as a set: they are left out where the trees have them. */
    private final BitSet isAstray = new BitSet();

    private long places = -1;

    private int source;
    private int place;

    /**
     * Candidates.
     *
     * @param known the trees
     * @param colliders where colliders are
     * @param wanted false for colliders to look through
     */
    public Candidates(BroadPhase known, ColliderStore colliders, IntPredicate wanted) {
        this.known = known;
        this.colliders = colliders;
        this.wanted = wanted;
    }

    /** Colliders by the distance, along a direction, after which a moving box enters theirs. */
    public void along(double[] box, double x, double y, double z) {
        System.arraycopy(box, 0, from, 0, 6);
        double most = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        double fx = x / most;
        double fy = y / most;
        double fz = z / most;
        double length = Math.sqrt(fx * fx + fy * fy + fz * fz);
        dx = fx / length;
        dy = fy / length;
        dz = fz / length;
        walk = rayTraversal;
        source = 0;
        start();
    }

    /** Colliders by their distance from a box. */
    public void near(double[] box) {
        System.arraycopy(box, 0, from, 0, 6);
        walk = boxTraversal;
        source = 0;
        start();
    }

    private void start() {
        place = 0;
        if (source >= TREES) {
            return;
        }
        AabbTree tree = source == 0 ? known.dynamicTree() : known.staticTree();
        if (walk == rayTraversal) {
            rayTraversal.start(tree, from, dx, dy, dz);
        } else {
            boxTraversal.start(tree, from);
        }
    }

    /** The next collider that is wanted and not farther than a limit, or {@link AabbTree#NONE}. */
    public int next(double limit) {
        while (source < SOURCES) {
            int c = ofSource(limit);
            if (c == NONE) {
                source++;
                start();
            } else if (isAsked(c)) {
                return c;
            }
        }
        return NONE;
    }

    private int ofSource(double limit) {
        if (source < TREES) {
            return walk.next(limit);
        }
        int[] list = source == TREES ? known.endless() : astray;
        int count = source == TREES ? known.endlessCount() : astrayCount;
        return place == count ? NONE : list[place++];
    }

    private boolean isAsked(int collider) {
        return !(source < TREES && isAstray.get(collider))
                && !colliders.isWhole(collider)
                && wanted.test(collider);
    }

    /** Places a collider where it is now. */
    public void aim(int c, Placement target) {
        Poses p = colliders.poses;
        target.setCentre(
                colliders.shape[c],
                p.positionX[c],
                p.positionY[c],
                p.positionZ[c],
                p.orientationX[c],
                p.orientationY[c],
                p.orientationZ[c],
                p.orientationW[c]);
    }

    /**
     * Looks for colliders that are not within their fat box, once after each change of places.
     *
     * @param now the count of changes
     * @param unplaced bodies of which the trees may not know yet
     * @param unplacedCount how many there are
     */
    public void begin(long now, int[] unplaced, int unplacedCount) {
        if (places == now) {
            return;
        }
        places = now;
        astrayCount = 0;
        isAstray.clear();
        byte[] kind = colliders.bodies.kind;
        for (int i = 0; i < unplacedCount; i++) {
            // the others follow below
            if (kind[unplaced[i]] == BodyStore.STATIC) {
                stray(unplaced[i], false);
            }
        }
        for (int slot = 0; slot < colliders.bodies.slotCount; slot++) {
            if (kind[slot] != BodyStore.FREE && kind[slot] != BodyStore.STATIC) {
                stray(slot, true);
            }
        }
    }

    /** Notes the colliders of a body, or those that are not within their boxes. */
    private void stray(int slot, boolean outside) {
        ColliderStore k = colliders;
        for (int c = k.bodies.collider[slot]; c != NONE; c = k.next[c]) {
            if (outside && inFatBox(c)) {
                continue;
            }
            if (astrayCount == astray.length) {
                astray = Arrays.copyOf(astray, 2 * astrayCount);
            }
            astray[astrayCount++] = c;
            isAstray.set(c);
        }
    }

    private boolean inFatBox(int c) {
        if (!known.contains(c)) {
            return false;
        }
        aim(c, at);
        at.bounds(tight);
        double[] fat = known.fatBoxes();
        for (int axis = 0; axis < 3; axis++) {
            if (!(fat[6 * c + axis] <= tight[axis] && tight[axis + 3] <= fat[6 * c + axis + 3])) {
                return false;
            }
        }
        return true;
    }
}
