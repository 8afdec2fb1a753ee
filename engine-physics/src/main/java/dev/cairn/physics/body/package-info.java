/**
 * Words for what a body is: what moves it, which ways it may not go, that it is gone.
 *
 * <p>Problem: descriptions, references and events of bodies share a few small types that know
 * nothing of worlds; here they lie, so that the front page of the physics stays short.
 */
@NullMarked
package dev.cairn.physics.body;

import org.jspecify.annotations.NullMarked;
