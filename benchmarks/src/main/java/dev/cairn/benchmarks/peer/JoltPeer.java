package dev.cairn.benchmarks.peer;

import com.github.stephengold.joltjni.BodyCreationSettings;
import com.github.stephengold.joltjni.BodyInterface;
import com.github.stephengold.joltjni.BoxShape;
import com.github.stephengold.joltjni.CapsuleShape;
import com.github.stephengold.joltjni.CollisionGroup;
import com.github.stephengold.joltjni.ConvexHullShapeSettings;
import com.github.stephengold.joltjni.CustomContactListener;
import com.github.stephengold.joltjni.CylinderShape;
import com.github.stephengold.joltjni.DistanceConstraintSettings;
import com.github.stephengold.joltjni.Float3;
import com.github.stephengold.joltjni.GroupFilterTable;
import com.github.stephengold.joltjni.HingeConstraintSettings;
import com.github.stephengold.joltjni.IndexedTriangle;
import com.github.stephengold.joltjni.JobSystem;
import com.github.stephengold.joltjni.JobSystemSingleThreaded;
import com.github.stephengold.joltjni.JobSystemThreadPool;
import com.github.stephengold.joltjni.Jolt;
import com.github.stephengold.joltjni.MapObj2Bp;
import com.github.stephengold.joltjni.MassProperties;
import com.github.stephengold.joltjni.Mat44;
import com.github.stephengold.joltjni.MeshShapeSettings;
import com.github.stephengold.joltjni.ObjVsBpFilter;
import com.github.stephengold.joltjni.ObjVsObjFilter;
import com.github.stephengold.joltjni.PhysicsSettings;
import com.github.stephengold.joltjni.PhysicsSystem;
import com.github.stephengold.joltjni.PointConstraintSettings;
import com.github.stephengold.joltjni.Quat;
import com.github.stephengold.joltjni.RVec3;
import com.github.stephengold.joltjni.ShapeResult;
import com.github.stephengold.joltjni.ShapeSettings;
import com.github.stephengold.joltjni.SphereShape;
import com.github.stephengold.joltjni.TempAllocator;
import com.github.stephengold.joltjni.TempAllocatorImplWithMallocFallback;
import com.github.stephengold.joltjni.TwoBodyConstraint;
import com.github.stephengold.joltjni.TwoBodyConstraintSettings;
import com.github.stephengold.joltjni.Vec3;
import com.github.stephengold.joltjni.enumerate.EActivation;
import com.github.stephengold.joltjni.enumerate.EConstraintSpace;
import com.github.stephengold.joltjni.enumerate.EMotionType;
import com.github.stephengold.joltjni.enumerate.EOverrideMassProperties;
import com.github.stephengold.joltjni.enumerate.ValidateResult;
import com.github.stephengold.joltjni.readonly.ConstShape;
import com.github.stephengold.joltjni.readonly.Vec3Arg;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.samples.SceneBuilder.ConstantForce;

import org.joml.Matrix3dc;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;

/** Jolt by way of jolt-jni. */
final class JoltPeer implements Peer {
    private static final int LAYER = 0;
    private static final int JOBS = 2048;
    private static final int BARRIERS = 8;
    private static final int SCRATCH_BYTES = 32 << 20;
    private static final int BEST_VELOCITY_STEPS = 30;
    private static final int BEST_POSITION_STEPS = 6;
    private static final float BEST_SLOP = 1e-3f;
    private static boolean ready;

    private final SceneDescription scene;
    private final PeerSettings settings;
    private final boolean best;
    private final IdentityHashMap<ConvexHull, ConstShape> hulls = new IdentityHashMap<>();
    private final float stepSeconds;
    private final PhysicsSystem system;
    private final BodyInterface interfaceOfBodies;
    private final TempAllocator scratch;
    private final JobSystem jobs;
    private final @Nullable Counter counter;
    private final List<Object> kept = new ArrayList<>();
    private final int[] ids;
    private final RVec3 at = new RVec3();
    private final Quat turned = new Quat();

