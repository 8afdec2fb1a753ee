package dev.cairn.physics.joint;

import dev.cairn.core.ecs.World;
import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.Curve;
import dev.cairn.physics.internal.JointStore;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The joints of a world. {@code PhysicsWorld.joints} gives it.
 *
 * <p>Simulation thread, between steps. Adding and removing allocates, all else does not unless it
 * says so.
 */
public final class Joints implements Stateful {
    /** What joints need of the world that they are in. */
    public interface Host {
        /**
         * The slot of a body.
         *
         * @param name of the argument, for the message
         * @param body any
         * @return its slot
         */
        int slotOf(String name, Jointed body);

        /**
         * Whether a body is in its world.
         *
         * @param slot of the body
         * @param entity that it has
         * @return false once it was removed
         */
        boolean isAlive(int slot, long entity);

        /**
         * Wakes a body with all that hangs on it.
         *
         * @param slot of the body
         */
        void wake(int slot);

        /**
         * Two bodies shall not collide, for one reason more.
         *
         * @param a slot of a body
         * @param b slot of another one
         */
        void apart(int a, int b);

        /**
         * One reason of {@link #apart} is gone.
         *
         * @param a slot of a body
         * @param b slot of another one
         */
        void together(int a, int b);

        /**
         * How many bodies were ever added, in this run of the program.
         *
         * @return a count that only grows
         */
        long bodiesBorn();

        /**
         * Throws if a step runs or the world is closed.
         *
         * @param call name of the method, for the message
         */
        void requireBetweenSteps(String call);
    }

    final JointStore store;
    final BodyStore bodies;
    final Host host;
    private JointRef[] refs = new JointRef[0];

    /** Room to restore them, and for the numbers of those that broke. */
    private JointRef[] savedRefs = new JointRef[0];

    private int[] brokenNumbers = {};

    /** By joint: whether it keeps its bodies from colliding. */
    private boolean[] isApart = {};

    /** Room to save the settings of all axes. */
    private double[] settings = {};

    final JointValues values = new JointValues();
    final JointFrames frames = new JointFrames();
    private final double[] frame = new double[JointStore.FRAME];
    private final Vector3d point = new Vector3d();
    private final List<JointRef> broken = new ArrayList<>();
    private final JointEntities entities;

    /**
     * Made by the world.
     *
     * @param store of the joints
     * @param bodies of the world
     * @param host the world
     * @param ecs the entities of the world
     */
    @SuppressWarnings("exports") // only the world, which is in this module, makes one
    public Joints(JointStore store, BodyStore bodies, Host host, World ecs) {
        this.store = store;
        this.bodies = bodies;
        this.host = host;
        entities = new JointEntities(this, ecs);
    }

    /**
     * Adds a joint, as {@code PhysicsWorld.add} does.
     *
     * @param joint what it is like
     * @return the joint
     * @throws IllegalArgumentException if both bodies are one, neither moves, or it has no place
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public JointRef add(Joint joint) {
        Checks.notNull("joint", joint);
        host.requireBetweenSteps("add");
        return make(joint, joint.a, joint.b, JointRef.NO_ENTITY);
    }

    /**
     * Adds a joint.
     *
     * @param entity that it is, or {@link JointRef#NO_ENTITY}
     */
    JointRef make(Joint joint, Jointed bodyA, Jointed bodyB, long entity) {
        int a = host.slotOf("a", bodyA);
        int b = host.slotOf("b", bodyB);
        check(joint, a, b);
        JointRef ref = new JointRef(this, joint, bodyA.entity(), bodyB.entity(), entity);
        RowList rows = new RowList();
        double distance = frames.distance(joint, bodies, a, b);
        ref.resolveLength(
                joint.kind.equals("pulley") ? frames.rope(joint, bodies, a, b) : distance);
        rows.compile(ref.axes);
        frames.write(joint, bodies, a, b, frame, 0, ref.parameters);
        Curve curve = joint.hasCurve() ? frames.curve(joint, bodies, a) : null;
        double start = 0;
        if (curve != null) {
            Vector3d from = frames.apart(joint, bodies, a, b);
            start = curve.nearest(from.x, from.y, from.z);
        }
        int j = store.add(rows.count);
        store.bodyA[j] = a;
        store.bodyB[j] = b;
        store.collides[j] = joint.collides;
        store.isRound[j] = joint.isRound;
        store.breakForce[j] = joint.breakForce;
        store.breakTorque[j] = joint.breakTorque;
        int p = JointStore.PARAMETERS * j;
        if (curve == null) {
            System.arraycopy(ref.parameters, 0, store.parameter, p, JointStore.PARAMETERS);
        } else {
            store.curve[j] = curve;
            store.parameter[p] = start;
            Arrays.fill(store.parameter, p + 1, p + JointStore.PARAMETERS, 0.0);
        }
        System.arraycopy(frame, 0, store.frame, JointStore.FRAME * j, JointStore.FRAME);
        rows.write(store, j);
        if (refs.length <= j) {
            refs = Arrays.copyOf(refs, store.isThere.length);
            isApart = Arrays.copyOf(isApart, store.isThere.length);
        }
        isApart[j] = false;
        refs[j] = ref;
        ref.index = j;
        ref.stamp = store.stamp[j];
        entities.made(ref);
        separate(j);
        wake(j);
        return ref;
    }

