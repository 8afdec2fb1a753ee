/**
 * Scenes whose ground is a surface of triangles, made by code so that its truth is known: a bowl,
 * hills, a house with stairs.
 */
@NullMarked
package dev.cairn.samples.scenes.level;

import org.jspecify.annotations.NullMarked;
