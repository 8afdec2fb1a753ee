package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneReader;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringWriter;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

/** What the pages for users say is so. */
public final class DocsTest {
    private static final Pattern BLOCK = Pattern.compile("```java\\n(.*?)```", Pattern.DOTALL);
    private static final Pattern NAME = Pattern.compile("`(dev\\.cairn\\.[\\w.]+)(?:#(\\w+))?`");
    private static final Pattern EXPORT = Pattern.compile("exports (dev\\.cairn[\\w.]*);");
    private static final Pattern MEMBER =
            Pattern.compile("(?:public|static|final|record|class|interface|@Override)\\b");

    /** Whole files on the pages, and who compiles and runs them. */
    private static final Set<String> PROGRAMS =
            Set.of("MyScene" /* here */, "JmeAdapter", "GdxAdapter" /* AdaptersTest */);

    /** Where the repository is. */
    public static final Path ROOT = root();

    /** The repository: the nearest folder upwards with the pages. */
    private static Path root() {
        Path folder = Path.of("").toAbsolutePath();
        while (folder != null && !Files.isRegularFile(folder.resolve("docs/quickstart.md"))) {
            folder = folder.getParent();
        }
        if (folder == null) {
            throw new IllegalStateException("no folder above this one has docs/quickstart.md");
        }
        return folder;
    }

    private static String page(String name) throws IOException {
        return Files.readString(ROOT.resolve("docs").resolve(name));
    }

    private static List<String> blocks(String page) {
        List<String> blocks = new ArrayList<>();
        for (Matcher m = BLOCK.matcher(page); m.find(); ) {
            blocks.add(m.group(1));
        }
        return blocks;
    }

    /**
     * {@code mvn -Prun}, {@code -Pcompare} and {@code -Prelease} ask every module for a program;
     * who has none must say so, by the parent or, without one, itself.
     */
    @Test
    void commandsOfTheReadmePassThroughEveryModule() throws IOException {
        String parent = Files.readString(ROOT.resolve("pom.xml"));
        Matcher modules = Pattern.compile("<module>([^<]*)</module>").matcher(parent);
        while (modules.find()) {
            Path pom = ROOT.resolve(modules.group(1)).resolve("pom.xml");
            if (Files.exists(pom)) {
                String text = Files.readString(pom);
                assertTrue(
                        text.contains("<parent>")
                                || (text.contains("<exec.skip>true</exec.skip>")
                                        && text.contains("<exec.executable>")),
                        pom + " has no parent and no exec.skip, exec.executable");
            }
        }
    }

    /** Both programs are compiled as a reader copies them, and run; the window's as a picture. */
    @Test
    void theQuickstartCompilesAndRuns(@TempDir Path folder)
            throws IOException, InterruptedException {
        List<String> programs = blocks(page("quickstart.md"));
        assertEquals(2, programs.size());
        for (String program : programs) {
            Matcher name = Pattern.compile("public class (\\w+)").matcher(program);
            assertTrue(name.find(), program);
            Path file = folder.resolve(name.group(1) + ".java");
            Files.writeString(file, program);
            compile(file, folder);
        }
        String place = run(folder, "FallingBox");
        assertTrue(place.matches("(?s).*5\\.0+E-1.*|.*0\\.5.*|.*4\\.99\\d*E-1.*"), place);
        if (dev.cairn.render.app.Offscreen.unavailableReason() == null) {
            Path picture = folder.resolve("first.png");
            run(folder, "-Dcairn.picture=" + picture, "-Dcairn.size=320x200", "FirstWindow");
            assertTrue(Files.size(picture) > 1000, "the picture of the first window");
        }
    }

