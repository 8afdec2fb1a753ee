package dev.cairn.physics;

import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.World;

/** Makes bodies of the entities with {@link NewBody}, between steps, in the order of their rows. */
final class Newcomers {
    private final BodyTable table;
    private final World ecs;
    private final Query query;
    private long[] found = {};

    Newcomers(BodyTable table, World ecs) {
        this.table = table;
        this.ecs = ecs;
        query = ecs.query(NewBody.COMPONENT);
    }

    void add() {
        int count = query.entityCount();
        if (count == 0) {
            return;
        }
        found = new long[count];
        int n = 0;
        for (int c = 0; c < query.chunkCount(); c++) {
            for (int row = 0; row < query.chunk(c).size(); row++) {
                found[n++] = query.chunk(c).entity(row);
            }
        }
        for (long entity : found) {
            Body body = ecs.get(entity, NewBody.COMPONENT).body();
            ecs.remove(entity, NewBody.COMPONENT);
            table.add(body, entity);
        }
    }
}
