package dev.cairn.core.ecs;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateException;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Components in the bytes of a state: by the names of their records. Only those that are named here
 * come out of bytes, so that no bytes make a program load a class. Immutable; any thread.
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
    }

    @Override
    public Component read(StateInput in) {
        return require(in.readString());
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
