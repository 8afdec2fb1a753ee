package dev.cairn.system;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What README, CONTRIBUTING and docs tell the reader to type, in blocks, in indented lines and
 * between backticks; not the notebook, which records other days.
 */
final class PageCommands {
    private static final Pattern FENCE = Pattern.compile("```(\\w*)\\n(.*?)```", Pattern.DOTALL);
    private static final Pattern MARKED = Pattern.compile("`([^`]+)`");
    private static final Set<String> SOURCES = Set.of("java", "xml", "kotlin", "groovy", "json");
    private static final Pattern COMMAND =
            Pattern.compile(
                    "(?:[A-Z_]+=\\S+ )*(?:mvn|java|bash|gradle|samples|apt-get|git|cd) +[^ ].*");

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
