package dev.cairn.physics;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.IntField;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Torque;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.contact.BodyTouches;
import dev.cairn.physics.contact.ComposeStage;
import dev.cairn.physics.contact.ContactRows;
import dev.cairn.physics.contact.ManifoldStage;
import dev.cairn.physics.contact.SensorStage;
import dev.cairn.physics.contact.SweepStage;
import dev.cairn.physics.contact.TouchEvents;
import dev.cairn.physics.contact.WakeStage;
import dev.cairn.physics.contact.hook.BeltStage;
import dev.cairn.physics.contact.hook.HookStage;
import dev.cairn.physics.contact.seam.PatchStage;
import dev.cairn.physics.contact.seam.SeamStage;
import dev.cairn.physics.contact.seam.WholeStage;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.island.SleepingBodies;
import dev.cairn.physics.joint.Joints;
import dev.cairn.physics.profile.StepStage;
import dev.cairn.physics.solver.ContactSolver;
import dev.cairn.physics.solver.row.ConstraintKind;
import dev.cairn.physics.solver.row.JointRows;
import dev.cairn.physics.state.BodyIndex;
import dev.cairn.physics.state.ForceReader;
import dev.cairn.physics.state.Publisher;
import dev.cairn.physics.state.RigidBody;
import dev.cairn.physics.state.StageCheck;
import dev.cairn.physics.state.StepClock;
import dev.cairn.physics.tuning.Tunable;

import org.jspecify.annotations.Nullable;

/**
 * One tick of the physics, as a system of the ECS named {@value #NAME}: reads {@link RigidBody},
 * writes {@link Pose} and {@link Velocity} of all bodies that can move. {@link PhysicsWorld} makes
 * it.
 *
 * <p>Simulation thread; each stage runs in blocks over the tick's workers. A steady tick allocates
 * nothing.
 */
final class PhysicsSystem implements WorldSystem, Stateful {
    /** The system's name in the schedule. */
    static final String NAME = "physics";

    private static final IntField SLOT = RigidBody.COMPONENT.intField("slot");

    final BodyTable table;
    final ContactStore contacts = new ContactStore();

    final JointStore joints = new JointStore();

    /** The kinds of constraints beside contacts, in the order in which they are solved. */
    private final ConstraintKind[] kinds = {
        new ConstraintKind(joints, new JointRows(), new JointRows())
    };

    /** All that binds bodies, contacts first. */
    final EdgeSource[] edges = ConstraintKind.sources(contacts, kinds);

    final TouchEvents events = new TouchEvents();
    private final BodyTouches bodyEvents;
    final ContactView view;
    PhysicsSettings settings;
    final StepClock profile = new StepClock();

    /** Set once, before the first step. */
    @Nullable Joints jointList;

    private final ContactRows rows;
    private final WakeStage wakes;
    private final ComposeStage compose;
    final SensorStage sensors;
    final HookStage hooks;
    private final BeltStage belts;
    private final ManifoldStage manifolds;
    private final WholeStage wholes;
    private final SweepStage sweeps;
    private final SeamStage seams;
    private final PatchStage patches;
    final ContactSolver solver;
    private final ForceReader forces;
    private final Publisher publisher;
    double gravityX;
    double gravityY;
    double gravityZ;
    private final BodyIndex index = new BodyIndex(SLOT);
    final SleepView sleepView;

