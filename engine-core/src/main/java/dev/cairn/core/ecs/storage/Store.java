package dev.cairn.core.ecs.storage;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.ecs.component.DeadEntityException;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.storage.Watch.What;
import dev.cairn.core.state.StateVisitor;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Entities and archetype tables, and the structural changes on them. Every change is checked first
 * and made afterwards, so a refused call leaves nothing half done. Simulation thread, between ticks
 * or at commit.
 */
public final class Store {
    public final EntityTable entities = new EntityTable();
    public final List<Archetype> archetypes = new ArrayList<>();
    private Watch[] watches = Watch.NONE;

    /** Goes up when an archetype appears or the number of used slabs of one changes. */
    public long structureVersion = 1;

    /** Number of the tick that changes are stamped with. */
    public long tick;

    /** Of the component that is watched, if one is: whose value was set. */
    public @Nullable Component<?> watched;

    public long[] told = {};
    public int toldCount;

    /** Goes up when tables go: then their numbers name others. */
    public int dropped;

    /** Room to restore the components of a table. */
    private Component<?>[] savedParts = {};

    private final Map<ComponentSet, Archetype> bySet = new HashMap<>();
    private final SpawnPlans plans = new SpawnPlans();
    private final Archetype empty;

    public Store() {
        empty = archetype(ComponentSet.EMPTY, List.of());
    }

    /** Tells these of all changes from now on, in their order, and nobody else. */
    public void watchBy(Watch[] all) {
        watches = all;
        for (Archetype archetype : archetypes) {
            archetype.watchBy(all);
        }
    }

    private Archetype archetype(ComponentSet set, List<Component<?>> members) {
        Archetype known = bySet.get(set);
        if (known != null) {
            return known;
        }
        Archetype created = new Archetype(archetypes.size(), set, members);
        created.watchBy(watches);
        archetypes.add(created);
        bySet.put(set, created);
        structureVersion++;
        return created;
    }

    public long spawn() {
        return append(empty);
    }

    public long spawn(Record a) {
        SpawnPlan plan = plans.find(a.getClass());
        if (plan == null) {
            plan = plan(a);
        }
        long entity = append(plan.archetype);
        int local = ChunkSizes.local(plan.archetype.rows - 1);
        plan.write(0, a, lastSlab(plan.archetype), local);
        plan.archetype.tellAll(What.ADDED, entity, plan.archetype.rows - 1);
        return entity;
    }

    public long spawn(Record a, Record b) {
        SpawnPlan plan = plans.find(a.getClass(), b.getClass());
        if (plan == null) {
            plan = plan(a, b);
        }
        long entity = append(plan.archetype);
        int local = ChunkSizes.local(plan.archetype.rows - 1);
        Slab slab = lastSlab(plan.archetype);
        plan.write(0, a, slab, local);
        plan.write(1, b, slab, local);
        plan.archetype.tellAll(What.ADDED, entity, plan.archetype.rows - 1);
        return entity;
    }

    public long spawn(Record[] records) {
        return spawn(find(records), records);
    }

    public void spawnMany(long[] into, Record[] records) {
        SpawnPlan plan = find(records);
        entities.reserve(into.length);
        for (int i = 0; i < into.length; i++) {
            into[i] = spawn(plan, records);
        }
    }

    private long spawn(SpawnPlan plan, Record[] records) {
        long entity = append(plan.archetype);
        int local = ChunkSizes.local(plan.archetype.rows - 1);
        Slab slab = lastSlab(plan.archetype);
        for (int part = 0; part < records.length; part++) {
            plan.write(part, records[part], slab, local);
        }
        plan.archetype.tellAll(What.ADDED, entity, plan.archetype.rows - 1);
        return entity;
    }

    private static Slab lastSlab(Archetype archetype) {
        return archetype.slab(archetype.rows - 1);
    }

    private long append(Archetype archetype) {
        long entity = entities.create();
        int row = archetype.append(entity, tick);
        entities.put(entity, archetype.index, row);
        if (ChunkSizes.local(row) == 0) {
            structureVersion++;
        }
        return entity;
    }

    private SpawnPlan find(Record[] records) {
        SpawnPlan plan = plans.find(records);
        return plan != null ? plan : plan(records);
    }

