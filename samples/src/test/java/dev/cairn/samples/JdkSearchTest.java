package dev.cairn.samples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The search for a JDK, over folders that look like a machine's. */
class JdkSearchTest {
    @TempDir Path machine;

    private final Map<String, String> environment = new HashMap<>();

    private File jdk(String folder, String version) throws IOException {
        return jdk(folder, version, "java.base jdk.incubator.vector");
    }

    private File jdk(String folder, String version, String modules) throws IOException {
        Path home = machine.resolve(folder);
        Files.createDirectories(home.resolve("bin"));
        Files.writeString(
                home.resolve("bin").resolve(File.separatorChar == '\\' ? "java.exe" : "java"), "");
        Files.writeString(
                home.resolve("release"),
                "JAVA_VERSION=\"" + version + "\"\nMODULES=\"" + modules + "\"\n");
        return home.toFile();
    }

    private File find() {
        File root = machine.resolve("usr/lib/jvm").toFile();
        return new JdkSearch(environment, machine.resolve("home/ann").toFile(), List.of(root))
                .find();
    }

    @Test
    void nothingIsFoundOnAMachineWithOldJavasOnly() throws IOException {
        jdk("usr/lib/jvm/java-17", "17.0.15");
        jdk("usr/lib/jvm/java-8", "1.8.0_392");
        environment.put("JAVA_HOME", machine.resolve("usr/lib/jvm/java-17").toString());
        assertNull(find());
    }

    @Test
    void aJdkBesideOldOnesIsFound() throws IOException {
        jdk("usr/lib/jvm/java-17", "17.0.15");
        File wanted = jdk("usr/lib/jvm/temurin-25", "25.0.3");
        jdk("usr/lib/jvm/java-24", "24.0.1");
        assertEquals(wanted, find());
    }

    @Test
    void theUsersChoiceComesFirst() throws IOException {
        jdk("usr/lib/jvm/temurin-25", "25.0.3");
        File chosen = jdk("tools/jdk", "25.0.1");
        environment.put("JAVA_HOME", chosen.getPath());
        assertEquals(chosen, find());
    }

    @Test
    void buildServicesVariablesAreRead() throws IOException {
        File chosen = jdk("opt/hosted/25", "25.0.1");
        environment.put("JAVA_HOME_17_X64", "/nowhere");
        environment.put("JAVA_HOME_25_X64", chosen.getPath());
        assertEquals(chosen, find());
    }

    @Test
    void release25IsPreferredToALaterOne() throws IOException {
        jdk("usr/lib/jvm/jdk-26", "26");
        File wanted = jdk("home/ann/.sdkman/candidates/java/25-tem", "25");
        assertEquals(wanted, find());
    }

    @Test
    void aLaterReleaseWillDo() throws IOException {
        File later = jdk("home/ann/.jdks/openjdk-26", "26.0.1");
        assertEquals(later, find());
    }

    @Test
    void macBundlesAreLookedInto() throws IOException {
        File wanted = jdk("usr/lib/jvm/temurin-25.jdk/Contents/Home", "25.0.3");
        assertEquals(wanted, find());
    }

    @Test
    void aJavaOnThePathIsFoundThroughItsLink() throws IOException {
        File wanted = jdk("elsewhere/jdk-25", "25.0.3");
        Path bin = Files.createDirectories(machine.resolve("usr/bin"));
        Files.createSymbolicLink(bin.resolve("java"), wanted.toPath().resolve("bin/java"));
        environment.put("PATH", "/nowhere" + File.pathSeparator + bin);
        assertEquals(wanted.getCanonicalFile(), find().getCanonicalFile());
    }

    @Test
    void aFolderWithoutJavaOrWithABrokenReleaseFileIsNone() throws IOException {
        File empty = jdk("usr/lib/jvm/gone", "25.0.3");
        assertTrue(new File(empty, "bin/java").delete());
        File broken = jdk("usr/lib/jvm/broken", "25.0.3");
        Files.writeString(broken.toPath().resolve("release"), "JAVA_VERSION=\"\\uXYZ\"");
        assertNull(find());
    }

