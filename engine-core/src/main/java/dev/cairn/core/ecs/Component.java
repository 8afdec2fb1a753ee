package dev.cairn.core.ecs;

/**
 * Key of a component.
 *
 * @param <T> the record
 */
public final class Component<T extends Record> {
    private Component() {}

    /** The key. @param type the record class @param <T> the record @return the key */
    public static <T extends Record> Component<T> of(Class<T> type) { return new Component<>(); }
    /** The key. @param lookup access @param type the record class @param <T> the record @return the key */
    public static <T extends Record> Component<T> of(java.lang.invoke.MethodHandles.Lookup lookup, Class<T> type) { return new Component<>(); }
    /** @return class */
    public Class<T> type() { throw new UnsupportedOperationException(); }
    /** @return simple name */
    public String name() { throw new UnsupportedOperationException(); }
    /** @param name field @return key */
    public DoubleField doubleField(String name) { return new DoubleField(); }
    /** @param name field @return key */
    public FloatField floatField(String name) { return new FloatField(); }
    /** @param name field @return key */
    public IntField intField(String name) { return new IntField(); }
    /** @param name field @return key */
    public LongField longField(String name) { return new LongField(); }
    /** @param name field @param type of the field @param <V> type @return key */
    public <V> ObjectField<V> objectField(String name, Class<V> type) { return new ObjectField<>(); }
    /** @param name field @return key */
    public ObjectField<Object> objectField(String name) { return new ObjectField<>(); }
}
