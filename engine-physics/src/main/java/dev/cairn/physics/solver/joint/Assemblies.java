package dev.cairn.physics.solver.joint;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.row.EdgeList;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntUnaryOperator;

/**
 * The assemblies of a tick: which joints hang together by bodies that move.
 *
 * <p>Found anew when the joints that are solved, or their bodies, are others than in the last tick;
 * what touches what does not matter. Simulation thread; allocates when they change.
 */
public final class Assemblies implements Stateful {
    /** Of the joints, among the kinds of the edges; 0 if there is no such kind. */
    private final int kind;

    public final JointStore store;

    private final Islands islands = new Islands();
    private final List<Assembly> all = new ArrayList<>();

    /** By joint: its assembly, or -1. */
    private int[] of = {};

    /** By slot: its assembly, or -1. */
    private int[] ofBody = {};

    /** See {@link #touch}. */
    private static final int LOOKS = 3;

    /**
     * Contacts with bodies in no assembly from which on sweeps and joints take turns: all points
     * are coupled with all, so time and room grow with the square.
     */
    private static final int MOST_TOUCHES = 64;

    private static final int NONE = -1;

    /** Assemblies are solved side by side: a body that two of them move would be written twice. */
    private static final int SEVERAL = -2;

    /** By slot of a body in no assembly: the one that it touches. */
    private int[] touched = {};

    /** By edge of the last tick: joint, bodies. */
    private int[] seen = {};

    private int seenCount;

    /** What assemblies remember, one after the other, in a state; see {@link Assembly#remember}. */
    private double[] memory = {};

    private int memoryCount;
    private long revision = -1;

    /** Whether another state was restored since they were found. */
    private boolean renewed;

    /** By batch: its first assembly in {@link #byBatch}; one more for the end. */
    private int[] firstOfBatch = new int[1];

    private int[] byBatch = {};

    /** Assemblies of the joints among the kinds of a list, if there are any. */
    public Assemblies(EdgeList list) {
        int found = 0;
        JointStore joints = new JointStore();
        for (int k = 0; k < list.kinds.length; k++) {
            if (list.kinds[k].source() instanceof JointStore s) {
                found = k + 1;
                joints = s;
            }
        }
        kind = found;
        store = joints;
    }

    /** How many there are. */
    public int count() {
        return all.size();
    }

    /** Whether a body is in one; bodies that came later are in none. */
    public boolean binds(int slot) {
        return !all.isEmpty() && slot < ofBody.length && ofBody[slot] >= 0;
    }

    /**
     * Brings them up to date with the edges of a tick; whether they are others than in the last.
     */
    public boolean update(EdgeList list, int slots) {
        if (kind == 0) {
            return false;
        }
        int from = list.first[kind];
        int to = list.first[kind + 1];
        boolean same = isSame(list, from, to);
        if (same && !renewed) {
            return false;
        }
        renewed = false;
        if (seen.length < 3 * (to - from)) {
            seen = new int[3 * (to - from) + 3 * (to - from) / 2];
        }
        for (int m = from; m < to; m++) {
            int at = 3 * (m - from);
            seen[at] = list.source[m];
            seen[at + 1] = list.slotA[m];
            seen[at + 2] = list.slotB[m];
        }
        seenCount = to - from;
        revision = store.revision;
        find(list, from, to, slots);
        if (same) {
            spread(); // they are those of a state that was restored
        }
        return !same;
    }

    /**
     * Notes which contacts of a list are between an assembly and static bodies, or what moves by
     * itself and touches no other assembly.
     */
    public void stand(EdgeList list) {
        for (int a = 0; a < all.size(); a++) {
            all.get(a).standCount = 0;
            all.get(a).touchCount = 0;
            all.get(a).touchesFixed = false;
        }
        for (int m = 0; m < list.contacts && !all.isEmpty(); m++) {
            int slot = list.mover(m);
            if (list.isBetweenMovers(m) || !binds(slot)) {
                continue;
            }
            all.get(ofBody[slot]).touchesFixed = true;
            if (isSolvedWith(list, m, slot)) {
                all.get(ofBody[slot]).stand(m);
            }
        }
        for (int look = 0; look < LOOKS && !all.isEmpty(); look++) {
            for (int m = 0; m < list.contacts; m++) {
                if (list.isBetweenMovers(m) && binds(list.slotA[m]) != binds(list.slotB[m])) {
                    touch(list, m, look);
                }
            }
        }
        for (int a = 0; a < all.size(); a++) {
            if (all.get(a).touchCount - all.get(a).standCount > MOST_TOUCHES) {
                all.get(a).touchCount = all.get(a).standCount;
            }
        }
    }

