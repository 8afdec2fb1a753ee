package dev.cairn.samples.fuzz;

/** How ordinary a world is: which part of the space of all worlds it is drawn from. */
public enum Family {
    /**
     * Things of a house, 2 cm to 2 m, down to a fiftieth as thick, on a floor, by the defaults of
     * the engine.
     */
    HOUSE,
    /** The same in a closed room, with restitution up to 1 and speeds up to 20 m/s. */
    ROOM,
    /** The same without gravity and with nothing around: only momenta and energy. */
    SPACE,
    /** Everything: the whole of the ranges, other ticks and sub-steps. */
    WIDE,
    /**
     * Bodies of one and of several shapes on a half-space, a slab, tiles, triangles or heights,
     * among fixed benches; for some, something kinematic moves among them.
     */
    LEVEL,
    /** Chains, loops, limbs, doors and carts, with loose things around them. */
    MACHINE
}
