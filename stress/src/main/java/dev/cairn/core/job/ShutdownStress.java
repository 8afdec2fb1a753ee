package dev.cairn.core.job;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;
import static org.openjdk.jcstress.annotations.Expect.FORBIDDEN;

import org.jspecify.annotations.Nullable;
import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.I_Result;

import java.util.concurrent.locks.LockSupport;

/** Closing while a helper goes to sleep ends the helper; a lost wake-up would hang the test. */
@JCStressTest
@Outcome(id = "1", expect = ACCEPTABLE, desc = "the helper ended")
@Outcome(expect = FORBIDDEN, desc = "the helper ended before the gate was closed")
@State
public class ShutdownStress {

    private final TickGate gate = new TickGate(2);
    private volatile @Nullable Thread sleeper;

    /** Whoever closes. */
    @Actor
    public void closer() {
        gate.close();
        Thread thread = sleeper;
        if (thread != null) {
            LockSupport.unpark(thread);
        }
    }

    /** The helper. */
    @Actor
    public void helper(I_Result result) {
        sleeper = Thread.currentThread();
        while (gate.mayPark(1)) {
            LockSupport.park(this);
        }
        result.r1 = gate.isClosed() ? 1 : 0;
    }
}
