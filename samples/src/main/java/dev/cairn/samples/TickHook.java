package dev.cairn.samples;

/** What a scene does around a tick; see {@link SceneBuilder#beforeTick(TickHook)}. */
@FunctionalInterface
public interface TickHook {
    /**
     * Runs once per tick, on the simulation thread.
     *
     * @param tick number of the tick, 1 for the first
     * @param seconds time of the scene at the end of that tick
     */
    void run(long tick, double seconds);
}
