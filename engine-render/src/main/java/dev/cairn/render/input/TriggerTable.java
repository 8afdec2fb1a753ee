package dev.cairn.render.input;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Which trigger starts which action, now and by default, and the lists of that which any thread may
 * read.
 */
final class TriggerTable {
    private static final Key[] NO_KEYS = {};

    private final Map<Trigger, String> actionOf = new LinkedHashMap<>();
    private Map<Trigger, String> defaults = Map.of();
    private volatile Map<String, Key[]> keysOfAction = Map.of();
    private volatile Map<String, List<Trigger>> triggersOfAction = Map.of();
    private volatile List<Bindings.Binding> listed = List.of();

    /** What a trigger starts, or null. */
    @Nullable String actionOf(Trigger trigger) {
        return actionOf.get(trigger);
    }

    /** As the newest of the action's triggers, so that lists show them in the order of binding. */
    void bind(Trigger trigger, String action) {
        actionOf.remove(trigger);
        actionOf.put(trigger, action);
    }

    /** Nothing starts an action any more. */
    void clear(String action) {
        actionOf.values().removeIf(action::equals);
    }

    void keepAsDefaults() {
        defaults = new LinkedHashMap<>(actionOf);
    }

    /** Back to the defaults of the actions that there are. */
    void reset(Set<String> actions) {
        actionOf.clear();
        defaults.forEach((trigger, action) -> {
            if (actions.contains(action)) {
                actionOf.put(trigger, action);
            }
        });
    }

    /** The triggers that were kept for an action. */
    List<Trigger> defaultsOf(String action) {
        return triggersIn(defaults, action);
    }

    /** The triggers of an action, reserved ones too. */
    List<Trigger> allOf(String action) {
        return triggersIn(actionOf, action);
    }

    private static List<Trigger> triggersIn(Map<Trigger, String> map, String action) {
        List<Trigger> own = new ArrayList<>();
        map.forEach((trigger, bound) -> {
            if (bound.equals(action)) {
                own.add(trigger);
            }
        });
        return own;
    }

    /** Makes the lists anew, without the keys that are reserved. */
    void list(Set<String> actions, Set<Key> reserved) {
        Map<String, Key[]> keys = new LinkedHashMap<>();
        Map<String, List<Trigger>> triggers = new LinkedHashMap<>();
        List<Bindings.Binding> list = new ArrayList<>();
        for (String action : actions) {
            List<Trigger> own = new ArrayList<>(allOf(action));
            own.removeIf(trigger -> trigger instanceof Key key && reserved.contains(key));
            keys.put(action, own.stream().filter(Key.class::isInstance).toArray(Key[]::new));
            String label = own.stream().map(Trigger::label).collect(Collectors.joining(", "));
            Bindings.Binding binding = new Bindings.Binding(action, own, label);
            triggers.put(action, binding.triggers());
            list.add(binding);
        }
        keysOfAction = keys;
        triggersOfAction = triggers;
        listed = List.copyOf(list);
    }

    /** Any thread. */
    List<Bindings.Binding> listed() {
        return listed;
    }

    /** Any thread, no allocation. */
    Key[] keys(String action) {
        return keysOfAction.getOrDefault(action, NO_KEYS);
    }

    /** Any thread, no allocation. */
    List<Trigger> triggers(String action) {
        return triggersOfAction.getOrDefault(action, List.of());
    }
}
