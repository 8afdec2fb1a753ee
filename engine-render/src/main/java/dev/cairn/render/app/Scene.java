package dev.cairn.render.app;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.camera.Light;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Drive;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ModelGroup;

import java.util.Objects;
import java.util.Set;
import java.util.function.Predicate;

/**
 * What an application shows: a world of bodies, how they look, the camera, the light and the key
 * bindings. All methods belong to the simulation thread, which is the thread of {@code initScene},
 * of {@code update} and of bound functions.
 */
public final class Scene {
    private final PhysicsWorld physics;
    private final Camera camera;
    private final Bindings bindings;
    private final Controls controls;
    private volatile Light light = Light.DAYLIGHT;
    private volatile String title;
    private Predicate<RuntimeException> failed = failure -> false;

    Scene(PhysicsWorld physics, Camera camera, Bindings bindings, String title) {
        this.physics = physics;
        this.camera = camera;
        this.bindings = bindings;
        this.title = title;
        this.controls = new Controls(physics, camera, bindings);
        bindings.reserve(Set.of());
    }

    /**
     * Has the camera ride on what carries it; a camera that the scene itself put on stays there.
     */
    void mountCamera() {
        if (physics.ecs().query(CameraMount.COMPONENT).entityCount() > 0) {
            CameraMount.attach(physics.ecs(), camera);
        }
    }

    /** Lets the user drive what is {@code Controllable}, before a tick. */
    void drive(double seconds) {
        controls.drive(seconds);
    }

    /**
     * Has somebody told of all that keys and buttons do to what is {@code Controllable}, say to
     * write it down.
     *
     * @param listener called before a tick for each thing done, on the simulation thread
     * @return this
     */
    public Scene onDrive(Drive.Listener listener) {
        controls.listener(Objects.requireNonNull(listener, "listener"));
        return this;
    }

    /**
     * Has somebody asked what to do when a tick fails: a hook threw, or a number of the scene was
     * too large for the world. Without an answer the window is closed.
     *
     * @param goesOn gets what was thrown, on the simulation thread; says whether the world is to be
     *     thrown away and made anew, as by {@link Application#restart}; whoever says so may want to
     *     pause, since what failed may fail again
     * @return this
     */
    public Scene onFailure(Predicate<RuntimeException> goesOn) {
        failed = Objects.requireNonNull(goesOn, "goesOn");
        return this;
    }

    boolean beginsAgainAfter(RuntimeException failure) {
        return failed.test(failure);
    }

    /**
     * The bodies, and through {@link PhysicsWorld#ecs()} all entities.
     *
     * @return the world
     */
    public PhysicsWorld physics() {
        return physics;
    }

    /**
     * Adds a body that is drawn.
     *
     * @param body what it is like; may be used again
     * @param model how it looks, in the frame of the body's shape
     * @return the body
     */
    public BodyRef add(Body body, Model model) {
        Objects.requireNonNull(model, "model");
        BodyRef added = physics.add(body);
        physics.ecs().add(added.entity(), new Visual(model));
        return added;
    }

    /**
     * Adds a body that is drawn in several parts.
     *
     * @param body what it is like; may be used again
     * @param look how it looks, in the frame of the body's shape
     * @return the body
     */
    public BodyRef add(Body body, ModelGroup look) {
        Objects.requireNonNull(look, "look");
        BodyRef added = physics.add(body);
        physics.ecs().add(added.entity(), new Visual(look));
        return added;
    }

    /**
     * Adds a body that is drawn as its shape.
     *
     * @param body what it is like
     * @return the body
     */
    public BodyRef add(Body body) {
        BodyRef added = physics.add(body);
        physics.ecs().add(added.entity(), new Visual(Model.of(added.shape())));
        return added;
    }

    /**
     * Adds something that is drawn but has no part in the physics. Move it by {@code
     * physics().ecs().set(entity, pose)}.
     *
     * @param pose where
     * @param model how it looks
     * @return its entity
     */
    public long addVisual(Pose pose, Model model) {
        return physics.ecs().spawn(pose, new Visual(Objects.requireNonNull(model, "model")));
    }

    /**
     * Adds something of several parts that is drawn but has no part in the physics.
     *
     * @param pose where
     * @param look how it looks
     * @return its entity
     */
    public long addVisual(Pose pose, ModelGroup look) {
        return physics.ecs().spawn(pose, new Visual(Objects.requireNonNull(look, "look")));
    }

    /**
     * The camera; it may be placed at any time.
     *
     * @return the camera
     */
    public Camera camera() {
        return camera;
    }

    /**
     * What keys and buttons do.
     *
     * @return the bindings, with the application's defaults in them
     */
    public Bindings bindings() {
        return bindings;
    }

    /**
     * The light.
     *
     * @return the light in force
     */
    public Light light() {
        return light;
    }

    /**
     * Changes the light.
     *
     * @param value the new light
     * @return this
     */
    public Scene light(Light value) {
        light = Objects.requireNonNull(value, "light");
        return this;
    }

    /**
     * The window's title.
     *
     * @return the title
     */
    public String title() {
        return title;
    }

    /**
     * Changes the window's title.
     *
     * @param value the new title
     * @return this
     */
    public Scene title(String value) {
        title = Objects.requireNonNull(value, "title");
        return this;
    }
}
