package dev.cairn.physics.solver;

/**
 * What a sweep needs besides rows and bodies: the sub-step's length and the soft step's numbers.
 */
final class SubStep {
    /** 1/s. */
    double inverse;

    /** m/s. */
    double pushSpeed;

    /** Soft step of two bodies that move: bias rate times mass scale, 1/s, and the two scales. */
    double rate;

    double massScale;
    double impulseScale;

    /** The same against what does not move. */
    double fixedRate;

    double fixedMassScale;
    double fixedImpulseScale;

    /** Sweeps over the points of a contact, of one that lands, and rounds with its friction. */
    int sweeps;

    int landing;
    int coldRounds;

    /** Most sweeps over a lone contact. */
    int lone;

    void set(double h, Softness soft, Softness fixed, SolverSettings settings) {
        inverse = 1 / h;
        pushSpeed = settings.pushSpeed();
        rate = soft.biasRate() * soft.massScale();
        massScale = soft.massScale();
        impulseScale = soft.impulseScale();
        fixedRate = fixed.biasRate() * fixed.massScale();
        fixedMassScale = fixed.massScale();
        fixedImpulseScale = fixed.impulseScale();
        sweeps = settings.innerSweeps();
        landing = Math.max(sweeps, settings.coldSweeps() / 2);
        coldRounds = settings.coldSweeps();
        lone = settings.loneSweeps();
    }

    /** Impulse of a sub-step that a metre of overlap holds at rest, over the effective mass. */
    double stiffness(boolean isFixed) {
        return isFixed ? fixedRate / fixedImpulseScale : rate / impulseScale;
    }
}
