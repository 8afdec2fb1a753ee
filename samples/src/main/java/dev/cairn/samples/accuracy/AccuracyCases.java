package dev.cairn.samples.accuracy;

import java.util.ArrayList;
import java.util.List;

/** All cases, in the order of the table. Stateless. */
public final class AccuracyCases {
    private static final List<AccuracyCase> CASES = collect();

    private AccuracyCases() {}

    private static List<AccuracyCase> collect() {
        List<AccuracyCase> all = new ArrayList<>();
        all.addAll(FreeMotion.cases());
        all.addAll(Rocking.rest());
        all.addAll(Impact.cases());
        all.addAll(Stacks.unloading());
        all.addAll(Friction.cases());
        all.addAll(Rocking.cases());
        all.addAll(Rolling.cases());
        all.addAll(Stacks.cases());
        all.addAll(Fast.cases());
        all.addAll(Invariance.cases());
        all.addAll(Conservation.cases());
        return List.copyOf(all);
    }

    /**
     * All cases.
     *
     * @return an immutable list
     */
    public static List<AccuracyCase> all() {
        return CASES;
    }

    /**
     * Finds a case.
     *
     * @param id its id, in any case of letters
     * @return the case
     * @throws IllegalArgumentException if there is none
     */
    public static AccuracyCase get(String id) {
        for (AccuracyCase one : CASES) {
            if (one.id().equalsIgnoreCase(id)) {
                return one;
            }
        }
        throw new IllegalArgumentException(
                "there is no accuracy case \"%s\"; there are: %s"
                        .formatted(
                                id,
                                String.join(", ", CASES.stream().map(AccuracyCase::id).toList())));
    }
}
