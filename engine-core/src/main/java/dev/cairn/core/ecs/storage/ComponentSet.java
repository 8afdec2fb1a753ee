package dev.cairn.core.ecs.storage;

import dev.cairn.core.ecs.component.Component;

import java.util.Arrays;
import java.util.Collection;

/** An immutable set of components, as a bit set over their ids. */
public final class ComponentSet {
    public static final ComponentSet EMPTY = new ComponentSet(new long[0]);

    /** Without trailing zero words, so that equal sets have equal arrays. */
    private final long[] words;

    private ComponentSet(long[] words) {
        this.words = words;
    }

    public static ComponentSet of(Collection<Component<?>> components) {
        ComponentSet set = EMPTY;
        for (Component<?> component : components) {
            set = set.with(component);
        }
        return set;
    }

    public ComponentSet with(Component<?> component) {
        int word = component.id() >>> 6;
        long[] copy = Arrays.copyOf(words, Math.max(words.length, word + 1));
        copy[word] |= 1L << component.id();
        return new ComponentSet(copy);
    }

    public ComponentSet without(Component<?> component) {
        int word = component.id() >>> 6;
        if (word >= words.length) {
            return this;
        }
        long[] copy = words.clone();
        copy[word] &= ~(1L << component.id());
        int length = copy.length;
        while (length > 0 && copy[length - 1] == 0) {
            length--;
        }
        return new ComponentSet(Arrays.copyOf(copy, length));
    }

    public boolean contains(Component<?> component) {
        int word = component.id() >>> 6;
        return word < words.length && (words[word] & 1L << component.id()) != 0;
    }

    public boolean containsAll(ComponentSet other) {
        for (int i = 0; i < other.words.length; i++) {
            long mine = i < words.length ? words[i] : 0;
            if ((other.words[i] & ~mine) != 0) {
                return false;
            }
        }
        return true;
    }

    public boolean intersects(ComponentSet other) {
        for (int i = 0; i < Math.min(words.length, other.words.length); i++) {
            if ((words[i] & other.words[i]) != 0) {
                return true;
            }
        }
        return false;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ComponentSet set && Arrays.equals(words, set.words);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(words);
    }
}
