package dev.cairn.core.ecs.storage;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The spawn plans by class tuple: an open hash table, since a spawn asks it every time. Classes
 * hash by identity; the table is only looked up, never walked, so that order is not visible.
 */
final class SpawnPlans {
    private @Nullable SpawnPlan[] table = new SpawnPlan[64];
    private int count;

    @Nullable SpawnPlan find(Class<?> a) {
        int mask = table.length - 1;
        for (int i = hash(a) & mask; ; i = i + 1 & mask) {
            SpawnPlan plan = table[i];
            if (plan == null || (plan.types.length == 1 && plan.types[0] == a)) {
                return plan;
            }
        }
    }

    @Nullable SpawnPlan find(Class<?> a, Class<?> b) {
        int mask = table.length - 1;
        for (int i = hash(a) * 31 + hash(b) & mask; ; i = i + 1 & mask) {
            SpawnPlan plan = table[i];
            if (plan == null
                    || (plan.types.length == 2 && plan.types[0] == a && plan.types[1] == b)) {
                return plan;
            }
        }
    }

    @Nullable SpawnPlan find(Record[] records) {
        int mask = table.length - 1;
        int hash = 0;
        for (Record value : records) {
            hash = hash * 31 + hash(value.getClass());
        }
        for (int i = hash & mask; ; i = i + 1 & mask) {
            SpawnPlan plan = table[i];
            if (plan == null || plan.matches(records)) {
                return plan;
            }
        }
    }

    /** Without plans. */
    void clear() {
        Arrays.fill(table, null);
        count = 0;
    }

    void put(SpawnPlan plan) {
        if (++count * 2 > table.length) {
            @Nullable SpawnPlan[] old = table;
            table = new SpawnPlan[old.length * 2];
            for (SpawnPlan each : old) {
                if (each != null) {
                    insert(each);
                }
            }
        }
        insert(plan);
    }

    private void insert(SpawnPlan plan) {
        int mask = table.length - 1;
        int hash =
                Arrays.stream(plan.types)
                        .mapToInt(SpawnPlans::hash)
                        .reduce(0, (h, c) -> h * 31 + c);
        int i = hash & mask;
        while (table[i] != null) {
            i = i + 1 & mask;
        }
        table[i] = plan;
    }

    private static int hash(Class<?> type) {
        return type.hashCode();
    }
}
