package dev.cairn.core.ecs.storage;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.component.Entities;

import org.junit.jupiter.api.Test;

/** An id is never given twice. */
class EntityTableTest {
    @Test
    void anIndexWhoseGenerationsAreUsedUpIsRetired() {
        EntityTable table = new EntityTable();
        long entity = table.create();
        table.age(entity, EntityTable.LAST_GENERATION);
        long old = Entities.of(Entities.index(entity), EntityTable.LAST_GENERATION);
        table.put(old, 0, 0);
        assertTrue(table.isAlive(old));
        table.free(old);
        assertFalse(table.isAlive(old));
        assertNotEquals(Entities.index(old), Entities.index(table.create()));
    }
}