    @Test
    void versionsAreRead() {
        assertEquals(8, JdkSearch.feature("1.8.0_392"));
        assertEquals(17, JdkSearch.feature("17"));
        assertEquals(25, JdkSearch.feature("25.0.3"));
        assertEquals(26, JdkSearch.feature("26-ea"));
        assertEquals(0, JdkSearch.feature(""));
        assertEquals(0, JdkSearch.feature("unknown"));
    }

    @Test
    void missingFlagsAreAddedOnce() throws IOException {
        File home = jdk("jdk", "25.0.3");
        List<String> all = Launcher.missingFlags(home, List.of());
        assertTrue(all.contains("--add-modules=jdk.incubator.vector"), all.toString());
        assertTrue(all.contains("--enable-native-access=ALL-UNNAMED"), all.toString());
        List<String> command =
                Launcher.command(
                        home,
                        List.of("-Xmx1g"),
                        "a.jar",
                        "dev.cairn.samples.Main",
                        new String[] {"--list"});
        assertTrue(command.contains("-Xmx1g"), command.toString());
        assertEquals("dev.cairn.samples.Main", command.get(command.size() - 2));
        assertEquals("--list", command.get(command.size() - 1));
        List<String> again = Launcher.missingFlags(home, command);
        assertFalse(again.contains("--add-modules=jdk.incubator.vector"), again.toString());
    }

    @Test
    void kernelsInLanesAreCompiledEarly() throws IOException {
        File home = jdk("jdk", "25.0.3");
        List<String> early = Launcher.earlyLanes(home);
        assertTrue(
                Launcher.command(home, List.of(), "a.jar", "Main", new String[0])
                        .containsAll(early));
        assertTrue(Launcher.earlyLanes(jdk("jre", "25.0.3", "java.base")).isEmpty());
        for (String kernels : Launcher.IN_LANES) {
            assertNotNull(
                    getClass().getResource("/" + kernels.replace('.', '/') + "/package-info.class"),
                    kernels);
            assertTrue(early.stream().anyMatch(o -> o.contains(kernels + ".*::*")), kernels);
        }
    }

    /** GLFW's rule; a child that was started so is not started once more. */
    @Test
    void onAMacTheWindowGetsTheFirstThread() throws IOException {
        File home = jdk("jdk", "25.0.3");
        assertTrue(Launcher.missingFlags(home, List.of(), true).contains("-XstartOnFirstThread"));
        assertFalse(Launcher.missingFlags(home, List.of(), false).contains("-XstartOnFirstThread"));
    }

    @Test
    void aJavaWithoutTheVectorModuleIsNotAskedForIt() throws IOException {
        File home = jdk("jre", "25.0.3", "java.base java.desktop");
        assertFalse(
                Launcher.missingFlags(home, List.of())
                        .contains("--add-modules=jdk.incubator.vector"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "WARNING: Using incubator modules: jdk.incubator.vector\\n|",
                "NOTE: x\\nWARNING: Using incubator modules: a\\nWARNING: y\\n"
                        + " | NOTE: x\\nWARNING: y\\n",
                "no line end                     | no line end",
                "WARN                            | WARN",
                "WWARNING: Using incubator modules: a\\nb | WWARNING: Using incubator modules:"
                        + " a\\nb",
                "bar 1\\rbar 2\\r                 | bar 1\\rbar 2\\r",
            })
    void onlyTheIncubatorsAnnouncementIsLeftOut(String said, String heard) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Launcher.copyWithoutWarning(
                new ByteArrayInputStream(said.translateEscapes().getBytes(UTF_8)), out);
        assertEquals(heard == null ? "" : heard.translateEscapes(), out.toString(UTF_8));
    }
}
