package dev.cairn.core.job;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.ZZ_Result;

/** A helper that goes to sleep while a tick opens is woken: one side sees the other. */
@JCStressTest
@Outcome(id = "false, false", expect = ACCEPTABLE, desc = "the helper saw the tick")
@Outcome(id = "true, true", expect = ACCEPTABLE, desc = "the helper sleeps, the caller wakes it")
@Outcome(id = "true, false", expect = ACCEPTABLE, desc = "both saw each other")
@Outcome(id = "false, true", expect = FORBIDDEN, desc = "the helper sleeps and nobody wakes it")
@State
public class WakeUpStress {

    private final TickGate gate = new TickGate(2);

    /** The caller: does it wake the helper? */
    @Actor
    public void caller(ZZ_Result result) {
        gate.open();
        result.r1 = gate.takeParked(1);
    }

    /** The helper: does it sleep? */
    @Actor
    public void helper(ZZ_Result result) {
        result.r2 = gate.mayPark(1);
    }
}