    private boolean isSolvedWith(EdgeList list, int m, int slot) {
        return !list.isSingle[m] && binds(slot) && all.get(ofBody[slot]).hasFactors;
    }

    /**
     * A contact of an assembly with a body that is in none. The first look forgets what that body
     * touched, the second finds the assembly or that there are several, the last notes the contact.
     */
    private void touch(EdgeList list, int m, int look) {
        int bound = binds(list.slotA[m]) ? list.slotA[m] : list.slotB[m];
        int free = bound == list.slotA[m] ? list.slotB[m] : list.slotA[m];
        int a = ofBody[bound];
        if (look == 0) {
            if (free >= touched.length) {
                touched = Arrays.copyOf(touched, 2 * free + 2);
            }
            touched[free] = NONE;
        } else if (look == 1) {
            touched[free] = touched[free] == NONE || touched[free] == a ? a : SEVERAL;
        } else if (touched[free] == a && isSolvedWith(list, m, bound)) {
            all.get(a).touch(m);
        }
    }

    /** Whose joints were seen in the last tick; what follows from it is found anew. */
    @Override
    public void state(StateVisitor s) {
        s.section("assemblies", this);
        seenCount = s.value("seenCount", seenCount);
        revision = s.value("revision", revision);
        seen = s.array("seen", seen, 3 * seenCount);
        if (!s.isRestoring() && !renewed) {
            gather();
        }
        memoryCount = s.value("memoryCount", memoryCount);
        memory = s.array("memory", memory, memoryCount);
        renewed |= s.isRestoring();
    }

    private void gather() {
        memoryCount = 0;
        for (int i = 0; i < all.size(); i++) { // an iterator would be garbage
            Assembly assembly = all.get(i);
            int n = assembly.memories();
            if (memoryCount + n > memory.length) {
                memory = Arrays.copyOf(memory, 2 * (memoryCount + n));
            }
            assembly.remember(memory, memoryCount);
            memoryCount += n;
        }
    }

    private void spread() {
        int from = 0;
        for (Assembly assembly : all) {
            if (from + assembly.memories() <= memoryCount) {
                assembly.recall(memory, from);
            }
            from += assembly.memories();
        }
    }

    private boolean isSame(EdgeList list, int from, int to) {
        if (revision != store.revision || seenCount != to - from) {
            return false;
        }
        for (int m = from; m < to; m++) {
            int at = 3 * (m - from);
            if (seen[at] != list.source[m]
                    || seen[at + 1] != list.slotA[m]
                    || seen[at + 2] != list.slotB[m]) {
                return false;
            }
        }
        return true;
    }

    private void find(EdgeList list, int from, int to, int slots) {
        all.clear();
        if (of.length < store.count) {
            of = new int[store.isThere.length];
        }
        if (ofBody.length < slots) {
            ofBody = new int[slots + slots / 2];
        }
        Arrays.fill(of, -1);
        Arrays.fill(ofBody, -1);
        int[] slot = new int[2 * (to - from)];
        int bodies = 0;
        for (int m = from; m < to; m++) {
            for (int side = 0; side < 2; side++) {
                int s = side == 0 ? list.slotA[m] : list.slotB[m];
                if (s >= 0 && ofBody[s] == -1) {
                    ofBody[s] = -2;
                    slot[bodies++] = s;
                }
            }
        }
        Arrays.sort(slot, 0, bodies);
        islands.ensureSlots(ofBody.length);
        islands.begin(slot, bodies);
        for (int m = from; m < to; m++) {
            if (list.isBetweenMovers(m)) {
                islands.join(list.slotA[m], list.slotB[m]);
            }
        }
        int count = 0;
        for (int k = 0; k < bodies; k++) {
            int root = islands.root(slot[k]);
            ofBody[slot[k]] = root == slot[k] ? count++ : ofBody[root];
        }
        make(list, from, to, slot, bodies, count);
    }

