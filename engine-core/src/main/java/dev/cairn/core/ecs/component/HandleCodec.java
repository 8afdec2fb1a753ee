package dev.cairn.core.ecs.component;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;

/**
 * A codec of method handles, for records whose module does not let us define a class beside them.
 * Same results as the generated one; a few times slower to spawn, the same to iterate.
 */
final class HandleCodec implements RecordCodec {
    private final Kind[] kinds;
    private final MethodHandle[] accessors;
    private final MethodHandle constructor;

    HandleCodec(MethodHandles.Lookup lookup, Class<?> type) throws ReflectiveOperationException {
        RecordComponent[] fields = type.getRecordComponents();
        kinds = new Kind[fields.length];
        accessors = new MethodHandle[fields.length];
        Class<?>[] parameters = new Class<?>[fields.length];
        MethodHandle[] narrowing = new MethodHandle[fields.length];
        for (int i = 0; i < fields.length; i++) {
            parameters[i] = fields[i].getType();
            kinds[i] = Kind.of(parameters[i]);
            accessors[i] = exact(lookup.unreflect(fields[i].getAccessor()), kinds[i]);
            narrowing[i] = narrow(parameters[i]);
        }
        MethodHandle plain =
                lookup.findConstructor(type, MethodType.methodType(void.class, parameters));
        constructor =
                MethodHandles.filterArguments(plain, 0, narrowing)
                        .asType(
                                plain.type()
                                        .changeReturnType(Record.class)
                                        .generic()
                                        .changeReturnType(Record.class))
                        .asSpreader(Object[].class, fields.length);
    }

    private static MethodHandle exact(MethodHandle accessor, Kind kind) {
        Class<?> result =
                switch (kind) {
                    case DOUBLE -> double.class;
                    case FLOAT -> float.class;
                    case LONG -> long.class;
                    case INT -> int.class;
                    case OBJECT -> Object.class;
                };
        return MethodHandles.explicitCastArguments(
                accessor, MethodType.methodType(result, Record.class));
    }

    /** From the column's type to the parameter's: an int back to boolean, byte, short or char. */
    private static MethodHandle narrow(Class<?> parameter) {
        MethodHandle identity = MethodHandles.identity(parameter);
        return Kind.of(parameter) == Kind.INT
                ? MethodHandles.explicitCastArguments(
                        identity, MethodType.methodType(parameter, int.class))
                : identity;
    }

    @Override
    public void write(Record value, Object[] columns, int base, int row) {
        try {
            for (int i = 0; i < kinds.length; i++) {
                Object column = columns[base + i];
                MethodHandle accessor = accessors[i];
                switch (kinds[i]) {
                    case DOUBLE -> ((double[]) column)[row] = (double) accessor.invokeExact(value);
                    case FLOAT -> ((float[]) column)[row] = (float) accessor.invokeExact(value);
                    case LONG -> ((long[]) column)[row] = (long) accessor.invokeExact(value);
                    case INT -> ((int[]) column)[row] = (int) accessor.invokeExact(value);
                    case OBJECT -> ((Object[]) column)[row] = (Object) accessor.invokeExact(value);
                }
            }
        } catch (Throwable failure) {
            throw rethrow(failure, value.getClass());
        }
    }

    @Override
    public Record read(Object[] columns, int base, int row) {
        Object[] values = new Object[kinds.length];
        for (int i = 0; i < kinds.length; i++) {
            Object column = columns[base + i];
            values[i] =
                    switch (kinds[i]) {
                        case DOUBLE -> (Object) ((double[]) column)[row];
                        case FLOAT -> (Object) ((float[]) column)[row];
                        case LONG -> (Object) ((long[]) column)[row];
                        case INT -> (Object) ((int[]) column)[row];
                        case OBJECT -> ((Object[]) column)[row];
                    };
        }
        try {
            return (Record) constructor.invokeExact(values);
        } catch (Throwable failure) {
            throw rethrow(failure, constructor.type().returnType());
        }
    }

    private static RuntimeException rethrow(Throwable failure, Class<?> type) {
        if (failure instanceof RuntimeException unchecked) {
            return unchecked;
        }
        if (failure instanceof Error error) {
            throw error;
        }
        return new IllegalStateException("accessor or constructor of " + type + " threw", failure);
    }
}
