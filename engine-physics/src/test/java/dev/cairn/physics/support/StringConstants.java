package dev.cairn.physics.support;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.classfile.ClassFile;
import java.lang.classfile.constantpool.PoolEntry;
import java.lang.classfile.constantpool.StringEntry;
import java.net.URISyntaxException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Makes the string constants of classes before a measurement of garbage. When a thread asks for a
 * method to be compiled, HotSpot resolves the string constants of the method's class on that
 * thread; they are our error messages, and those that are new are counted as the thread's own
 * bytes: 24 and 24 to 56 to a constant. On a busy machine this comes late. A constant that the
 * JVM's table of strings knows already costs nothing.
 */
public final class StringConstants {
    /** Else the table forgets them. */
    private static final List<String> KEPT = new ArrayList<>();

    private StringConstants() {}

    /**
     * Makes those of all classes that came from where one came from.
     *
     * @param one a class from a folder or a jar
     */
    public static void make(Class<?> one) throws IOException, URISyntaxException {
        Path place = Path.of(one.getProtectionDomain().getCodeSource().getLocation().toURI());
        int before = KEPT.size();
        if (Files.isDirectory(place)) {
            below(place);
        } else {
            try (FileSystem jar = FileSystems.newFileSystem(place)) {
                below(jar.getPath("/"));
            }
        }
        assertTrue(KEPT.size() > before, "no class with a string constant below " + place);
    }

    private static void below(Path root) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(root)) {
            files = all.filter(file -> file.toString().endsWith(".class")).toList();
        }
        for (Path file : files) {
            for (PoolEntry entry : ClassFile.of().parse(Files.readAllBytes(file)).constantPool()) {
                if (entry instanceof StringEntry constant) {
                    KEPT.add(constant.stringValue().intern());
                }
            }
        }
    }
}
