package dev.cairn.physics.collider;

import java.util.Arrays;

/**
 * Names for the bits of {@link Filter}: up to 64 layers, and which of them do not collide.
 *
 * <pre>{@code
 * Layers layers = Layers.of("scenery", "crate", "ghost").apart("ghost", "crate");
 * Body ghost = Body.dynamic().shape(ball).filter(layers.filter("ghost"));
 * }</pre>
 *
 * <p>Immutable; any thread. Filters that were made before {@link #apart} stay as they are.
 */
public final class Layers {
    private final String[] names;

    /** For each layer the bits of those that it collides with; symmetric. */
    private final long[] masks;

    private Layers(String[] names, long[] masks) {
        this.names = names;
        this.masks = masks;
    }

    /**
     * Layers that all collide with one another and with themselves.
     *
     * @param names 1 to 64 different names
     * @return the layers
     * @throws IllegalArgumentException if there are none, too many, or two of one name
     */
    public static Layers of(String... names) {
        if (names.length == 0 || names.length > Long.SIZE) {
            throw new IllegalArgumentException(
                    names.length + " layers were named; there may be 1 to 64, a bit for each");
        }
        String[] own = names.clone();
        for (int i = 0; i < own.length; i++) {
            if (Arrays.asList(own).indexOf(own[i]) < i) {
                throw new IllegalArgumentException(
                        "layer '" + own[i] + "' is named twice; each name is one layer");
            }
        }
        long[] all = new long[own.length];
        Arrays.fill(all, -1L);
        return new Layers(own, all);
    }

    /**
     * These layers, but two of them, or one with itself, do not collide.
     *
     * @param a a name
     * @param b a name, may be {@code a}
     * @return new layers
     * @throws IllegalArgumentException if a name is unknown
     */
    public Layers apart(String a, String b) {
        int i = index(a);
        int j = index(b);
        long[] other = masks.clone();
        other[i] &= ~(1L << j);
        other[j] &= ~(1L << i);
        return new Layers(names, other);
    }

    /**
     * The filter of colliders in a layer.
     *
     * @param name one of the names
     * @return its bit and those of the layers that it collides with
     * @throws IllegalArgumentException if the name is unknown
     */
    public Filter filter(String name) {
        int i = index(name);
        return new Filter(1L << i, masks[i]);
    }

    /**
     * A filter for questions: it meets what is in some layers.
     *
     * @param wanted names
     * @return a filter of every category with the bits of these layers as mask
     * @throws IllegalArgumentException if a name is unknown
     */
    public Filter only(String... wanted) {
        long mask = 0;
        for (String name : wanted) {
            mask |= 1L << index(name);
        }
        return new Filter(-1L, mask);
    }

    private int index(String name) {
        int i = Arrays.asList(names).indexOf(name);
        if (i < 0) {
            throw new IllegalArgumentException(
                    "layer '" + name + "' is not one of " + Arrays.toString(names));
        }
        return i;
    }
}
