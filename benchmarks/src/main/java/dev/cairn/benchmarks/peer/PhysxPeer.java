package dev.cairn.benchmarks.peer;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.samples.SceneBuilder.ConstantForce;

import org.joml.Quaterniondc;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

import physx.PxTopLevelFunctions;
import physx.common.PxBoundedData;
import physx.common.PxDefaultAllocator;
import physx.common.PxDefaultCpuDispatcher;
import physx.common.PxDefaultErrorCallback;
import physx.common.PxFoundation;
import physx.common.PxQuat;
import physx.common.PxTolerancesScale;
import physx.common.PxTransform;
import physx.common.PxVec3;
import physx.cooking.PxConvexFlagEnum;
import physx.cooking.PxConvexMeshDesc;
import physx.cooking.PxCookingParams;
import physx.cooking.PxTriangleMeshDesc;
import physx.extensions.PxDistanceJoint;
import physx.extensions.PxDistanceJointFlagEnum;
import physx.extensions.PxJoint;
import physx.geometry.PxBoxGeometry;
import physx.geometry.PxCapsuleGeometry;
import physx.geometry.PxConvexMesh;
import physx.geometry.PxConvexMeshGeometry;
import physx.geometry.PxGeometry;
import physx.geometry.PxSphereGeometry;
import physx.geometry.PxTriangleMesh;
import physx.geometry.PxTriangleMeshGeometry;
import physx.physics.PxCombineModeEnum;
import physx.physics.PxFilterData;
import physx.physics.PxMaterial;
import physx.physics.PxPhysics;
import physx.physics.PxRigidActor;
import physx.physics.PxRigidDynamic;
import physx.physics.PxScene;
import physx.physics.PxSceneDesc;
import physx.physics.PxSceneFlagEnum;
import physx.physics.PxShape;
import physx.physics.PxSimulationStatistics;
import physx.physics.PxSolverTypeEnum;
import physx.support.PxArray_PxU32;
import physx.support.PxArray_PxVec3;

import java.lang.foreign.Arena;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;

/** PhysX on the CPU, by way of physx-jni. */
final class PhysxPeer implements Peer {
    private static @Nullable PxPhysics shared;
    private static @Nullable PxTolerancesScale scale;

    private static final int DEFAULT_POSITION_ITERATIONS = 4;
    private static final int BEST_POSITION_ITERATIONS = 16;
    private static final float BEST_BOUNCE_SPEED = 0.1f;

    private final SceneDescription description;
    private final PeerSettings settings;
    private final boolean best;
    private final Arena arena = Arena.ofConfined();
    private final PxVec3 force = new PxVec3();
    private final IdentityHashMap<ConvexHull, PxConvexMesh> hulls = new IdentityHashMap<>();
    private final List<PxTriangleMesh> meshes = new ArrayList<>();
    private final float substepSeconds;
    private final PxPhysics physics;
    private final PxDefaultCpuDispatcher dispatcher;
    private final PxScene scene;
    private final List<PxRigidActor> actors = new ArrayList<>();
    private final List<PxJoint> joints = new ArrayList<>();

    PhysxPeer(SceneDescription description, PeerSettings settings) {
        this.description = description;
        this.settings = settings;
        this.best = settings.tuning() == PeerSettings.Tuning.BEST;
        this.substepSeconds = (float) (description.stepSeconds() / settings.substeps());
        if (System.getProperty("cairn.natives.physx") != null) {
            Natives.load(Engine.PHYSX, List.of());
        }
        physics = physics();
        dispatcher = PxTopLevelFunctions.DefaultCpuDispatcherCreate(settings.workers() - 1);
        PxSceneDesc desc = new PxSceneDesc(scale());
        PxVec3 gravity = new PxVec3(0, (float) -description.gravity(), 0);
        desc.setGravity(gravity);
        desc.setCpuDispatcher(dispatcher);
        desc.setFilterShader(PxTopLevelFunctions.DefaultFilterShader());
        if (best) {
            desc.setSolverType(PxSolverTypeEnum.eTGS);
            desc.setBounceThresholdVelocity(BEST_BOUNCE_SPEED);
            desc.getFlags().raise(PxSceneFlagEnum.eENABLE_FRICTION_EVERY_ITERATION);
        }
        scene = physics.createScene(desc);
        gravity.destroy();
        desc.destroy();
        for (SceneDescription.Solid solid : description.bodies()) {
            add(solid);
        }
        description.links().forEach(this::join);
    }

