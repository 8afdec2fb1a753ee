package dev.cairn.render.camera;

import org.joml.Vector3d;

/**
 * The light of a scene: one sun and a sky. The colour that a surface of colour {@code a} and unit
 * normal {@code n} sends out is {@code a * (ambient(n) + sun * max(0, n . s) * visible)}, with
 * {@code s} the unit direction to the sun and {@code ambient} going from {@code ground} (n down) to
 * {@code sky} (n up) with {@code (1 + n.y) / 2}: Lambert's law and a hemisphere light. All light
 * values are linear, 1 = a white surface facing it shows as white. Immutable.
 *
 * @param sunX direction to the sun, world frame, any length &gt; 0, x
 * @param sunY same, y
 * @param sunZ same, z
 * @param sunRed strength of the sun's red, linear, &ge; 0
 * @param sunGreen green
 * @param sunBlue blue
 * @param skyRed light from above, red, linear, &ge; 0
 * @param skyGreen green
 * @param skyBlue blue
 * @param groundRed light from below, red, linear, &ge; 0
 * @param groundGreen green
 * @param groundBlue blue
 * @param zenithRgb colour of the background straight up, 0xRRGGBB in sRGB
 * @param horizonRgb colour of the background at the horizon, into which distance fades, 0xRRGGBB in
 *     sRGB
 * @param hazeMetres distance at which a surface has faded to the horizon by 63 %; 0 = no haze
 * @param shadows whether the sun casts shadows
 */
public record Light(
        double sunX,
        double sunY,
        double sunZ,
        double sunRed,
        double sunGreen,
        double sunBlue,
        double skyRed,
        double skyGreen,
        double skyBlue,
        double groundRed,
        double groundGreen,
        double groundBlue,
        int zenithRgb,
        int horizonRgb,
        double hazeMetres,
        boolean shadows) {
    /** A clear day, the sun high on the left behind the usual camera. */
    public static final Light DAYLIGHT =
            new Light(
                    -0.65, 1.0, 0.50, 0.88, 0.82, 0.72, 0.30, 0.35, 0.42, 0.19, 0.18, 0.17,
                    0x4F7FB5, 0xD5E0EA, 400, true);

    /** Checks the ranges. */
    public Light {
        double length = length(sunX, sunY, sunZ);
        if (!(length > 0) || Double.isInfinite(length)) {
            throw new IllegalArgumentException(
                    "sun direction is ("
                            + sunX
                            + ", "
                            + sunY
                            + ", "
                            + sunZ
                            + "), expected a finite vector that is not zero");
        }
        checkLight("sunRed", sunRed);
        checkLight("sunGreen", sunGreen);
        checkLight("sunBlue", sunBlue);
        checkLight("skyRed", skyRed);
        checkLight("skyGreen", skyGreen);
        checkLight("skyBlue", skyBlue);
        checkLight("groundRed", groundRed);
        checkLight("groundGreen", groundGreen);
        checkLight("groundBlue", groundBlue);
        checkLight("hazeMetres", hazeMetres);
    }

    /**
     * The same light from another direction.
     *
     * @param x direction to the sun, world frame, any length &gt; 0
     * @param y same
     * @param z same
     * @return a copy
     */
    public Light from(double x, double y, double z) {
        return new Light(
                x,
                y,
                z,
                sunRed,
                sunGreen,
                sunBlue,
                skyRed,
                skyGreen,
                skyBlue,
                groundRed,
                groundGreen,
                groundBlue,
                zenithRgb,
                horizonRgb,
                hazeMetres,
                shadows);
    }

    /**
     * The same light with or without shadows.
     *
     * @param cast whether the sun casts shadows
     * @return a copy
     */
    public Light shadows(boolean cast) {
        return new Light(
                sunX,
                sunY,
                sunZ,
                sunRed,
                sunGreen,
                sunBlue,
                skyRed,
                skyGreen,
                skyBlue,
                groundRed,
                groundGreen,
                groundBlue,
                zenithRgb,
                horizonRgb,
                hazeMetres,
                cast);
    }

    /**
     * The same light with another haze.
     *
     * @param metres distance at which a surface has faded to the horizon by 63 %; 0 = no haze
     * @return a copy
     */
    public Light haze(double metres) {
        return new Light(
                sunX,
                sunY,
                sunZ,
                sunRed,
                sunGreen,
                sunBlue,
                skyRed,
                skyGreen,
                skyBlue,
                groundRed,
                groundGreen,
                groundBlue,
                zenithRgb,
                horizonRgb,
                metres,
                shadows);
    }

    /**
     * The same light with one grey strength for the sun and one for sky and ground.
     *
     * @param sun strength of the sun, linear, &ge; 0
     * @param ambient strength from everywhere, linear, &ge; 0
     * @return a copy
     */
    public Light strengths(double sun, double ambient) {
        return new Light(
                sunX,
                sunY,
                sunZ,
                sun,
                sun,
                sun,
                ambient,
                ambient,
                ambient,
                ambient,
                ambient,
                ambient,
                zenithRgb,
                horizonRgb,
                hazeMetres,
                shadows);
    }

    /**
     * The same light with another background.
     *
     * @param zenith colour straight up, 0xRRGGBB in sRGB
     * @param horizon colour at the horizon, 0xRRGGBB in sRGB
     * @return a copy
     */
    public Light background(int zenith, int horizon) {
        return new Light(
                sunX,
                sunY,
                sunZ,
                sunRed,
                sunGreen,
                sunBlue,
                skyRed,
                skyGreen,
                skyBlue,
                groundRed,
                groundGreen,
                groundBlue,
                zenith,
                horizon,
                hazeMetres,
                shadows);
    }

    /**
     * The direction to the sun.
     *
     * @param dest receives the unit vector, world frame
     * @return {@code dest}
     */
    public Vector3d towardsSun(Vector3d dest) {
        double length = length(sunX, sunY, sunZ);
        return dest.set(sunX / length, sunY / length, sunZ / length);
    }

    /** Of any finite vector: squares of small or large numbers are 0 or infinite. */
    private static double length(double x, double y, double z) {
        return Math.hypot(Math.hypot(x, y), z);
    }

    private static void checkLight(String name, double value) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(
                    name + " is " + value + ", expected >= 0 and finite");
        }
    }
}
