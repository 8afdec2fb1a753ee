package dev.cairn.physics.state;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.island.SleepingBodies;

/** A hash of the state's bits, in slot and row order. */
public final class Digest {
    private Digest() {}

    /**
     * Hashes a state.
     *
     * @param b the bodies
     * @param c the contacts
     * @param joints adds nothing if there are none
     * @return 64 bits
     */
    public static long of(BodyStore b, ContactStore c, SleepingBodies sleepers, JointStore joints) {
        long h = 0x6361_6972_6e00_0001L;
        for (int s = 0; s < b.slotCount; s++) {
            h = mix(h, b.kind[s]);
            if (b.kind[s] == BodyStore.FREE) {
                continue;
            }
            h = mix(h, b.entity[s]);
            h = mix(h, b.positionX[s]);
            h = mix(h, b.positionY[s]);
            h = mix(h, b.positionZ[s]);
            for (int i = 3 * s; b.isFar && i < 3 * s + 3; i++) {
                h = b.positionLow[i] != 0 ? mix(h, b.positionLow[i]) : h;
            }
            h = mix(h, b.orientationX[s]);
            h = mix(h, b.orientationY[s]);
            h = mix(h, b.orientationZ[s]);
            h = mix(h, b.orientationW[s]);
            h = mix(h, b.velocityX[s]);
            h = mix(h, b.velocityY[s]);
            h = mix(h, b.velocityZ[s]);
            h = mix(h, b.angularVelocityX[s]);
            h = mix(h, b.angularVelocityY[s]);
            h = mix(h, b.angularVelocityZ[s]);
            h = mix(h, b.inertiaScale[s]);
            h = mix(h, b.restTicks[s]);
            h = mix(h, b.unrest[s]);
            h = mix(h, b.pressed[s]);
            h = mix(h, b.pressing[s]);
            if (sleepers.enabled()) {
                for (int i = 0; i < SleepingBodies.WORDS; i++) {
                    h = mix(h, sleepers.bits(s, i));
                }
            }
        }
        for (int row = 0; row < c.count; row++) {
            h = contact(h, c, row);
        }
        for (int j = 0; j < joints.count; j++) {
            h = joints.isThere[j] ? joint(h, joints, j) : h;
        }
        return h;
    }

    private static long joint(long start, JointStore s, int j) {
        long h = mix(start, (long) s.bodyA[j] << 32 | s.bodyB[j]);
        h = mix(h, s.isEnabled[j] ? 1 : 0);
        for (int r = s.firstRow[j]; r < s.firstRow[j] + s.rows[j]; r++) {
            h = mix(h, s.before[r]);
            h = mix(h, s.after[r]);
            h = mix(h, s.held[r]);
        }
        return h;
    }

    private static long contact(long start, ContactStore c, int row) {
        long h = mix(start, (long) c.bodyA[row] << 32 | c.bodyB[row]);
        h = mix(h, c.pointCount[row]);
        h = mix(h, c.touching[row]);
        h = mix(h, c.frictionImpulseX(row));
        h = mix(h, c.frictionImpulseY(row));
        h = mix(h, c.frictionImpulseZ(row));
        h = mix(h, c.twistImpulse(row));
        for (int i = 3 * row; c.rolls && c.rollingArm[row] > 0 && i < 3 * row + 3; i++) {
            h = mix(h, c.rollingImpulse[i]);
        }
        for (int i = 4 * row; c.uneven && i < 4 * row + 4; i++) {
            h = mix(h, c.frictionLoad[i]);
        }
        int first = ContactStore.POINTS * row;
        for (int p = first; p < first + c.pointCount[row]; p++) {
            h = mix(h, c.feature[p]);
            h = mix(h, c.separation[p]);
            h = mix(h, c.normalImpulse[p]);
            h = mix(h, c.totalNormalImpulse[p]);
            h = mix(h, c.preload[p]);
        }
        return h;
    }

    private static long mix(long h, double value) {
        return mix(h, Double.doubleToRawLongBits(value));
    }

    private static long mix(long h, long value) {
        long k = (h ^ value) * 0x9E37_79B9_7F4A_7C15L;
        return k ^ k >>> 29;
    }
}
