package dev.cairn.samples;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ModelGroup;
import dev.cairn.render.mesh.Texture;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;

/**
 * What a scene's script speaks to, and, once the script has run, the scene's live side: its bodies,
 * camera, hooks and error metrics.
 *
 * <p>A body added here carries a {@code Visual}, so a window or an offscreen picture can draw it;
 * nothing here needs GL. Whoever steps the world calls {@link #beforeTick} and {@link #afterTick}
 * around each step. One thread, the simulation's.
 */
public final class SceneBuilder {
    private static final double LEAST_FLOOR = 24;

    private final PhysicsWorld world;
    private final SceneOptions options;
    private final SplittableRandom random;
    private final List<BodyRef> bodies = new ArrayList<>();
    private final List<TickHook> before = new ArrayList<>();
    private final List<TickHook> after = new ArrayList<>();
    private final ErrorMetrics errors = new ErrorMetrics();
    private final List<ConstantForce> forces = new ArrayList<>();
    private final List<String> remarks = new ArrayList<>();
    private final List<String> remarksSeen = Collections.unmodifiableList(remarks);
    private final IdentityHashMap<Shape, Model> models = new IdentityHashMap<>();
    private final List<Long> visuals = new ArrayList<>();
    private SceneView view = new SceneView(0, 4, 14, 0, 1, 0);
    private Light light = Light.DAYLIGHT;
    private double stepSeconds = SampleScene.STEP_SECONDS;
    private double gravityTurn;
    private long tick;
    private boolean hasSystems;

    /**
     * A force that never changes.
     *
     * @param body index of the body in {@link #bodies}
     * @param fx at the centre of mass, world, N
     * @param fy at the centre of mass, world, N
     * @param fz at the centre of mass, world, N
     */
    public record ConstantForce(int body, double fx, double fy, double fz) {}

    /**
     * Creates a builder.
     *
     * @param world an empty world with gravity (0, -{@link SampleScene#GRAVITY}, 0)
     * @param options values of the scene's parameters
     */
    public SceneBuilder(PhysicsWorld world, SceneOptions options) {
        this.world = world;
        this.options = options;
        this.random = new SplittableRandom(options.seed());
    }

    /**
     * The world that the bodies go to.
     *
     * @return the world
     */
    public PhysicsWorld world() {
        return world;
    }

    /**
     * The value of a parameter.
     *
     * @param name its name
     * @return what the user set, or the default
     * @throws IllegalArgumentException if the scene declares no such parameter
     */
    public double get(String name) {
        Double value = options.values().get(name);
        if (value == null) {
            throw new IllegalArgumentException(
                    "parameter \"" + name + "\" is not declared by this scene");
        }
        return value;
    }

    /**
     * The value of a counting parameter.
     *
     * @param name its name
     * @return what the user set, or the default
     */
    public int count(String name) {
        return (int) get(name);
    }

    /**
     * The mesh file of {@code --obj}.
     *
     * @return the path, or null if none was given
     */
    public @Nullable Path obj() {
        return options.obj();
    }