    /**
     * How a reference to a joint becomes bytes; for {@code PhysicsWorld.codecs}.
     *
     * @return a codec
     */
    public static StateCodec<JointRef> codec() {
        return JointRef.CODEC;
    }

    /**
     * How the curve of a path becomes bytes; for {@code PhysicsWorld.codecs}.
     *
     * @return a codec
     */
    public static StateCodec<?> curveCodec() {
        return Curve.CODEC;
    }

    /**
     * What users know of the joints, beside the store. A reference that the world has given stays
     * the one to its joint.
     */
    @Override
    public void state(StateVisitor s) {
        s.section("jointList", this);
        int count = store.count;
        JointRef[] saved = s.array("refs", s.isRestoring() ? savedRefs : refs, count);
        savedRefs = s.isRestoring() ? saved : savedRefs;
        isApart = s.array("isApart", isApart, 0, count, store.isThere.length, true);
        int numbers = count * Joint.AXES * AxisSettings.NUMBERS;
        if (settings.length < numbers) {
            settings = new double[numbers + numbers / 2];
        }
        if (!s.isRestoring()) {
            exchange(false);
        }
        settings = s.array("settings", settings, numbers);
        int gone = s.value("brokenCount", broken.size());
        if (!s.isRestoring()) {
            numberBroken();
        }
        brokenNumbers = s.array("broken", brokenNumbers, gone);
        if (s.isRestoring()) {
            own(saved, count);
            exchange(true);
            broken.clear();
            for (int i = 0; i < gone; i++) {
                broken.add(refs[brokenNumbers[i]]);
            }
        }
        entities.state(s);
    }

    private void numberBroken() {
        if (brokenNumbers.length < broken.size()) {
            brokenNumbers = new int[2 * broken.size()];
        }
        for (int i = 0; i < broken.size(); i++) {
            brokenNumbers[i] = broken.get(i).index;
        }
    }

    @SuppressWarnings("NullAway") // a row without a joint has no reference
    private void own(JointRef[] saved, int count) {
        if (refs.length < Math.max(count, store.isThere.length)) {
            refs = Arrays.copyOf(refs, Math.max(count, store.isThere.length));
        }
        for (int j = 0; j < refs.length; j++) {
            JointRef now = refs[j];
            JointRef then = j < count ? saved[j] : null;
            if (then == null || then.isOf(this)) {
                refs[j] = then;
            } else if (now == null || !now.isTwin(then)) {
                refs[j] = new JointRef(this, then);
            }
        }
    }

    /** Settings of all axes: from the references to numbers, or back. */
    private void exchange(boolean back) {
        for (int j = 0; j < store.count; j++) {
            for (int k = 0; k < Joint.AXES && refs[j] != null; k++) {
                int at = (j * Joint.AXES + k) * AxisSettings.NUMBERS;
                refs[j].axes[k].exchange(settings, at, back);
            }
        }
    }

    private void check(Joint joint, int a, int b) {
        if (a == b) {
            throw new IllegalArgumentException(
                    joint.kind
                            + " joint"
                            + named(joint)
                            + " has one body twice; give it two bodies");
        }
        if (!moves(a) && !moves(b)) {
            throw new IllegalArgumentException(
                    joint.kind
                            + " joint"
                            + named(joint)
                            + " is between two fixed bodies, which nothing moves; make one of them"
                            + " dynamic");
        }
        if (!joint.isPlaced && !joint.isDistance() && !joint.hasCurve()) {
            throw new IllegalArgumentException(
                    joint.kind
                            + " joint"
                            + named(joint)
                            + " has no place; call .at(x, y, z) or .anchors(..)");
        }
    }

    private boolean moves(int slot) {
        return bodies.kind[slot] == BodyStore.DYNAMIC || bodies.kind[slot] == BodyStore.ASLEEP;
    }

