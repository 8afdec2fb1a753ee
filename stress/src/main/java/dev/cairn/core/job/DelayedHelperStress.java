package dev.cairn.core.job;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.III_Result;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * A helper that read its stage word in one stage and is late claims nothing of the next ones: three
 * stages of other jobs and other sizes follow each other while it claims under whatever it read.
 */
@JCStressTest
@Outcome(id = "11, 1111, 111", expect = ACCEPTABLE, desc = "each block of each stage ran once")
@Outcome(expect = FORBIDDEN, desc = "a late helper ran, skipped or repeated a block")
@State
public class DelayedHelperStress {

    private final Stage stage = new Stage(2, null);
    private final AtomicInteger first = new AtomicInteger();
    private final AtomicInteger second = new AtomicInteger();
    private final AtomicInteger third = new AtomicInteger();
    private final BlockJob firstJob = (block, worker) -> first.addAndGet(DIGIT[block]);
    private final BlockJob secondJob = (block, worker) -> second.addAndGet(DIGIT[block]);
    private final BlockJob thirdJob = (block, worker) -> third.addAndGet(DIGIT[block]);

    /** Decimal digit of a block: a count per block in one number. */
    private static final int[] DIGIT = {1, 10, 100, 1000};

    /** The caller. */
    @Actor
    public void caller(III_Result result) {
        stage.run(firstJob, 2);
        stage.run(secondJob, 4);
        stage.run(thirdJob, 3);
        result.r1 = first.get();
        result.r2 = second.get();
        result.r3 = third.get();
    }

    /** The helper. */
    @Actor
    public void helper() {
        stage.claimUnits(stage.published(), 1);
    }
}
