/**
 * A hand that takes bodies and pulls them, for users' own windows and for robots' grips.
 *
 * <p>{@link dev.cairn.physics.hand.Hand} is made of what every user has: a fixed body without
 * contacts, and a joint of the kind pull between it and the body that is held.
 */
@NullMarked
package dev.cairn.physics.hand;

import org.jspecify.annotations.NullMarked;
