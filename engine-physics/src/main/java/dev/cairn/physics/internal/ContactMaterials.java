package dev.cairn.physics.internal;

import dev.cairn.physics.collider.Mix;

import java.util.Arrays;

/**
 * Whose contact a row is, and what the surfaces of its colliders, or of its triangle, make of its
 * friction, restitution, rolling friction and belt.
 *
 * <p>One writer to a row; no allocation.
 */
public final class ContactMaterials {
    private ContactMaterials() {}

    /**
     * Says whose contact a row is, of what surfaces, and with what friction and restitution.
     *
     * @param colliders whose bodies are found
     * @param a the lower collider
     * @param b the other one
     */
    public static void join(ContactStore c, int row, ColliderStore colliders, int a, int b) {
        c.colliderA[row] = a;
        c.colliderB[row] = b;
        c.bodyA[row] = colliders.body[a];
        c.bodyB[row] = colliders.body[b];
        c.surfaceA[row] = colliders.surface[a];
        c.surfaceB[row] = colliders.surface[b];
        mix(c, row, colliders);
    }

    /**
     * Makes a row of the same colliders and surfaces as another one, with the same normal.
     *
     * @param row empty
     * @param like the other one
     * @param colliders whose bodies are found
     */
    public static void joinLike(ContactStore c, int row, int like, ColliderStore colliders) {
        join(c, row, colliders, c.colliderA[like], c.colliderB[like]);
        frictionOf(c, row, like);
        c.setNormal(row, c.normalX(like), c.normalY(like), c.normalZ(like));
    }

    /** Gives a row the friction, the restitution and the belt of another one. */
    public static void frictionOf(ContactStore c, int row, int like) {
        c.setFriction(row, c.friction(like));
        c.restitution[row] = c.restitution[like];
        if (c.rolls) {
            c.rollingArm[row] = c.rollingArm[like];
        }
        if (c.belts) {
            System.arraycopy(c.belt, 3 * like, c.belt, 3 * row, 3);
        }
    }

    /**
     * Whether two contacts have the same friction and bounce.
     *
     * @return whether one row may stand for both
     */
    public static boolean isAlike(ContactStore c, int row, int other) {
        int i = 3 * row;
        int j = 3 * other;
        return c.friction(row) == c.friction(other)
                && c.restitution[row] == c.restitution[other]
                && (!c.rolls || c.rollingArm[row] == c.rollingArm[other])
                && (!c.belts || Arrays.equals(c.belt, i, i + 3, c.belt, j, j + 3));
    }

    /** A collider's surface is another one; between steps. */
    public static void mixAll(ContactStore c, int collider, ColliderStore colliders) {
        for (int row = 0; row < c.count; row++) {
            if (c.colliderA[row] == collider || c.colliderB[row] == collider) {
                mix(c, row, colliders);
            }
        }
    }

    /** Friction, restitution and rolling friction of two surfaces that meet. */
    public static void mix(ContactStore c, int row, ColliderStore colliders) {
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        if (c.grouped && c.triangle[row] > 0 && mixTriangle(c, row, colliders)) {
            return;
        }
        mix(
                c,
                row,
                colliders.friction[a],
                colliders.friction[b],
                colliders.restitution[a],
                colliders.restitution[b],
                colliders.mixing[a],
                colliders.mixing[b],
                Math.max(colliders.rollingArm[a], colliders.rollingArm[b]));
    }

    /** The same with the material of the row's triangle, if its collider has such. */
    private static boolean mixTriangle(ContactStore c, int row, ColliderStore colliders) {
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        int s = colliders.isSurface(a) ? a : b;
        int o = s == a ? b : a;
        int at = colliders.material(s, c.triangle[row] - 1);
        if (at < 0) {
            return false;
        }
        double[] own = colliders.palettes.of(s);
        mix(
                c,
                row,
                own[at],
                colliders.friction[o],
                own[at + 1],
                colliders.restitution[o],
                (byte) own[at + 3],
                colliders.mixing[o],
                Math.max(own[at + 2], colliders.rollingArm[o]));
        return true;
    }

    private static void mix(
            ContactStore c,
            int row,
            double ofA,
            double ofB,
            double bounceA,
            double bounceB,
            int ruleA,
            int ruleB,
            double arm) {
        double friction = Math.sqrt(ofA * ofB);
        double bounce = Math.max(bounceA, bounceB);
        if ((ruleA | ruleB) != 0) {
            friction = Mix.of((ruleA & 15) | (ruleB & 15) << 4, ofA, ofB, friction);
            bounce = Mix.of(ruleA >> 4 | ruleB >> 4 << 4, bounceA, bounceB, bounce);
        }
        c.setFriction(row, friction);
        c.restitution[row] = bounce;
        if (c.rolls) {
            c.rollingArm[row] = arm;
        }
    }
}
