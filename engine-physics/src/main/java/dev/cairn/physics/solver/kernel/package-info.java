/**
 * The arithmetic of contacts, row by row: fill, bias sweep, relax sweep, friction, store.
 *
 * <p>What runs where there is no Vector API, and what the wide kernels are held to, bit by bit. A
 * normal impulse changes by {@code dl = -m (massScale vn + b) - impulseScale l}, clamped so that
 * the total never pulls; the points of a contact first take one common step, then are swept one by
 * one. Patch friction is a circle of two tangents and a twist at the centre of the patch.
 *
 * <p>The classes here are written once, in double; {@code build/Twins.java} makes their twins in
 * single precision, whose names begin with Single.
 *
 * <p>Sources: E. Catto, Soft Step solver (2023); M. Macklin et al., "Small Steps in Physics
 * Simulation" (2019); M. Powell and M. Hestenes (1969) for the offset.
 */
@NullMarked
package dev.cairn.physics.solver.kernel;

import org.jspecify.annotations.NullMarked;