    /** Bodies with a joint between them do not collide there, unless one asks for it. */
    private void join(Link link) {
        PxTransform frameA = transform(link.anchorA(), link.frameA());
        PxTransform frameB = transform(link.anchorB(), link.frameB());
        PxRigidActor a = actors.get(link.a());
        PxRigidActor b = actors.get(link.b());
        joints.add(
                switch (link.kind()) {
                    case BALL ->
                            PxTopLevelFunctions.SphericalJointCreate(physics, a, frameA, b, frameB);
                    case HINGE ->
                            PxTopLevelFunctions.RevoluteJointCreate(physics, a, frameA, b, frameB);
                    case ROD -> {
                        PxDistanceJoint rod =
                                PxTopLevelFunctions.DistanceJointCreate(
                                        physics, a, frameA, b, frameB);
                        rod.setMinDistance((float) link.length());
                        rod.setMaxDistance((float) link.length());
                        rod.setDistanceJointFlag(
                                PxDistanceJointFlagEnum.eMIN_DISTANCE_ENABLED, true);
                        yield rod;
                    }
                });
        frameA.destroy();
        frameB.destroy();
    }

    private static PxTransform transform(Vector3dc place, Quaterniondc rotation) {
        PxVec3 at = vector(place);
        PxQuat turned =
                new PxQuat(
                        (float) rotation.x(),
                        (float) rotation.y(),
                        (float) rotation.z(),
                        (float) rotation.w());
        PxTransform made = new PxTransform(at, turned);
        at.destroy();
        turned.destroy();
        return made;
    }

    private static PxPhysics physics() {
        PxPhysics known = shared;
        if (known == null) {
            int version = PxTopLevelFunctions.getPHYSICS_VERSION();
            PxFoundation foundation =
                    PxTopLevelFunctions.CreateFoundation(
                            version, new PxDefaultAllocator(), new PxDefaultErrorCallback());
            known = PxTopLevelFunctions.CreatePhysics(version, foundation, scale());
            shared = known;
        }
        return known;
    }

    private static PxTolerancesScale scale() {
        PxTolerancesScale known = scale;
        if (known == null) {
            known = new PxTolerancesScale();
            scale = known;
        }
        return known;
    }

