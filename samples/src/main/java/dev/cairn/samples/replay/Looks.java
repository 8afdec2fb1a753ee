package dev.cairn.samples.replay;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.input.Controllable;
import dev.cairn.render.mesh.Mesh;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ModelGroup;
import dev.cairn.render.mesh.Texture;
import dev.cairn.samples.weather.Hull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * How the looks of a scene become bytes: meshes, textures and controls by their number among those
 * that the scene begins with, so that they can be read back wherever the same scene was built, and
 * no mesh is written. A mesh that came later than the beginning, other than that of a box, ball,
 * cylinder or cone, becomes the placeholder. One thread.
 */
public final class Looks {
    private final List<Object> known = new ArrayList<>();
    private final IdentityHashMap<Object, Integer> numbers = new IdentityHashMap<>();

    /**
     * Those of a scene.
     *
     * @param world with the scene as it begins
     */
    public Looks(PhysicsWorld world) {
        addLook(Model.placeholder());
        addLook(Model.of(Box.ofHalfExtents(1, 1, 1)));
        addLook(Model.of(Sphere.of(1)));
        addLook(Model.of(Cylinder.of(1, 1)));
        addLook(Model.of(Cone.of(1, 1)));
        World ecs = world.ecs();
        ecs.query(Visual.COMPONENT)
                .forEach(entity -> addLook(ecs.get(entity, Visual.COMPONENT).model()));
        ecs.query(Controllable.COMPONENT)
                .forEach(entity -> add(ecs.get(entity, Controllable.COMPONENT).controls()));
    }

    private void addLook(Object look) {
        switch (look) {
            case Model model -> {
                add(model.mesh());
                add(model.texture());
            }
            case ModelGroup group -> group.parts().forEach(this::addLook);
            default -> throw new IllegalArgumentException(look + " is no model");
        }
    }

    private void add(Object object) {
        if (numbers.putIfAbsent(object, known.size()) == null) {
            known.add(object);
        }
    }

    /**
     * Codecs of all that the world of a scene holds, and of what is done to it.
     *
     * @return codecs that write looks by number
     */
    public StateCodecs codecs() {
        StateCodecs all =
                PhysicsWorld.codecs(Controllable.COMPONENT, CameraMount.COMPONENT, Hull.COMPONENT)
                        .with(Act.CODEC)
                        .with(StateCodec.of(Model.class, "look", this::write, this::read))
                        .with(StateCodec.of(ModelGroup.class, "looks", this::write, this::readAll));
        // Lists of controls, of whichever class they are.
        Map<Class<?>, String> lists = new HashMap<>();
        for (Object object : known) {
            if (object instanceof List<?>
                    && lists.put(object.getClass(), "controls" + lists.size()) == null) {
                all = all.with(controls(object.getClass(), "controls" + (lists.size() - 1)));
            }
        }
        return all;
    }

    private <T> StateCodec<T> controls(Class<T> type, String name) {
        return StateCodec.of(
                type,
                name,
                (list, out) -> out.writeInt(numbers.getOrDefault(list, -1)),
                in -> known(type, in.readInt()));
    }

    private void write(ModelGroup group, StateOutput out) {
        out.writeInt(group.parts().size());
        for (Model part : group.parts()) {
            write(part, out);
        }
    }

    private ModelGroup readAll(StateInput in) {
        List<Model> parts = new ArrayList<>();
        for (int left = in.requireCount(60, in.readInt()); left > 0; left--) {
            parts.add(read(in));
        }
        return new ModelGroup(parts);
    }

    private void write(Model model, StateOutput out) {
        Model known = numbers.containsKey(model.mesh()) ? model : Model.placeholder();
        out.writeInt(numbers.getOrDefault(known.mesh(), -1));
        out.writeInt(numbers.getOrDefault(known.texture(), 1)); // a texture that came later
        out.writeInt(known.rgb());
        out.writeDouble(known.scaleX());
        out.writeDouble(known.scaleY());
        out.writeDouble(known.scaleZ());
        out.writeDouble(known.originX());
        out.writeDouble(known.originY());
        out.writeDouble(known.originZ());
    }

    private Model read(StateInput in) {
        return new Model(
                known(Mesh.class, in.readInt()),
                known(Texture.class, in.readInt()),
                in.readInt(),
                in.readDouble(),
                in.readDouble(),
                in.readDouble(),
                in.readDouble(),
                in.readDouble(),
                in.readDouble());
    }

    private <T> T known(Class<T> type, int number) {
        if (number < 0 || number >= known.size()) {
            throw new IllegalArgumentException(
                    "look " + number + " of a scene that has " + known.size());
        }
        return type.cast(known.get(number));
    }
}
