package dev.cairn.system.term;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The glossary leads to what exists, and each accuracy case that is named is explained. */
final class GlossaryTest {
    private static final Path DOCS = root().resolve("docs");

    /** Letter and number; F keys have numbers too, and are no cases from F8 on. */
    private static final Pattern CASE =
            Pattern.compile("(?<![\\w.-])(?:[A-EG-I]\\d\\d?|F[1-7])\\b");

    /** The repository: the nearest folder upwards with the glossary. */
    private static Path root() {
        Path folder = Path.of("").toAbsolutePath();
        while (folder != null && !Files.isRegularFile(folder.resolve("docs/glossary.md"))) {
            folder = folder.getParent();
        }
        if (folder == null) {
            throw new IllegalStateException("no folder above this one has docs/glossary.md");
        }
        return folder;
    }

    @Test
    void whatTheGlossaryNamesExists() throws IOException {
        Set<String> files;
        try (Stream<Path> all = Files.walk(root())) {
            files =
                    all.filter(file -> file.toString().endsWith(".java"))
                            .map(file -> root().relativize(file).toString())
                            .map(file -> file.replace('\\', '/'))
                            .collect(Collectors.toCollection(TreeSet::new));
        }
        List<String> missing = new ArrayList<>();
        int seen = 0;
        for (String line : Files.readAllLines(DOCS.resolve("glossary.md"))) {
            String last = line.replaceAll(" \\|$", "").replaceAll("^.*\\| ", "");
            Matcher name = Pattern.compile("`([\\w.]+)(?:/\\w+\\.java)?`").matcher(last);
            while (line.startsWith("| **") && name.find()) {
                seen++;
                if (files.stream().noneMatch(file -> leadsTo(file, name.group(1)))) {
                    missing.add(name.group(1));
                }
            }
        }
        assertEquals(List.of(), missing);
        assertTrue(seen > 100, "names: " + seen);
    }

    /** A class by its simple name, with packages before it and a member behind it, or a package. */
    private static boolean leadsTo(String file, String name) {
        StringBuilder path = new StringBuilder();
        for (String part : name.split("\\.")) {
            path.append('/').append(part);
            if (Character.isUpperCase(part.charAt(0))) {
                return file.endsWith(path + ".java");
            }
        }
        return ("/" + file).contains(path + "/");
    }

    @Test
    void everyCaseIsExplained() throws IOException {
        Set<String> explained = cases(DOCS.resolve("accuracy-cases.md"));
        Set<String> named = new TreeSet<>();
        try (Stream<Path> all = Files.walk(DOCS)) {
            for (Path file : all.filter(file -> file.toString().endsWith(".md")).toList()) {
                named.addAll(cases(file));
            }
        }
        assertTrue(named.size() > 70, "cases: " + named);
        named.removeAll(explained);
        assertEquals(Set.of(), named);
    }

    private static Set<String> cases(Path file) throws IOException {
        return CASE.matcher(Files.readString(file))
                .results()
                .map(found -> found.group())
                .collect(Collectors.toCollection(TreeSet::new));
    }
}
