package dev.cairn.physics.solver.row;

import dev.cairn.physics.solver.body.SolverBodies;

/**
 * The contacts of a tick as constraint rows, sorted by colour, in groups of {@link #lanes}: field f
 * of the row at place j is at {@code base(j) + f lanes}. So a vector of one field of a whole group
 * is one load, and a pass over a colour is one stream through memory.
 *
 * <p>Angular fields are weighted: with {@code I^-1 = L L^T} of a body, an arm is {@code L^T (r x
 * n)}, and the angular velocity in the solver is {@code L^-1 w}. Then the same three numbers tell
 * how a turn moves the point and how an impulse at the point turns the body.
 */
public final class ConstraintRows implements EdgePlaces {
    static final int NORMAL = 0;

    /** 1 while the contact had no impulse to start the sub-step with. */
    public static final int COLD = 3;

    /** Start of the points, {@link #POINT_FIELDS} each. */
    public static final int POINT = 4;

    /** Of a point: weighted arms of A and B. */
    public static final int ARM_A = 0;

    public static final int ARM_B = 3;

    /** Of a point: effective mass along the normal, kg. */
    public static final int MASS = 6;

    /** Of a point: normal impulse of the sub-step, N s. */
    public static final int IMPULSE = 7;

    /** Of a point: separation now plus offset, m. */
    public static final int SEPARATION = 8;

    public static final int POINT_FIELDS = 9;

    /** Per point: separation at the start of the tick plus offset, m. */
    public static final int GAP = 40;

    /** Per point: distance from the patch's centre, m. */
    public static final int REACH = 44;

    /** Per point: normal impulse of the tick, N s. */
    public static final int SUM = 48;

    public static final int TANGENT1 = 52;
    public static final int TANGENT2 = 55;

    /** Coulomb coefficient. */
    public static final int FRICTION = 58;

    /** Inverse of the 2 x 2 tangent block: 11, 12, 22. */
    public static final int BLOCK = 59;

    /** Friction impulses of the sub-step along the tangents, then the twist impulse. */
    public static final int LAMBDA = 62;

    /** Inverse of the twist's inverse inertia. */
    public static final int TWIST_MASS = 65;

    /** Weighted arms of the tangents at the patch's centre: A t1, A t2, B t1, B t2. */
    public static final int LEVER = 66;

    /** Weighted normals of A and B: {@code L^T n}. */
    public static final int TWIST = 78;

    /** Totals of the tick: friction along the tangents, twist. */
    public static final int TOTAL = 84;

    /** Inverse masses, 1/kg; the sweeps take them from the bodies. */
    public static final int MASS_A = 87;

    public static final int MASS_B = 88;

    /** Doubles to a row. */
    public static final int FIELDS = 89;

    /**
     * Where the rows start: behind the 16 bytes of an array's header this is a whole cache line, if
     * the array starts with one; large arrays of the G1 collector do.
     */
    public static final int START = 6;

    /** Ints to a row. */
    public static final int LINK = 4;

    /** Offsets of the bodies in {@link SolverBodies#state}; 0 for static bodies. */
    static final int BODY_A = 0;

    public static final int BODY_B = 1;

    /** Points; 0 in a place that pads its colour. */
    public static final int COUNT = 2;

    /** Row in the contact store. */
    public static final int SOURCE = 3;

    /** Places to a chunk, the unit of work: a multiple of every number of lanes. */
    public static final int CHUNK = 32;

    /** Places for which there is room at first. */
    private static final int LEAST = 64;

    /** Rows to a vector. */
    public final int lanes;

    /** Rows that a colour is padded to multiples of: one vector, or two. */
    public final int group;

    /** The contacts whose rows these are, and others. */
    public final EdgeList list;

    /** Rolling friction of the rows; of windows there is none. */
    public final RollingRows rolling = new RollingRows();

    /** Friction of rows between bodies whose surfaces run along; of windows there is none. */
    public final DragRows drags = new DragRows();

    /** Places in use, padding included. */
    public int places;

    /** The rows, if they are doubles. */
    public double[] doubles = {};

    /** The rows, if they are floats. */
    public float[] floats = {};

    public final boolean isSingle;

    public int[] link = {};

    /** Largest number of points in a group. */
    public int[] points = {};

    /** Whether a row of a group has friction. */
    public boolean[] hasFriction = {};

    /**
     * By place: what the settle pass does to the row. 1 in the tick in which a load that the
     * contact's island carried has gone, {@code StaticStart.MARK} where its island starts.
     */
    public byte[] settleMark = {};

    public ConstraintRows(int lanes, int group, boolean isSingle, EdgeList list) {
        this.lanes = lanes;
        this.group = group;
        this.isSingle = isSingle;
        this.list = list;
    }

    /** A field of a row, for readers of few. */
    public double get(int index) {
        return isSingle ? floats[index] : doubles[index];
    }

    /** Changes a field of a row. */
    public void put(int index, double value) {
        if (isSingle) {
            floats[index] = (float) value;
        } else {
            doubles[index] = value;
        }
    }

    /** Index of field 0 of the row at place {@code j}. */
    public int base(int j) {
        int lane = j % lanes;
        return START + (j - lane) * FIELDS + lane;
    }

    /** Points of the row at place {@code j}. */
    public int points(int j) {
        return link[j * LINK + COUNT];
    }

    @Override
    public int group() {
        return group;
    }

    /** Impulses of a row from which the next sub-step would start; in double precision only. */
    public void forget(int j) {
        int o = base(j);
        for (int p = 0; p < points(j); p++) {
            doubles[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes] = 0;
        }
        for (int k = 0; k < 3; k++) {
            doubles[o + (LAMBDA + k) * lanes] = 0;
        }
    }

    @Override
    public void bind(int place, int source, int offsetA, int offsetB, int variant) {
        int l = place * LINK;
        link[l + BODY_A] = offsetA;
        link[l + BODY_B] = offsetB;
        link[l + COUNT] = variant;
        link[l + SOURCE] = source;
        settleMark[place] = 0;
    }

    @Override
    public void pad(int place) {
        bind(place, 0, 0, 0, 0);
    }

    /** Makes room; see {@link #places} for how many are in use. */
    @Override
    public void ensurePlaces(int wanted) {
        places = wanted;
        if (wanted * LINK > link.length) {
            int n = Math.max(wanted, Math.max(LEAST, settleMark.length + (settleMark.length >> 1)));
            n = (n + CHUNK - 1) / CHUNK * CHUNK;
            if (isSingle) {
                floats = new float[START + n * FIELDS];
            } else {
                doubles = new double[START + n * FIELDS];
            }
            link = new int[n * LINK];
            settleMark = new byte[n];
            points = new int[n / lanes];
            hasFriction = new boolean[n / lanes];
        }
    }
}
