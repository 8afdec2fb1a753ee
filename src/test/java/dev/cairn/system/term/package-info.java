/** The words of the pages: terms lead to classes that exist, and codes of cases are explained. */
@NullMarked
package dev.cairn.system.term;

import org.jspecify.annotations.NullMarked;