    private void add(SceneDescription.Solid solid) {
        PxTransform pose = transform(solid.centre(), solid.rotation());
        PxGeometry geometry =
                switch (solid.shape()) {
                    case Box box ->
                            new PxBoxGeometry(
                                    (float) box.halfX(), (float) box.halfY(), (float) box.halfZ());
                    case Sphere sphere -> new PxSphereGeometry((float) sphere.radius());
                    case Capsule capsule ->
                            new PxCapsuleGeometry(
                                    (float) capsule.radius(), (float) capsule.halfLength());
                    case ConvexHull hull ->
                            new PxConvexMeshGeometry(hulls.computeIfAbsent(hull, this::mesh));
                    case TriangleMesh _, HeightField _ ->
                            new PxTriangleMeshGeometry(mesh(Triangles.of(solid.shape())));
                    default ->
                            throw new IllegalArgumentException(
                                    "PhysX: its adapter has no "
                                            + solid.shape().getClass().getSimpleName());
                };
        float friction = (float) Math.sqrt(solid.friction());
        PxMaterial material =
                physics.createMaterial(friction, friction, (float) solid.restitution());
        material.setFrictionCombineMode(PxCombineModeEnum.eMULTIPLY);
        material.setRestitutionCombineMode(PxCombineModeEnum.eMAX);
        PxShape shape = physics.createShape(geometry, material, true);
        if (solid.shape() instanceof Capsule) {
            upright(shape);
        }
        // The default filter shader lets pairs through whose words agree.
        PxFilterData group = new PxFilterData(1, 1, 0, 0);
        shape.setSimulationFilterData(group);
        group.destroy();
        PxRigidActor actor;
        if (solid.fixed()) {
            actor = physics.createRigidStatic(pose);
            actor.attachShape(shape);
        } else {
            PxRigidDynamic body = physics.createRigidDynamic(pose);
            body.attachShape(shape);
            body.setMass((float) solid.mass());
            PxVec3 inertia =
                    new PxVec3(
                            (float) solid.inertia().m00(),
                            (float) solid.inertia().m11(),
                            (float) solid.inertia().m22());
            body.setMassSpaceInertiaTensor(inertia);
            PxVec3 set = body.getMassSpaceInertiaTensor();
            ReadBack.inertia(Engine.PHYSX, solid, set.getX(), set.getY(), set.getZ());
            body.setLinearDamping(0);
            body.setAngularDamping(0);
            body.setSleepThreshold(0);
            body.setSolverIterationCounts(
                    settings.iterationFactor()
                            * (best ? BEST_POSITION_ITERATIONS : DEFAULT_POSITION_ITERATIONS),
                    settings.iterationFactor());
            body.setMaxAngularVelocity(1e4f);
            PxVec3 velocity = vector(solid.velocity());
            PxVec3 spin = vector(solid.angularVelocity());
            body.setLinearVelocity(velocity);
            body.setAngularVelocity(spin);
            velocity.destroy();
            spin.destroy();
            inertia.destroy();
            actor = body;
        }
        shape.release();
        material.release();
        pose.destroy();
        scene.addActor(actor);
        actors.add(actor);
    }

    /** Capsules lie along x there, along y here. */
    private static void upright(PxShape shape) {
        PxVec3 origin = new PxVec3(0, 0, 0);
        float half = (float) Math.sqrt(0.5);
        PxQuat quarter = new PxQuat(0, 0, half, half);
        PxTransform local = new PxTransform(origin, quarter);
        shape.setLocalPose(local);
        local.destroy();
        quarter.destroy();
        origin.destroy();
    }

    private PxConvexMesh mesh(ConvexHull hull) {
        PxArray_PxVec3 points = array(SceneDescription.Solid.points(hull));
        PxBoundedData data = data(points);
        PxConvexMeshDesc recipe = new PxConvexMeshDesc();
        recipe.setPoints(data);
        recipe.getFlags().raise(PxConvexFlagEnum.eCOMPUTE_CONVEX);
        PxCookingParams cooking = new PxCookingParams(scale());
        PxConvexMesh made = PxTopLevelFunctions.CreateConvexMesh(cooking, recipe);
        cooking.destroy();
        recipe.destroy();
        data.destroy();
        points.destroy();
        return made;
    }

    private PxTriangleMesh mesh(Triangles surface) {
        PxArray_PxVec3 points = array(surface.xyz());
        PxArray_PxU32 corners = new PxArray_PxU32(surface.indices().length);
        for (int i = 0; i < surface.indices().length; i++) {
            corners.set(i, surface.indices()[i]);
        }
        PxBoundedData xyz = data(points);
        PxBoundedData triangles = new PxBoundedData();
        triangles.setCount(surface.count());
        triangles.setStride(Triangles.STRIDE);
        triangles.setData(corners.begin());
        PxTriangleMeshDesc recipe = new PxTriangleMeshDesc();
        recipe.setPoints(xyz);
        recipe.setTriangles(triangles);
        PxCookingParams cooking = new PxCookingParams(scale());
        PxTriangleMesh made = PxTopLevelFunctions.CreateTriangleMesh(cooking, recipe);
        cooking.destroy();
        recipe.destroy();
        triangles.destroy();
        xyz.destroy();
        corners.destroy();
        points.destroy();
        meshes.add(made);
        return made;
    }