    /**
     * A number between two bounds, drawn from the stream that {@code --seed} starts.
     *
     * @param low lower bound
     * @param high upper bound, above the lower
     * @return low &lt;= number &lt; high
     */
    public double random(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    /**
     * Adds a body and the way it looks.
     *
     * @param shape its shape; bodies that share the object share the mesh
     * @param rgb its colour, 0xRRGGBB
     * @param body all else
     * @return the body in the world
     */
    public BodyRef add(Shape shape, int rgb, Body body) {
        Model model = models.get(shape);
        if (model == null) {
            model = Model.of(shape);
            models.put(shape, model);
        }
        return add(shape, model.color(rgb), body);
    }

    /**
     * Adds a body and the way it looks.
     *
     * @param shape its shape
     * @param model its look
     * @param body all else
     * @return the body in the world
     */
    public BodyRef add(Shape shape, Model model, Body body) {
        return add(body.shape(shape), new Visual(model));
    }

    /**
     * Adds a body of several shapes, drawn as they are.
     *
     * @param parts what it is made of
     * @param rgb its colour
     * @param body all else
     * @return the body in the world
     */
    public BodyRef addParts(List<Collider> parts, int rgb, Body body) {
        List<Model> look = new ArrayList<>();
        for (Collider part : parts) {
            look.add(Model.of(part.placed()).color(rgb));
            body.collider(part);
        }
        return remember(world.add(body.with(new Visual(new ModelGroup(look)))));
    }

    /**
     * Adds a body that says itself what it is made of.
     *
     * @param body all of it
     * @param look a {@code Model} or a {@code ModelGroup}, or null if it is not drawn
     * @return the body in the world
     */
    public BodyRef add(Body body, @Nullable Visual look) {
        return remember(world.add(look == null ? body : body.with(look)));
    }

    /**
     * Adds a body of glass: a wall that holds what is behind it, and hides none of it.
     *
     * @param shape its shape
     * @param body all else
     * @return the body in the world
     */
    public BodyRef addGlass(Shape shape, Body body) {
        return add(shape, Model.of(shape).texture(Texture.glass()).color(Palette.GLASS), body);
    }

    /**
     * Adds something that is drawn but has no part in the physics.
     *
     * @param pose where
     * @param look a {@code Model} or a {@code ModelGroup}
     * @return its entity
     */
    public long addVisual(Pose pose, Visual look) {
        long entity = world.ecs().spawn(pose, look);
        visuals.add(entity);
        return entity;
    }

    /** Removes what was added and is still there, and gives the world its usual gravity back. */
    public void clear() {
        for (BodyRef body : bodies) {
            if (body.isAlive()) {
                body.remove();
            }
        }
        for (long entity : visuals) {
            if (world.ecs().isAlive(entity)) {
                world.ecs().delete(entity);
            }
        }
        visuals.clear();
        world.setGravity(0, -SampleScene.GRAVITY, 0);
    }

    private BodyRef remember(BodyRef body) {
        bodies.add(body);
        return body;
    }

    /**
     * Adds a fixed, level plate whose upper side is the plane y = 0, centred on the origin; it
     * reaches {@value #LEAST_FLOOR} m each way at least, so that it is seen to end in a horizon.
     *
     * @param halfX half of the size that the scene needs along x, m
     * @param halfZ half of the size that the scene needs along z, m
     * @param friction its Coulomb coefficient
     * @param restitution its coefficient of restitution
     * @return the plate
     */
    public BodyRef floor(double halfX, double halfZ, double friction, double restitution) {
        double halfY = 0.5;
        Box plate =
                Box.ofHalfExtents(
                        Math.max(halfX, LEAST_FLOOR), halfY, Math.max(halfZ, LEAST_FLOOR));
        return add(
                plate,
                Model.ground(plate),
                Body.fixed()
                        .at(0, -halfY, 0)
                        .material(Palette.material(friction, restitution))
                        .name("floor"));
    }

    /**
     * Says where the scene wants to be seen from.
     *
     * @param value the camera's place and aim
     */
    public void view(SceneView value) {
        view = value;
    }

    /**
     * Where the scene wants to be seen from.
     *
     * @return the camera's place and aim
     */
    public SceneView view() {
        return view;
    }

    /**
     * Says in which light the scene wants to be seen.
     *
     * @param value the light; {@link Light#DAYLIGHT} if nothing is said
     */
    public void light(Light value) {
        light = value;
    }

    /**
     * In which light the scene wants to be seen.
     *
     * @return the light
     */
    public Light light() {
        return light;
    }

    /**
     * Changes the length of a tick for runs without a window.
     *
     * @param value s, above 0; {@link SampleScene#STEP_SECONDS} if nothing is said
     */
    public void stepSeconds(double value) {
        stepSeconds = value;
    }

    /**
     * The length of a tick.
     *
     * @return s
     */
    public double stepSeconds() {
        return stepSeconds;
    }

    /**
     * Has something done before every tick: forces, bodies that come and go.
     *
     * @param hook called with the number of the tick to come and the time at its end
     */
    public void beforeTick(TickHook hook) {
        before.add(hook);
    }

    /**
     * Whether the scene does something before ticks, which a scene file cannot hold.
     *
     * @return true if {@link #beforeTick(TickHook)} was called, or systems of the scene act
     */
    public boolean actsBeforeTicks() {
        return hasSystems || !before.isEmpty();
    }

    SceneOptions options() {
        return options;
    }

    void needs(String scene, String system) {
        if (!world.ecs().schedule().systems().contains(system)) {
            throw new IllegalArgumentException(
                    "scene %s needs the system \"%s\", which its world lacks: build the world with"
                                    .formatted(scene, system)
                            + " PhysicsWorld.builder().systems(scene.systems(options))");
        }
        hasSystems = true;
    }

    /**
     * Has something done after every tick: truths compared, events noted.
     *
     * @param hook called with the number of the tick and the time at its end
     */
    public void afterTick(TickHook hook) {
        after.add(hook);
    }

    /**
     * Has a force act on a body in every tick. As data, so that whoever runs the scene in another
     * engine can apply it there.
     *
     * @param body a body that was added here
     * @param fx at the centre of mass, world, N
     * @param fy at the centre of mass, world, N
     * @param fz at the centre of mass, world, N
     */
    public void constantForce(BodyRef body, double fx, double fy, double fz) {
        forces.add(new ConstantForce(bodies.indexOf(body), fx, fy, fz));
        beforeTick((next, seconds) -> body.applyForce(fx, fy, fz));
    }

    /**
     * The forces that act in every tick.
     *
     * @return a live, unmodifiable view
     */
    public List<ConstantForce> forces() {
        return Collections.unmodifiableList(forces);
    }

    /**
     * Turns gravity about the z axis, as it looks from inside a drum that turns the other way.
     *
     * @param radiansPerSecond angular speed, from -y towards +x if positive; 0 stops it
     */
    public void gravityTurn(double radiansPerSecond) {
        gravityTurn = radiansPerSecond;
        beforeTick((next, seconds) -> {
            double angle = gravityAngle(next);
            world.setGravity(
                    SampleScene.GRAVITY * StrictMath.sin(angle),
                    -SampleScene.GRAVITY * StrictMath.cos(angle),
                    0);
        });
    }

    /**
     * The direction of gravity in a tick.
     *
     * @param number of the tick, 1 for the first
     * @return its angle from -y towards +x, radians
     */
    public double gravityAngle(long number) {
        return gravityTurn * (number - 1) * SampleScene.STEP_SECONDS;
    }

    /**
     * Declares an error metric: how far the scene is from its closed form.
     *
     * @param name name in reports, ending in its unit or in {@code Relative}
     * @param value the metric over the ticks so far; NaN where the closed form does not apply
     */
    public void error(String name, DoubleSupplier value) {
        errors.declare(name, value);
    }

    /**
     * Notes a line for the user, printed after the run or while the window is open.
     *
     * @param line text without a line break
     */
    public void remark(String line) {
        remarks.add(line);
    }

    /**
     * All bodies added so far, in order.
     *
     * @return a live, unmodifiable view
     */
    public List<BodyRef> bodies() {
        return Collections.unmodifiableList(bodies);
    }

    /**
     * The lines noted so far.
     *
     * @return a live, unmodifiable view
     */
    public List<String> remarks() {
        return remarksSeen;
    }

    /**
     * The error metrics at this moment; those whose closed form does not apply are left out.
     *
     * @return values by name, in the order of declaration
     */
    public Map<String, Double> errors() {
        return errors.now();
    }

    /**
     * The same without garbage.
     *
     * @param toNames gets the names
     * @param toValues gets the values
     * @return how many, at most the length of either
     */
    public int readErrors(String[] toNames, double[] toValues) {
        return errors.read(toNames, toValues);
    }

    /** Runs the scene's hooks before a step of the world. */
    public void beforeTick() {
        long next = tick + 1;
        for (int i = 0; i < before.size(); i++) {
            before.get(i).run(next, next * stepSeconds);
        }
    }

    /** Runs the scene's hooks after a step of the world, and counts the tick. */
    public void afterTick() {
        tick++;
        for (int i = 0; i < after.size(); i++) {
            after.get(i).run(tick, tick * stepSeconds);
        }
    }

    /**
     * Counts on from another tick, since the world was put back to its state then.
     *
     * @param number of the tick, at least 0
     */
    public void returnTo(long number) {
        tick = number;
    }

    /**
     * The ticks counted so far.
     *
     * @return at least 0
     */
    public long tick() {
        return tick;
    }
}