    PhysicsSystem(PhysicsSettings settings, double gravityX, double gravityY, double gravityZ) {
        this.settings = settings;
        this.gravityX = gravityX;
        this.gravityY = gravityY;
        this.gravityZ = gravityZ;
        table = new BodyTable(settings, contacts, edges);
        bodyEvents = new BodyTouches(table.colliders);
        rows = new ContactRows(table.colliders, table.sleepers);
        wakes = new WakeStage(table.sleepers, table.bodies, contacts);
        sensors = new SensorStage(table.colliders, table.broadPhase);
        belts = new BeltStage(table.colliders, contacts);
        hooks = new HookStage(table.colliders, contacts);
        compose = new ComposeStage(table.colliders);
        manifolds = new ManifoldStage(table.colliders, table.bounds, rows);
        wholes = new WholeStage(table.colliders, contacts);
        sweeps = new SweepStage(table.colliders, contacts, table.bounds, edges);
        seams = new SeamStage(table.colliders, contacts, table.bounds);
        patches = new PatchStage(table.colliders, contacts);
        solver = new ContactSolver(settings.tuning(), kinds);
        forces = new ForceReader(table.registry);
        publisher = new Publisher(table.registry);
        view = new ContactView(table, contacts, events, bodyEvents, sensors);
        table.contactsOf = view::of;
        sleepView = new SleepView(table);
    }

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public void describe(Access access) {
        access.in(RigidBody.COMPONENT, Pose.COMPONENT)
                .optionalNext(Force.COMPONENT, Torque.COMPONENT)
                .writesAll(Pose.COMPONENT, Velocity.COMPONENT);
    }

    @Override
    public void run(Tick tick) {
        table.isStepping = true;
        try {
            step(tick);
        } finally {
            table.isStepping = false;
        }
    }

    /** The table of contents. */
    private void step(Tick tick) {
        profile.begin();
        events.clear();
        sensors.clear();
        table.access.takePoses();
        readRegistry(tick);
        forces.run(tick);
        table.registry.refreshLists();
        profile.end(StepStage.BODIES);
        assert StageCheck.awake(table.bodies, table.registry.dynamic, table.registry.dynamicCount);
        table.registry.beginMotion(tick.stepSeconds(), gravity());
        moveBounds(tick);
        assert StageCheck.boxes(
                table.bodies,
                table.colliders,
                table.broadPhase,
                table.registry.dynamic,
                table.registry.dynamicCount);
        profile.end(StepStage.BOUNDS);
        table.broadPhase.findPairs(tick.jobs());
        assert StageCheck.newPairs(table.broadPhase);
        profile.end(StepStage.PAIRS);
        rows.update(contacts, table.broadPhase, events, sensors, tick.jobs());
        assert StageCheck.rows(
                contacts, sensors.count(), table.colliders, table.bodies, table.broadPhase);
        table.broadPhase.endTick();
        wakes.refresh(table.bounds, table.broadPhase);
        table.registry.freeGone();
        profile.end(StepStage.ROWS);
        manifolds.run(contacts, tick.stepSeconds(), tick.jobs());
        profile.end(StepStage.POINTS);
        wakes.run(
                table.bounds,
                table.broadPhase,
                manifolds,
                gravityX,
                gravityY,
                gravityZ,
                tick.stepSeconds(),
                settings.substeps(),
                tick.jobs());
        wholes.join(table.broadPhase);
        sweeps.run(tick.stepSeconds(), tick.jobs());
        wholes.see();
        hooks.run(tick.jobs());
        events.approach(contacts, table.bodies, tick.jobs());
        wholes.choose(hooks.get() != null);
        belts.run(tick.jobs());
        table.registry.refreshLists();
        boolean solves = table.registry.dynamicCount > 0;
        if (solves) {
            sweeps.strike(
                    table.broadPhase,
                    settings.tuning().get(Tunable.RESTITUTION_THRESHOLD),
                    settings.substeps(),
                    hooks.get() != null);
            seams.join(tick.stepSeconds(), tick.jobs());
            patches.join(tick.jobs());
            solver.step(
                    table.bodies,
                    contacts,
                    gravityX,
                    gravityY,
                    gravityZ,
                    tick.stepSeconds(),
                    tick.jobs());
            patches.part(tick.jobs());
            seams.part(tick.jobs());
            wholes.part(tick.jobs());
        } else {
            wholes.see();
        }
        table.registry.motion.end(
                table.registry.kinematic, table.registry.kinematicCount, tick.stepSeconds());
        if (solves) {
            sweeps.finish(
                    table.registry.dynamic,
                    table.registry.dynamicCount,
                    table.broadPhase,
                    table.registry.kinematicCount > 0,
                    hooks.get() != null,
                    tick.jobs());
        }
        profile.end(StepStage.SOLVE);
        if (jointList != null) {
            jointList.afterStep();
        }
        fallAsleep(tick);
        publishPoses(tick);
        compose.run(tick.jobs());
        sensors.run(tick.jobs());
        assert StageCheck.poses(table.bodies, table.registry.dynamic, table.registry.dynamicCount);
        profile.end(StepStage.PUBLISH);
        events.update(contacts, rows, tick.jobs());
        bodyEvents.update(events, contacts);
        view.update();
        sleepView.update();
        profile.end(StepStage.TOUCH);
        profile.end(table.bodies.slotCount, contacts.count);
    }