    private static String named(Joint joint) {
        return joint.name.isEmpty() ? "" : " '" + joint.name + "'";
    }

    /**
     * How many joints there are.
     *
     * @return the number, those that are off or broken included
     */
    public int count() {
        return list(null);
    }

    /**
     * All joints. Allocates.
     *
     * @return a new list, in the order of their numbers
     */
    public List<JointRef> all() {
        List<JointRef> list = new ArrayList<>();
        list(list);
        return list;
    }

    /** Whether there is a joint of the number. The store forgets those of removed bodies later. */
    boolean isThere(int j) {
        return store.isThere[j]
                && host.isAlive(store.bodyA[j], refs[j].entityA())
                && host.isAlive(store.bodyB[j], refs[j].entityB())
                && (refs[j].entity() == JointRef.NO_ENTITY || entities.isLinked(refs[j].entity()));
    }

    private int list(@Nullable List<JointRef> into) {
        int n = 0;
        for (int j = 0; j < store.count; j++) {
            if (isThere(j)) {
                n++;
                if (into != null) {
                    into.add(refs[j]);
                }
            }
        }
        return n;
    }

    /**
     * How many joints broke in the last step.
     *
     * @return at least 0
     */
    public int brokenCount() {
        return broken.size();
    }

    /**
     * A joint that broke in the last step. It is off from then on, and not removed.
     *
     * @param index 0 to brokenCount - 1, in the order of their numbers
     * @return the joint
     */
    public JointRef broken(int index) {
        return broken.get(index);
    }

    /**
     * How many joints ended since the step before because one of their bodies went. {@link
     * JointRef#remove} and the deletion of a joint's own entity are not counted.
     *
     * @return at least 0
     */
    public int lostCount() {
        return entities.lost.size();
    }

    /**
     * A joint that ended because one of its bodies went.
     *
     * @param index 0 to lostCount - 1, in the order of their numbers
     * @return the joint; it is no longer alive, but tells its name, kind, bodies and entity
     */
    public JointRef lost(int index) {
        return entities.lost.get(index);
    }

    /**
     * The joint of an entity that was made by {@link NewJoint}.
     *
     * @param entity any
     * @return the joint, or null if the entity is none
     */
    public @Nullable JointRef of(long entity) {
        int j = entities.number(entity);
        return j >= 0 && j < refs.length && refs[j] != null && refs[j].entity() == entity
                ? refs[j]
                : null;
    }

    /** Called by the world after a step, when bodies that were asked for are there. */
    public void endStep() {
        entities.endStep(refs);
    }

    /** A user takes a joint out. */
    void remove(int j) {
        JointRef ref = refs[j];
        wake(j);
        store.remove(j);
        separate(j);
        entities.removed(ref);
    }

    /**
     * Copies what can be drawn of the joints. Allocates only while their number grows.
     *
     * @param into receives it
     */
    public void capture(JointData into) {
        Checks.notNull("into", into).fill(this, refs);
    }

    /** Called by the world at the end of a step. */
    public void afterStep() {
        broken.clear();
        for (int j = 0; j < store.count; j++) {
            boolean breaks = load(j, 0) > store.breakForce[j] || load(j, 3) > store.breakTorque[j];
            if (breaks && store.isEnabled[j]) {
                store.isEnabled[j] = false;
                store.revision++;
                separate(j);
                broken.add(refs[j]);
            }
        }
    }

    /** Length of a force, or from 3 on of a torque, of a joint. */
    double load(int j, int from) {
        double[] r = store.reaction;
        int k = 6 * j + from;
        return Math.sqrt(r[k] * r[k] + r[k + 1] * r[k + 1] + r[k + 2] * r[k + 2]);
    }

    /** Keeps the bodies of a joint from colliding if they should not, now that it has changed. */
    void separate(int j) {
        boolean wanted = store.isThere[j] && store.isEnabled[j] && !store.collides[j];
        if (wanted && !isApart[j]) {
            host.apart(store.bodyA[j], store.bodyB[j]);
        } else if (!wanted && isApart[j]) {
            host.together(store.bodyA[j], store.bodyB[j]);
        }
        isApart[j] = wanted;
    }

    /** Moves the point of A. */
    void moveTo(int j, double x, double y, double z) {
        int a = store.bodyA[j];
        point.set(x - bodies.positionX[a], y - bodies.positionY[a], z - bodies.positionZ[a]);
        frames.write(bodies, a, point, store.frame, JointStore.FRAME * j);
        wake(j);
    }

    void wake(int j) {
        host.wake(store.bodyA[j]);
        host.wake(store.bodyB[j]);
    }
}