    private SpawnPlan plan(Record... records) {
        Component<?>[] components = components(records);
        List<Component<?>> members = List.of(components);
        Class<?>[] types = new Class<?>[records.length];
        Arrays.setAll(types, i -> records[i].getClass());
        SpawnPlan plan =
                new SpawnPlan(types, components, archetype(ComponentSet.of(members), members));
        plans.put(plan);
        return plan;
    }

    /** The components of the records of one spawn. */
    public static Component<?>[] components(Record... records) {
        Component<?>[] components = new Component<?>[records.length];
        for (int i = 0; i < records.length; i++) {
            components[i] = Component.of(records[i].getClass());
            for (int before = 0; before < i; before++) {
                if (components[before] == components[i]) {
                    throw new ComponentException(
                            "component "
                                    + components[i]
                                    + " is given twice in one spawn; an entity has each component"
                                    + " at most once");
                }
            }
        }
        return components;
    }

    public void delete(long entity) {
        long place = require(entity, "delete");
        archetype(place).tellAll(What.REMOVED, entity, row(place));
        removeRow(archetype(place), row(place));
        entities.free(entity);
    }

    private void removeRow(Archetype archetype, int row) {
        long moved = archetype.removeRow(row, tick);
        if (moved != Entities.NONE) {
            entities.put(moved, archetype.index, row);
        }
        if (ChunkSizes.local(archetype.rows) == 0) {
            structureVersion++;
        }
    }

    public void add(long entity, Record value) {
        long place = require(entity, "add");
        Component<?> component = Component.of(value.getClass());
        Archetype from = archetype(place);
        if (from.has(component)) {
            throw new ComponentException(
                    "entity "
                            + Entities.toString(entity)
                            + " has a "
                            + component
                            + " already; replace it with set");
        }
        Archetype to = from.grownBy(component);
        if (to == null) {
            List<Component<?>> members = new ArrayList<>(Arrays.asList(from.components));
            members.add(component);
            to = archetype(from.set.with(component), members);
            from.rememberGrown(component, to);
            to.rememberShrunk(component, from);
        }
        int row = move(entity, from, row(place), to);
        component
                .codec()
                .write(value, to.slab(row).published, to.base(component), ChunkSizes.local(row));
        to.tell(What.ADDED, entity, row, component);
    }

    public void remove(long entity, Component<?> component) {
        long place = require(entity, "remove");
        Archetype from = archetype(place);
        if (!from.has(component)) {
            throw absent(entity, component, "there is nothing to remove; ask has first");
        }
        from.tell(What.REMOVED, entity, row(place), component);
        Archetype to = from.shrunkBy(component);
        if (to == null) {
            List<Component<?>> members = new ArrayList<>(Arrays.asList(from.components));
            members.remove(component);
            to = archetype(from.set.without(component), members);
            from.rememberShrunk(component, to);
            to.rememberGrown(component, from);
        }
        move(entity, from, row(place), to);
    }

    public void clear(long entity) {
        long place = require(entity, "clear");
        Archetype from = archetype(place);
        if (from != empty) {
            from.tellAll(What.REMOVED, entity, row(place));
            move(entity, from, row(place), empty);
        }
    }

    /** Moves a row to another table, with the components that both have. */
    private int move(long entity, Archetype from, int row, Archetype to) {
        int target = to.append(entity, tick);
        if (ChunkSizes.local(target) == 0) {
            structureVersion++;
        }
        Slab source = from.slab(row);
        Slab destination = to.slab(target);
        int local = ChunkSizes.local(row);
        int targetLocal = ChunkSizes.local(target);
        for (Component<?> component : from.components) {
            int base = to.base(component);
            if (base >= 0) {
                int old = from.base(component);
                for (int i = 0; i < component.fieldCount(); i++) {
                    component
                            .field(i)
                            .copyRow(
                                    source.published[old + i],
                                    local,
                                    destination.published[base + i],
                                    targetLocal);
                }
            }
        }
        removeRow(from, row);
        entities.put(entity, to.index, target);
        return target;
    }

    public <T extends Record> T get(long entity, Component<T> component) {
        long place = require(entity, "get");
        Archetype archetype = archetype(place);
        int base = archetype.base(component);
        if (base < 0) {
            throw absent(entity, component, "ask has first");
        }
        int row = row(place);
        return component
                .type()
                .cast(
                        component
                                .codec()
                                .read(archetype.slab(row).published, base, ChunkSizes.local(row)));
    }

