package dev.cairn.physics;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.island.Islands;
import dev.cairn.physics.joint.JointData;

import java.util.Arrays;

/**
 * What the engine knows beyond poses, copied so that another thread may look at it: contact points
 * with normals and impulses; boxes, velocities and centres of mass of the bodies; joints. {@link
 * PhysicsWorld#capture} fills it. World frame, SI units.
 *
 * <p>One thread at a time; the arrays belong to the object and are at least as long as the counts
 * say. Filling one again allocates only while the numbers grow.
 */
public final class DebugData {
    /** In place of an island or a colour where there is none. */
    public static final int NONE = -1;

    /** A body that never moves. */
    public static final byte FIXED = 0;

    /** A body that is simulated. */
    public static final byte AWAKE = 1;

    /** A body that rests and is left out until something touches it. */
    public static final byte ASLEEP = 2;

    /** A body that moves as the user says. */
    public static final byte KINEMATIC = 3;

    private int pointCount;
    private double[] points = {};
    private double[] normals = {};
    private double[] impulses = {};
    private double[] separations = {};
    private int[] firstBodies = {};
    private int[] secondBodies = {};
    private int[] colours = {};
    private int[] colourOfRow = {};
    private int bodyCount;
    private int[] islands = {};
    private int[] bodyOfSlot = {};
    private int[] awakeSlots = {};
    private final Islands links = new Islands();
    private double[] centres = {};
    private double[] velocities = {};
    private double[] boxes = {};
    private byte[] states = {};
    private long[] entities = {};
    private final JointData joints = new JointData();

    /** Empty data. */
    public DebugData() {}

    /** Copies. Simulation thread, between steps. */
    void fill(PhysicsSystem physics) {
        fillBodies(physics.table);
        fillIslands(physics.table, physics.edges);
        ContactStore rows = physics.contacts;
        if (colourOfRow.length < rows.count) {
            colourOfRow = new int[rows.count + (rows.count >> 1)];
        }
        Arrays.fill(colourOfRow, 0, rows.count, NONE);
        physics.solver.readColours(colourOfRow);
        fillPoints(physics.table.bodies, rows);
        if (physics.jointList != null) {
            physics.jointList.capture(joints);
        }
    }

    /**
     * The joints: where they are, how far they may go, and what they bear.
     *
     * @return this object's own; it changes with the next filling
     */
    public JointData joints() {
        return joints;
    }

    private void fillPoints(BodyStore bodies, ContactStore rows) {
        int most = rows.count * ContactStore.POINTS;
        if (impulses.length < most) {
            int capacity = most + (most >> 1);
            points = new double[3 * capacity];
            normals = new double[3 * capacity];
            impulses = new double[capacity];
            separations = new double[capacity];
            firstBodies = new int[capacity];
            secondBodies = new int[capacity];
            colours = new int[capacity];
        }
        int n = 0;
        for (int row = 0; row < rows.count; row++) {
            int a = rows.bodyA[row];
            for (int p = 0; p < rows.pointCount[row]; p++, n++) {
                int at = ContactStore.POINTS * row + p;
                points[3 * n] = bodies.positionX[a] + rows.anchorAX(at);
                points[3 * n + 1] = bodies.positionY[a] + rows.anchorAY(at);
                points[3 * n + 2] = bodies.positionZ[a] + rows.anchorAZ(at);
                normals[3 * n] = rows.normalX(row);
                normals[3 * n + 1] = rows.normalY(row);
                normals[3 * n + 2] = rows.normalZ(row);
                impulses[n] = rows.totalNormalImpulse[at];
                separations[n] = rows.separation[at];
                firstBodies[n] = bodyOfSlot[a];
                secondBodies[n] = bodyOfSlot[rows.bodyB[row]];
                colours[n] = colourOfRow[row];
            }
        }
        pointCount = n;
    }

    private void fillBodies(BodyTable table) {
        BodyStore b = table.bodies;
        if (states.length < b.slotCount) {
            int capacity = b.slotCount + (b.slotCount >> 1);
            centres = new double[3 * capacity];
            velocities = new double[3 * capacity];
            boxes = new double[6 * capacity];
            states = new byte[capacity];
            entities = new long[capacity];
            islands = new int[capacity];
            bodyOfSlot = new int[capacity];
            awakeSlots = new int[capacity];
        }
        double[] fat = table.broadPhase.fatBoxes();
        int n = 0;
        for (int s = 0; s < b.slotCount; s++) {
            bodyOfSlot[s] = NONE;
            if (b.kind[s] == BodyStore.FREE) {
                continue;
            }
            bodyOfSlot[s] = n;
            entities[n] = b.entity[s];
            states[n] =
                    switch (b.kind[s]) {
                        case BodyStore.STATIC -> FIXED;
                        case BodyStore.KINEMATIC -> KINEMATIC;
                        case BodyStore.ASLEEP -> ASLEEP;
                        default -> AWAKE;
                    };
            centres[3 * n] = b.positionX[s];
            centres[3 * n + 1] = b.positionY[s];
            centres[3 * n + 2] = b.positionZ[s];
            velocities[3 * n] = b.velocityX[s];
            velocities[3 * n + 1] = b.velocityY[s];
            velocities[3 * n + 2] = b.velocityZ[s];
            Arrays.fill(boxes, 6 * n, 6 * n + 6, 0);
            for (int c = b.collider[s]; c != ColliderStore.NONE; c = table.colliders.next[c]) {
                if (table.broadPhase.contains(c)) {
                    join(fat, 6 * c, 6 * n, c == b.collider[s]);
                }
            }
            n++;
        }
        bodyCount = n;
    }