    private void make(EdgeList list, int from, int to, int[] slot, int bodies, int count) {
        int[] bodiesOf = new int[count];
        int[] jointsOf = new int[count];
        int[] local = new int[ofBody.length];
        for (int k = 0; k < bodies; k++) {
            local[slot[k]] = bodiesOf[ofBody[slot[k]]]++;
        }
        for (int m = from; m < to; m++) {
            int a = ofBody[list.mover(m)];
            of[list.source[m]] = a;
            jointsOf[a]++;
        }
        int[][] body = new int[count][];
        int[][] joint = new int[count][];
        int[][] end = new int[count][];
        int[][] rows = new int[count][];
        for (int a = 0; a < count; a++) {
            body[a] = new int[bodiesOf[a]];
            joint[a] = new int[jointsOf[a]];
            end[a] = new int[2 * jointsOf[a]];
            rows[a] = new int[jointsOf[a]];
            jointsOf[a] = 0;
        }
        for (int k = 0; k < bodies; k++) {
            body[ofBody[slot[k]]][local[slot[k]]] = slot[k];
        }
        for (int m = from; m < to; m++) {
            int a = of[list.source[m]];
            int k = jointsOf[a]++;
            joint[a][k] = list.source[m];
            end[a][2 * k] = list.slotA[m] < 0 ? -1 : local[list.slotA[m]];
            end[a][2 * k + 1] = list.slotB[m] < 0 ? -1 : local[list.slotB[m]];
            rows[a][k] = store.rows[list.source[m]];
        }
        for (int a = 0; a < count; a++) {
            Assembly assembly = assembly(body[a], joint[a], end[a], rows[a]);
            for (int j : joint[a]) {
                for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
                    assembly.isRigid &= store.role[r] == JointStore.LOCK;
                }
            }
            all.add(assembly);
        }
    }

    private Assembly assembly(int[] body, int[] joint, int[] end, int[] rows) {
        double[] arm = new double[6 * joint.length];
        double[] axes = new double[9 * joint.length];
        double[] own = new double[9];
        boolean isPoints = true;
        for (int k = 0; k < joint.length; k++) {
            int j = joint[k];
            int f = JointStore.FRAME * j;
            System.arraycopy(store.frame, f, arm, 6 * k, 3);
            System.arraycopy(store.frame, f + 7, arm, 6 * k + 3, 3);
            JointMath.axes(store.frame, f + 3, own);
            isPoints &= rows[k] == 3;
            int first = store.firstRow[j];
            for (int r = 0; r < rows[k] && isPoints; r++) {
                int axis = store.law[first + r] - JointStore.SLIDE;
                isPoints = store.role[first + r] == JointStore.LOCK && axis >= 0 && axis < 3;
                isPoints &= store.target[first + r] == 0;
                if (isPoints) {
                    System.arraycopy(own, 3 * axis, axes, 9 * k + 3 * r, 3);
                }
            }
        }
        return new Assembly(body, joint, end, rows, isPoints, arm, axes);
    }

    /**
     * Lists the assemblies by batch.
     *
     * @param batchOfBody tells the batch of a slot
     * @param batches how many there are
     */
    public void sort(IntUnaryOperator batchOfBody, int batches) {
        if (all.isEmpty()) {
            return;
        }
        if (firstOfBatch.length < batches + 1) {
            firstOfBatch = new int[batches + batches / 2 + 2];
        }
        if (byBatch.length < all.size()) {
            byBatch = new int[all.size() + all.size() / 2];
        }
        Arrays.fill(firstOfBatch, 0, batches + 1, 0);
        for (int a = 0; a < all.size(); a++) {
            firstOfBatch[batch(batchOfBody, a) + 1]++;
        }
        for (int b = 0; b < batches; b++) {
            firstOfBatch[b + 1] += firstOfBatch[b];
        }
        for (int a = 0; a < all.size(); a++) {
            byBatch[firstOfBatch[batch(batchOfBody, a)]++] = a;
        }
        System.arraycopy(firstOfBatch, 0, firstOfBatch, 1, batches);
        firstOfBatch[0] = 0;
    }

    private int batch(IntUnaryOperator batchOfBody, int a) {
        return batchOfBody.applyAsInt(all.get(a).body[0]);
    }

    /** The first of the assemblies of a batch, those of the next follow. */
    public int first(int batch) {
        return all.isEmpty() ? 0 : firstOfBatch[batch];
    }

    /** One of them. */
    public Assembly at(int i) {
        return all.get(byBatch[i]);
    }
}
