package dev.cairn.system.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.cairn.render.app.Offscreen;
import dev.cairn.system.DocsTest;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What the pages tell a reader to type into a shell beside the samples: Maven itself, the jars that
 * it leaves, git, the machine's packages. All of it runs in a clone of these sources, one line
 * after the other, as a reader would; what takes hours runs in a small form. Where the lines are
 * held against the pages: {@link CommandRunsTest}.
 */
@Tag("soak")
final class MavenCommandsTest {
    private static final long LIMIT_SECONDS = 1200;

    /** Where a line runs: the clone, what is above it, or the project of the quickstart. */
    private enum Place {
        ABOVE,
        CLONE,
        PROJECT
    }

    /**
     * A command of the pages by a pattern and the line that runs for it (AS_IT_STANDS: itself).
     * Afterwards a file is there that was not, and the line has said something; "" for neither.
     */
    private record Step(Place place, String command, String run, String leaves, String says) {
        @Override
        public String toString() {
            return command;
        }

        String line() {
            return run.equals(AS_IT_STANDS) ? command.replace("\\", "") : run;
        }
    }

    private static final String AS_IT_STANDS = "";

    /** For lines that are not about it: it takes half of their time. */
    private static final String NO_JAVADOC = " -Dmaven.javadoc.skip ";

    private static Step step(String command, String run, String leaves, String says) {
        return new Step(Place.CLONE, command, run, leaves, says);
    }

    /** In the order in which a reader gets to them; each line may use what those above left. */
    private static final List<Step> STEPS =
            List.of(
                    new Step(
                            Place.ABOVE,
                            "git clone.*|cd cairn",
                            "git clone -q origin cairn && cd cairn && git log --oneline",
                            "cairn/pom.xml",
                            "as it is"),
                    step("mvn -version", AS_IT_STANDS, "", "Apache Maven \\d"),
                    step(
                            "JAVA_HOME=/path/to/jdk-25 mvn \\.\\.",
                            "JAVA_HOME=$JDK mvn -version",
                            "",
                            "Java version: 25"),
                    step(
                            "mvn -Prun install",
                            AS_IT_STANDS,
                            "samples/target/samples.jar",
                            "Installing .*engine-render"),
                    new Step(
                            Place.PROJECT,
                            "mvn compile exec:exec -Dmain=FallingBox",
                            "JAVA_HOME=$JDK mvn compile exec:exec -Dmain=FallingBox",
                            "target/classes/FallingBox.class",
                            "\\( *\\S+ +(4\\.99\\d|5\\.00\\d)E-1 "),
                    new Step(
                            Place.PROJECT,
                            "mvn compile exec:exec -Dmain=FirstWindow",
                            "JAVA_HOME=$JDK mvn compile exec:exec -Dmain=FirstWindow",
                            Offscreen.unavailableReason() == null ? "FirstWindow.png" : "",
                            ""),
                    new Step(
                            Place.PROJECT,
                            "gradle run",
                            "gradle -Dmaven.repo.local=$PWD/../repository"
                                    + " -Porg.gradle.java.installations.paths=$JDK run",
                            "build/classes/java/main/FallingBox.class",
                            "\\( *\\S+ +(4\\.99\\d|5\\.00\\d)E-1 "),
                    step("mvn -Prun", AS_IT_STANDS, "", "stack[ \\S]*\\s"),
                    step(
                            "java -jar samples/target/samples\\.jar --scene room"
                                    + " --export-scene room\\.json",
                            AS_IT_STANDS,
                            "room.json",
                            ""),
                    step(
                            "mvn -Pformat",
                            "printf '\\n\\n\\n' >> build/Bundle.java && ! git diff --quiet"
                                    + " && mvn -Pformat && git diff --exit-code",
                            "",
                            "BUILD SUCCESS"),
                    step(
                            "mvn package -DskipTests",
                            AS_IT_STANDS,
                            "engine-physics/target/reports/apidocs/index.html",
                            ""),
                    step(
                            "java -jar benchmarks/target/benchmarks\\.jar -l",
                            AS_IT_STANDS,
                            "",
                            "EcsIterate"),
                    step(
                            "mvn -Prelease -Dcairn\\.url=https://\\.\\.",
                            "mvn -Prelease -Dcairn.url=https://example.org/cairn",
                            "target/cairn-0.1.0-SNAPSHOT-bundle.zip",
                            "signatures"),
                    step(
                            "mvn install -DskipTests",
                            AS_IT_STANDS,
                            "",
                            "Installing .*samples-\\S+-javadoc\\.jar"),
                    step(
                            "mvn verify artifact:compare -DskipTests",
                            AS_IT_STANDS,
                            "",
                            "comparison result: 3 files match"),
                    step(
                            "mvn -Pcompare( -Dcompare=\"--.*\")?",
                            "mvn -Pcompare '-Dcompare=--quick --scenes stack-4 --engines cairn"
                                    + " --substeps 1 --rounds 1 --patience 0.1 --defaults-only"
                                    + " --out report'",
                            "report/report.html",
                            ""),
                    step("mvn -Pcompare -Dcompare=--help", AS_IT_STANDS, "", "--engines"),
                    step(
                            "mvn -Pstress package( -DskipTests)?",
                            "mvn -Pstress package -DskipTests -pl stress -am",
                            "stress/target/stress.jar",
                            ""),
                    step(
                            "java -jar stress/target/stress\\.jar.*",
                            "PATH=$JDK/bin:$PATH java -jar stress/target/stress.jar -time 20"
                                    + " -iters 1 -f 1 -sc false -af NONE -r target/stress",
                            "target/stress/index.html",
                            "(\\d+) planned; \\1 passed, 0 failed, 0 soft errs, 0 hard"),
                    step(
                            "mvn -pl engine-physics -am verify",
                            "mvn -pl engine-physics -am verify"
                                    + NO_JAVADOC
                                    + "-Dtest=RotationsTest,BlocksTest",
                            "engine-physics/target/surefire-reports",
                            "Tests run: [1-9]"),
                    step(
                            "mvn -Pcoverage verify",
                            "mvn -Pcoverage verify -pl engine-core -am"
                                    + NO_JAVADOC
                                    + "-Dtest=BlocksTest",
                            "engine-core/target/site/jacoco/index.html",
                            ""),
                    step(
                            "mvn -Psoak verify|mvn verify -Psoak .*",
                            "mvn -Psoak verify -pl engine-physics -am"
                                    + NO_JAVADOC
                                    + "-Dtest=StateDeltaTest",
                            "",
                            "Tests run: [1-9]"),
                    step(
                            "mvn verify( .*-Dtest=.*)?",
                            "mvn verify -pl src/test -am -Dtest=TutorialsTest"
                                    + NO_JAVADOC
                                    + "-Dsurefire.failIfNoSpecifiedTests=false",
                            "",
                            "Tests run: [1-9]"),
                    step(
                            "bash \\.ci/run",
                            "printf -- '-Dtest=PackagesTest\\n-Dmaven.javadoc.skip\\n'"
                                    + " > .mvn/maven.config && bash .ci/run;"
                                    + " r=$?; rm .mvn/maven.config; exit $r",
                            "",
                            "Tests run: [1-9]"),
                    step(
                            "bash \\.ci/regress",
                            "echo >> README.md && git commit -qam later && bash .ci/regress 1",
                            "",
                            "pyramid"),
                    step(
                            "apt-get install .*",
                            "! command -v apt-get || apt-get install --simulate libegl1 libgl1"
                                    + " libgl1-mesa-dri",
                            "",
                            ""));