    /** All that the next tick depends on, but for entities. */
    @Override
    public void state(StateVisitor s) {
        s.section("physics", this);
        gravityX = s.value("gravityX", gravityX);
        gravityY = s.value("gravityY", gravityY);
        gravityZ = s.value("gravityZ", gravityZ);
        int substeps = s.value("substeps", settings.substeps());
        if (substeps != settings.substeps()) {
            setSubsteps(substeps);
        }
        table.state(s);
        contacts.state(s);
        rows.state(s);
        joints.state(s);
        if (jointList != null) {
            jointList.state(s);
        }
        events.state(s);
        bodyEvents.state(s);
        sensors.state(s);
        seams.state(s);
        wakes.state(s);
        forces.state(s);
        index.state(s);
        solver.state(s, table.bodies.slotCount);
        if (s.isRestoring()) {
            hooks.renew();
            view.update();
            sleepView.show();
        }
    }

    void setSubsteps(int count) {
        settings = settings.withSubsteps(count);
        solver.setSubsteps(count);
    }

    void wakeAll() {
        table.sleepers.wakeAll(table.bodies.slotCount);
    }

    int lanes() {
        return solver.lanes();
    }

    boolean isRunning() {
        return table.isStepping;
    }

    /** Bodies whose entity is gone leave. */
    private void readRegistry(Tick tick) {
        if (index.isStale(tick)) {
            for (int c = 0; c < tick.chunkCount(); c++) {
                Chunk chunk = tick.chunk(c);
                int[] slots = chunk.in(SLOT);
                int size = chunk.size();
                for (int row = 0; row < size; row++) {
                    table.registry.see(slots[row], chunk.entity(row));
                }
            }
            table.registry.sweep();
        }
        table.registry.beginTick(tick.number());
    }

    /** Islands that have come to rest sleep from the next tick on. */
    private void fallAsleep(Tick tick) {
        SleepingBodies sleepers = table.sleepers;
        long changes = sleepers.changes();
        sleepers.look(
                table.registry.dynamic,
                table.registry.dynamicCount,
                gravity(),
                tick.stepSeconds(),
                tick.jobs());
        if (sleepers.changes() != changes) {
            table.registry.restBounds();
            wakes.lean(settings.substeps());
        }
    }

    private double gravity() {
        return Math.sqrt(gravityX * gravityX + gravityY * gravityY + gravityZ * gravityZ);
    }

    /** Boxes follow their bodies; a body that cannot be computed with stays where it is. */
    private void moveBounds(Tick tick) {
        table.bounds.run(
                table.broadPhase,
                table.registry.dynamic,
                table.registry.dynamicCount,
                gravityX,
                gravityY,
                gravityZ,
                tick.stepSeconds(),
                tick.jobs());
        for (int i = 0; i < table.bounds.invalidCount(); i++) {
            int slot = table.bounds.invalidSlot(i);
            quarantine(slot);
            table.bounds.placeFixed(table.broadPhase, slot, false);
        }
    }

    private void quarantine(int slot) {
        table.quarantine(slot);
        for (EdgeSource source : edges) {
            source.forget(slot);
        }
    }

    /** Columns of the next state; a body that ceased to be finite goes back to where it was. */
    private void publishPoses(Tick tick) {
        publisher.run(tick);
        if (publisher.failures() == 0) {
            return;
        }
        for (int slot = 0; slot < table.bodies.slotCount; slot++) {
            if (publisher.takeFailure(slot)) {
                quarantine(slot);
                table.registry.addUnplaced(slot);
            }
        }
    }
}
