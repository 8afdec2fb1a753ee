/** First form: the signatures that the other modules build on. */
@NullMarked
package dev.cairn.core.tick;

import org.jspecify.annotations.NullMarked;