    /** Whether a command of a page is one of those that run here. */
    static boolean runs(String command) {
        return STEPS.stream().anyMatch(step -> Pattern.matches(step.command, command));
    }

    /** A row for no command of a page is one that nobody types any more. */
    static List<String> patterns() {
        return STEPS.stream().map(Step::command).toList();
    }

    @TempDir static Path folder;

    /** What is known here, without what was built, as a repository of its own to clone from. */
    @BeforeAll
    static void sourcesToClone() throws IOException, InterruptedException {
        for (String program : List.of("mvn", "git", "bash")) {
            assumeTrue(onPath(program), program + " is not on the path");
        }
        Path origin = folder.resolve("origin");
        copySources(origin);
        bash(
                origin,
                "git init -q . && git config user.name reader && git config user.email r@e.org"
                        + " && git add -A && git commit -q -m 'as it is'");
        project(Files.createDirectories(folder.resolve("project")));
        localRepository(folder.resolve("repository"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("steps")
    void runsAndLeavesWhatItSays(Step step) throws IOException, InterruptedException {
        assumeTrue(!step.command.startsWith("gradle") || onPath("gradle"), "no Gradle here");
        Path where =
                switch (step.place) {
                    case ABOVE -> folder;
                    case CLONE -> folder.resolve("cairn");
                    case PROJECT -> folder.resolve("project");
                };
        Path left = where.resolve(step.leaves);
        assertTrue(step.leaves.isEmpty() || !Files.exists(left), left + " is there already");
        String said = bash(where, step.line());
        assertTrue(
                step.says.isEmpty() || Pattern.compile(step.says).matcher(said).find(),
                () -> step.line() + " does not say " + step.says + ": " + said);
        assertTrue(Files.exists(left), () -> step.line() + " leaves no " + left + ": " + said);
    }

    private static Stream<Step> steps() {
        return STEPS.stream();
    }

    /** What the line says; it must end well. */
    private static String bash(Path where, String line) throws IOException, InterruptedException {
        Path log = Files.createTempFile(folder, "said", ".txt");
        ProcessBuilder builder =
                new ProcessBuilder("bash", "-c", line)
                        .directory(where.toFile())
                        .redirectInput(ProcessBuilder.Redirect.from(new File("/dev/null")))
                        .redirectErrorStream(true)
                        .redirectOutput(log.toFile());
        Set<String> none = Set.of("DISPLAY", "WAYLAND_DISPLAY", "CI", "MAVEN_PROJECTBASEDIR");
        builder.environment().keySet().removeAll(none);
        builder.environment().put("JDK", System.getProperty("java.home"));
        builder.environment()
                .put("MAVEN_OPTS", "-Dmaven.repo.local=" + folder.resolve("repository"));
        Process process = builder.start();
        boolean ended = process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS);
        if (!ended) {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
        String said =
                Files.readString(log, StandardCharsets.UTF_8).replaceAll("\u001B\\[[;\\d]*m", "");
        assertTrue(ended, () -> line + " has not ended: " + said);
        assertEquals(0, process.waitFor(), () -> line + ": " + said);
        return said;
    }

    private static boolean onPath(String program) {
        return Arrays.stream(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator))
                .anyMatch(entry -> Files.isExecutable(Path.of(entry, program)));
    }

    private static void copySources(Path to) throws IOException {
        Files.walkFileTree(
                DocsTest.ROOT,
                new SimpleFileVisitor<>() {
                    @Override
                    public FileVisitResult preVisitDirectory(Path from, BasicFileAttributes its)
                            throws IOException {
                        if (Set.of("target", ".git").contains(from.getFileName().toString())) {
                            return FileVisitResult.SKIP_SUBTREE;
                        }
                        Files.createDirectories(to.resolve(DocsTest.ROOT.relativize(from)));
                        return FileVisitResult.CONTINUE;
                    }

                    @Override
                    public FileVisitResult visitFile(Path from, BasicFileAttributes its)
                            throws IOException {
                        if (!from.getFileName().toString().equals(".git")) {
                            Files.copy(from, to.resolve(DocsTest.ROOT.relativize(from)));
                        }
                        return FileVisitResult.CONTINUE;
                    }
                });
    }

    /** The quickstart's pom, lines for Gradle and programs as they stand there. */
    private static void project(Path to) throws IOException {
        String page = Files.readString(DocsTest.ROOT.resolve("docs/quickstart.md"));
        Matcher block =
                Pattern.compile("```(java|xml|groovy)\\n(.*?)```", Pattern.DOTALL).matcher(page);
        Path sources = Files.createDirectories(to.resolve("src/main/java"));
        while (block.find()) {
            Matcher name = Pattern.compile("public class (\\w+)").matcher(block.group(2));
            Path file =
                    switch (block.group(1)) {
                        case "xml" -> to.resolve("pom.xml");
                        case "groovy" -> to.resolve("build.gradle");
                        default -> {
                            assertTrue(name.find(), () -> "no class in " + block.group(2));
                            yield sources.resolve(name.group(1) + ".java");
                        }
                    };
            Files.writeString(file, block.group(2));
        }
    }

    /**
     * What the machine's own has, by links, so that little is downloaded, but for what is ours:
     * that is installed here and not into the repository of whoever runs the tests.
     */
    private static void localRepository(Path to) throws IOException {
        String home = System.getProperty("user.home");
        Path own = Path.of(System.getProperty("localRepository", home + "/.m2/repository"));
        Path dev = Files.createDirectories(to.resolve("dev"));
        for (Path[] level : new Path[][] {{own, to}, {own.resolve("dev"), dev}}) {
            if (!Files.isDirectory(level[0])) {
                continue;
            }
            try (Stream<Path> groups = Files.list(level[0])) {
                for (Path group : groups.toList()) {
                    String name = group.getFileName().toString();
                    if (!Set.of("dev", "cairn").contains(name)) {
                        Files.createSymbolicLink(level[1].resolve(name), group);
                    }
                }
            }
        }
    }
}
