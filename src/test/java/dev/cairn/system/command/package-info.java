/** That each command which a page tells a reader to type is run by a test, and which test it is. */
@NullMarked
package dev.cairn.system.command;

import org.jspecify.annotations.NullMarked;
