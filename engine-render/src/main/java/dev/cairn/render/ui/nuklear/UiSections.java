package dev.cairn.render.ui.nuklear;

import org.lwjgl.system.MemoryUtil;

import java.util.HashMap;
import java.util.Map;

/** Which sections of the panels are open, by title, where Nuklear reads and writes it. */
final class UiSections implements AutoCloseable {
    /** The address of an int, 1 if open; an array, so that no lookup makes an object. */
    private final Map<String, long[]> states = new HashMap<>();

    /** The address of a section's state; made as it should begin where it is not known yet. */
    long state(String title, boolean open) {
        long[] state = states.get(title);
        return state != null ? state[0] : make(title, open ? 1 : 0);
    }

    private long make(String title, int open) {
        long[] state = {MemoryUtil.nmemAllocChecked(4)};
        MemoryUtil.memPutInt(state[0], open);
        states.put(title, state);
        return state[0];
    }

    /** Has them open and closed as others are; before the first frame. */
    void openAs(UiSections others) {
        others.states.forEach((title, state) -> make(title, MemoryUtil.memGetInt(state[0])));
    }

    @Override
    public void close() {
        for (long[] state : states.values()) {
            MemoryUtil.nmemFree(state[0]);
        }
    }
}
