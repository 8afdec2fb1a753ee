package dev.cairn.benchmarks.peer;

import static java.lang.foreign.MemoryLayout.sequenceLayout;
import static java.lang.foreign.MemoryLayout.structLayout;
import static java.lang.foreign.ValueLayout.ADDRESS;
import static java.lang.foreign.ValueLayout.JAVA_BYTE;
import static java.lang.foreign.ValueLayout.JAVA_FLOAT;
import static java.lang.foreign.ValueLayout.JAVA_INT;
import static java.lang.foreign.ValueLayout.JAVA_LONG;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.samples.SceneBuilder.ConstantForce;

import org.joml.Matrix3dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemoryLayout;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.SegmentAllocator;
import java.lang.foreign.SymbolLookup;
import java.lang.invoke.MethodHandle;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Box3D by {@code java.lang.foreign}, from the shared library that the system property {@value
 * #LIBRARY} names: it is not on Maven Central. Written for the C interface of version 0.2.0 in
 * single precision ({@code include/box3d/types.h}, {@code box3d.h}, {@code collision.h}); any other
 * version is refused, because the offsets below are those of its structures.
 */
final class Box3dPeer implements Peer {
    /** Path of {@code libbox3d.so}, {@code box3d.dll} or {@code libbox3d.dylib}. */
    static final String LIBRARY = "cairn.natives.box3d";

    private static final MemoryLayout VECTOR =
            structLayout(JAVA_FLOAT.withName("x"), JAVA_FLOAT.withName("y"), JAVA_FLOAT);
    private static final MemoryLayout QUATERNION =
            structLayout(JAVA_FLOAT.withName("x"), JAVA_FLOAT, JAVA_FLOAT, JAVA_FLOAT);
    private static final MemoryLayout WORLD_ID = JAVA_INT;
    private static final MemoryLayout VERSION = structLayout(JAVA_INT, JAVA_INT, JAVA_INT);
    private static final MemoryLayout COUNTERS = structLayout(sequenceLayout(50, JAVA_INT));
    private static final MemoryLayout MASS = structLayout(sequenceLayout(13, JAVA_FLOAT));
    private static final MemoryLayout BOX_HULL = structLayout(sequenceLayout(80, JAVA_LONG));
    private static final MemoryLayout WORLD_DEF = structLayout(sequenceLayout(18, JAVA_LONG));
    private static final MemoryLayout BODY_DEF = structLayout(sequenceLayout(13, JAVA_LONG));
    private static final MemoryLayout SHAPE_DEF = structLayout(sequenceLayout(15, JAVA_LONG));
    private static final int MOST_HULL_VERTICES = 255;

    private final Arena arena = Arena.ofConfined();
    private final Linker linker = Linker.nativeLinker();
    private final SymbolLookup library;
    private final PeerSettings settings;
    private final float stepSeconds;
    private final MethodHandle step;
    private final MethodHandle position;
    private final MethodHandle rotation;
    private final MethodHandle counters;
    private final MethodHandle linear;
    private final MethodHandle angular;
    private final MethodHandle applyForce;
    private final MethodHandle gravity;
    private final SceneDescription scene;
    private final MethodHandle destroyWorld;
    private final SegmentAllocator vectorSpace;
    private final int world;
    private final long[] bodies;
    private final List<MemorySegment> meshes = new ArrayList<>();

    Box3dPeer(SceneDescription scene, PeerSettings settings) {
        this.scene = scene;
        this.settings = settings;
        stepSeconds = (float) scene.stepSeconds();
        library = open(arena);
        checkVersion();
        step = find("b3World_Step", FunctionDescriptor.ofVoid(WORLD_ID, JAVA_FLOAT, JAVA_INT));
        position = find("b3Body_GetPosition", FunctionDescriptor.of(VECTOR, JAVA_LONG));
        rotation = find("b3Body_GetRotation", FunctionDescriptor.of(QUATERNION, JAVA_LONG));
        counters = find("b3World_GetCounters", FunctionDescriptor.of(COUNTERS, WORLD_ID));
        linear = find("b3Body_GetLinearVelocity", FunctionDescriptor.of(VECTOR, JAVA_LONG));
        angular = find("b3Body_GetAngularVelocity", FunctionDescriptor.of(VECTOR, JAVA_LONG));
        applyForce =
                find(
                        "b3Body_ApplyForceToCenter",
                        FunctionDescriptor.ofVoid(JAVA_LONG, VECTOR, JAVA_BYTE));
        gravity = find("b3World_SetGravity", FunctionDescriptor.ofVoid(WORLD_ID, VECTOR));
        destroyWorld = find("b3DestroyWorld", FunctionDescriptor.ofVoid(WORLD_ID));
        vectorSpace = SegmentAllocator.prefixAllocator(arena.allocate(COUNTERS));
        world = createWorld(scene);
        bodies = new long[scene.bodies().size()];
        Builder builder = new Builder();
        for (int i = 0; i < bodies.length; i++) {
            bodies[i] = builder.add(scene.bodies().get(i));
        }
        scene.links().forEach(this::join);
    }

    @SuppressWarnings("restricted") // the point of this class; the JVM is started with permission
    private static SymbolLookup open(Arena arena) {
        String path = System.getProperty(LIBRARY);
        if (path == null) {
            throw new MissingEngineException(
                    "Box3D: not on Maven Central; build its shared library and name it by -D"
                            + LIBRARY
                            + "=PATH");
        }
        try {
            return SymbolLookup.libraryLookup(Path.of(path).toAbsolutePath(), arena);
        } catch (IllegalArgumentException failure) {
            throw new MissingEngineException(
                    "Box3D: %s=%s does not load: %s".formatted(LIBRARY, path, failure.getMessage()),
                    failure);
        }
    }

    @SuppressWarnings("restricted")
    private MethodHandle find(String name, FunctionDescriptor type) {
        MemorySegment address =
                library.find(name)
                        .orElseThrow(() ->
                                new MissingEngineException(
                                        "Box3D: the library has no function " + name));
        return linker.downcallHandle(address, type);
    }

    private void checkVersion() {
        MemorySegment version =
                (MemorySegment)
                        call(
                                find("b3GetVersion", FunctionDescriptor.of(VERSION)),
                                (SegmentAllocator) arena);
        int major = version.getAtIndex(JAVA_INT, 0);
        int minor = version.getAtIndex(JAVA_INT, 1);
        if (major != 0 || minor != 2) {
            throw new MissingEngineException(
                    "Box3D: the library is version %d.%d; this adapter knows 0.2"
                            .formatted(major, minor));
        }
    }

    private static Object call(MethodHandle handle, Object... arguments) {
        try {
            return handle.invokeWithArguments(arguments);
        } catch (RuntimeException | Error failure) {
            throw failure;
        } catch (Throwable failure) {
            throw new IllegalStateException("Box3D: a call failed", failure);
        }
    }

    private int createWorld(SceneDescription scene) {
        MemorySegment definition = defaults("b3DefaultWorldDef", WORLD_DEF);
        vector(definition, 0, new Vector3d(0, -scene.gravity(), 0));
        definition.set(JAVA_BYTE, 56, (byte) 0); // enableSleep
        definition.set(JAVA_INT, 60, settings.workers()); // workerCount
        MethodHandle create = find("b3CreateWorld", FunctionDescriptor.of(WORLD_ID, ADDRESS));
        return (int) call(create, definition);
    }

    /**
     * Its hinges turn about z, ours about x: its joint frames are turned by a third about (1, 1,
     * 1).
     */
    private void join(Link link) {
        String kind =
                switch (link.kind()) {
                    case BALL -> "Spherical";
                    case HINGE -> "Revolute";
                    case ROD -> "Distance";
                };
        int longs =
                switch (link.kind()) {
                    case BALL -> 23;
                    case HINGE -> 19;
                    case ROD -> 20;
                };
        MemorySegment definition =
                defaults(
                        "b3Default%sJointDef".formatted(kind),
                        structLayout(sequenceLayout(longs, JAVA_LONG)));
        definition.set(JAVA_LONG, 8, bodies[link.a()]);
        definition.set(JAVA_LONG, 16, bodies[link.b()]);
        Quaterniond theirs = new Quaterniond(0.5, 0.5, 0.5, 0.5);
        frame(definition, 24, link.anchorA(), link.frameA().mul(theirs, new Quaterniond()));
        frame(definition, 52, link.anchorB(), link.frameB().mul(theirs, new Quaterniond()));
        if (link.kind() == Link.Kind.ROD) {
            definition.set(JAVA_FLOAT, 112, (float) link.length());
        }
        call(
                find(
                        "b3Create%sJoint".formatted(kind),
                        FunctionDescriptor.of(JAVA_LONG, WORLD_ID, ADDRESS)),
                world,
                definition);
    }

    private static void frame(MemorySegment to, long offset, Vector3dc at, Quaterniondc turned) {
        vector(to, offset, at);
        to.set(JAVA_FLOAT, offset + 12, (float) turned.x());
        to.set(JAVA_FLOAT, offset + 16, (float) turned.y());
        to.set(JAVA_FLOAT, offset + 20, (float) turned.z());
        to.set(JAVA_FLOAT, offset + 24, (float) turned.w());
    }

    private MemorySegment defaults(String name, MemoryLayout layout) {
        return (MemorySegment)
                call(find(name, FunctionDescriptor.of(layout)), (SegmentAllocator) arena);
    }

    private static void vector(MemorySegment to, long offset, Vector3dc value) {
        to.set(JAVA_FLOAT, offset, (float) value.x());
        to.set(JAVA_FLOAT, offset + 4, (float) value.y());
        to.set(JAVA_FLOAT, offset + 8, (float) value.z());
    }

    /** Adds bodies; holds the functions that only building needs. */
    private final class Builder {
        private final MethodHandle createBody =
                find("b3CreateBody", FunctionDescriptor.of(JAVA_LONG, WORLD_ID, ADDRESS));
        private final MethodHandle sphere =
                find(
                        "b3CreateSphereShape",
                        FunctionDescriptor.of(JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
        private final MethodHandle capsule =
                find(
                        "b3CreateCapsuleShape",
                        FunctionDescriptor.of(JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
        private final MethodHandle hull =
                find(
                        "b3CreateHullShape",
                        FunctionDescriptor.of(JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
        private final MethodHandle boxHull =
                find(
                        "b3MakeBoxHull",
                        FunctionDescriptor.of(BOX_HULL, JAVA_FLOAT, JAVA_FLOAT, JAVA_FLOAT));
        private final MethodHandle makeHull =
                find("b3CreateHull", FunctionDescriptor.of(ADDRESS, ADDRESS, JAVA_INT, JAVA_INT));
        private final MethodHandle freeHull =
                find("b3DestroyHull", FunctionDescriptor.ofVoid(ADDRESS));
        private final MethodHandle setMass =
                find("b3Body_SetMassData", FunctionDescriptor.ofVoid(JAVA_LONG, MASS));
        private final MethodHandle getMass =
                find("b3Body_GetMassData", FunctionDescriptor.of(MASS, JAVA_LONG));

        long add(SceneDescription.Solid solid) {
            MemorySegment definition = defaults("b3DefaultBodyDef", BODY_DEF);
            definition.set(JAVA_INT, 0, solid.fixed() ? 0 : 2);
            frame(definition, 4, solid.centre(), solid.rotation());
            vector(definition, 32, solid.velocity());
            vector(definition, 44, solid.angularVelocity());
            definition.set(JAVA_BYTE, 94, (byte) 0); // enableSleep
            long body = (long) call(createBody, world, definition);
            addShape(body, solid);
            if (!solid.fixed()) {
                mass(body, solid);
            }
            return body;
        }

        private void addShape(long body, SceneDescription.Solid solid) {
            MemorySegment definition = defaults("b3DefaultShapeDef", SHAPE_DEF);
            definition.set(JAVA_FLOAT, 32, (float) solid.friction());
            definition.set(JAVA_FLOAT, 36, (float) solid.restitution());
            switch (solid.shape()) {
                case Box box -> {
                    MemorySegment data =
                            (MemorySegment)
                                    call(
                                            boxHull,
                                            (SegmentAllocator) arena,
                                            (float) box.halfX(),
                                            (float) box.halfY(),
                                            (float) box.halfZ());
                    call(hull, body, definition, data);
                }
                case Sphere ball -> {
                    MemorySegment data = arena.allocate(16, 4);
                    data.set(JAVA_FLOAT, 12, (float) ball.radius());
                    call(sphere, body, definition, data);
                }
                case Capsule round -> {
                    MemorySegment data = arena.allocate(28, 4);
                    vector(data, 0, new Vector3d(0, -round.halfLength(), 0));
                    vector(data, 12, new Vector3d(0, round.halfLength(), 0));
                    data.set(JAVA_FLOAT, 24, (float) round.radius());
                    call(capsule, body, definition, data);
                }
                case ConvexHull points -> addHull(body, definition, points);
                case TriangleMesh _, HeightField _ ->
                        addMesh(body, definition, Triangles.of(solid.shape()));
                default ->
                        throw new IllegalArgumentException(
                                "Box3D: its adapter has no "
                                        + solid.shape().getClass().getSimpleName());
            }
        }

        private void addHull(long body, MemorySegment definition, ConvexHull points) {
            double[] xyz = points.vertices();
            int count = xyz.length / 3;
            Vector3d centre = points.centreOfMass(new Vector3d());
            MemorySegment data = arena.allocate(12L * count, 4);
            for (int i = 0; i < count; i++) {
                vector(
                        data,
                        12L * i,
                        new Vector3d(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]).sub(centre));
            }
            MemorySegment made =
                    (MemorySegment)
                            call(makeHull, data, count, Math.min(count, MOST_HULL_VERTICES));
            if (made.address() == 0) {
                throw new IllegalArgumentException(
                        "Box3D: it makes no hull of these %d points".formatted(count));
            }
            call(hull, body, definition, made);
            call(freeHull, made);
        }

        /** The shape refers to the mesh, which lives as long as the world. */
        private void addMesh(long body, MemorySegment definition, Triangles surface) {
            MemorySegment recipe = arena.allocate(40, 8); // b3MeshDef
            recipe.set(ADDRESS, 0, arena.allocateFrom(JAVA_FLOAT, surface.xyz()));
            recipe.set(ADDRESS, 8, arena.allocateFrom(JAVA_INT, surface.indices()));
            recipe.set(ADDRESS, 16, arena.allocate(surface.count())); // all of material 0
            recipe.set(JAVA_INT, 28, surface.corners());
            recipe.set(JAVA_INT, 32, surface.count());
            recipe.set(JAVA_BYTE, 38, (byte) 1); // identifyEdges, against ghost collisions
            MethodHandle make =
                    find(
                            "b3CreateMesh",
                            FunctionDescriptor.of(ADDRESS, ADDRESS, ADDRESS, JAVA_INT));
            MemorySegment made = (MemorySegment) call(make, recipe, MemorySegment.NULL, 0);
            if (made.address() == 0) {
                throw new IllegalArgumentException(
                        "Box3D: it makes no mesh of these %d triangles".formatted(surface.count()));
            }
            meshes.add(made);
            MemorySegment scale = arena.allocate(VECTOR);
            vector(scale, 0, new Vector3d(1));
            MethodHandle create =
                    find(
                            "b3CreateMeshShape",
                            FunctionDescriptor.of(JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS, VECTOR));
            call(create, body, definition, made, scale);
        }

        private void mass(long body, SceneDescription.Solid solid) {
            MemorySegment data = arena.allocate(MASS);
            data.setAtIndex(JAVA_FLOAT, 0, (float) solid.mass());
            Matrix3dc inertia = solid.inertia();
            for (int column = 0; column < 3; column++) {
                for (int row = 0; row < 3; row++) {
                    data.setAtIndex(
                            JAVA_FLOAT, 4 + 3 * column + row, (float) inertia.get(column, row));
                }
            }
            call(setMass, body, data);
            MemorySegment back = (MemorySegment) call(getMass, (SegmentAllocator) arena, body);
            ReadBack.inertia(
                    Engine.BOX3D,
                    solid,
                    back.getAtIndex(JAVA_FLOAT, 4),
                    back.getAtIndex(JAVA_FLOAT, 8),
                    back.getAtIndex(JAVA_FLOAT, 12));
        }
    }

    @Override
    public void step() {
        for (int f = 0; f < scene.forces().size(); f++) {
            // Cleared by the engine after each step.
            ConstantForce force = scene.forces().get(f);
            MemorySegment value = vectorSpace.allocate(VECTOR);
            vector(value, 0, new Vector3d(force.fx(), force.fy(), force.fz()));
            call(applyForce, bodies[force.body()], value, (byte) 1);
        }
        try {
            step.invokeExact(world, stepSeconds, settings.substeps());
        } catch (Throwable failure) {
            throw new IllegalStateException("Box3D: b3World_Step failed", failure);
        }
    }

    @Override
    public void readPoses(double[] poses) {
        for (int i = 0; i < bodies.length; i++) {
            int o = i * POSE_STRIDE;
            MemorySegment at = (MemorySegment) call(position, vectorSpace, bodies[i]);
            for (int k = 0; k < 3; k++) {
                poses[o + k] = at.getAtIndex(JAVA_FLOAT, k);
            }
            MemorySegment turned = (MemorySegment) call(rotation, vectorSpace, bodies[i]);
            for (int k = 0; k < 4; k++) {
                poses[o + 3 + k] = turned.getAtIndex(JAVA_FLOAT, k);
            }
        }
    }

    @Override
    public void setGravity(double x, double y, double z) {
        MemorySegment value = vectorSpace.allocate(VECTOR);
        vector(value, 0, new Vector3d(x, y, z));
        call(gravity, world, value);
    }

    @Override
    public void readVelocities(double[] velocities) {
        for (int i = 0; i < bodies.length; i++) {
            int o = i * VELOCITY_STRIDE;
            MemorySegment v = (MemorySegment) call(linear, vectorSpace, bodies[i]);
            for (int k = 0; k < 3; k++) {
                velocities[o + k] = v.getAtIndex(JAVA_FLOAT, k);
            }
            MemorySegment w = (MemorySegment) call(angular, vectorSpace, bodies[i]);
            for (int k = 0; k < 3; k++) {
                velocities[o + 3 + k] = w.getAtIndex(JAVA_FLOAT, k);
            }
        }
    }

    @Override
    public int contactPairs() {
        // eight buckets: contacts with one manifold, with two, ...; those with none are not counted
        MemorySegment counts = (MemorySegment) call(counters, vectorSpace, world);
        int touching = 0;
        for (int bucket = 0; bucket < 8; bucket++) {
            touching += counts.getAtIndex(JAVA_INT, 37 + bucket);
        }
        return touching;
    }

    @Override
    public int contactPoints() {
        return UNKNOWN;
    }

    @Override
    public List<String> notes() {
        return List.of(
                "Box3D 0.2.0, single precision, from the library that " + LIBRARY + " names",
                "defaults: 30 Hz contacts, damping ratio 10, push out at most at 3 m/s, restitution"
                        + " above 1 m/s, continuous collision on, recycling of contacts on",
                "best effort is the same",
                "sleeping off; boxes are its box hulls; cylinders: it has none; mass and inertia as"
                        + " given, read back",
                "position is that of the body's origin, which is the centre of mass here");
    }

    @Override
    public void close() {
        call(destroyWorld, world);
        MethodHandle free = find("b3DestroyMesh", FunctionDescriptor.ofVoid(ADDRESS));
        for (MemorySegment mesh : meshes) {
            call(free, mesh);
        }
        arena.close();
    }
}
