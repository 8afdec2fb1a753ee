/** A user's package: nothing here is known to the engine. */
@NullMarked
package dev.cairn.core.user;

import org.jspecify.annotations.NullMarked;
