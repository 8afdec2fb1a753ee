package dev.cairn.core.ecs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.user.UserRecords;

import org.junit.jupiter.api.Test;

import java.lang.invoke.MethodHandles;

/** Records of other packages, of any visibility, are components, with generated code. */
class ComponentAccessTest {

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

    private static void agrees(RecordCodec codec, Record value) {
        Field[] fields = Component.of(value.getClass()).fields;
        Object[] columns = new Object[1 + fields.length];
        for (int i = 0; i < fields.length; i++) {
            columns[1 + i] = fields[i].kind.allocate(fields[i].type, 4);
        }
        codec.write(value, columns, 1, 2);
        assertEquals(value, codec.read(columns, 1, 2));
    }
}
