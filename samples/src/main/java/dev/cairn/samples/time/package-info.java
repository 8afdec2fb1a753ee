/**
 * What a world as a value is good for, in two small programs: two peers of a game over a bad
 * network end in the same world ({@link dev.cairn.samples.time.TwoPeers}), and a billiard shot is
 * aimed by trying it out ({@link dev.cairn.samples.time.AimedShot}).
 */
@NullMarked
package dev.cairn.samples.time;

import org.jspecify.annotations.NullMarked;