    JoltPeer(SceneDescription scene, PeerSettings settings) {
        this.scene = scene;
        this.settings = settings;
        this.stepSeconds = (float) scene.stepSeconds();
        prepare();
        scratch = new TempAllocatorImplWithMallocFallback(SCRATCH_BYTES);
        jobs =
                settings.workers() == 1
                        ? new JobSystemSingleThreaded(JOBS)
                        : new JobSystemThreadPool(JOBS, BARRIERS, settings.workers() - 1);
        int count = scene.bodies().size();
        MapObj2Bp layers = new MapObj2Bp(1, 1).add(LAYER, 0);
        ObjVsBpFilter broad = new ObjVsBpFilter(1, 1);
        ObjVsObjFilter narrow = new ObjVsObjFilter(1);
        kept.addAll(List.of(layers, broad, narrow));
        int room = Math.max(1024, 16 * count);
        system = new PhysicsSystem();
        system.init(count + 16, 0, room, room, layers, broad, narrow);
        system.setGravity(0, (float) -scene.gravity(), 0);
        PhysicsSettings tuned = system.getPhysicsSettings();
        tuned.setAllowSleeping(false);
        best = settings.tuning() == PeerSettings.Tuning.BEST;
        if (best) {
            tuned.setNumVelocitySteps(BEST_VELOCITY_STEPS);
            tuned.setNumPositionSteps(BEST_POSITION_STEPS);
            tuned.setPenetrationSlop(BEST_SLOP);
        }
        tuned.setNumVelocitySteps(settings.iterationFactor() * tuned.getNumVelocitySteps());
        tuned.setNumPositionSteps(settings.iterationFactor() * tuned.getNumPositionSteps());
        system.setPhysicsSettings(tuned);
        interfaceOfBodies = system.getBodyInterface();
        ids = new int[count];
        GroupFilterTable filter = filter(scene);
        for (int i = 0; i < count; i++) {
            ids[i] =
                    add(
                            scene.bodies().get(i),
                            filter == null ? null : new CollisionGroup(filter, 0, i));
        }
        scene.links().forEach(this::join);
        system.optimizeBroadPhase();
        counter = settings.counting() && settings.workers() == 1 ? new Counter() : null;
        if (counter != null) {
            system.setContactListener(counter);
        }
    }

    /** Keeps bodies with a joint between them from colliding. */
    private static @Nullable GroupFilterTable filter(SceneDescription scene) {
        if (scene.links().isEmpty()) {
            return null;
        }
        GroupFilterTable table = new GroupFilterTable(scene.bodies().size());
        for (Link link : scene.links()) {
            table.disableCollision(link.a(), link.b());
        }
        return table;
    }

    private void join(Link link) {
        Vec3 x = vector(link.axisA());
        RVec3 p = place(link.anchorA());
        RVec3 q = place(link.anchorB());
        TwoBodyConstraintSettings recipe =
                switch (link.kind()) {
                    case BALL -> {
                        PointConstraintSettings ball = new PointConstraintSettings();
                        ball.setSpace(EConstraintSpace.LocalToBodyCOM);
                        ball.setPoint1(p);
                        ball.setPoint2(q);
                        yield ball;
                    }
                    case HINGE -> {
                        HingeConstraintSettings hinge = new HingeConstraintSettings();
                        hinge.setSpace(EConstraintSpace.LocalToBodyCOM);
                        hinge.setPoint1(p);
                        hinge.setPoint2(q);
                        hinge.setHingeAxis1(x);
                        hinge.setHingeAxis2(vector(link.axisB()));
                        hinge.setNormalAxis1(vector(link.normalA()));
                        hinge.setNormalAxis2(vector(link.normalB()));
                        yield hinge;
                    }
                    case ROD -> {
                        DistanceConstraintSettings rod = new DistanceConstraintSettings();
                        rod.setSpace(EConstraintSpace.LocalToBodyCOM);
                        rod.setPoint1(p);
                        rod.setPoint2(q);
                        rod.setMinDistance((float) link.length());
                        rod.setMaxDistance((float) link.length());
                        yield rod;
                    }
                };
        TwoBodyConstraint joint =
                interfaceOfBodies.createConstraint(recipe, ids[link.a()], ids[link.b()]);
        system.addConstraint(joint);
        kept.add(joint);
    }

    private static RVec3 place(Vector3dc v) {
        return new RVec3(v.x(), v.y(), v.z());
    }

    static void prepare() {
        if (ready) {
            return;
        }
        Natives.load(
                Engine.JOLT,
                List.of(
                        "linux/x86-64/com/github/stephengold/libjoltjni.so",
                        "windows/x86-64/com/github/stephengold/joltjni.dll",
                        "osx/x86-64/com/github/stephengold/libjoltjni.dylib",
                        "osx/aarch64/com/github/stephengold/libjoltjni.dylib"));
        Jolt.registerDefaultAllocator();
        Jolt.installDefaultAssertCallback();
        Jolt.installDefaultTraceCallback();
        if (!Jolt.newFactory()) {
            throw new IllegalStateException("Jolt: its factory could not be made");
        }
        Jolt.registerTypes();
        ready = true;
    }

