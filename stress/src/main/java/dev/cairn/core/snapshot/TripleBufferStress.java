package dev.cairn.core.snapshot;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.III_Result;

/**
 * The reader sees whole values only, never an older one after a newer one, and in the end the
 * newest; the writer never fills the slot that the reader holds.
 */
@JCStressTest
@Outcome(id = "0, 0, 4", expect = ACCEPTABLE, desc = "whole, forwards, newest at last")
@Outcome(expect = FORBIDDEN, desc = "torn, backwards, or the newest was lost")
@State
public class TripleBufferStress {

    private static final int PUBLICATIONS = 4;

    private final TripleBuffer<int[]> buffer = new TripleBuffer<>(() -> new int[2]);

    /** The simulation thread. */
    @Actor
    public void writer() {
        for (int value = 1; value <= PUBLICATIONS; value++) {
            int[] slot = buffer.writing();
            slot[0] = value;
            slot[1] = value;
            buffer.publish();
        }
    }

    /** The drawing thread. */
    @Actor
    public void reader(III_Result result) {
        int before = 0;
        for (int i = 0; i < 4; i++) {
            int[] slot = buffer.latest();
            int last = slot[1];
            int first = slot[0];
            if (first != last || slot[1] != first) {
                result.r1 = 1;
            }
            if (first < before) {
                result.r2 = 1;
            }
            before = first;
        }
    }

    /** The drawing thread, after all. */
    @Arbiter
    public void end(III_Result result) {
        result.r3 = buffer.latest()[0];
    }
}
