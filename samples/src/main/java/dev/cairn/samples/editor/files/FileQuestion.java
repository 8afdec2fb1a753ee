package dev.cairn.samples.editor.files;

import java.nio.file.Path;

/**
 * What a file is wanted for.
 *
 * @param heading of the dialog
 * @param folder where to begin, an existing one
 * @param ending of the names of files, such as {@code .json}
 * @param saves whether the file is to be written, and need not be there
 * @param name proposed for a file to be written, else empty
 */
record FileQuestion(String heading, Path folder, String ending, boolean saves, String name) {}
