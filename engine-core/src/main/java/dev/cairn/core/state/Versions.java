package dev.cairn.core.state;

import java.util.LinkedHashMap;
import java.util.Map;

/** Names and types of the components of a record, as {@code x:double, cell:int}. */
public final class Versions {
    private Versions() {}

    /**
     * Refuses what was written by another version, and tells the first component that differs.
     *
     * @param what whose components these are, for the message
     * @param saved names and types that were written
     * @param own those of this program
     * @throws StateException if they differ
     */
    public static void require(String what, String saved, String own) {
        if (!saved.equals(own)) {
            throw new StateException(
                    what
                            + " is of another version: "
                            + difference(components(saved), components(own))
                            + "; written were ("
                            + saved
                            + "), and this program has ("
                            + own
                            + ")");
        }
    }

    private static Map<String, String> components(String text) {
        Map<String, String> types = new LinkedHashMap<>();
        for (String component : text.split(", ", -1)) {
            int colon = component.indexOf(':');
            if (colon > 0) {
                types.put(component.substring(0, colon), component.substring(colon + 1));
            }
        }
        return types;
    }

    private static String difference(Map<String, String> saved, Map<String, String> own) {
        for (Map.Entry<String, String> each : saved.entrySet()) {
            String type = own.get(each.getKey());
            String called = "component '" + each.getKey() + "' (" + each.getValue() + ")";
            if (type == null) {
                return called + " is not there any more";
            }
            if (!type.equals(each.getValue())) {
                return called + " is a " + type + " now";
            }
        }
        for (Map.Entry<String, String> each : own.entrySet()) {
            if (!saved.containsKey(each.getKey())) {
                return "component '" + each.getKey() + "' (" + each.getValue() + ") is new";
            }
        }
        return "the components are in another order";
    }
}
