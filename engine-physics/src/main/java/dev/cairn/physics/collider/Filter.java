package dev.cairn.physics.collider;

import dev.cairn.core.state.StateCodec;

/**
 * Which others a collider meets. Two of them collide if each one's mask has a bit of the other's
 * category, unless both are of one group. Immutable; any thread.
 *
 * @param category what the collider is: bits, most often one, see {@link Layers}
 * @param mask what it collides with: bits of categories
 * @param group 0 for none; two of the same group above 0 always collide, two of the same group
 *     below 0 never, whatever category and mask say
 */
public record Filter(long category, long mask, int group) {
    /** Category 1, collides with all: what a collider is if nothing is said. */
    public static final Filter ALL = new Filter(1, -1, 0);

    /** Collides with nothing, and no query with a filter finds it. */
    public static final Filter NOTHING = new Filter(0, 0, 0);

    /** How a filter becomes bytes. */
    public static final StateCodec<Filter> CODEC =
            StateCodec.of(
                    Filter.class,
                    "filter",
                    (f, out) -> {
                        out.writeLong(f.category);
                        out.writeLong(f.mask);
                        out.writeInt(f.group);
                    },
                    in -> new Filter(in.readLong(), in.readLong(), in.readInt()));

    /**
     * A filter of no group.
     *
     * @param category what the collider is, bits
     * @param mask what it collides with, bits of categories
     */
    public Filter(long category, long mask) {
        this(category, mask, 0);
    }

    /**
     * This filter in a group whose members always collide with one another.
     *
     * @param number 1 to 2147483647
     * @return a new filter
     * @throws IllegalArgumentException if the number is out of range
     */
    public Filter alwaysWith(int number) {
        return new Filter(category, mask, above0(number));
    }

    /**
     * This filter in a group whose members never collide with one another: the parts of a rope, the
     * limbs of one figure.
     *
     * @param number 1 to 2147483647
     * @return a new filter
     * @throws IllegalArgumentException if the number is out of range
     */
    public Filter neverWith(int number) {
        return new Filter(category, mask, -above0(number));
    }

    private static int above0(int number) {
        if (number < 1) {
            throw new IllegalArgumentException(
                    "group is " + number + "; it must be at least 1: number the groups from 1 on");
        }
        return number;
    }

    /**
     * Whether two colliders meet; the order does not matter.
     *
     * @param other filter of the other collider
     * @return true if they collide
     */
    public boolean meets(Filter other) {
        if (group != 0 && group == other.group) {
            return group > 0;
        }
        return (category & other.mask) != 0 && (other.category & mask) != 0;
    }
}
