package dev.cairn.physics.solver;

/**
 * What a sweep needs besides rows and bodies: the sub-step's length and the soft step's numbers.
 */
final class SubStep {
    /** How many a tick has; the length of one, s. */
    int count;

    double seconds;

    /** 1/s. */
    double inverse;

    /**
     * Contacts keep their impulses as those of a sub-step without extra effort: how many of that
     * one, a power of two, and so exact. The first also holds the ratio to the last tick's.
     */
    double fillScale;

    double keepScale;

    /** m/s. */
    double pushSpeed;

    /** Share of its overlap that a point at rest moves into its offset; 0 for no offsets. */
    double offsetGain;

    /** Speed below which a point rests, m/s; set for each tick. */
    double still;

    /** Gap up to which a point touches, and is not open, m; set for each tick. */
    double touch;

    /**
     * Speed at which a hard point may still close, m/s; set for each tick. So small that nothing
     * moves by it, but more than rounding: an impulse that should be 0 is 0 then, and not what was
     * rounded, which would decide whether the contact begins the next sub-step warm.
     */
    double closing;

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

    /**
     * Sets all but the fill scale.
     *
     * @param doublings of the sub-steps' number
     */
    void set(double stepSeconds, int doublings, SolverSettings settings) {
        count = settings.substeps() << doublings;
        keepScale = 1 << doublings;
        double h = stepSeconds / count;
        double hertz = settings.hertzPerRate() / h;
        double damping = settings.dampingRatio();
        Softness soft = Softness.of(hertz, damping, h);
        Softness fixed =
                Softness.of(
                        hertz * settings.staticHertzScale(),
                        damping * settings.staticDampingScale(),
                        h);
        seconds = h;
        inverse = 1 / h;
        pushSpeed = settings.pushSpeed();
        offsetGain = settings.offsetGain();
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

    /** How deep a body of any mass sinks into one that moves, under its own weight, m: g/w². */
    double sag(double gravity) {
        return gravity * seconds * impulseScale / rate;
    }

    /** Impulse of a sub-step that a metre of overlap holds at rest, over the effective mass. */
    double stiffness(boolean isFixed) {
        return isFixed ? fixedRate / fixedImpulseScale : rate / impulseScale;
    }
}
