package dev.cairn.physics.solver.graph;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.solver.body.DrivenSides;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.joint.Assemblies;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.EdgePlaces;

import java.util.Arrays;

/**
 * Lists the edges that are solved, of contacts and of all other kinds, and gives them batches,
 * colours and places.
 *
 * <p>Most ticks have the edges of the tick before: then all of it still holds, and a comparison is
 * what is paid; where only presses what did not, the batches hold, and the colours are made anew.
 * So all persists, and yet is a function of the present edges alone. Simulation thread, the look at
 * contacts in blocks; allocates only when a store has grown.
 */
public final class Collector implements Stateful {
    private static final int CONTACTS_PER_BLOCK = 1024;

    private final Colouring colouring;
    private final Batches batches;
    private final EdgeFacts facts = new EdgeFacts();
    private final PairOrder order = new PairOrder();

    /** Kinematic bodies that move, of this tick. */
    public final DrivenSides sides = new DrivenSides();

    /** What is carried evenly is solved as if what carries it stood still. */
    public final ReferenceFrames frames = new ReferenceFrames();

    /** Those of this tick. */
    public final Assemblies assemblies;

    /** Those of this tick. */
    public final BouncingContacts bouncing = new BouncingContacts();

    /** By edge of the list: whether it is a contact without impulse; whether it bounces. */
    private boolean[] cold = {};

    private boolean[] bounces = {};

    /** By edge of the list: what tells it from others of its two bodies. */
    private long[] part = {};

    /** By kind: the first of its edges among those that follow; one more for the end. */
    private int[] firstListed = {};

    /**
     * By edge of the last tick, solved or not: its row in the store; its place in the list or -1.
     */
    private int[] listed = {};

    private int[] at = {};

    private final BlockJob look = this::look;
    private BodyStore bodies = new BodyStore();
    private ContactStore contacts = new ContactStore();
    private EdgeList list = new EdgeList();
    private final ColourCheck check = new ColourCheck();
    private int slots;
    private int workers;
    private boolean stacked;

    /**
     * Whether the edges of this tick are those of the last one: which bodies they bind, and what
     * colours follow.
     */
    private boolean sameList;

    private boolean sameBodies;

    /** Whether another state was restored since the last tick. */
    private boolean renewed;

    private boolean sameColours;
    private boolean sameVariants;

    /** Whether bodies on one contact are told apart. */
    private final boolean guides;

    /**
     * A collector that fills the given parts.
     *
     * @param guides whether a body on nothing but one contact is guided by it
     */
    public Collector(Colouring colouring, Batches batches, Assemblies assemblies, boolean guides) {
        this.assemblies = assemblies;
        this.guides = guides;
        this.colouring = colouring;
        this.batches = batches;
    }

    /**
     * Brings rows, guides, batches and colours up to date.
     *
     * @param guide receives which bodies have edges, see {@link SolverBodies#guide}
     * @param workerCount workers that may work at batches
     * @param floatsFrom rows of an island that are floats if there are as many
     * @param jobs runs the look at contacts
     * @return whether any two dynamic bodies touch
     */
    public boolean run(
            BodyStore bodyStore,
            ContactStore contactStore,
            EdgeList edges,
            int[] guide,
            int workerCount,
            int floatsFrom,
            Jobs jobs) {
        bodies = bodyStore;
        contacts = contactStore;
        list = edges;
        ensureEdges();
        sameColours = true;
        sameVariants = true;
        sameList = !renewed && hasSameKinds();
        jobs.run(look, Blocks.count(contacts.activeCount, CONTACTS_PER_BLOCK));
        sameBodies = sameList || list();
        sameBodies &= slots == bodies.slotCount;
        sameBodies &= workers == workerCount || renewed;
        sameBodies &= !assemblies.update(list, bodies.slotCount);
        boolean isAnew = !sameBodies || renewed;
        renewed = false;
        if (isAnew) {
            slots = bodies.slotCount;
            workers = workerCount;
            bind(guide);
            batches.cut(list, slots, guide, workerCount, floatsFrom, assemblies);
            listSides();
            assemblies.stand(list);
        }
        if (!sameList || isAnew) {
            listBouncers();
        }
        if (isAnew || !sameColours) {
            colour();
        }
        if (isAnew || !sameColours || !sameVariants) {
            colouring.finish(list, batches);
            link();
            assert check.areDisjoint(colouring, list, colouring.firstColour[batches.divider], slots)
                    : "a colour has two edges of one body";
        }
        return stacked;
    }

    /** The edges of the last tick; all that follows from them is made anew. */
    @Override
    public void state(StateVisitor s) {
        s.section("collector", this);
        slots = s.value("slots", slots);
        renewed |= s.isRestoring();
    }

    /** Whether a body touches one that is much heavier, see {@link SolverBodies#isLight}. */
    public boolean hasLight() {
        return facts.hasLight;
    }

