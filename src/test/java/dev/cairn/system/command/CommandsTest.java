package dev.cairn.system.command;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.system.DocsTest;

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

/**
 * Command lines of README and docs that take too long to run: that what they name is there. Those
 * of the samples are taken in by their own parser, see {@link DocsTest}; which run, and where, is
 * in {@link CommandRunsTest}.
 */
final class CommandsTest {
    private static final Pattern BENCHMARK =
            Pattern.compile("java -jar\\s+benchmarks/target/benchmarks\\.jar((?: +[^\\s`|()#]+)*)");
    private static final Pattern CHOSEN =
            Pattern.compile("-Dtest=([\\w,]+)|mvn[^`\\n]*? -P(\\w+)|mvn[^`\\n]*? -pl ([\\w,/-]+)");
    private static final Pattern MARKED = Pattern.compile("`([A-Z]\\w+(?:Test|Probe))\\b");

    private static final Pattern METHOD = Pattern.compile("`([A-Z]\\w+Test)\\.(\\w+)`");

    /** Names of the Java files below a folder of each module. */
    private static Set<String> classes(String below) throws IOException {
        try (Stream<Path> files = Files.walk(DocsTest.ROOT)) {
            return files.map(Path::toString)
                    .filter(file -> file.contains(below) && file.endsWith(".java"))
                    .map(file -> file.replaceAll(".*[/\\\\]|\\.java$", ""))
                    .collect(Collectors.toSet());
        }
    }

    /** A command of the benchmarks' own, or what JMH takes: options, and names of its classes. */
    @Test
    void everyBenchmarkIsThere() throws IOException {
        String main =
                Files.readString(
                        DocsTest.ROOT.resolve(
                                "benchmarks/src/main/java/dev/cairn/benchmarks/Main.java"));
        Set<String> classes = classes("benchmarks");
        int found = 0;
        for (Path page : PageCommands.pages()) {
            Matcher m = BENCHMARK.matcher(Files.readString(page));
            for (; m.find(); found++) {
                List<String> words = List.of(m.group(1).strip().split(" +", -1));
                String first = words.getFirst();
                boolean own = main.contains("case \"" + first + "\"");
                boolean ofJmh = first.isEmpty() || first.startsWith("-");
                String last = words.getLast();
                boolean named = classes.contains(last.replaceAll("\\..*", ""));
                assertTrue(
                        own || named || (ofJmh && last.startsWith("-")) || first.isEmpty(),
                        page + ": benchmarks.jar knows no " + words);
            }
        }
        assertTrue(found > 10, "command lines: " + found);
    }

    /** Tests, profiles and modules that Maven is asked for, and tests that a page names. */
    @Test
    void everyTestProfileAndModuleIsThere() throws IOException {
        Set<String> tests = classes("src/test/java");
        String parent = Files.readString(DocsTest.ROOT.resolve("pom.xml"));
        int found = 0;
        for (Path page : PageCommands.pages()) {
            String text = Files.readString(page);
            Matcher m = CHOSEN.matcher(text);
            for (; m.find(); found++) {
                if (m.group(1) != null) {
                    for (String test : m.group(1).split(",", -1)) {
                        assertTrue(tests.contains(test), page + ": there is no test " + test);
                    }
                } else if (m.group(2) != null) {
                    assertTrue(
                            parent.contains("<id>" + m.group(2) + "</id>"),
                            page + ": there is no profile " + m.group(2));
                } else {
                    for (String module : m.group(3).split(",", -1)) {
                        assertTrue(
                                Files.exists(DocsTest.ROOT.resolve(module).resolve("pom.xml")),
                                page + ": there is no module " + module);
                    }
                }
            }
            for (Matcher named = MARKED.matcher(text); named.find(); found++) {
                String test = named.group(1);
                assertTrue(tests.contains(test), page + ": there is no test " + test);
            }
        }
        assertTrue(found > 30, "what is named: " + found);
    }

    /** A point and the test that shows it: `Test.method` names a method that is there. */
    @Test
    void everyTestMethodThatAPageNamesIsThere() throws IOException {
        int found = 0;
        for (Path page : PageCommands.pages()) {
            for (Matcher named = METHOD.matcher(Files.readString(page)); named.find(); found++) {
                String method = "void " + named.group(2) + "(";
                String test = named.group(1) + ".java";
                try (Stream<Path> files = Files.walk(DocsTest.ROOT)) {
                    Path source =
                            files.filter(file -> file.endsWith(test) && isSource(file))
                                    .findAny()
                                    .orElseThrow(() -> new AssertionError("no " + test));
                    assertTrue(
                            Files.readString(source).contains(method),
                            page + ": " + test + " has no " + method + ")");
                }
            }
        }
        assertTrue(found > 40, "what is named: " + found);
    }

    private static boolean isSource(Path file) {
        return file.toString().contains("src/test/java") || file.toString().contains("src\\test");
    }

    /**
     * What README, CONTRIBUTING and docs tell the reader to type, in blocks, in indented lines and
     * between backticks; not the notebook, which records other days.
     */
    static final class PageCommands {
        private static final Pattern FENCE =
                Pattern.compile("```(\\w*)\\n(.*?)```", Pattern.DOTALL);
        private static final Pattern MARKED = Pattern.compile("`([^`]+)`");
        private static final Set<String> SOURCES = Set.of("java", "xml", "groovy", "json");
        private static final Pattern COMMAND =
                Pattern.compile(
                        "(?:[A-Z_]+=\\S+ )*(?:mvn|java|bash|gradle|samples|apt-get|git|cd) +[^"
                                + " ].*");

        private PageCommands() {}

        /** README, CONTRIBUTING and the pages below docs. */
        static List<Path> pages() throws IOException {
            List<Path> pages = new ArrayList<>();
            pages.add(DocsTest.ROOT.resolve("README.md"));
            pages.add(DocsTest.ROOT.resolve("CONTRIBUTING.md"));
            try (Stream<Path> files = Files.walk(DocsTest.ROOT.resolve("docs"))) {
                files.filter(file -> file.toString().endsWith(".md"))
                        .filter(file -> !file.toString().contains("notebook"))
                        .sorted()
                        .forEach(pages::add);
            }
            return pages;
        }

        /** All commands, without what explains them behind two blanks, those joined by && apart. */
        static Set<String> all() throws IOException {
            Set<String> commands = new TreeSet<>();
            for (Path page : pages()) {
                String text = Files.readString(page).replaceAll("\\\\\n *", " ");
                StringBuilder prose = new StringBuilder();
                Matcher fence = FENCE.matcher(text);
                while (fence.find()) {
                    if (!SOURCES.contains(fence.group(1))) {
                        fence.group(2).lines().forEach(line -> add(commands, line));
                    }
                    fence.appendReplacement(prose, "");
                }
                fence.appendTail(prose);
                prose.toString()
                        .lines()
                        .filter(line -> line.startsWith("    "))
                        .forEach(line -> add(commands, line));
                for (Matcher marked = MARKED.matcher(prose); marked.find(); ) {
                    add(commands, marked.group(1).replaceAll("\\s+", " "));
                }
            }
            return commands;
        }

        private static void add(Set<String> commands, String line) {
            if (COMMAND.matcher(line.strip()).matches()) {
                String told = line.strip().replaceAll(" {2,}(?!-).*| #.*", "");
                for (String one : told.replaceAll(" +", " ").split(" && ", -1)) {
                    commands.add(one);
                }
            }
        }
    }
}
