package dev.cairn.core.tick;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.I_Result;

/** Each asked-for single step runs exactly once, whatever the simulation thread does meanwhile. */
@JCStressTest
@Outcome(id = "2", expect = ACCEPTABLE, desc = "two were asked for, two ran")
@Outcome(expect = FORBIDDEN, desc = "a single step was lost or doubled")
@State
public class SingleStepStress {

    private int steps;
    private final TickLoop loop = new TickLoop(1.0, () -> steps++);

    /** A tool's thread. */
    @Actor
    public void tool() {
        loop.singleStep();
        loop.singleStep();
    }

    /** The simulation thread. */
    @Actor
    public void simulation() {
        loop.advance(0.0);
        loop.advance(0.0);
    }

    /** The simulation thread, after all. */
    @Arbiter
    public void end(I_Result result) {
        loop.advance(0.0);
        result.r1 = steps;
    }
}
