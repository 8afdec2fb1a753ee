package dev.cairn.samples;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleSupplier;

/** How far a scene is from its closed forms, by name, in the order of declaration. One thread. */
final class ErrorMetrics {
    private final List<String> names = new ArrayList<>();
    private final List<DoubleSupplier> metrics = new ArrayList<>();

    void declare(String name, DoubleSupplier metric) {
        int known = names.indexOf(name);
        if (known >= 0) {
            metrics.set(known, metric);
        } else {
            names.add(name);
            metrics.add(metric);
        }
    }

    /** The values that apply now. */
    Map<String, Double> now() {
        Map<String, Double> now = new LinkedHashMap<>();
        for (int i = 0; i < names.size(); i++) {
            double value = metrics.get(i).getAsDouble();
            if (!Double.isNaN(value)) {
                now.put(names.get(i), value);
            }
        }
        return now;
    }

    /**
     * The values that apply now, without garbage.
     *
     * @param toNames gets the names
     * @param toValues gets the values
     * @return how many, at most the length of either
     */
    int read(String[] toNames, double[] toValues) {
        int count = 0;
        for (int i = 0; i < names.size() && count < toNames.length; i++) {
            double value = metrics.get(i).getAsDouble();
            if (!Double.isNaN(value)) {
                toNames[count] = names.get(i);
                toValues[count++] = value;
            }
        }
        return count;
    }
}
