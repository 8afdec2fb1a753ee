package dev.cairn.core.ecs.component;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.World;
import dev.cairn.core.user.UserRecords;

import org.junit.jupiter.api.Test;

import java.lang.invoke.MethodHandles;

/** Records of other packages, of any visibility, are components, with generated code. */
class ComponentAccessTest {
    /** A field of every kind. */
    private record Every(
            double x,
            float f,
            long l,
            int i,
            boolean flag,
            byte small,
            short medium,
            char letter,
            String text) {}

    private static final Every EVERY =
            new Every(-0.0, 2.5f, Long.MIN_VALUE, -7, true, (byte) -5, (short) -600, 'ß', "text");

    @Test
    void recordsOfAnyVisibilityWork() {
        try (World world = World.builder().workers(1).build()) {
            for (Record value : UserRecords.all()) {
                Component<?> component = Component.of(value.getClass());
                long entity = world.spawn(value);
                assertEquals(value, world.get(entity, component));
                assertFalse(component.codec instanceof HandleCodec, value.toString());
            }
        }
        assertSame(Component.of(UserRecords.all().get(0).getClass()), UserRecords.own());
    }

    /** What a module that is not open leaves: public code only. */
    @Test
    void theOtherCodecsAgree() throws ReflectiveOperationException {
        Record value = UserRecords.all().get(2);
        assertTrue(CodecGenerator.isPublic(value.getClass()));
        agrees(CodecGenerator.generateHere(value.getClass()), value);
        agrees(new HandleCodec(MethodHandles.publicLookup(), value.getClass()), value);
        assertFalse(CodecGenerator.isPublic(UserRecords.all().get(0).getClass()));
        assertFalse(CodecGenerator.isPublic(UserRecords.all().get(3).getClass()), "field");
    }

    @Test
    void aCodecOfMethodHandlesDoesTheSame() throws ReflectiveOperationException {
        Component<Every> every = Component.of(Every.class);
        HandleCodec codec = new HandleCodec(MethodHandles.lookup(), Every.class);
        Object[] columns = new Object[every.fieldCount()];
        for (int i = 0; i < columns.length; i++) {
            columns[i] = every.field(i).newColumn(3);
        }
        codec.write(EVERY, columns, 0, 2);
        assertEquals(EVERY, codec.read(columns, 0, 2));
        assertEquals(EVERY, every.codec().read(columns, 0, 2));
    }

    private static void agrees(RecordCodec codec, Record value) {
        Field[] fields = Component.of(value.getClass()).fields;
        Object[] columns = new Object[1 + fields.length];
        for (int i = 0; i < fields.length; i++) {
            columns[1 + i] = fields[i].newColumn(4);
        }
        codec.write(value, columns, 1, 2);
        assertEquals(value, codec.read(columns, 1, 2));
    }
}
