package dev.cairn.core.ecs.component;

import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandles;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;

/**
 * Key of a component. A component is a record that names its fields; every field becomes a column
 * of its own: {@code double}, {@code float}, {@code long} and {@code int} as they are, {@code
 * boolean} (0 or 1), {@code byte}, {@code short} and {@code char} in an {@code int} column,
 * anything else in a column of references.
 *
 * <pre>{@code
 * public record Wind(float x, float y, float z) {}
 * public static final Component<Wind> WIND = Component.of(Wind.class);
 * public static final FloatField WIND_X = WIND.floatField("x");
 * }</pre>
 *
 * <p>There is one key per record class in a JVM. Immutable; any thread.
 *
 * @param <T> the record
 */
public final class Component<T extends Record> {
    private static final ConcurrentHashMap<Class<?>, Component<?>> KNOWN =
            new ConcurrentHashMap<>();
    private static final AtomicInteger NEXT_ID = new AtomicInteger();

    /** Dense over the JVM; never visible in a result, since it depends on class loading. */
    final int id;

    final Field[] fields;
    final RecordCodec codec;
    private final Class<T> type;

    private Component(Class<T> type, RecordCodec codec) {
        this.type = type;
        this.codec = codec;
        RecordComponent[] described = type.getRecordComponents();
        this.fields = new Field[described.length];
        for (int i = 0; i < described.length; i++) {
            fields[i] = Field.create(this, described[i].getName(), described[i].getType(), i);
        }
        this.id = NEXT_ID.getAndIncrement();
    }

    /**
     * The key of a record class.
     *
     * @param type the record class
     * @param <T> the record
     * @return its key, always the same one
     * @throws NullPointerException if {@code type} is null
     * @throws ComponentException if {@code type} is not a record, or its module keeps it from us;
     *     then use {@link #of(MethodHandles.Lookup, Class)}. Without named modules every record is
     *     reached, package-private and private ones too
     */
    public static <T extends Record> Component<T> of(Class<T> type) {
        Objects.requireNonNull(type, "type must not be null: pass the record's class");
        Component<?> known = KNOWN.get(type);
        return cast(known != null ? known : register(type, null));
    }

    /**
     * The key of a record class in a named module that is not open to {@code dev.cairn.core}. Also
     * the fastest way for records that are not public in a module that is open.
     *
     * @param lookup {@code MethodHandles.lookup()} of a class in the record's package
     * @param type the record class
     * @param <T> the record
     * @return its key, always the same one
     * @throws NullPointerException if an argument is null
     * @throws ComponentException if {@code type} is not a record, or {@code lookup} does not reach
     *     it
     */
    public static <T extends Record> Component<T> of(MethodHandles.Lookup lookup, Class<T> type) {
        Objects.requireNonNull(lookup, "lookup must not be null: pass MethodHandles.lookup()");
        Objects.requireNonNull(type, "type must not be null: pass the record's class");
        Component<?> known = KNOWN.get(type);
        return cast(known != null ? known : register(type, lookup));
    }

    @SuppressWarnings("unchecked") // a key is only ever stored under its own class
    private static <T extends Record> Component<T> cast(Component<?> component) {
        return (Component<T>) component;
    }

    private static Component<?> register(
            Class<? extends Record> type, MethodHandles.@Nullable Lookup lookup) {
        if (!type.isRecord()) {
            throw new ComponentException(
                    type.getName() + " is no record class; a component is declared as a record");
        }
        RecordCodec codec = codec(type, lookup);
        return KNOWN.computeIfAbsent(type, key -> new Component<>(type, codec));
    }

    /** The fastest codec that the record's module allows. */
    private static RecordCodec codec(Class<?> type, MethodHandles.@Nullable Lookup given) {
        Component.class.getModule().addReads(type.getModule());
        try {
            return inside(
                    MethodHandles.privateLookupIn(
                            type, given != null ? given : MethodHandles.lookup()),
                    type);
        } catch (IllegalAccessException closed) {
            try {
                return CodecGenerator.isPublic(type)
                        ? CodecGenerator.generateHere(type)
                        : new HandleCodec(MethodHandles.publicLookup(), type);
            } catch (ReflectiveOperationException hidden) {
                closed.addSuppressed(hidden);
                throw unreachable(type, closed);
            }
        } catch (ReflectiveOperationException failure) {
            throw unreachable(type, failure);
        }
    }

    private static RecordCodec inside(MethodHandles.Lookup lookup, Class<?> type)
            throws ReflectiveOperationException {
        if (type.isHidden()) {
            return new HandleCodec(lookup, type);
        }
        if (lookup.hasFullPrivilegeAccess()) {
            try {
                return CodecGenerator.generate(lookup, type);
            } catch (LinkageError unread) { // its module or loader does not know this one
                return new HandleCodec(lookup, type);
            }
        }
        return CodecGenerator.isPublic(type)
                ? CodecGenerator.generateHere(type)
                : new HandleCodec(lookup, type);
    }

