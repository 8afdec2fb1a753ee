package dev.cairn.samples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** Files that options name to be written: what is wrong with one is told before a run. */
final class OutputFile {
    private OutputFile() {}

    static void checkPng(String option, Path file) {
        if (!file.toString().endsWith(".png")) {
            throw new UsageException("%s %s: the name must end in .png".formatted(option, file));
        }
        checkFolder(option, file);
        checkWritable(option, file);
    }

    static void checkFolder(String option, Path file) {
        Path parent = file.toAbsolutePath().getParent();
        if (parent == null || !Files.isDirectory(parent) || Files.isDirectory(file)) {
            throw new UsageException(
                    "%s %s: cannot write there; name a file in a folder that exists"
                            .formatted(option, file));
        }
    }

    /** Finds out before a long run, not after it, whether the results can be written. */
    static void checkWritable(String option, Path file) {
        boolean isNew = Files.notExists(file);
        try {
            Files.newByteChannel(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE).close();
            if (isNew) {
                Files.deleteIfExists(file);
            }
        } catch (IOException refused) {
            throw new UsageException(
                    "%s %s: this file cannot be written (%s); name another"
                            .formatted(option, file, refused.getClass().getSimpleName()),
                    refused);
        }
    }
}
