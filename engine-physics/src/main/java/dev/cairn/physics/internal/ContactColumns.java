package dev.cairn.physics.internal;

/**
 * The columns of the contacts, and where in them the numbers of a row or a point are.
 *
 * <p>Points are stored four to a row: point {@code p} of row {@code c} is at {@code 4 * c + p}. The
 * normal is a unit vector in world axes from body A to body B. Anchors are the contact point,
 * midway between the surfaces, relative to each body's centre of mass, in world axes at the start
 * of the tick, in metres. Impulses are what warm-starts the next tick.
 */
public class ContactColumns {
    /** No rows. */
    ContactColumns() {}

    /** Points per row. */
    public static final int POINTS = 4;

    /** Numbers per point in {@link #anchors}. */
    public static final int ANCHORS = 6;

    /** Numbers per row in {@link #head}: normal, then these. */
    public static final int HEAD = 8;

    /** Of a row's head: the Coulomb coefficient. */
    public static final int FRICTION = 3;

    /** Of a row's head: the friction impulse. */
    public static final int FRICTION_IMPULSE = 4;

    /** Of a row's head: the twist impulse. */
    public static final int TWIST = 7;

    /** Behind the 16 bytes of an array's header this is a whole cache line. */
    static final int START = 6;

    /** Numbers per row in {@link #kept}. */
    public static final int KEPT = 24;

    /** Of a row's: its points on the incident shape in that one's axes, m, three numbers each. */
    public static final int KEPT_POINT = 12;

    /** Where in it is how far around the shape the pair was looked through, m. */
    public static final int KEPT_GAP = 10;

    /** Slots of the two colliders, the lower one first: a row is of a pair of these. */
    public int[] colliderA = {}, colliderB = {};

    /** What the two colliders touch with, see {@link Surface}. */
    public byte[] surfaceA = {}, surfaceB = {};

    /** Slots of their bodies; at least one of them is dynamic. */
    public int[] bodyA = {}, bodyB = {};

    /** 0 to 4. */
    public int[] pointCount = {};

    /**
     * Which of a row's points, ascending by feature id as an unsigned number, is at each place: two
     * bits a place, the first one lowest. It stays while the ids do.
     */
    public byte[] order = {};

    /**
     * Mean distance of the patch's area from its middle over that of its points; 0 when the points
     * are all of the patch.
     */
    public double[] patch = {};

    /**
     * What the solver reads of a row beside its points, in one cache line: the unit normal from A
     * to B in world axes; the mixed Coulomb coefficient; the friction impulse at the patch centre
     * in world axes, N s over the last sub-step, and the twist impulse about the normal, N m s over
     * the last sub-step, both warm start. Row c begins at {@link #head}.
     */
    public double[] head = {};

    /**
     * Whether a material with rolling friction has been here; until then there is nothing in {@link
     * #rollingArm} and {@link #rollingImpulse}.
     */
    public boolean rolls;

    /** Mixed arm of rolling friction, m, at least 0. */
    public double[] rollingArm = {};

    /**
     * Rolling impulse on B, world, N m s over the last sub-step, in the contact plane; three
     * numbers a row; warm start.
     */
    public double[] rollingImpulse = {};

    /** Whether ticks have had different lengths; until then nothing is in {@link #frictionLoad}. */
    public boolean uneven;

    /**
     * What friction has held on B on the mean when ticks changed their length, world, N, and its
     * twist about the normal, N m; four numbers a row.
     */
    public double[] frictionLoad = {};

    /** Whether a surface that moves along has been here; until then nothing is in {@link #belt}. */
    public boolean belts;

    /**
     * Velocity along the contact of the surface of the body that does not move, world, m/s; three
     * numbers a row, all 0 for most.
     */
    public double[] belt = {};

    /** Whether hits are listened to; until then nothing is in {@link #approach}. */
    public boolean hits;

    /** How fast the two approached before they touched, m/s. */
    public double[] approach = {};