    private static ComponentException unreachable(Class<?> type, Exception cause) {
        ComponentException failure =
                new ComponentException(
                        "the fields of record "
                                + type.getName()
                                + " cannot be reached; make it public in an exported package, write"
                                + " 'opens "
                                + type.getPackageName()
                                + " to dev.cairn.core' in its module, or call"
                                + " Component.of(MethodHandles.lookup(), "
                                + type.getSimpleName()
                                + ".class) from its package");
        failure.initCause(cause);
        return failure;
    }

    /**
     * The record class.
     *
     * @return the class
     */
    public Class<T> type() {
        return type;
    }

    /**
     * The simple name of the record, for messages.
     *
     * @return the name
     */
    public String name() {
        return type.getSimpleName();
    }

    /**
     * Key of a {@code double} column.
     *
     * @param name name of the record's field
     * @return the key
     * @throws ComponentException if there is no such field, or it is of another type
     */
    public DoubleField doubleField(String name) {
        return (DoubleField) field(name, Kind.DOUBLE);
    }

    /**
     * Key of a {@code float} column.
     *
     * @param name name of the record's field
     * @return the key
     * @throws ComponentException if there is no such field, or it is of another type
     */
    public FloatField floatField(String name) {
        return (FloatField) field(name, Kind.FLOAT);
    }

    /**
     * Key of an {@code int} column: a field of type {@code int}, {@code boolean}, {@code byte},
     * {@code short} or {@code char}.
     *
     * @param name name of the record's field
     * @return the key
     * @throws ComponentException if there is no such field, or it is of another type
     */
    public IntField intField(String name) {
        return (IntField) field(name, Kind.INT);
    }

    /**
     * Key of a {@code long} column.
     *
     * @param name name of the record's field
     * @return the key
     * @throws ComponentException if there is no such field, or it is of another type
     */
    public LongField longField(String name) {
        return (LongField) field(name, Kind.LONG);
    }

    /**
     * Key of a column of references.
     *
     * @param name name of the record's field
     * @param type class of the field, as it is declared in the record
     * @param <V> type of the field
     * @return the key
     * @throws ComponentException if there is no such field, or it is of another type
     */
    @SuppressWarnings("unchecked") // checked against the declared type
    public <V> ObjectField<V> objectField(String name, Class<V> type) {
        Field field = field(name, Kind.OBJECT);
        if (field.type != type) {
            throw new ComponentException(
                    "field "
                            + field
                            + " is a "
                            + field.type.getName()
                            + ", not a "
                            + type.getName());
        }
        return (ObjectField<V>) field;
    }

    /**
     * Key of a column of references, of any declared type. Its arrays may be of a narrower type
     * than {@code Object[]}, so only values of the declared type can be stored in them.
     *
     * @param name name of the record's field
     * @return the key
     * @throws ComponentException if there is no such field, or it is of another type
     */
    @SuppressWarnings("unchecked") // an array of any class is an Object[]
    public ObjectField<Object> objectField(String name) {
        return (ObjectField<Object>) field(name, Kind.OBJECT);
    }

    /**
     * Number of fields.
     *
     * @return 0 or more
     */
    public int fieldCount() {
        return fields.length;
    }

    /**
     * A field by its place.
     *
     * @param offset place in the record, 0 to fieldCount - 1
     * @return the key of the field
     * @throws ArrayIndexOutOfBoundsException if there is no such field
     */
    public Field field(int offset) {
        return fields[offset];
    }

    /**
     * What moves the record in and out of columns.
     *
     * @return the codec
     */
    public RecordCodec codec() {
        return codec;
    }

    /**
     * The component's number in this JVM, for tables by component: dense. Depends on the order in
     * which classes are loaded, so no result may depend on it.
     *
     * @return 0 or more
     */
    public int id() {
        return id;
    }

    private Field field(String name, Kind kind) {
        Objects.requireNonNull(name, "name must not be null: pass the name of a record field");
        for (Field field : fields) {
            if (field.name.equals(name)) {
                if (field.kind != kind) {
                    throw new ComponentException(
                            "field "
                                    + field
                                    + " is a "
                                    + field.type.getSimpleName()
                                    + " and lives in a column of kind "
                                    + field.kind
                                    + ", not "
                                    + kind
                                    + "; ask for it with the matching method");
                }
                return field;
            }
        }
        throw new ComponentException(
                "component " + name() + " has no field '" + name + "'; it has " + fieldNames());
    }

    private String fieldNames() {
        return fields.length == 0
                ? "no fields at all"
                : Arrays.stream(fields).map(Field::name).collect(Collectors.joining(", "));
    }

    /**
     * The component's name.
     *
     * @return the simple name of the record
     */
    @Override
    public String toString() {
        return name();
    }
}