    /**
     * A scene file in a program of one's own: read, changed, written, and drawn from its camera.
     */
    @Test
    void theProgramWithASceneFileCompilesAndRuns(@TempDir Path folder)
            throws IOException, InterruptedException {
        String program =
                blocks(page("scene-files.md")).stream()
                        .filter(block -> block.contains("class MyScene "))
                        .findFirst()
                        .orElseThrow();
        Path file = folder.resolve("MyScene.java");
        Files.writeString(file, program);
        compile(file, folder);
        Path mine = folder.resolve("my.json");
        String said = samples(0, "--scene", "stack", "--export-scene", mine.toString());
        int entities = SceneReader.read(mine).entities().size();
        if (dev.cairn.render.app.Offscreen.unavailableReason() == null) {
            Path picture = folder.resolve("mine.png");
            run(
                    folder,
                    "-Dcairn.picture=" + picture,
                    "-Dcairn.tick=5",
                    "-Dcairn.size=320x200",
                    "MyScene");
            assertTrue(Files.size(picture) > 1000, said);
            SceneFile written = SceneReader.read(folder.resolve("mine.json"));
            assertEquals(entities + 1, written.entities().size());
        }
    }

    /**
     * Every other Java snippet of README and docs, as a member or as statements of a class that
     * inherits what the page takes as given ({@link SnippetContexts}) and what its snippets before
     * it declare; statements are run.
     */
    @Test
    void everySnippetCompilesAndRuns(@TempDir Path folder)
            throws IOException, InterruptedException {
        List<Path> files = new ArrayList<>();
        for (Path page : pages()) {
            String name = page.getFileName().toString().replace(".md", "");
            String text = Files.readString(page);
            assertEquals(
                    text.split("```java", -1).length,
                    text.split("```java\n", -1).length,
                    name + ": a fence is marked java and nothing else");
            // These two are programs that run, and lines of a test.
            if (!name.equals("quickstart") && !name.equals("tutorials")) {
                files.addAll(snippets(name, blocks(text), folder));
            }
        }
        assertTrue(files.size() > 20, "snippets: " + files.size());
        compile(files, folder);
        List<String> words = new ArrayList<>(List.of(SnippetContexts.class.getName()));
        int statements = 0;
        for (Path file : files) {
            words.add(file.getFileName().toString().replace(".java", ""));
            statements += Files.readString(file).contains("void snippet()") ? 1 : 0;
        }
        String said = run(folder, words.toArray(String[]::new));
        assertEquals(statements, said.lines().filter(line -> line.startsWith("ran ")).count());
        assertTrue(statements > 20, said);
    }

    /** README and the pages below docs. */
    private static List<Path> pages() throws IOException {
        List<Path> pages = new ArrayList<>(List.of(ROOT.resolve("README.md")));
        try (Stream<Path> files = Files.walk(ROOT.resolve("docs"))) {
            files.filter(file -> file.toString().endsWith(".md")).sorted().forEach(pages::add);
        }
        return pages;
    }