    /** Whether a body fell asleep beside one that moves; until then nothing is in {@link #lean}. */
    public boolean leans;

    /**
     * Force of a contact between a body asleep and one that moves when the one fell asleep, N; 0
     * for other contacts.
     */
    public double[] lean = {};

    /** Whether a user's hook has been here; until then nothing is in {@link #hookMemory}. */
    public boolean hooked;

    /** What the hook remembers of the row. */
    public int[] hookMemory = {};

    /**
     * Whether a body with several colliders has been here; until then there is nothing in {@link
     * #lever}.
     */
    public boolean compounds;

    /**
     * From the centre of mass of A to the centre of its collider, then the same of B, world axes at
     * the start of the tick, m; six numbers a row, what its anchors contain.
     */
    public double[] lever = {};

    /**
     * Of each of a row's points, four bits, the first one lowest: 1 more than its place among the
     * corners of the patch that {@code PatchStage} made of several rows in the last tick; 0 if it
     * was none of them.
     */
    public int[] rank = {};

    /** Whether a surface of triangles has been here; until then {@link #group} is empty. */
    public boolean grouped;

    /**
     * Of a row that is one of several of its pair of colliders: the number of the pair's group, at
     * least 1; negative for all but the first row of the group. 0 for the only row of a pair.
     */
    public int[] group = {};

    /** Of a row with a surface of triangles: the number of the triangle and 1, else 0. */
    public int[] triangle = {};

    /** Numbers of a row in {@link #ground}. */
    public static final int GROUND = 8;

    /**
     * Of a row with a surface of triangles that keeps its points, see {@link #keeps}: its normal in
     * the surface's axes, and of each point how high on the surface it is along that, m; last, as a
     * number, bit p for a point p of a round side.
     */
    public double[] ground = {};

    /** Mixed coefficient of restitution, 0..1. */
    public double[] restitution = {};

    /** 1 while the bodies touch: since they came within reach they have overlapped or pushed. */
    public byte[] touching = {};

    /** The narrow phase's warm-start word; 0 if there is none. */
    public long[] cache = {};

    /**
     * What the narrow phase remembers of pairs with a hull; empty until {@link
     * ContactStore#beginMemory}.
     */
    public long[] memory = {};

    /** Whether {@link #kept} holds something of a row. */
    public boolean[] keeps = {};

    /**
     * Relative pose and points when a pair of boxes was last collided; the manifold stage's own. A
     * row's numbers are three whole cache lines: rows that are near lie far from each other.
     */
    public double[] kept = {};

    /**
     * Per point: contact point relative to A's, then to B's centre of mass, world axes, m. Point p
     * begins at {@link #anchor}: those of a row are three cache lines, where in columns of their
     * own they would be six.
     */
    public double[] anchors = {};

    /**
     * Per point: signed distance of the surfaces along the normal, m; negative when they overlap.
     */
    public double[] separation = {};

    /**
     * Per point: id of the features that touch; equal ids in successive ticks are the same point.
     */
    public int[] feature = {};

    /** Per point: normal impulse of the last sub-step, N s, never negative; warm start. */
    public double[] normalImpulse = {};

    /**
     * Per point: the resting load that the solver has learnt, N s over a sub-step, never negative;
     * carried with the point like {@link #normalImpulse}, 0 for a new one.
     */
    public double[] preload = {};

    /**
     * Per point: sum of the normal impulses over the tick, N s; what users read as the contact's
     * impulse.
     */
    public double[] totalNormalImpulse = {};

    /**
     * Where a row begins in {@link #head}: at a cache line, if the array does.
     *
     * @return index
     */
    public static int head(int row) {
        return START + HEAD * row;
    }

    /**
     * Where a point begins in {@link #anchors}; the first of a row at a cache line, as there.
     *
     * @return index
     */
    public static int anchor(int point) {
        return START + ANCHORS * point;
    }

