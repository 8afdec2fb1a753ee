package dev.cairn.samples.time;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;

/**
 * One direction of a simulated network: packets come late, each by another time, so out of order,
 * and some never come. All by a seed, so that a run can be repeated. One thread.
 *
 * @param <P> packet
 */
final class Wire<P> {
    private record Sent<P>(long arrives, P packet) {}

    private final SplittableRandom random;
    private final int latency;
    private final int jitter;
    private final double loss;
    private final List<Sent<P>> flying = new ArrayList<>();
    private int lost;

    /**
     * A wire.
     *
     * @param latency ticks that each packet takes at least
     * @param jitter most ticks more
     * @param loss share of packets that never come
     */
    Wire(long seed, int latency, int jitter, double loss) {
        random = new SplittableRandom(seed);
        this.latency = latency;
        this.jitter = jitter;
        this.loss = loss;
    }

    void send(long now, P packet) {
        if (random.nextDouble() < loss) {
            lost++;
        } else {
            flying.add(new Sent<>(now + latency + random.nextInt(jitter + 1), packet));
        }
    }

    /** Hands over what has arrived. */
    void receive(long now, Consumer<P> receiver) {
        List<Sent<P>> there = flying.stream().filter(sent -> sent.arrives <= now).toList();
        flying.removeAll(there);
        there.forEach(sent -> receiver.accept(sent.packet));
    }

    int lost() {
        return lost;
    }
}
