package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;

/**
 * A record by its components, one after the other in the order of their declaration. What reads it
 * first compares their names and types with those that were written, once per kind of record, so
 * that another version of the record is told by name. Handles are found when it is made.
 *
 * @param <T> the record
 */
final class RecordParts<T extends Record> implements StateCodec<T> {
    private final Class<T> type;
    private final Parts.Part[] parts;
    private final String[] names;
    private final MethodHandle[] accessors;
    private final MethodHandle constructor;

    /** Names and types of all components; those of records within are {@code outer.inner}. */
    private final String version;

    RecordParts(MethodHandles.Lookup caller, Class<T> type) {
        this(caller, type, List.of());
    }

    private RecordParts(MethodHandles.Lookup caller, Class<T> type, List<Class<?>> outer) {
        if (!type.isRecord()) {
            throw new IllegalArgumentException(
                    type.getName() + " is no record; give it a StateCodec.of(..)");
        }
        this.type = type;
        RecordComponent[] components = type.getRecordComponents();
        parts = new Parts.Part[components.length];
        names = new String[components.length];
        accessors = new MethodHandle[components.length];
        Class<?>[] parameters = new Class<?>[components.length];
        List<Class<?>> around = new ArrayList<>(outer);
        around.add(type);
        List<String> described = new ArrayList<>();
        try {
            MethodHandles.Lookup lookup = lookup(caller, type);
            for (int i = 0; i < components.length; i++) {
                parameters[i] = components[i].getType();
                names[i] = components[i].getName();
                parts[i] = part(caller, components[i], around);
                describe(names[i], parts[i], described);
                accessors[i] =
                        lookup.unreflect(components[i].getAccessor())
                                .asType(MethodType.methodType(Object.class, Record.class));
            }
            constructor =
                    lookup.findConstructor(type, MethodType.methodType(void.class, parameters))
                            .asSpreader(Object[].class, parameters.length)
                            .asType(MethodType.methodType(Record.class, Object[].class));
        } catch (IllegalAccessException | NoSuchMethodException closed) {
            throw new IllegalArgumentException(
                    "the components of record "
                            + type.getName()
                            + " cannot be reached; pass MethodHandles.lookup() of a class of its"
                            + " package, or write 'opens "
                            + type.getPackageName()
                            + " to dev.cairn.core' in its module",
                    closed);
        }
        version = String.join(", ", described);
    }

    /** Into the record's class where its module allows it, else what is public. */
    private static MethodHandles.Lookup lookup(MethodHandles.Lookup caller, Class<?> type) {
        RecordParts.class.getModule().addReads(type.getModule());
        try {
            return MethodHandles.privateLookupIn(type, caller);
        } catch (IllegalAccessException closed) {
            return MethodHandles.publicLookup();
        }
    }

    private static Parts.Part part(
            MethodHandles.Lookup caller, RecordComponent component, List<Class<?>> around) {
        Class<?> type = component.getType();
        Parts.Part plain = Parts.of(type);
        if (plain != null) {
            return plain;
        }
        if (around.contains(type)) {
            throw refused(component, "holds records of its own kind, without an end");
        }
        if (type.isRecord()) {
            return new Parts.OrNull(
                    new Nested(new RecordParts<>(caller, type.asSubclass(Record.class), around)));
        }
        throw refused(
                component,
                "is neither a primitive, a String, an enum, an array of primitives nor a record of"
                        + " such");
    }

    private static IllegalArgumentException refused(RecordComponent component, String why) {
        return new IllegalArgumentException(
                "component '"
                        + component.getName()
                        + "' ("
                        + component.getType().getTypeName()
                        + ") of record "
                        + component.getDeclaringRecord().getName()
                        + " "
                        + why
                        + "; give the record a StateCodec.of(..)");
    }

    private static void describe(String name, Parts.Part part, List<String> to) {
        to.add(name + ":" + part.name());
        if (part instanceof Parts.OrNull(Nested(RecordParts<?> inner))) {
            for (int i = 0; i < inner.names.length; i++) {
                describe(name + "." + inner.names[i], inner.parts[i], to);
            }
        }
    }

    /** A record within. */
    private record Nested(RecordParts<?> inner) implements Parts.Part {
        @Override
        public String name() {
            return inner.type.getName();
        }

        @Override
        public void write(Object value, StateOutput out) {
            inner.writeParts((Record) value, out);
        }

        @Override
        public Object read(StateInput in) {
            return inner.readParts(in);
        }
    }

    @Override
    public Class<T> type() {
        return type;
    }

    @Override
    public String name() {
        return type.getName();
    }

    @Override
    public void write(T value, StateOutput out) {
        out.writeObject(version);
        writeParts(value, out);
    }

    @Override
    public T read(StateInput in) {
        Versions.require("record " + type.getName(), in.readObject(String.class), version);
        return type.cast(readParts(in));
    }

    private void writeParts(Record value, StateOutput out) {
        for (int i = 0; i < parts.length; i++) {
            try {
                parts[i].write(part(value, i), out);
            } catch (StateException refusal) {
                throw at(i, refusal);
            }
        }
    }

    @SuppressWarnings("NullAway") // a part that may be null is written by OrNull
    private Object part(Record value, int i) {
        try {
            return (Object) accessors[i].invokeExact(value);
        } catch (Throwable failure) {
            throw failed("the accessor threw " + failure, failure);
        }
    }

    private Record readParts(StateInput in) {
        @Nullable Object[] values = new Object[parts.length];
        for (int i = 0; i < parts.length; i++) {
            try {
                values[i] = parts[i].read(in);
            } catch (StateException refusal) {
                throw at(i, refusal);
            }
        }
        try {
            return (Record) constructor.invokeExact(values);
        } catch (Throwable failure) {
            throw failed("the record refuses its components: " + failure, failure);
        }
    }

    private StateException at(int i, StateException refusal) {
        return new StateException(
                "component '"
                        + names[i]
                        + "' ("
                        + parts[i].name()
                        + ") of record "
                        + type.getName()
                        + ": "
                        + refusal.getMessage(),
                refusal);
    }

    private StateException failed(String what, Throwable failure) {
        if (failure instanceof Error error) {
            throw error;
        }
        return new StateException("record " + type.getName() + ": " + what, failure);
    }
}