    /** Whether the edges and their bodies are those of the tick before. */
    public boolean isSame() {
        return sameBodies;
    }

    private EdgeSource source(int kind) {
        return kind == 0 ? contacts : list.kinds[kind - 1].source();
    }

    private void ensureEdges() {
        int wanted = 0;
        for (int k = 0; k <= list.kinds.length; k++) {
            wanted += source(k).capacity();
        }
        list.ensureCapacity(wanted);
        int n = list.source.length;
        if (cold.length < n) {
            cold = Arrays.copyOf(cold, n);
            bounces = Arrays.copyOf(bounces, n);
            part = Arrays.copyOf(part, n);
            listed = Arrays.copyOf(listed, n);
            at = Arrays.copyOf(at, n);
        }
        facts.ensureCapacity(n);
        facts.hasLight = false;
        facts.hasParts = contacts.compounds || contacts.grouped;
        if (firstListed.length < list.first.length) {
            firstListed = new int[list.first.length];
        }
    }

    /** Whether there are as many edges as in the last tick, and those beside contacts the same. */
    private boolean hasSameKinds() {
        for (int k = 0; k <= list.kinds.length; k++) {
            if (source(k).edges() != firstListed[k + 1] - firstListed[k]) {
                return false;
            }
        }
        for (int k = 1; k <= list.kinds.length; k++) {
            EdgeSource edges = source(k);
            for (int i = 0; i < edges.edges(); i++) {
                int e = firstListed[k] + i;
                int a = edges.edgeA(i);
                int slotA = a < 0 ? -1 : mover(a);
                int slotB = a < 0 ? -1 : mover(edges.edgeB(i));
                int m = at[e];
                if (listed[e] != edges.edgeRow(i)
                        || (m < 0
                                ? slotA >= 0 || slotB >= 0
                                : list.slotA[m] != slotA
                                        || list.slotB[m] != slotB
                                        || list.carrier[m] != carrier(a, edges.edgeB(i), false))) {
                    return false;
                }
            }
        }
        return true;
    }

    /** A slot, or -1 for a body that does not move. */
    private int mover(int slot) {
        return bodies.kind[slot] == BodyStore.DYNAMIC ? slot : -1;
    }

    /**
     * Which of two bodies is kinematic and moves, or has a surface that moves along the other's:
     * its slot, or -1. A surface that runs along a floor is, to the solver, a floor that runs.
     */
    private int carrier(int a, int b, boolean isContact) {
        if (bodies.isDriven(a)) {
            return mover(b) >= 0 && frames.has(b) ? -1 : a;
        }
        if (bodies.isDriven(b)) {
            return mover(a) >= 0 && frames.has(a) ? -1 : b;
        }
        boolean runs = isContact && bodies.belts > 0 && (mover(a) < 0) != (mover(b) < 0);
        if (runs && bodies.hasBelt[mover(a) < 0 ? b : a]) {
            return mover(a) < 0 ? a : b;
        }
        return -1;
    }

    /** Reads a range of contacts, and compares it with the list. */
    private void look(int block, int worker) {
        int end = Blocks.end(block, CONTACTS_PER_BLOCK, contacts.activeCount);
        for (int i = Blocks.begin(block, CONTACTS_PER_BLOCK); i < end; i++) {
            facts.readContact(contacts, bodies, i);
            if (sameList && !isAsListed(i)) {
                sameList = false; // by whoever finds one
            }
        }
    }

    /** Compares a contact with the list; its impulse and points are brought up to date. */
    private boolean isAsListed(int i) {
        int n = at[i];
        int bodyA = facts.bodyA[i];
        int bodyB = facts.bodyB[i];
        if (listed[i] != contacts.active[i] || bodyA >= 0 != n >= 0) {
            return false;
        }
        if (n < 0) {
            return true;
        }
        if (list.slotA[n] != mover(bodyA)
                || list.slotB[n] != mover(bodyB)
                || list.carrier[n] != carrier(bodyA, bodyB, true)
                || part[n] != facts.part[i]
                || bounces[n] != facts.bounces[i]) {
            return false;
        }
        list.impulse[n] = facts.impulse[i];
        boolean isCold = list.isBetweenMovers(n) && list.impulse[n] == 0;
        if (cold[n] != isCold) {
            sameColours = false;
            cold[n] = isCold;
        }
        if (list.variant[n] != facts.variant[i]) {
            sameVariants = false;
            list.variant[n] = facts.variant[i];
        }
        return true;
    }

