package dev.cairn.benchmarks.compare.measure;

import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Measures this engine alone, within the calling JVM, by the report's own code. One thread. */
public final class Probe {
    /** Flags of the JVM that a measurement runs in, those of the report's engines. */
    public static final List<String> JVM_FLAGS = EngineProcess.FLAGS;

    private final Worker worker = new Worker(Engine.CAIRN);

    /** Starts cold. */
    public Probe() {}

    /**
     * The processor's name.
     *
     * @return as the system tells it
     */
    public static String processor() {
        return Machine.processor();
    }

    /**
     * One setting's figures.
     *
     * @param substeps per tick
     * @param error of the scene, or NaN where it failed
     * @param cpuMicros per movable body and tick, of each round
     */
    public record Figures(int substeps, double error, List<Double> cpuMicros) {}

    /**
     * Runs a scene of the report.
     *
     * @param scene its id
     * @param settings its parameters that differ from the report's
     * @param substeps per tick
     * @param rounds timed rounds
     * @param seconds per round, at least
     * @return what was found
     */
    public Figures run(
            String scene, Map<String, String> settings, int substeps, int rounds, double seconds) {
        PeerSettings peer = new PeerSettings(1, substeps, false, PeerSettings.Tuning.DEFAULT);
        Protocol.Answer judged = ask(Protocol.Kind.JUDGE, scene, settings, peer, 60);
        Double error = judged.failure() == null ? judged.error() : null;
        List<Double> cpu = new ArrayList<>();
        for (int round = 0; round < rounds; round++) {
            Double one = ask(Protocol.Kind.TIME, scene, settings, peer, seconds).cpuMicros();
            cpu.add(value(one));
        }
        return new Figures(substeps, value(error), cpu);
    }

    /**
     * Steps a scene of the report from the start of the JVM on, by the default settings.
     *
     * @param scene its id
     * @param seconds since the JVM's start
     * @return the figures of {@link ColdStart}, by name
     */
    public Map<String, Double> start(String scene, double seconds) {
        PeerSettings peer = new PeerSettings(1, 4, false, PeerSettings.Tuning.DEFAULT);
        return ask(Protocol.Kind.COLD, scene, Map.of(), peer, seconds).errors();
    }

    private static double value(@Nullable Double number) {
        return number == null ? Double.NaN : number;
    }

    private Protocol.Answer ask(
            Protocol.Kind kind,
            String scene,
            Map<String, String> settings,
            PeerSettings peer,
            double seconds) {
        return worker.answer(new Protocol.Request(kind, scene, settings, peer, seconds));
    }
}