    /**
     * Where a row begins in {@link #kept}: at a cache line.
     *
     * @return index
     */
    public static int keptAt(int row) {
        return START + KEPT * row;
    }

    /** Unit normal from A to B, world: x. */
    public double normalX(int row) {
        return head[head(row)];
    }

    /** Unit normal from A to B, world: y. */
    public double normalY(int row) {
        return head[head(row) + 1];
    }

    /** Unit normal from A to B, world: z. */
    public double normalZ(int row) {
        return head[head(row) + 2];
    }

    /** The triangle under the deepest point of a row, or -1 if it is of two solids. */
    public int triangle(int row) {
        return grouped ? triangle[row] - 1 : -1;
    }

    /** Mixed Coulomb coefficient. */
    public double friction(int row) {
        return head[head(row) + FRICTION];
    }

    /** Friction impulse at the patch centre, world: x, N s over the last sub-step. */
    public double frictionImpulseX(int row) {
        return head[head(row) + FRICTION_IMPULSE];
    }

    /** Friction impulse at the patch centre, world: y, N s over the last sub-step. */
    public double frictionImpulseY(int row) {
        return head[head(row) + FRICTION_IMPULSE + 1];
    }

    /** Friction impulse at the patch centre, world: z, N s over the last sub-step. */
    public double frictionImpulseZ(int row) {
        return head[head(row) + FRICTION_IMPULSE + 2];
    }

    /** Twist impulse about the normal, N m s over the last sub-step. */
    public double twistImpulse(int row) {
        return head[head(row) + TWIST];
    }

    /** A point from A's centre of mass, world: x, m. */
    public double anchorAX(int point) {
        return anchors[anchor(point)];
    }

    /** A point from A's centre of mass, world: y, m. */
    public double anchorAY(int point) {
        return anchors[anchor(point) + 1];
    }

    /** A point from A's centre of mass, world: z, m. */
    public double anchorAZ(int point) {
        return anchors[anchor(point) + 2];
    }

    /** A point from B's centre of mass, world: x, m. */
    public double anchorBX(int point) {
        return anchors[anchor(point) + 3];
    }

    /** A point from B's centre of mass, world: y, m. */
    public double anchorBY(int point) {
        return anchors[anchor(point) + 4];
    }

    /** A point from B's centre of mass, world: z, m. */
    public double anchorBZ(int point) {
        return anchors[anchor(point) + 5];
    }

    /** Sets the unit normal of a row. */
    public void setNormal(int row, double x, double y, double z) {
        int i = head(row);
        head[i] = x;
        head[i + 1] = y;
        head[i + 2] = z;
    }

    /** Sets the Coulomb coefficient of a row. */
    public void setFriction(int row, double coefficient) {
        head[head(row) + FRICTION] = coefficient;
    }

    /** Sets the friction impulse of a row, N s, and its twist, N m s. */
    public void setFrictionImpulse(int row, double x, double y, double z, double twist) {
        int i = head(row);
        head[i + FRICTION_IMPULSE] = x;
        head[i + FRICTION_IMPULSE + 1] = y;
        head[i + FRICTION_IMPULSE + 2] = z;
        head[i + TWIST] = twist;
    }

    /** Sets the rolling impulse of a row, N m s; only while {@link #rolls}. */
    public void setRollingImpulse(int row, double x, double y, double z) {
        rollingImpulse[3 * row] = x;
        rollingImpulse[3 * row + 1] = y;
        rollingImpulse[3 * row + 2] = z;
    }

    /** Sets where a point is from A and from B, m. */
    public void setAnchors(
            int point, double ax, double ay, double az, double bx, double by, double bz) {
        int i = anchor(point);
        anchors[i] = ax;
        anchors[i + 1] = ay;
        anchors[i + 2] = az;
        anchors[i + 3] = bx;
        anchors[i + 4] = by;
        anchors[i + 5] = bz;
    }
}
