/**
 * The tutorials as tests: each method is a chapter of {@code docs/tutorials.md}, whose code must
 * stand here word for word, so that what a reader copies compiles and does what the page says;
 * {@code EverydayTest} has ten programs of the first day.
 */
@NullMarked
package dev.cairn.system.tutorial;

import org.jspecify.annotations.NullMarked;
