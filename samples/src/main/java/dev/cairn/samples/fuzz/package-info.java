/**
 * A generator of ordinary worlds, and the laws that none of them may break.
 *
 * <p>{@code samples fuzz} draws small worlds from a seed ({@link WorldGenerator}), runs each of
 * them and looks whether energy, momenta, walls, overlaps, sleep and bits are as they must be
 * ({@link Laws}), makes a world that breaks a law as small as it goes ({@link Shrinker}), and
 * writes it as a scene file. The laws know no case: they hold for every world there is. See {@code
 * docs/laws.md}.
 */
@NullMarked
package dev.cairn.samples.fuzz;

import org.jspecify.annotations.NullMarked;
