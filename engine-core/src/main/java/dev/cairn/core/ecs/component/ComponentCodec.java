package dev.cairn.core.ecs.component;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.StateException;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.core.state.Versions;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Components in the bytes of a state: by the names of their records, with the names and types of
 * their fields, so that another version is told by name. Only those that are named here come out of
 * bytes, so that no bytes make a program load a class. Immutable; any thread.
 */
@SuppressWarnings("rawtypes") // the class of a key of any record
public final class ComponentCodec implements StateCodec<Component> {
    private final Map<String, Component<?>> known = new LinkedHashMap<>();

    /**
     * A codec.
     *
     * @param components all that entities may have
     */
    public ComponentCodec(Component<?>... components) {
        for (Component<?> component : components) {
            known.put(component.type().getName(), component);
        }
    }

    /**
     * The standard codecs, this one, and those that follow from the classes of the fields.
     *
     * @param components all that entities may have
     * @return codecs
     */
    public static StateCodecs codecs(Component<?>... components) {
        return StateCodecs.STANDARD
                .derived(classes(components))
                .with(new ComponentCodec(components));
    }

    @Override
    public Class<Component> type() {
        return Component.class;
    }

    @Override
    public String name() {
        return "component";
    }

    @Override
    public void write(Component value, StateOutput out) {
        String name = value.type().getName();
        require(name);
        out.writeString(name);
        out.writeString(fields(value));
    }

    @Override
    public Component read(StateInput in) {
        Component<?> component = require(in.readString());
        Versions.require(
                "component " + component.type().getName(), in.readString(), fields(component));
        return component;
    }

    /** Names and types of the fields, which are the columns. */
    private static String fields(Component<?> component) {
        return Arrays.stream(component.fields)
                .map(field -> field.name + ":" + field.type.getTypeName())
                .collect(Collectors.joining(", "));
    }

    /** Classes of the objects in the columns of components. */
    private static Class<?>[] classes(Component<?>... components) {
        return Arrays.stream(components)
                .flatMap(component -> Arrays.stream(component.fields))
                .filter(field -> field.kind == Kind.OBJECT)
                .map(field -> field.type)
                .distinct()
                .toArray(Class<?>[]::new);
    }

    private Component<?> require(String name) {
        Component<?> component = known.get(name);
        if (component == null) {
            throw new StateException(
                    "the state has entities with the component "
                            + name
                            + ", which the codec of components does not know; name it where the"
                            + " codecs are made");
        }
        return component;
    }
}
