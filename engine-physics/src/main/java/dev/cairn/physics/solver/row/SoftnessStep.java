package dev.cairn.physics.solver.row;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

/**
 * The sub-step that the softness of contacts goes by: the longest of late.
 *
 * <p>Problem: a spring that is stepped by {@code h} may have a frequency of some share of {@code
 * 1/h}. If that followed each tick, every tick of another length would change the stiffness under a
 * load, by the square: what a contact has learnt of its load had to be made up anew each time, with
 * what it knew of the moment's disturbance, and a stack that stood to 1e-14 m fell within seconds
 * (five boxes, every tenth tick ten times shorter: disturbances grew 2.9 times from one short tick
 * to the next). A softer spring is as good in a shorter step. So a longer tick counts at once, and
 * shorter ones count when there has been nothing else for {@link #WINDOW}.
 *
 * <p>Ticks of one length: that length. Simulation thread. Does not allocate.
 */
public final class SoftnessStep implements Stateful {
    /** After so much time of shorter ticks they are the rule, s. */
    private static final double WINDOW = 2;

    /** What is not shorter than this share is not worth a change. */
    private static final double SHORTER = 0.5;

    private double seconds;
    private double longest;
    private double elapsed;

    /**
     * Takes note of the next tick.
     *
     * @param subStep of it, s
     * @param step of it, s
     * @param isAsked whether the user has changed the number of sub-steps: that counts at once
     * @return the new length over the old one, which is 1 but for rare ticks
     */
    public double next(double subStep, double step, boolean isAsked) {
        double before = seconds;
        longest = Math.max(longest, subStep);
        elapsed += step;
        if (subStep > seconds || isAsked) {
            seconds = subStep;
        } else if (elapsed >= WINDOW) {
            seconds = longest < SHORTER * seconds ? longest : seconds;
            longest = 0;
            elapsed = 0;
        }
        return before == 0 ? 1 : seconds / before;
    }

    @Override
    public void state(StateVisitor s) {
        s.section("softnessStep", this);
        seconds = s.value("seconds", seconds);
        longest = s.value("longest", longest);
        elapsed = s.value("elapsed", elapsed);
    }

    /** Length of the sub-step, s. */
    public double seconds() {
        return seconds;
    }
}
