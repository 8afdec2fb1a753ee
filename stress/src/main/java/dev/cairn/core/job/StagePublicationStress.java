package dev.cairn.core.job;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.III_Result;

/**
 * Plain writes before a stage are seen by its blocks, whoever runs them, and plain writes of the
 * blocks are seen by the caller after the stage.
 */
@JCStressTest
@Outcome(id = "43, 44, [01]", expect = ACCEPTABLE, desc = "both blocks saw 42, the caller saw them")
@Outcome(expect = FORBIDDEN, desc = "a write was not seen")
@State
public class StagePublicationStress {

    private final Stage stage = new Stage(2, null);
    private final int[] written = new int[2];
    private int input;
    private int ranByHelper;
    private final BlockJob job =
            (block, worker) -> {
                written[block] = input + 1 + block;
                if (worker == 1 && block == 1) {
                    ranByHelper = 1;
                }
            };

    /** The caller. */
    @Actor
    public void caller(III_Result result) {
        input = 42;
        stage.run(job, 2);
        result.r1 = written[0];
        result.r2 = written[1];
        result.r3 = ranByHelper;
    }

    /** The helper. */
    @Actor
    public void helper() {
        stage.claimUnits(stage.published(), 1);
    }
}