    public boolean has(long entity, Component<?> component) {
        return archetype(require(entity, "has")).has(component);
    }

    public void set(long entity, Record value) {
        long place = require(entity, "set");
        Component<?> component = Component.of(value.getClass());
        Archetype archetype = archetype(place);
        int base = archetype.base(component);
        if (base < 0) {
            throw absent(entity, component, "give it one with add");
        }
        int row = row(place);
        Slab slab = archetype.slab(row);
        archetype.keep(row, component);
        component.codec().write(value, slab.published, base, ChunkSizes.local(row));
        Arrays.fill(slab.versions, base, base + component.fieldCount(), tick);
        if (component.equals(watched)) {
            if (toldCount == told.length) {
                told = Arrays.copyOf(told, Math.max(16, 2 * toldCount));
            }
            told[toldCount++] = entity;
        }
        archetype.tell(What.SET, entity, row, component);
    }

    private Archetype archetype(long place) {
        return archetypes.get((int) (place >>> 32));
    }

    private static int row(long place) {
        return (int) place;
    }

    /** Where the entity is. */
    public long require(long entity, String call) {
        long place = entities.place(entity);
        if (place < 0) {
            throw new DeadEntityException(
                    "entity "
                            + Entities.toString(entity)
                            + " is not alive in this world, so "
                            + call
                            + " has nothing to work on; ask isAlive first");
        }
        return place;
    }

    private static ComponentException absent(long entity, Component<?> component, String remedy) {
        return new ComponentException(
                "entity " + Entities.toString(entity) + " has no " + component + "; " + remedy);
    }

    /** Entities and tables. */
    public void state(StateVisitor s) {
        s.section("entities", this);
        tick = s.value("tick", tick);
        toldCount = s.value("toldCount", toldCount);
        told = s.array("told", told, toldCount);
        entities.state(s);
        int tables = s.value("tables", archetypes.size());
        for (int i = 0; i < tables; i++) {
            Component<?>[] now = s.isRestoring() ? savedParts : archetypes.get(i).components;
            int parts = s.value("parts", now.length);
            Component<?>[] members = s.array("components", now, parts);
            if (s.isRestoring()) {
                savedParts = members;
                match(i, members, parts);
            }
            archetypes.get(i).state(s);
            s.section("entities", this);
        }
        if (s.isRestoring()) {
            dropFrom(tables);
            structureVersion++;
        }
    }

    /** Makes the table of a number the one with these components. */
    private void match(int index, Component<?>[] members, int parts) {
        if (index < archetypes.size()) {
            Component<?>[] now = archetypes.get(index).components;
            if (Arrays.equals(now, 0, now.length, members, 0, parts)) {
                return;
            }
        }
        dropFrom(index);
        List<Component<?>> list = List.of(Arrays.copyOf(members, parts));
        archetype(ComponentSet.of(list), list);
    }

    /** The tick in which an entity with a component last left its table; -1 if none has. */
    public long lastDeparture(Component<?> component) {
        long last = -1;
        for (int i = 0; i < archetypes.size(); i++) {
            Archetype archetype = archetypes.get(i);
            if (archetype.has(component)) {
                last = Math.max(last, archetype.departureTick);
            }
        }
        return last;
    }

    /** The order of tables is part of the state: those that came later were never there. */
    private void dropFrom(int count) {
        if (count == archetypes.size()) {
            return;
        }
        while (archetypes.size() > count) {
            bySet.remove(archetypes.removeLast().set);
        }
        for (Archetype archetype : archetypes) {
            archetype.forgetNeighbours();
        }
        plans.clear();
        dropped++;
    }

    public long digest(long hash) {
        long result = entities.digest(hash);
        for (Archetype archetype : archetypes) {
            if (archetype.rows == 0) {
                continue;
            }
            result = Hash.mix(result, archetype.signature);
            result = Hash.mix(result, archetype.rows);
            for (int chunk = 0; chunk < archetype.chunkCount(); chunk++) {
                Slab slab = archetype.slabs[chunk];
                result = Hash.mix(result, Hash.of(slab.entities, slab.size));
                for (Object column : slab.published) {
                    result = Hash.mix(result, Hash.of(column, slab.size));
                }
            }
        }
        return result;
    }
}
