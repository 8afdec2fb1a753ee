package dev.cairn.physics.body;

/**
 * What all dynamic bodies of a world have in motion, summed in slot order (so the same bits for any
 * number of workers).
 *
 * @param kineticEnergy of translation and rotation, J
 * @param momentumX linear momentum, world x, kg m/s
 * @param momentumY linear momentum, world y, kg m/s
 * @param momentumZ linear momentum, world z, kg m/s
 * @param angularMomentumX angular momentum about the world's origin, world x, kg m²/s
 * @param angularMomentumY angular momentum about the world's origin, world y, kg m²/s
 * @param angularMomentumZ angular momentum about the world's origin, world z, kg m²/s
 */
public record Kinetics(
        double kineticEnergy,
        double momentumX,
        double momentumY,
        double momentumZ,
        double angularMomentumX,
        double angularMomentumY,
        double angularMomentumZ) {
    /**
     * The same as a record.
     *
     * @param sums the seven numbers in this order
     * @return a new record
     */
    public static Kinetics of(double[] sums) {
        return new Kinetics(sums[0], sums[1], sums[2], sums[3], sums[4], sums[5], sums[6]);
    }
}
