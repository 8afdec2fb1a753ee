package dev.cairn.core.tick;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.III_Result;

/** Two actions of one thread run once, in order, and see what the thread wrote before. */
@JCStressTest
@Outcome(id = "12, 7, 2", expect = ACCEPTABLE, desc = "both, in order, with their data")
@Outcome(expect = FORBIDDEN, desc = "lost, repeated, overtaken or blind")
@State
public class InboxStress {

    private final Inbox inbox = new Inbox(1);
    private int data; // plain
    private int order;
    private int seen;
    private int ran;

    /** Any thread. */
    @Actor
    public void poster() {
        data = 7;
        inbox.post(() -> {
            order = order * 10 + 1;
            seen = data;
        });
        inbox.post(() -> order = order * 10 + 2);
    }

    /** The simulation thread. */
    @Actor
    public void simulation() {
        ran += inbox.drain();
        ran += inbox.drain();
    }

    /** The simulation thread, after all. */
    @Arbiter
    public void end(III_Result result) {
        ran += inbox.drain();
        result.r1 = order;
        result.r2 = seen;
        result.r3 = ran;
    }
}