    private static List<Path> snippets(String page, List<String> blocks, Path folder)
            throws IOException {
        String simple = Character.toUpperCase(page.charAt(0)) + page.substring(1).replace("-", "_");
        String context =
                Arrays.stream(SnippetContexts.class.getClasses())
                        .map(Class::getSimpleName)
                        .filter(simple::equals)
                        .findFirst()
                        .orElse("Common");
        String above = "dev.cairn.system.SnippetContexts." + context;
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < blocks.size(); i++) {
            String name = "Snippet_" + simple + "_" + (i + 1);
            Path file = folder.resolve(name + ".java");
            String block = blocks.get(i);
            if (block.startsWith("import ")) {
                Matcher whole = Pattern.compile("public (?:final )?class (\\w+)").matcher(block);
                assertTrue(whole.find() && PROGRAMS.contains(whole.group(1)), block);
                continue;
            }
            Files.writeString(
                    file,
                    imports()
                            + ("class " + name + " extends " + above + " {\n")
                            + (MEMBER.matcher(block).lookingAt()
                                    ? block
                                    : "void snippet() throws Exception {\n" + block + "}\n")
                            + "}\n");
            above = name;
            files.add(file);
        }
        return files;
    }

    private static String imports() throws IOException {
        StringBuilder imports = new StringBuilder();
        for (String exported : exports()) {
            if (!exported.startsWith("dev.cairn.render")) {
                imports.append("import ").append(exported).append(".*;\n");
            }
        }
        return imports.append("import org.joml.*;\nimport java.util.List;\n")
                .append("import java.nio.file.Path;\n")
                .toString();
    }

    private static final String UNKNOWN = "--no-such-option";
    static final Pattern COMMAND =
            Pattern.compile(
                    "(?m)(?:java -jar samples/target/samples\\.jar|(?<=`|^ {4}|^)samples)"
                            + "((?: (?! |#)[^`\\s#\\\\]+| \\\\\\n *[^`\\s#]+)+)");

    /** Command lines of the samples, taken in by their own parser; scenes by the list. */
    @Test
    void everyCommandLineIsOne() throws IOException {
        String scenes = samples(0, "--list");
        int found = 0;
        for (Path page : pages()) {
            Matcher m = COMMAND.matcher(Files.readString(page));
            for (; m.find(); found++) {
                String line = m.group(1).replace("\\\n", " ").strip();
                List<String> words =
                        new ArrayList<>(
                                Arrays.stream(line.split("\\s+", -1))
                                        .filter(word -> !word.isEmpty())
                                        .toList());
                int scene = words.indexOf("--scene") + 1;
                if (scene > 0) {
                    for (String id : words.get(scene).split(",", -1)) {
                        assertTrue(
                                Pattern.compile("(?m)^\\s*" + id + "\\b").matcher(scenes).find(),
                                page + ": there is no scene " + id);
                    }
                }
                words.add(UNKNOWN); // must be the only word that the parser does not know
                String said = samples(2, words.toArray(String[]::new));
                assertTrue(
                        said.startsWith("Unknown option: '" + UNKNOWN + "'"),
                        page + ": samples " + line + ": " + said);
            }
        }
        assertTrue(found > 20, "command lines: " + found);
    }

    private static String samples(int expected, String... words) {
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(said, true, StandardCharsets.UTF_8);
        int exit = dev.cairn.samples.Main.run(words, out, out, false);
        String text = said.toString(StandardCharsets.UTF_8);
        assertEquals(expected, exit, String.join(" ", words) + ": " + text);
        return text;
    }

    static void compile(Path file, Path to) {
        compile(List.of(file), to);
    }

    private static void compile(List<Path> sources, Path to) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter said = new StringWriter();
        List<String> options =
                List.of(
                        "-proc:none",
                        "-d",
                        to.toString(),
                        "-cp",
                        System.getProperty("java.class.path"));
        try (var files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            boolean good =
                    compiler.getTask(
                                    said,
                                    files,
                                    null,
                                    options,
                                    null,
                                    files.getJavaFileObjectsFromPaths(sources))
                            .call();
            assertTrue(good, said::toString);
        } catch (IOException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static String run(Path folder, String... words)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.add("--add-modules=jdk.incubator.vector");
        command.add("--enable-native-access=ALL-UNNAMED");
        command.add("-cp");
        command.add(folder + File.pathSeparator + System.getProperty("java.class.path"));
        command.addAll(Arrays.asList(words));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("LIBGL_ALWAYS_SOFTWARE", "1");
        Process process = builder.directory(folder.toFile()).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        return said;
    }

    /** Each line of a tutorial's code is a line of its test, in the same order. */
    @Test
    void theTutorialsAreTheirTests() throws IOException {
        List<String> test =
                Files.readAllLines(
                                ROOT.resolve(
                                        "src/test/java/dev/cairn/system/tutorial/TutorialsTest.java"))
                        .stream()
                        .map(String::strip)
                        .filter(line -> !line.isEmpty())
                        .toList();
        int from = 0;
        for (String block : blocks(page("tutorials.md"))) {
            List<String> lines =
                    block.lines().map(String::strip).filter(line -> !line.isEmpty()).toList();
            // The closing bracket of a try block stands behind the assertions in the test.
            int length = lines.getLast().equals("}") ? lines.size() - 1 : lines.size();
            int at = from;
            while (at + length <= test.size()
                    && !test.subList(at, at + length).equals(lines.subList(0, length))) {
                at++;
            }
            assertTrue(at + length <= test.size(), "not in the test in this order:\n" + block);
            from = at + length;
        }
    }

    /** The page links to each of the ten, and each is short. */
    @Test
    void theEverydayProgramsAreAllThereAndShort() throws IOException {
        assertPrograms(
                "EverydayTest",
                List.of(
                        "fallingBox",
                        "wind",
                        "trigger",
                        "layers",
                        "platform",
                        "compound",
                        "conveyor",
                        "oneWay",
                        "picking",
                        "ensembleOfWorlds"));
        assertPrograms(
                "LiveChangesTest", List.of("mass", "type", "shape", "filter", "gravityScale"));
    }

    private static void assertPrograms(String test, List<String> expected) throws IOException {
        String folder = "src/test/java/dev/cairn/system/tutorial/";
        String programs = Files.readString(ROOT.resolve(folder + test + ".java"));
        Pattern program =
                Pattern.compile("    @Test\n    void (\\w+)\\(\\) .*?\n    }\n", Pattern.DOTALL);
        List<String> names = new ArrayList<>();
        for (Matcher m = program.matcher(programs); m.find(); ) {
            names.add(m.group(1));
            long lines = m.group().lines().count();
            assertTrue(lines < 30, m.group(1) + " has " + lines + " lines, expected below 30");
        }
        assertEquals(expected, names);
        for (String name : names) {
            assertTrue(page("tutorials.md").contains("| `" + name + "` |"), name);
        }
    }

    @Test
    void whatIsSaidToBeThereIsThere() throws ClassNotFoundException, IOException {
        String table = page("features.md");
        int found = 0;
        for (Matcher m = NAME.matcher(table); m.find(); found++) {
            Class<?> type = Class.forName(m.group(1));
            assertTrue(java.lang.reflect.Modifier.isPublic(type.getModifiers()), m.group());
            assertTrue(exports().contains(type.getPackageName()), m.group() + " is not exported");
            String method = m.group(2);
            assertTrue(
                    method == null
                            || Arrays.stream(type.getMethods())
                                    .map(Method::getName)
                                    .anyMatch(method::equals),
                    m.group());
        }
        assertTrue(found > 25, "rows that name something: " + found);
    }

    /** The words of the second table, against the names of the files in exported packages. */
    @Test
    void whatIsSaidToBeAbsentIsAbsent() throws IOException {
        String page = page("features.md");
        List<String> types = new ArrayList<>();
        for (String module : new String[] {"engine-core", "engine-physics", "engine-render"}) {
            for (String exported : exports()) {
                Path folder = ROOT.resolve(module + "/src/main/java/" + exported.replace('.', '/'));
                if (Files.isDirectory(folder)) {
                    try (Stream<Path> files = Files.list(folder)) {
                        files.forEach(file -> types.add(file.getFileName().toString()));
                    }
                }
            }
        }
        assertTrue(types.size() > 80, "exported files: " + types.size());
        String absent = page.substring(page.indexOf("| there is not |"));
        for (String row : absent.lines().skip(2).takeWhile(l -> l.startsWith("|")).toList()) {
            for (String word : row.split("\\|", -1)[2].strip().split(", *", -1)) {
                assertFalse(
                        types.stream().anyMatch(type -> type.contains(word)),
                        "docs/features.md says that there is no " + word + ": " + row);
            }
        }
    }

    private static List<String> exports() throws IOException {
        List<String> exports = new ArrayList<>();
        for (String module : new String[] {"engine-core", "engine-physics", "engine-render"}) {
            String text =
                    Files.readString(ROOT.resolve(module + "/src/main/module/module-info.java"));
            for (Matcher m = EXPORT.matcher(text); m.find(); ) {
                exports.add(m.group(1));
            }
        }
        return exports;
    }
}
