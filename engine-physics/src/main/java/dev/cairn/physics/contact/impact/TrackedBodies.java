package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;

/** Bodies that are followed through a tick with impacts, since they hang together by contacts. */
final class TrackedBodies {
    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final StruckBodies bodies;
    private final MovingPair pair;
    private final ImpactQueue queue;

    /** By row: it is in the queue, or was looked at. */
    private boolean[] seen = {};

    TrackedBodies(
            ColliderStore colliders,
            ContactStore contacts,
            StruckBodies bodies,
            MovingPair pair,
            ImpactQueue queue) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bodies = bodies;
        this.pair = pair;
        this.queue = queue;
    }

    void begin() {
        if (seen.length < contacts.bodyA.length) {
            seen = new boolean[contacts.bodyA.length];
        }
    }

    /** A row that is in the queue. */
    void see(int row) {
        seen[row] = true;
    }

    /**
     * Impacts change which bodies meet, so all are struck in the order of their times: slower
     * meetings come into the queue too, of all bodies that hang together by contacts with one that
     * is struck. Contacts that do not bounce are left to the solver.
     */
    void gather(double step) {
        bodies.clearMarks();
        for (int i = 0; i < queue.size(); i++) {
            bodies.mark(colliders.body[queue.first(i)]);
            bodies.mark(colliders.body[queue.second(i)]);
        }
        for (int i = 0; i < bodies.markedCount; i++) {
            int body = bodies.marked[i];
            for (int link = bodies.head[body]; link >= 0; link = bodies.next[link]) {
                int row = link >> 1;
                if (seen[row] || !bodies.fits(row)) {
                    continue;
                }
                seen[row] = true;
                bodies.mark(contacts.bodyA[row]);
                bodies.mark(contacts.bodyB[row]);
                if (!contacts.isSolved(row) || !isExact(row)) {
                    continue;
                }
                int a = contacts.colliderA[row];
                int b = contacts.colliderB[row];
                if (pair.meet(a, b, 0, step) || pair.isUndecided()) {
                    queue.add(pair.time(), a, b, 0, 0, row, pair.isUndecided());
                }
            }
        }
        for (int i = 0; i < bodies.markedCount; i++) {
            int body = bodies.marked[i];
            for (int link = bodies.head[body]; link >= 0; link = bodies.next[link]) {
                seen[link >> 1] = false;
            }
        }
    }

    /** Rows of bodies that are followed to the end: all that they bounce off has been struck. */
    void release() {
        for (int i = 0; i < bodies.markedCount; i++) {
            int body = bodies.marked[i];
            for (int link = bodies.head[body]; link >= 0; link = bodies.next[link]) {
                int row = link >> 1;
                if (bodies.isFollowed(contacts.bodyA[row])
                        && bodies.isFollowed(contacts.bodyB[row])
                        && bodies.fits(row)
                        && isExact(row)) {
                    contacts.disable(row);
                }
            }
        }
    }

    /** Whether two touch in one point, and bounce, and no third body holds them. */
    private boolean isExact(int row) {
        return contacts.restitution[row] > 0 && !bodies.isHeld(row) && bodies.isRound(row);
    }
}
