package dev.cairn.physics.rest;

import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsWorld;

/** How deep bodies are in each other. */
final class Overlap {
    private Overlap() {}

    /** The deepest overlap of a contact, m; 0 if none overlaps. */
    static double deepest(PhysicsWorld world) {
        Contacts contacts = world.contacts();
        double deepest = 0;
        for (int c = 0; c < contacts.count(); c++) {
            for (int p = 0; p < contacts.pointCount(c); p++) {
                deepest = Math.max(deepest, -contacts.separation(c, p));
            }
        }
        return deepest;
    }
}
