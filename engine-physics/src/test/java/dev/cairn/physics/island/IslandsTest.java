package dev.cairn.physics.island;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;

import org.junit.jupiter.api.Test;

import java.util.Random;

/** Islands against a flood over all links, again and again until nothing changes. */
class IslandsTest {
    private static final int BODIES = 60;

    @Test
    void islandsAreTheConnectedComponents() {
        long seed = 20_260_711;
        System.out.println("seed " + seed);
        Random random = new Random(seed);
        BodyStore bodies = new BodyStore();
        bodies.ensureCapacity(BODIES);
        bodies.slotCount = BODIES;
        ContactStore contacts = new ContactStore();
        contacts.ensureCapacity(200);
        Islands islands = new Islands();
        islands.ensureSlots(BODIES);
        int[] awake = new int[BODIES];
        for (int round = 0; round < 500; round++) {
            int count = 0;
            for (int i = 0; i < BODIES; i++) {
                bodies.kind[i] = (byte) random.nextInt(1, 4);
                if (random.nextInt(3) > 0) {
                    bodies.kind[i] = BodyStore.DYNAMIC;
                }
                if (bodies.kind[i] == BodyStore.DYNAMIC) {
                    awake[count++] = i;
                }
            }
            contacts.count = random.nextInt(1, 100);
            for (int row = 0; row < contacts.count; row++) {
                contacts.bodyA[row] = random.nextInt(BODIES);
                contacts.bodyB[row] = random.nextInt(BODIES);
                contacts.pointCount[row] = random.nextInt(3);
            }
            contacts.activateAll();
            islands.build(bodies, new EdgeSource[] {contacts}, awake, count);
            int[] expected = flood(bodies, contacts);
            for (int i = 0; i < count; i++) {
                assertEquals(expected[awake[i]], islands.root(awake[i]), "body " + awake[i]);
            }
        }
    }

    private static int[] flood(BodyStore bodies, ContactStore contacts) {
        int[] name = new int[BODIES];
        for (int i = 0; i < BODIES; i++) {
            name[i] = i;
        }
        for (boolean again = true; again; ) {
            again = false;
            for (int row = 0; row < contacts.count; row++) {
                int a = contacts.bodyA[row];
                int b = contacts.bodyB[row];
                if (contacts.pointCount[row] > 0
                        && bodies.kind[a] == BodyStore.DYNAMIC
                        && bodies.kind[b] == BodyStore.DYNAMIC
                        && name[a] != name[b]) {
                    name[a] = Math.min(name[a], name[b]);
                    name[b] = name[a];
                    again = true;
                }
            }
        }
        return name;
    }
}
