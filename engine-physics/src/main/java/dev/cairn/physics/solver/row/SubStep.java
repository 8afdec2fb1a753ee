package dev.cairn.physics.solver.row;

import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

/**
 * What a sweep needs besides rows and bodies: the sub-step's length and the soft step's numbers.
 */
public final class SubStep {
    /** How many a tick has; the length of one, s. */
    public int count;

    public double seconds;

    /** 1/s. */
    public double inverse;

    /** This sub-step over that of the last tick: the scale of the impulses that were kept. */
    public double fillScale;

    /** m/s. */
    public double pushSpeed;

    /** Share of its overlap that a point at rest moves into its offset; 0 for no offsets. */
    public double offsetGain;

    /** Against gravity, of length 1, or 0 without gravity; set for each tick. */
    public double upX, upY, upZ;

    /** Speed below which a point rests, m/s; set for each tick. */
    public double still;

    /** Gap up to which a point touches, and is not open, m; set for each tick. */
    public double touch;

    /**
     * Speed at which a hard point may still close, m/s; set for each tick. So small that nothing
     * moves by it, but more than rounding: an impulse that should be 0 is 0 then, and not what was
     * rounded, which would decide whether the contact begins the next sub-step warm.
     */
    public double closing;

    /** Soft step of two bodies that move: bias rate times mass scale, 1/s, and the two scales. */
    public double rate;

    public double massScale;
    public double impulseScale;

    /** The same against static bodies. */
    public double fixedRate;

    public double fixedMassScale;
    public double fixedImpulseScale;

    /** Sweeps over the points of a contact, of one that lands, and rounds with its friction. */
    public int sweeps;

    public int landingSweeps;
    public int coldRounds;

    /** Most sweeps over a lone contact. */
    public int lone;

    private final Softness soft = new Softness();
    private final Softness fixed = new Softness();

    /**
     * Sets what follows from the length of the tick and the settings.
     *
     * @param softSeconds length of the sub-step that the softness goes by, see {@link
     *     SoftnessStep}, s
     */
    public void set(double stepSeconds, double softSeconds, Tuning settings) {
        count = settings.count(Tunable.SUBSTEPS);
        double h = stepSeconds / count;
        double hertz = settings.get(Tunable.CONTACT_STIFFNESS) / softSeconds;
        double damping = settings.get(Tunable.CONTACT_DAMPING_RATIO);
        soft.set(hertz, damping, h);
        fixed.set(
                hertz * settings.get(Tunable.STATIC_STIFFNESS_SCALE),
                damping * settings.get(Tunable.STATIC_DAMPING_SCALE),
                h);
        seconds = h;
        inverse = 1 / h;
        pushSpeed = settings.get(Tunable.PUSH_SPEED);
        offsetGain = settings.get(Tunable.OFFSET_GAIN);
        rate = soft.biasRate * soft.massScale;
        massScale = soft.massScale;
        impulseScale = soft.impulseScale;
        fixedRate = fixed.biasRate * fixed.massScale;
        fixedMassScale = fixed.massScale;
        fixedImpulseScale = fixed.impulseScale;
        sweeps = settings.count(Tunable.INNER_SWEEPS);
        landingSweeps = Math.max(sweeps, settings.count(Tunable.COLD_SWEEPS) / 2);
        coldRounds = settings.count(Tunable.COLD_SWEEPS);
        lone = settings.count(Tunable.LONE_SWEEPS);
    }

    /** Sets where up is. */
    public void setUp(double[] gravity, double weight) {
        double inverseWeight = weight > 0 ? -1 / weight : 0;
        upX = inverseWeight * gravity[0];
        upY = inverseWeight * gravity[1];
        upZ = inverseWeight * gravity[2];
    }

    /** Impulse of a sub-step that a metre of overlap holds at rest, over the effective mass. */
    public double stiffness(boolean isFixed) {
        return isFixed ? fixedRate / fixedImpulseScale : rate / impulseScale;
    }
}
