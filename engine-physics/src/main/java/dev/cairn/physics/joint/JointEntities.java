package dev.cairn.physics.joint;

import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.component.DeadEntityException;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.state.RigidBody;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Joints that are entities, and joints whose bodies have gone: what is done about them when a step
 * ends. Simulation thread, between steps.
 */
final class JointEntities {
    private static final JointRef[] NO_JOINTS = {};

    private final Joints joints;
    private final World ecs;
    private final Query newcomers;
    private final Query asked;
    private final Query linked;
    private final Query bodies;

    /** Joints that ended since the step before as a body of theirs went. */
    final List<JointRef> lost = new ArrayList<>();

    /** By joint: whether users take it to be there. */
    private boolean[] isKnown = {};

    /** How many joints have an entity. */
    private int linkedCount;

    /** Bodies at the last look, and how many were born until then. */
    private int bodyCount;

    private long bornThen;

    JointEntities(Joints joints, World ecs) {
        this.joints = joints;
        this.ecs = ecs;
        newcomers = ecs.query(NewJoint.COMPONENT);
        asked = ecs.query(JointChange.COMPONENT);
        linked = ecs.query(RigidJoint.COMPONENT);
        bodies = ecs.query(RigidBody.COMPONENT);
    }

    /** The count of births is this program's own, so only its growth is saved. */
    void state(StateVisitor s) {
        s.section("jointEntities", this);
        JointStore store = joints.store;
        isKnown = s.array("isKnown", isKnown, 0, store.count, store.isThere.length, true);
        linkedCount = s.value("linkedCount", linkedCount);
        int ended = s.value("lostCount", lost.size());
        JointRef[] ends = s.array("lost", lost.toArray(NO_JOINTS), ended);
        bodyCount = s.value("bodyCount", bodyCount);
        long since = s.value("bornThen", joints.host.bodiesBorn() - bornThen);
        if (s.isRestoring()) {
            bornThen = joints.host.bodiesBorn() - since;
            lost.clear();
            for (int k = 0; k < ended; k++) {
                JointRef each = ends[k];
                lost.add(each.isOf(joints) ? each : new JointRef(joints, each));
            }
        }
    }

    /** A joint was added. */
    void made(JointRef ref) {
        if (isKnown.length <= ref.index) {
            isKnown = Arrays.copyOf(isKnown, joints.store.isThere.length);
        }
        isKnown[ref.index] = true;
        linkedCount += ref.entity() == JointRef.NO_ENTITY ? 0 : 1;
    }

    /** A user has taken a joint out. */
    void removed(JointRef ref) {
        isKnown[ref.index] = false;
        if (ref.entity() != JointRef.NO_ENTITY) {
            linkedCount--;
            delete(ref.entity());
        }
    }

    /**
     * After a step, when bodies that were asked for are there: ends joints whose body or entity has
     * gone, then makes and changes what was asked for. Whether any has gone is told by counts:
     * looking at each joint in each step would cost more than solving it.
     */
    void endStep(JointRef[] refs) {
        lost.clear();
        long expected = bodyCount + (joints.host.bodiesBorn() - bornThen);
        if (bodies.entityCount() != expected || linked.entityCount() != linkedCount) {
            for (int j = 0; j < joints.store.count; j++) {
                if (isKnown[j] && !joints.isThere(j)) {
                    end(j, refs[j]);
                }
            }
        }
        bodyCount = bodies.entityCount();
        bornThen = joints.host.bodiesBorn();
        adopt();
        change();
    }

    /** A joint is there no more: its entity was deleted, or a body. */
    private void end(int j, JointRef ref) {
        JointStore store = joints.store;
        boolean isAsked = ref.entity() != JointRef.NO_ENTITY && !isLinked(ref.entity());
        if (store.isThere[j] && store.stamp[j] == ref.stamp) {
            if (isAsked
                    && joints.host.isAlive(store.bodyA[j], ref.entityA())
                    && joints.host.isAlive(store.bodyB[j], ref.entityB())) {
                joints.wake(j);
            }
            store.remove(j);
            joints.separate(j);
        }
        if (!isAsked) {
            lost.add(ref);
        }
        removed(ref);
    }

    boolean isLinked(long entity) {
        return ecs.isAlive(entity) && ecs.has(entity, RigidJoint.COMPONENT);
    }

    private void delete(long entity) {
        if (ecs.isAlive(entity)) {
            ecs.delete(entity);
        }
    }

    /** The number in the component of an entity, or -1. */
    int number(long entity) {
        return isLinked(entity) ? ecs.get(entity, RigidJoint.COMPONENT).number() : -1;
    }

    /** Makes joints of the entities with {@link NewJoint}, in order of their rows. */
    private void adopt() {
        for (long entity : newcomers.entities()) {
            Joint joint = ecs.get(entity, NewJoint.COMPONENT).joint();
            long a = resolved(joint.a.entity());
            long b = resolved(joint.b.entity());
            if (!ecs.isAlive(a) || !ecs.isAlive(b)) {
                ecs.delete(entity);
                continue;
            }
            ecs.remove(entity, NewJoint.COMPONENT);
            JointRef made = joints.make(joint, Jointed.of(a), Jointed.of(b), entity);
            ecs.add(entity, new RigidJoint(made.index, a, b));
        }
    }

    /** The entity of a handle; what is no handle is one. */
    private long resolved(long entity) {
        if (entity >= 0) {
            return entity;
        }
        try {
            return ecs.resolve(entity);
        } catch (DeadEntityException gone) {
            throw new IllegalArgumentException(
                    "a NewJoint names a body by a handle of another step (0x"
                            + Long.toHexString(entity)
                            + "); resolve it after the step that recorded it, and pass the entity",
                    gone);
        }
    }

    /** Makes the changes that were asked for, in order of their rows. */
    private void change() {
        for (long entity : asked.entities()) {
            JointChange change = ecs.get(entity, JointChange.COMPONENT);
            ecs.delete(entity);
            long of = resolved(change.entity());
            if (!ecs.isAlive(of)) {
                continue; // it ended in the same step
            }
            JointRef joint = joints.of(of);
            if (joint == null) {
                throw new IllegalArgumentException(
                        "a JointChange names entity "
                                + of
                                + ", which is no joint; pass that of a NewJoint");
            }
            change.change().accept(joint);
        }
    }
}
