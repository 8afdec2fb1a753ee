/** Where panels go in windows of any size. */
@NullMarked
package dev.cairn.samples.panel;

import org.jspecify.annotations.NullMarked;
