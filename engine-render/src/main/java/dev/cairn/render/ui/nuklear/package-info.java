/**
 * {@link dev.cairn.render.ui.Ui} by Nuklear, Micha Mettke's library of one header (public domain),
 * as LWJGL binds it: {@code NuklearUi} speaks to it, {@code UiFont} bakes its letters, {@code
 * UiStyle} chooses its colours, {@code UiPainter} draws what it wants drawn. Window thread only.
 */
@NullMarked
package dev.cairn.render.ui.nuklear;

import org.jspecify.annotations.NullMarked;
