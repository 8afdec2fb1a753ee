package dev.cairn.samples;

import dev.cairn.physics.Material;

/** The colours of the scenes, 0xRRGGBB, and the materials that go with them. Stateless. */
public final class Palette {
    /** Walls. */
    public static final int STONE = 0xB8B2A7;

    /** The bodies that a scene is about, in turn; see {@link #body}. */
    private static final int[] BODIES = {
        0xC8553D, 0xE0A458, 0x588B8B, 0x3D5A80, 0x8F6593, 0x6A994E
    };

    /** A basketball. */
    public static final int BASKETBALL = 0xD9702B;

    /** Glass. */
    public static final int GLASS = 0xA9CDE4;

    private Palette() {}

    /**
     * Returns a colour that differs from its neighbours'.
     *
     * @param index any number at least 0
     * @return 0xRRGGBB
     */
    public static int body(int index) {
        return BODIES[index % BODIES.length];
    }

    /**
     * Returns a material by friction and restitution, with the default density.
     *
     * @param friction Coulomb coefficient
     * @param restitution coefficient of restitution
     * @return the material
     */
    public static Material material(double friction, double restitution) {
        return Material.DEFAULT.withFriction(friction).withRestitution(restitution);
    }
}
