package dev.cairn.samples;

import java.util.List;
import java.util.Map;

/**
 * What a headless run found out. Immutable.
 *
 * @param scene id of the scene
 * @param parameters value of each parameter, and the seed and sub-steps of the run; numbers and
 *     texts
 * @param bodies bodies at the end, fixed ones included
 * @param ticks ticks of 1/60 s that were run
 * @param workers threads that worked at a tick
 * @param lanes constraints that one instruction works at; 1 is scalar code
 * @param tickMillisMedian median duration of a tick, ms; the first tick is not counted
 * @param tickMillisP99 duration that one tick in a hundred exceeds, ms
 * @param contacts pairs that touch at the end
 * @param kineticEnergy of all bodies at the end, J
 * @param maxPenetrationMetres deepest overlap over the run, measured by {@code Penetration}
 * @param errors metrics against the scene's closed form, by name
 * @param digest state digest after the last tick, 16 hexadecimal digits
 * @param allocatedBytesPerTick bytes that a steady tick allocates, all threads of the simulation
 * @param stageMicros mean duration of each stage of the physics step, µs of wall time, in order
 * @param systemMicros mean work of each system of the world in a tick, µs, in the order of the
 *     schedule; the physics is one of them
 * @param remarks lines that the scene wants printed; not part of the JSON
 */
public record SceneReport(
        String scene,
        Map<String, Object> parameters,
        int bodies,
        int ticks,
        int workers,
        int lanes,
        double tickMillisMedian,
        double tickMillisP99,
        int contacts,
        double kineticEnergy,
        double maxPenetrationMetres,
        Map<String, Double> errors,
        String digest,
        double allocatedBytesPerTick,
        Map<String, Double> stageMicros,
        Map<String, Double> systemMicros,
        List<String> remarks) {}