    private int add(SceneDescription.Solid solid, @Nullable CollisionGroup group) {
        ConstShape shape =
                switch (solid.shape()) {
                    case Box box -> box(box);
                    case Sphere sphere -> new SphereShape((float) sphere.radius());
                    case ConvexHull hull -> hulls.computeIfAbsent(hull, this::hull);
                    case Capsule capsule ->
                            new CapsuleShape(
                                    (float) capsule.halfLength(), (float) capsule.radius());
                    case Cylinder cylinder -> cylinder(cylinder);
                    case TriangleMesh _, HeightField _ -> mesh(Triangles.of(solid.shape()));
                    default ->
                            throw new IllegalArgumentException(
                                    "Jolt: its adapter has no "
                                            + solid.shape().getClass().getSimpleName());
                };
        BodyCreationSettings body =
                new BodyCreationSettings(
                        shape,
                        new RVec3(solid.centre().x(), solid.centre().y(), solid.centre().z()),
                        new Quat(
                                (float) solid.rotation().x(),
                                (float) solid.rotation().y(),
                                (float) solid.rotation().z(),
                                (float) solid.rotation().w()),
                        solid.fixed() ? EMotionType.Static : EMotionType.Dynamic,
                        LAYER);
        kept.add(shape);
        if (group != null) {
            body.setCollisionGroup(group);
        }
        body.setFriction((float) solid.friction());
        body.setRestitution((float) solid.restitution());
        body.setAllowSleeping(false);
        body.setLinearDamping(0);
        body.setAngularDamping(0);
        body.setMaxLinearVelocity(1e6f);
        body.setMaxAngularVelocity(1e4f);
        body.setApplyGyroscopicForce(true);
        if (!solid.fixed()) {
            body.setOverrideMassProperties(EOverrideMassProperties.MassAndInertiaProvided);
            body.setMassPropertiesOverride(massProperties(solid));
            Mat44 set = body.getMassPropertiesOverride().getInertia();
            ReadBack.inertia(
                    Engine.JOLT,
                    solid,
                    set.getElement(0, 0),
                    set.getElement(1, 1),
                    set.getElement(2, 2));
            body.setLinearVelocity(vector(solid.velocity()));
            body.setAngularVelocity(vector(solid.angularVelocity()));
        }
        return interfaceOfBodies.createAndAddBody(
                body, solid.fixed() ? EActivation.DontActivate : EActivation.Activate);
    }

    private ConstShape hull(ConvexHull hull) {
        float[] xyz = SceneDescription.Solid.points(hull);
        List<Vec3Arg> points = new ArrayList<>();
        for (int i = 0; i < xyz.length; i += 3) {
            points.add(new Vec3(xyz[i], xyz[i + 1], xyz[i + 2]));
        }
        ConvexHullShapeSettings recipe =
                new ConvexHullShapeSettings(points, best ? 0 : Jolt.cDefaultConvexRadius);
        return made("hull", recipe);
    }