    /** The box around two boxes, or the first one. */
    private void join(double[] fat, int from, int to, boolean first) {
        for (int i = 0; i < 3; i++) {
            double low = fat[from + i];
            double high = fat[from + i + 3];
            boxes[to + i] = first ? low : Math.min(low, boxes[to + i]);
            boxes[to + i + 3] = first ? high : Math.max(high, boxes[to + i + 3]);
        }
    }

    private void fillIslands(BodyTable table, EdgeSource[] edges) {
        links.ensureSlots(table.bodies.slotCount);
        int awake = 0;
        for (int s = 0; s < table.bodies.slotCount; s++) {
            if (table.bodies.kind[s] == BodyStore.DYNAMIC) {
                awakeSlots[awake++] = s;
            }
        }
        links.build(table.bodies, edges, awakeSlots, awake);
        for (int s = 0; s < table.bodies.slotCount; s++) {
            int body = bodyOfSlot[s];
            if (body != NONE) {
                islands[body] =
                        switch (states[body]) {
                            case FIXED, KINEMATIC -> NONE;
                            case ASLEEP -> table.sleepers.islandOf(s);
                            default -> links.root(s);
                        };
            }
        }
    }

    /**
     * How many contact points there are.
     *
     * @return at least 0
     */
    public int pointCount() {
        return pointCount;
    }

    /**
     * Where the contact points are: midway between the surfaces at the start of the step, carried
     * along with the centre of mass of the first body.
     *
     * @return x, y, z each, m
     */
    public double[] points() {
        return points;
    }

    /**
     * The direction from the first body of each point to the second.
     *
     * @return x, y, z each, unit vectors
     */
    public double[] normals() {
        return normals;
    }

    /**
     * What the bodies pushed each other with at each point.
     *
     * @return N s, summed over the step
     */
    public double[] impulses() {
        return impulses;
    }

    /**
     * The distance of the surfaces at each point, at the start of the step.
     *
     * @return m, negative where they overlap
     */
    public double[] separations() {
        return separations;
    }

    /**
     * The first body of each point.
     *
     * @return places in the list of bodies
     */
    public int[] firstBodies() {
        return firstBodies;
    }

    /**
     * The second body of each point.
     *
     * @return places in the list of bodies
     */
    public int[] secondBodies() {
        return secondBodies;
    }

    /**
     * The colour of each point's contact in the constraint graph, in the order in which colours are
     * solved: no two contacts of a colour move the same body.
     *
     * @return colours from 0, or {@link #NONE} where nothing was solved: the bodies sleep
     */
    public int[] colours() {
        return colours;
    }

    /**
     * The deepest overlap at any point.
     *
     * @return m, at least 0
     */
    public double deepestOverlap() {
        double deepest = 0;
        for (int i = 0; i < pointCount; i++) {
            deepest = Math.max(deepest, -separations[i]);
        }
        return deepest;
    }

    /**
     * How many bodies there are, fixed ones included.
     *
     * @return at least 0
     */
    public int bodyCount() {
        return bodyCount;
    }

    /**
     * The entity of each body.
     *
     * @return entities
     */
    public long[] entities() {
        return entities;
    }

    /**
     * What each body does.
     *
     * @return {@link #FIXED}, {@link #AWAKE}, {@link #ASLEEP} or {@link #KINEMATIC} each
     */
    public byte[] states() {
        return states;
    }

    /**
     * The island of each body: those that hang together by contacts have equal numbers.
     *
     * @return numbers without an order; {@link #NONE} for a fixed or kinematic body
     */
    public int[] islands() {
        return islands;
    }

    /**
     * The centres of mass.
     *
     * @return x, y, z each, m
     */
    public double[] centres() {
        return centres;
    }

    /**
     * The velocities of the centres of mass.
     *
     * @return x, y, z each, m/s
     */
    public double[] velocities() {
        return velocities;
    }

    /**
     * The boxes by which the broad phase finds neighbours, margin included.
     *
     * @return minX, minY, minZ, maxX, maxY, maxZ each, m; six zeros for a body that was never
     *     stepped
     */
    public double[] boxes() {
        return boxes;
    }
}
