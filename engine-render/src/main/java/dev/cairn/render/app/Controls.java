package dev.cairn.render.app;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Control;
import dev.cairn.render.input.Controllable;
import dev.cairn.render.input.Drive;
import dev.cairn.render.input.Key;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.EnumSet;

/** Does to the entities with a {@link Controllable} what the user asks for. Simulation thread. */
final class Controls {
    private final PhysicsWorld physics;
    private final Camera camera;
    private final Bindings bindings;
    private final Query controllable;
    private final EnumSet<Key> keys = EnumSet.noneOf(Key.class);
    private long[] entities = new long[4];
    private final Vector3d vector = new Vector3d();
    private final Vector3d forward = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private final Drive drive;
    private Drive.@Nullable Listener listener;

    Controls(PhysicsWorld physics, Camera camera, Bindings bindings) {
        this.physics = physics;
        this.camera = camera;
        this.bindings = bindings;
        this.drive = new Drive(physics);
        this.controllable = physics.ecs().query(Controllable.COMPONENT);
    }

    /** Tells somebody of all that is done. */
    void listener(Drive.Listener value) {
        listener = value;
    }

    /** Before a tick of so many seconds. */
    void drive(double seconds) {
        int count = find();
        keys.clear();
        for (int i = 0; i < count; i++) {
            Controllable component = physics.ecs().get(entities[i], Controllable.COMPONENT);
            for (Control control : component.controls()) {
                if (control.key() != null) {
                    keys.add(control.key());
                }
                if (isAsked(control)) {
                    act(entities[i], control, seconds);
                }
            }
        }
        bindings.reserve(keys);
    }

    /** Lists the entities first: a pose that is set may move its entity between chunks. */
    private int find() {
        int count = 0;
        for (int c = 0; c < controllable.chunkCount(); c++) {
            Chunk chunk = controllable.chunk(c);
            for (int row = 0; row < chunk.size(); row++) {
                if (count == entities.length) {
                    entities = Arrays.copyOf(entities, 2 * count);
                }
                entities[count++] = chunk.entity(row);
            }
        }
        return count;
    }

    private boolean isAsked(Control control) {
        boolean once = control.effect() == Control.Effect.KICK;
        if (control.key() != null) {
            return once ? bindings.wasPressed(control.key()) : bindings.isDown(control.key());
        }
        return control.button() != null
                && (once
                        ? bindings.wasPressed(control.button())
                        : bindings.isDown(control.button()));
    }

    private void act(long entity, Control control, double seconds) {
        BodyRef body = physics.bodyOf(entity);
        vector.set(control.x(), control.y(), control.z());
        switch (control.axes()) {
            case WORLD -> {}
            case ENTITY -> orientation(entity, body).transform(vector);
            case VIEW -> {
                // Level: yaw 0 looks along -z and grows to the right.
                camera.forward(forward);
                vector.rotateY(-Math.atan2(forward.x, -forward.z));
            }
        }
        drive.apply(entity, control.effect(), vector.x, vector.y, vector.z, seconds);
        if (listener != null) {
            listener.driven(entity, control.effect(), vector.x, vector.y, vector.z, seconds);
        }
    }

    private Quaterniond orientation(long entity, @Nullable BodyRef body) {
        if (body != null) {
            return body.orientation(turn);
        }
        World ecs = physics.ecs();
        if (!ecs.has(entity, Pose.COMPONENT)) {
            return turn.identity();
        }
        Pose pose = ecs.get(entity, Pose.COMPONENT);
        return turn.set(pose.qx(), pose.qy(), pose.qz(), pose.qw());
    }
}