    /** Lists the edges, and which of them bounce; whether they are those of the last tick. */
    private boolean list() {
        boolean same = true;
        int n = 0;
        for (int k = 0; k <= list.kinds.length; k++) {
            EdgeSource edges = source(k);
            same &= list.first[k] == n;
            list.first[k] = n;
            int from = firstListed[k];
            firstListed[k + 1] = from + edges.edges();
            for (int i = 0; i < edges.edges(); i++) {
                listed[from + i] = edges.edgeRow(i);
                at[from + i] = -1;
            }
            if (k > 0) {
                facts.readKind(edges, bodies, from);
            }
            order.sort(facts, from, edges.edges(), bodies.slotCount);
            for (int j = 0; j < order.count; j++, n++) {
                int e = from + order.index[j];
                at[e] = n;
                same &= list(n, e, k == 0);
            }
        }
        same &= list.count == n;
        list.first[list.kinds.length + 1] = n;
        list.count = n;
        list.contacts = list.first[1];
        return same;
    }

    /** Lists an edge; whether it has been there in the last tick. */
    private boolean list(int n, int e, boolean isContact) {
        int row = listed[e];
        int a = mover(facts.bodyA[e]);
        int b = mover(facts.bodyB[e]);
        boolean isCold = isContact && (a | b) >= 0 && facts.impulse[e] == 0;
        int carrier = carrier(facts.bodyA[e], facts.bodyB[e], isContact);
        boolean same = list.source[n] == row && list.slotA[n] == a && list.slotB[n] == b;
        same &= list.carrier[n] == carrier;
        list.carrier[n] = carrier;
        sameColours &= cold[n] == isCold;
        sameVariants &= list.variant[n] == facts.variant[e];
        list.source[n] = row;
        list.slotA[n] = a;
        list.slotB[n] = b;
        list.variant[n] = facts.variant[e];
        list.impulse[n] = facts.impulse[e];
        cold[n] = isCold;
        bounces[n] = facts.bounces[e];
        part[n] = facts.part[e];
        return same;
    }

    /** Each edge with a kinematic body that moves has that to itself. */
    private void listSides() {
        sides.begin(slots, batches.count);
        for (int b = 0; b < batches.count; b++) {
            sides.beginBatch(b);
            for (int k = batches.firstRow[b]; k < batches.firstRow[b + 1]; k++) {
                int m = batches.byBatch[k];
                list.side[m] = list.carrier[m] < 0 ? 0 : sides.add(list.carrier[m], m, b);
            }
        }
    }

    /**
     * Tells which bodies have edges. A body on nothing but one contact with a static body is
     * guided.
     */
    private void bind(int[] guide) {
        boolean[] lost = bodies.lostGuide;
        Arrays.fill(guide, 0, slots, SolverBodies.FREE);
        stacked = false;
        for (int m = 0; m < list.count; m++) {
            int a = list.slotA[m];
            int b = list.slotB[m];
            if ((a | b) >= 0) {
                guide[a] = SolverBodies.BOUND;
                guide[b] = SolverBodies.BOUND;
                stacked |= m < list.contacts;
            } else {
                int i = Math.max(a, b);
                boolean isOnly = guides && guide[i] == SolverBodies.FREE && m < list.contacts;
                isOnly &= list.carrier[m] < 0;
                guide[i] = !isOnly ? SolverBodies.BOUND : lost[i] ? SolverBodies.LOST : m;
            }
        }
        for (int i = 0; i < slots; i++) {
            lost[i] &= guide[i] != SolverBodies.FREE;
        }
    }

    private void listBouncers() {
        bouncing.begin(list.contacts);
        for (int m = 0; m < list.contacts; m++) {
            if (bounces[m]) {
                bouncing.add(m);
            }
        }
        bouncing.sort(list, batches);
    }

    private void colour() {
        colouring.begin(slots, list);
        for (int k = 0; k <= list.kinds.length; k++) {
            int end = list.first[k + 1];
            boolean lockstep = false;
            for (int m = list.first[k]; m < end; m++) {
                lockstep |= batches.isLockstep(m);
            }
            if (list.first[k] < end) {
                colouring.beginKind(k, lockstep);
            }
            for (int m = list.first[k]; m < end; m++) {
                if (list.isBetweenMovers(m)) {
                    colouring.add(m, list.slotA[m], list.slotB[m], cold[m], batches.isLockstep(m));
                } else {
                    colouring.addFixed(m, list.mover(m));
                }
            }
        }
    }

    private void link() {
        for (int k = 0; k <= list.kinds.length; k++) {
            EdgePlaces floats = list.places(k, true);
            EdgePlaces doubles = list.places(k, false);
            for (int m = list.first[k]; m < list.first[k + 1]; m++) {
                (list.isSingle[m] ? floats : doubles)
                        .bind(
                                list.place[m],
                                list.source[m],
                                offset(list.slotA[m], list.side[m]),
                                offset(list.slotB[m], list.side[m]),
                                list.variant[m]);
            }
        }
    }

    private static int offset(int slot, int side) {
        return slot >= 0 ? SolverBodies.offset(slot) : side;
    }
}