    private ConstShape mesh(Triangles surface) {
        Float3[] corners = new Float3[surface.corners()];
        float[] xyz = surface.xyz();
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new Float3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
        }
        IndexedTriangle[] triangles = new IndexedTriangle[surface.count()];
        int[] of = surface.indices();
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = new IndexedTriangle(of[3 * i], of[3 * i + 1], of[3 * i + 2]);
        }
        return made("mesh", new MeshShapeSettings(corners, triangles));
    }

    private ConstShape made(String what, ShapeSettings recipe) {
        ShapeResult made = recipe.create();
        if (!made.isValid()) {
            throw new IllegalArgumentException(
                    "Jolt: it makes no %s: %s".formatted(what, made.getError()));
        }
        kept.addAll(List.of(recipe, made));
        return made.get();
    }

    private CylinderShape cylinder(Cylinder cylinder) {
        double thinnest = Math.min(cylinder.halfHeight(), cylinder.radius());
        return new CylinderShape(
                (float) cylinder.halfHeight(), (float) cylinder.radius(), rounding(thinnest));
    }

    private float rounding(double thinnest) {
        return best ? 0 : (float) Math.min(Jolt.cDefaultConvexRadius, thinnest);
    }

    private BoxShape box(Box box) {
        float rounding = rounding(Math.min(box.halfX(), Math.min(box.halfY(), box.halfZ())));
        return new BoxShape(
                new Vec3((float) box.halfX(), (float) box.halfY(), (float) box.halfZ()), rounding);
    }

    private static MassProperties massProperties(SceneDescription.Solid solid) {
        Matrix3dc i = solid.inertia();
        float[] columns = {
            (float) i.m00(),
            (float) i.m01(),
            (float) i.m02(),
            0,
            (float) i.m10(),
            (float) i.m11(),
            (float) i.m12(),
            0,
            (float) i.m20(),
            (float) i.m21(),
            (float) i.m22(),
            0,
            0,
            0,
            0,
            1
        };
        return new MassProperties().setMass((float) solid.mass()).setInertia(new Mat44(columns));
    }

    private static Vec3 vector(Vector3dc v) {
        return new Vec3((float) v.x(), (float) v.y(), (float) v.z());
    }

    @Override
    public void step() {
        if (counter != null) {
            counter.manifolds = 0;
        }
        for (int f = 0; f < scene.forces().size(); f++) {
            // Cleared by the engine after each update.
            ConstantForce force = scene.forces().get(f);
            interfaceOfBodies.addForce(
                    ids[force.body()],
                    new Vec3((float) force.fx(), (float) force.fy(), (float) force.fz()));
        }
        int errors = system.update(stepSeconds, settings.substeps(), scratch, jobs);
        if (errors != 0) {
            throw new IllegalStateException(
                    "Jolt: update reports error bits "
                            + errors
                            + " (its manifold, pair or contact buffer is full)");
        }
    }

    @Override
    public void readPoses(double[] poses) {
        int o = 0;
        for (int id : ids) {
            interfaceOfBodies.getPositionAndRotation(id, at, turned);
            poses[o] = at.xx();
            poses[o + 1] = at.yy();
            poses[o + 2] = at.zz();
            poses[o + 3] = turned.getX();
            poses[o + 4] = turned.getY();
            poses[o + 5] = turned.getZ();
            poses[o + 6] = turned.getW();
            o += POSE_STRIDE;
        }
    }

    @Override
    public void setGravity(double x, double y, double z) {
        system.setGravity((float) x, (float) y, (float) z);
    }

    @Override
    public void readVelocities(double[] velocities) {
        for (int i = 0; i < ids.length; i++) {
            if (scene.bodies().get(i).fixed()) {
                continue;
            }
            int o = VELOCITY_STRIDE * i;
            Vec3 v = interfaceOfBodies.getLinearVelocity(ids[i]);
            velocities[o] = v.getX();
            velocities[o + 1] = v.getY();
            velocities[o + 2] = v.getZ();
            Vec3 w = interfaceOfBodies.getAngularVelocity(ids[i]);
            velocities[o + 3] = w.getX();
            velocities[o + 4] = w.getY();
            velocities[o + 5] = w.getZ();
        }
    }

    @Override
    public int contactPairs() {
        return counter == null
                ? UNKNOWN
                : Math.round((float) counter.manifolds / settings.substeps());
    }

    @Override
    public int contactPoints() {
        return UNKNOWN;
    }

    @Override
    public List<String> notes() {
        return List.of(
                "10 velocity and 2 position iterations, slop 2 cm, Baumgarte 0.2 as they come",
                "best effort: 30 velocity and 6 position iterations, slop 1 mm, no rounding",
                "boxes, cylinders and hulls rounded by the default convex radius 0.05 m, within"
                        + " their size",
                "sleeping and damping off, speed caps raised, gyroscopic torque on",
                "bounce threshold 1 m/s cannot be set from Java in this version",
                "contact points are not counted, only pairs");
    }

    @Override
    public void close() {
        system.removeAllBodies();
        system.close();
        jobs.close();
        scratch.close();
        kept.clear();
    }

    /** Counts manifolds; used where no time is taken. */
    private static final class Counter extends CustomContactListener {
        private int manifolds;

        @Override
        public void onContactAdded(long body1, long body2, long manifold, long settings) {
            manifolds++;
        }

        @Override
        public void onContactPersisted(long body1, long body2, long manifold, long settings) {
            manifolds++;
        }

        @Override
        public void onContactRemoved(long pair) {
            // counted anew in each step
        }

        @Override
        @SuppressWarnings("EnumOrdinal") // what this version of jolt-jni passes to the native side
        public int onContactValidate(
                long body1, long body2, double x, double y, double z, long result) {
            return ValidateResult.AcceptAllContactsForThisBodyPair.ordinal();
        }
    }
}