    private static PxArray_PxVec3 array(float[] xyz) {
        PxArray_PxVec3 points = new PxArray_PxVec3();
        for (int i = 0; i < xyz.length; i += 3) {
            PxVec3 point = new PxVec3(xyz[i], xyz[i + 1], xyz[i + 2]);
            points.pushBack(point);
            point.destroy();
        }
        return points;
    }

    private static PxBoundedData data(PxArray_PxVec3 points) {
        PxBoundedData data = new PxBoundedData();
        data.setCount(points.size());
        data.setStride(PxVec3.SIZEOF);
        data.setData(points.begin());
        return data;
    }

    private static PxVec3 vector(Vector3dc v) {
        return new PxVec3((float) v.x(), (float) v.y(), (float) v.z());
    }

    @Override
    public void step() {
        for (int n = 0; n < settings.substeps(); n++) {
            for (int f = 0; f < description.forces().size(); f++) {
                // Cleared by the engine after each step.
                ConstantForce one = description.forces().get(f);
                force.setX((float) one.fx());
                force.setY((float) one.fy());
                force.setZ((float) one.fz());
                ((PxRigidDynamic) actors.get(one.body())).addForce(force);
            }
            scene.simulate(substepSeconds);
            scene.fetchResults(true);
        }
    }

    @Override
    public void readPoses(double[] poses) {
        int o = 0;
        for (int i = 0; i < actors.size(); i++) {
            PxTransform pose = actors.get(i).getGlobalPose();
            PxVec3 at = pose.getP();
            PxQuat turned = pose.getQ();
            poses[o] = at.getX();
            poses[o + 1] = at.getY();
            poses[o + 2] = at.getZ();
            poses[o + 3] = turned.getX();
            poses[o + 4] = turned.getY();
            poses[o + 5] = turned.getZ();
            poses[o + 6] = turned.getW();
            o += POSE_STRIDE;
        }
    }

    @Override
    public void setGravity(double x, double y, double z) {
        force.setX((float) x);
        force.setY((float) y);
        force.setZ((float) z);
        scene.setGravity(force);
    }

    @Override
    public void readVelocities(double[] velocities) {
        for (int i = 0; i < actors.size(); i++) {
            if (!(actors.get(i) instanceof PxRigidDynamic body)) {
                continue;
            }
            int o = VELOCITY_STRIDE * i;
            PxVec3 v = body.getLinearVelocity();
            velocities[o] = v.getX();
            velocities[o + 1] = v.getY();
            velocities[o + 2] = v.getZ();
            PxVec3 w = body.getAngularVelocity();
            velocities[o + 3] = w.getX();
            velocities[o + 4] = w.getY();
            velocities[o + 5] = w.getZ();
        }
    }

    /** The Java side has no constructor for the statistics, so they lie in memory of ours. */
    @Override
    public int contactPairs() {
        PxSimulationStatistics statistics =
                PxSimulationStatistics.wrapPointer(
                        arena.allocate(PxSimulationStatistics.SIZEOF, 16).address());
        scene.getSimulationStatistics(statistics);
        return statistics.getNbDiscreteContactPairsWithContacts();
    }

    @Override
    public int contactPoints() {
        return UNKNOWN;
    }

    @Override
    public List<String> notes() {
        return List.of(
                "PGS with 4 position and 1 velocity iterations, patch friction, bounce threshold"
                        + " 0.2 x 10 m/s as they come",
                "best effort: TGS with 16 position and 1 velocity iterations, friction in each,"
                        + " bounce threshold 0.1 m/s",
                "sleeping and damping off; no gyroscopic torque in this version",
                "friction: bodies carry the square root, combined by product; restitution by max",
                "cylinders: it has none",
                "contact points are not counted, only pairs");
    }

    @Override
    public void close() {
        for (PxJoint joint : joints) {
            joint.release();
        }
        joints.clear();
        for (PxRigidActor actor : actors) {
            actor.release();
        }
        actors.clear();
        for (PxConvexMesh mesh : hulls.values()) {
            mesh.release();
        }
        for (PxTriangleMesh mesh : meshes) {
            mesh.release();
        }
        scene.release();
        force.destroy();
        arena.close();
        dispatcher.destroy();
    }
}
