package dev.cairn.core.job;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.III_Result;

import java.util.concurrent.atomic.AtomicIntegerArray;

/** Each block runs exactly once with two that claim, and the stage ends when all have run. */
@JCStressTest
@Outcome(id = "1, 1, 1", expect = ACCEPTABLE, desc = "each block ran once")
@Outcome(expect = FORBIDDEN, desc = "a block ran twice, or not before the stage ended")
@State
public class StageExactlyOnceStress {

    private final Stage stage = new Stage(2, null);
    private final AtomicIntegerArray runs = new AtomicIntegerArray(3);
    private final BlockJob job = (block, worker) -> runs.incrementAndGet(block);

    /** The caller. */
    @Actor
    public void caller(III_Result result) {
        stage.run(job, 3);
        result.r1 = runs.get(0);
        result.r2 = runs.get(1);
        result.r3 = runs.get(2);
    }

    /** The helper. */
    @Actor
    public void helper() {
        stage.claimUnits(stage.published(), 1);
    }
}
