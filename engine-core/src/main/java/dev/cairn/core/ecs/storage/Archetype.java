package dev.cairn.core.ecs.storage;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.component.Field;
import dev.cairn.core.state.StateVisitor;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * The table of all entities that have exactly one set of components. Rows are dense: all slabs are
 * full but the last used one. Slabs that fall empty are kept for later rows.
 */
public final class Archetype {
    /** Rows of a new archetype's first slab; it grows, so that lone entities stay cheap. */
    private static final int FIRST_CAPACITY = 64;

    private static final int GROWTH = 4;

    public final int index;
    public final ComponentSet set;

    /** In the order of their class names, which does not depend on class loading. */
    public final Component<?>[] components;

    /** One per column. */
    public final Field[] fields;

    public final int[] objectSlots;

    /** Names of the components, for the digest. */
    public final long signature;

    /** Who observes a component of these, in the order of registration. */
    private Watch[] watches = Watch.NONE;

    public Slab[] slabs = new Slab[0];
    public int rows;

    /** The tick in which a row last left; -1 if none has. */
    long departureTick = -1;

    /** Column by field id, -1 where the archetype has no such column. */
    private final int[] slotByField;

    /** First column by component id, -1 where absent. */
    private final int[] baseByComponent;

    private @Nullable Archetype[] grown = new Archetype[0];
    private @Nullable Archetype[] shrunk = new Archetype[0];

    Archetype(int index, ComponentSet set, List<Component<?>> members) {
        List<Component<?>> sorted = new ArrayList<>(members);
        sorted.sort(Comparator.comparing(component -> component.type().getName()));
        this.index = index;
        this.set = set;
        this.components = sorted.toArray(Component<?>[]::new);
        int maxField = -1;
        int maxComponent = -1;
        List<Field> columns = new ArrayList<>();
        long names = Hash.START;
        for (Component<?> component : components) {
            for (int i = 0; i < component.fieldCount(); i++) {
                columns.add(component.field(i));
            }
            maxComponent = Math.max(maxComponent, component.id());
            names = Hash.mix(names, Hash.of(component.type().getName()));
        }
        this.signature = names;
        this.fields = columns.toArray(Field[]::new);
        for (Field field : fields) {
            maxField = Math.max(maxField, field.id());
        }
        this.slotByField = new int[maxField + 1];
        this.baseByComponent = new int[maxComponent + 1];
        Arrays.fill(slotByField, -1);
        Arrays.fill(baseByComponent, -1);
        int base = 0;
        for (Component<?> component : components) {
            baseByComponent[component.id()] = base;
            for (int i = 0; i < component.fieldCount(); i++) {
                slotByField[component.field(i).id()] = base++;
            }
        }
        this.objectSlots =
                columns.stream().filter(Field::isReference).mapToInt(this::slot).toArray();
    }

    /** The column of a field, or -1. */
    public int slot(Field field) {
        int id = field.id();
        return id < slotByField.length ? slotByField[id] : -1;
    }

    /** The first column of a component, or -1. */
    public int base(Component<?> component) {
        int id = component.id();
        return id < baseByComponent.length ? baseByComponent[id] : -1;
    }

    public boolean has(Component<?> component) {
        return base(component) >= 0;
    }

    /** Number of slabs that have rows. */
    public int chunkCount() {
        return ChunkSizes.count(rows);
    }

    public Slab slab(int row) {
        return slabs[ChunkSizes.chunk(row)];
    }

    /** Adds an uninitialised row for the entity; the caller fills every column. */
    int append(long entity, long tick) {
        int row = rows;
        int chunk = ChunkSizes.chunk(row);
        int local = ChunkSizes.local(row);
        if (chunk == slabs.length || local >= slabs[chunk].entities.length) {
            enlarge(chunk);
        }
        Slab slab = slabs[chunk];
        slab.entities[local] = entity;
        slab.size = local + 1;
        slab.structureTick = tick;
        rows = row + 1;
        return row;
    }

