package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.samples.Parameter;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Runs scenes x engines x workers x sub-steps by the protocol. One thread; not reusable. */
final class Campaign {
    /** Silence beyond this is a crash. */
    private static final double LIMIT_SECONDS = 300;

    /**
     * What to run.
     *
     * @param scenes the scenes, their parameters set
     * @param engines the engines, in the order of tables
     * @param workers numbers of threads
     * @param substeps numbers of sub-steps, ascending
     * @param rounds timed runs per point
     * @param seconds stepped per timed run, at least
     * @param warmSeconds warm-up per engine and scene, at most
     */
    record Plan(
            List<Case> scenes,
            List<Engine> engines,
            List<Integer> workers,
            List<Integer> substeps,
            int rounds,
            double seconds,
            double warmSeconds) {

        Plan {
            scenes = List.copyOf(scenes);
            engines = List.copyOf(engines);
            workers = List.copyOf(workers);
            substeps = List.copyOf(substeps);
        }

        /** The number of requests, for the progress bar. */
        int requests() {
            return scenes.size() * engines.size() * (1 + points() * (1 + rounds));
        }

        int points() {
            return workers.size() * substeps.size();
        }
    }

    /** Hears how the campaign goes on. */
    @FunctionalInterface
    interface Progress {
        /** So many more requests are done, or will never be made; this is under way. */
        void done(int requests, String underWay);
    }

    private final Plan plan;
    private final Path logs;
    private final Progress progress;

    Campaign(Plan plan, Path logs, Progress progress) {
        this.plan = plan;
        this.logs = logs;
        this.progress = progress;
    }

    Results run() {
        Machine machine = new Machine();
        List<Results.Point> points = new ArrayList<>();
        for (Case scene : plan.scenes()) {
            List<Contestant> contestants = new ArrayList<>();
            try {
                for (Engine engine : plan.engines()) {
                    contestants.add(new Contestant(scene, engine));
                }
                contestants.forEach(Contestant::judge);
                for (int round = 0; round < plan.rounds(); round++) {
                    for (int i = 0; i < contestants.size(); i++) {
                        contestants.get((i + round) % contestants.size()).time();
                    }
                }
            } finally {
                contestants.forEach(Contestant::close);
            }
            contestants.forEach(contestant -> points.addAll(contestant.points));
        }
        Map<String, String> settings = new LinkedHashMap<>();
        settings.put("sub-steps N", plan.substeps().toString());
        settings.put("workers", plan.workers().toString());
        settings.put("timed rounds, interleaved over the engines", plan.rounds() + "");
        settings.put("stepped per round and point", plan.seconds() + " s or one whole run");
        settings.put(
                "warm-up per engine and scene",
                "until three windows agree within 2 %, at most " + plan.warmSeconds() + " s");
        return new Results(machine.describe(), settings, points);
    }

    /** One engine in one scene. */
    private final class Contestant implements AutoCloseable {
        private final Case scene;
        private final EngineProcess process;
        private final List<Results.Point> points = new ArrayList<>();

        Contestant(Case scene, Engine engine) {
            this.scene = scene;
            this.process = new EngineProcess(engine, logs, List.of());
        }

        void judge() {
            boolean missing = false;
            for (int workers : plan.workers()) {
                for (int substeps : plan.substeps()) {
                    if (workers > process.engine().maxWorkers() || missing) {
                        progress.done(1 + plan.rounds(), "");
                        if (!missing) {
                            continue;
                        }
                    }
                    Protocol.Answer judged =
                            missing
                                    ? points.getLast().judged()
                                    : ask(Protocol.Kind.JUDGE, workers, substeps, 0);
                    missing = judged.missing();
                    points.add(
                            new Results.Point(
                                    scene.id(),
                                    parameters(),
                                    process.engine(),
                                    workers,
                                    substeps,
                                    judged,
                                    new ArrayList<>()));
                }
            }
            if (!missing && !points.isEmpty()) {
                int middle = plan.substeps().get(plan.substeps().size() / 2);
                ask(Protocol.Kind.WARM, plan.workers().getFirst(), middle, plan.warmSeconds());
            } else {
                progress.done(1, "");
            }
        }

        private Map<String, String> parameters() {
            Map<String, String> texts = new LinkedHashMap<>();
            scene.options()
                    .values()
                    .forEach((name, value) -> texts.put(name, Parameter.show(value)));
            return texts;
        }

        void time() {
            for (Results.Point point : points) {
                if (point.judged().missing()) {
                    continue;
                }
                point.rounds()
                        .add(
                                ask(
                                        Protocol.Kind.TIME,
                                        point.workers(),
                                        point.substeps(),
                                        plan.seconds()));
            }
        }

        private Protocol.Answer ask(Protocol.Kind kind, int workers, int substeps, double seconds) {
            progress.done(0, scene.id() + " " + process.engine().title() + " N=" + substeps);
            Protocol.Answer answer =
                    process.ask(
                            new Protocol.Request(
                                    kind, scene.id(), scene.settings(), workers, substeps, seconds),
                            LIMIT_SECONDS);
            progress.done(1, "");
            return answer;
        }

        @Override
        public void close() {
            process.close();
        }
    }
}