    private void enlarge(int chunk) {
        if (chunk < slabs.length) {
            slabs[chunk].grow(Math.min(ChunkSizes.SMALLEST, slabs[chunk].entities.length * GROWTH));
            return;
        }
        Slab added = new Slab(this, chunk == 0 ? FIRST_CAPACITY : ChunkSizes.capacity(chunk));
        Slab[] longer = Arrays.copyOf(slabs, chunk + 1);
        longer[chunk] = added;
        slabs = longer;
    }

    /**
     * Takes a row out; the last row moves into its place.
     *
     * @return the entity that moved, or {@link Entities#NONE}
     */
    long removeRow(int row, long tick) {
        int last = rows - 1;
        Slab lastSlab = slab(last);
        int lastLocal = ChunkSizes.local(last);
        Slab slab = slab(row);
        int local = ChunkSizes.local(row);
        long moved = Entities.NONE;
        if (row != last) {
            slab.copyRow(lastSlab, lastLocal, local);
            slab.structureTick = tick;
            moved = slab.entities[local];
        }
        if (objectSlots.length > 0) {
            lastSlab.forgetRow(lastLocal);
            lastSlab.forgetSpare(lastLocal);
            slab.forgetSpare(local);
        }
        lastSlab.size = lastLocal;
        lastSlab.structureTick = tick;
        departureTick = tick;
        rows = last;
        return moved;
    }

    /** Takes those that watch one of its components, in the order given. */
    void watchBy(Watch[] all) {
        watches = Arrays.stream(all).filter(watch -> has(watch.component)).toArray(Watch[]::new);
    }

    /** All components of a row have come, or are about to go. */
    void tellAll(Watch.What what, long entity, int row) {
        for (Watch watch : watches) {
            watch.tell(what, entity, slab(row), ChunkSizes.local(row));
        }
    }

    /** One component of a row has come, was set, or is about to go. */
    void tell(Watch.What what, long entity, int row, Component<?> component) {
        for (Watch watch : watches) {
            if (watch.component.equals(component)) {
                watch.tell(what, entity, slab(row), ChunkSizes.local(row));
            }
        }
    }

    /** One component of a row is about to be replaced. */
    void keep(int row, Component<?> component) {
        for (Watch watch : watches) {
            if (watch.component.equals(component)) {
                watch.keep(slab(row), ChunkSizes.local(row));
            }
        }
    }

    /** All rows; slabs that are not in use are empty. */
    void state(StateVisitor s) {
        s.section("table", this);
        rows = s.count("rows", rows);
        departureTick = s.value("departureTick", departureTick);
        int chunks = chunkCount();
        if (s.isRestoring()) {
            prepare(chunks);
        }
        for (int chunk = 0; chunk < chunks; chunk++) {
            slabs[chunk].state(s);
        }
    }

    /** Makes room for all rows, and empties the slabs behind them. */
    private void prepare(int chunks) {
        for (int chunk = 0; chunk < chunks; chunk++) {
            int local =
                    chunk == chunks - 1
                            ? ChunkSizes.local(rows - 1)
                            : ChunkSizes.capacity(chunk) - 1;
            while (chunk == slabs.length || local >= slabs[chunk].entities.length) {
                enlarge(chunk);
            }
        }
        for (int chunk = chunks; chunk < slabs.length; chunk++) {
            slabs[chunk].empty();
        }
    }

    /** Forgets which tables follow from this one: there may be others now. */
    void forgetNeighbours() {
        Arrays.fill(grown, null);
        Arrays.fill(shrunk, null);
    }

    @Nullable Archetype grownBy(Component<?> component) {
        return component.id() < grown.length ? grown[component.id()] : null;
    }

    @Nullable Archetype shrunkBy(Component<?> component) {
        return component.id() < shrunk.length ? shrunk[component.id()] : null;
    }

    void rememberGrown(Component<?> component, Archetype to) {
        grown = put(grown, component.id(), to);
    }

    void rememberShrunk(Component<?> component, Archetype to) {
        shrunk = put(shrunk, component.id(), to);
    }

    private static @Nullable Archetype[] put(@Nullable Archetype[] edges, int id, Archetype to) {
        @Nullable Archetype[] longer = id < edges.length ? edges : Arrays.copyOf(edges, id + 1);
        longer[id] = to;
        return longer;
    }
}
