package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Collections;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;

import javax.tools.ToolProvider;
import javax.xml.parsers.DocumentBuilderFactory;

/**
 * What {@code mvn -Prelease} lays out, by the rules of Maven Central: the program that it ends with
 * is run on jars that stand in for those of a build.
 */
final class BundleTest {
    private static final String VERSION = "7.8.9";
    private static final String ADDRESS = "https://example.org/stones/cairn";
    private static final List<String> LIBRARIES =
            List.of("engine-core", "engine-physics", "engine-render", "samples");

    @TempDir static Path program;

    @TempDir Path root;

    @BeforeAll
    static void compileTheProgram() {
        String source = DocsTest.ROOT.resolve("build/Bundle.java").toString();
        String[] words = {"-proc:none", "-d", program.toString(), source};
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, words));
    }

    /** The poms as they are, and a jar of each sort for each module. */
    @BeforeEach
    void aBuild() throws IOException {
        for (String name : List.of("pom.xml", "LICENSE", "NOTICE")) {
            Files.copy(DocsTest.ROOT.resolve(name), root.resolve(name));
        }
        for (String module : modules()) {
            Path folder = Files.createDirectories(root.resolve(module).resolve("target"));
            Path pom = DocsTest.ROOT.resolve(module).resolve("pom.xml");
            Files.copy(pom, root.resolve(module).resolve("pom.xml"));
            String stem = module + "-" + VERSION;
            if (LIBRARIES.contains(module) || module.equals("cairn-natives")) {
                jar(folder.resolve(stem + ".jar"), "META-INF/LICENSE", "META-INF/NOTICE");
            }
            if (LIBRARIES.contains(module)) {
                jar(folder.resolve(stem + "-sources.jar"), "META-INF/LICENSE", "META-INF/NOTICE");
                jar(folder.resolve(stem + "-javadoc.jar"), "index.html");
            }
        }
    }

    private static List<String> modules() {
        return Stream.concat(LIBRARIES.stream(), Stream.of("cairn-natives", "cairn-bom")).toList();
    }

    private static void jar(Path file, String... names) throws IOException {
        try (ZipOutputStream to = new ZipOutputStream(Files.newOutputStream(file))) {
            for (String name : names) {
                to.putNextEntry(new ZipEntry(name));
                to.write(name.getBytes(StandardCharsets.UTF_8));
                to.closeEntry();
            }
        }
    }

    /** What the program says. */
    private String bundle(int expected, String address) throws IOException, InterruptedException {
        Process process =
                new ProcessBuilder(
                                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                                "-cp",
                                program.toString(),
                                "Bundle",
                                VERSION,
                                address)
                        .directory(root.toFile())
                        .redirectErrorStream(true)
                        .start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(expected, process.waitFor(), said);
        return said;
    }

    private Map<String, byte[]> entries() throws IOException {
        Map<String, byte[]> all = new LinkedHashMap<>();
        Path zip = root.resolve("target").resolve("cairn-" + VERSION + "-bundle.zip");
        try (ZipFile file = new ZipFile(zip.toFile())) {
            for (ZipEntry entry : Collections.list(file.entries())) {
                all.put(entry.getName(), file.getInputStream(entry).readAllBytes());
            }
        }
        return all;
    }

    @Test
    void eachArtifactHasWhatCentralWants() throws Exception {
        String said = bundle(0, ADDRESS);
        assertTrue(said.contains("signatures"), said);
        assertFalse(said.contains("<url>"), said);
        Map<String, byte[]> entries = entries();
        for (String library : LIBRARIES) {
            String stem = "dev/cairn/%s/%s/%s-%s".formatted(library, VERSION, library, VERSION);
            for (String kind : List.of(".pom", ".jar", "-sources.jar", "-javadoc.jar")) {
                assertNotNull(entries.get(stem + kind), stem + kind);
            }
        }
        for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
            String name = entry.getKey();
            if (name.endsWith(".pom") || name.endsWith(".jar")) {
                for (String algorithm : List.of("MD5", "SHA-1", "SHA-256")) {
                    String beside = name + "." + algorithm.replace("-", "").toLowerCase();
                    byte[] digest = MessageDigest.getInstance(algorithm).digest(entry.getValue());
                    assertEquals(
                            HexFormat.of().formatHex(digest),
                            new String(entries.get(beside), StandardCharsets.US_ASCII),
                            beside);
                }
            }
            if (name.endsWith(".jar")) {
                assertTrue(
                        names(entry.getValue())
                                .containsAll(Set.of("META-INF/LICENSE", "META-INF/NOTICE")),
                        name);
            }
            if (name.endsWith(".pom")) {
                requireWhatCentralWantsOf(name, entry.getValue());
            }
        }
    }

    /** Of each pom by itself, but licence and developers, which children have from the parent. */
    private static void requireWhatCentralWantsOf(String name, byte[] pom) throws Exception {
        Element project = xml(pom);
        assertEquals(ADDRESS, text(project, "url"), name);
        assertEquals(ADDRESS, text(child(project, "scm"), "url"), name);
        assertEquals("scm:git:" + ADDRESS, text(child(project, "scm"), "connection"), name);
        assertFalse(text(project, "name").isEmpty(), name);
        assertFalse(text(project, "description").isEmpty(), name);
        if (child(project, "parent") == null) {
            assertNotNull(child(project, "licenses"), name);
            assertNotNull(child(project, "developers"), name);
        }
    }

    @Test
    void theSameBuildGivesTheSameBytes() throws Exception {
        bundle(0, ADDRESS);
        Path zip = root.resolve("target").resolve("cairn-" + VERSION + "-bundle.zip");
        byte[] first = Files.readAllBytes(zip);
        bundle(0, ADDRESS);
        assertArrayEquals(first, Files.readAllBytes(zip));
    }

    @Test
    void whatIsMissingIsTold() throws Exception {
        assertTrue(bundle(0, "").contains("-Dcairn.url"));
        assertTrue(bundle(1, "no page").contains("cairn.url is \"no page\""));
        Path jar = root.resolve("engine-core/target/engine-core-" + VERSION + ".jar");
        jar(jar, "META-INF/LICENSE");
        assertTrue(bundle(1, ADDRESS).contains("has no META-INF/NOTICE"));
        Files.delete(jar);
        assertTrue(bundle(1, ADDRESS).contains("is missing: run mvn -Prelease"));
    }

    /** The bill of materials names what is published, in the version of its own. */
    @Test
    void theBillOfMaterialsNamesEachArtifact() throws Exception {
        Element bom = xml(Files.readAllBytes(DocsTest.ROOT.resolve("cairn-bom/pom.xml")));
        Element parent = xml(Files.readAllBytes(DocsTest.ROOT.resolve("pom.xml")));
        assertEquals(text(parent, "version"), text(bom, "version"));
        Set<String> named = new TreeSet<>();
        NodeList all = bom.getElementsByTagName("dependency");
        for (int i = 0; i < all.getLength(); i++) {
            Element dependency = (Element) all.item(i);
            assertEquals("dev.cairn", text(dependency, "groupId"));
            assertEquals("${project.version}", text(dependency, "version"));
            named.add(text(dependency, "artifactId"));
        }
        Set<String> published = new TreeSet<>(modules());
        published.remove("cairn-bom");
        assertEquals(published, named);
    }

    /** It has no parent, but the same versions of plugins and the same time in what it packs. */
    @Test
    void theBillOfMaterialsIsBuiltAsTheRest() throws Exception {
        Map<String, String> parent = plugins(DocsTest.ROOT.resolve("pom.xml"));
        Map<String, String> bom = plugins(DocsTest.ROOT.resolve("cairn-bom/pom.xml"));
        assertEquals(
                Set.of("maven-install-plugin", "maven-deploy-plugin", "exec-maven-plugin"),
                bom.keySet());
        bom.forEach((name, version) -> assertEquals(parent.get(name), version, name));
        assertEquals(timestamp("pom.xml"), timestamp("cairn-bom/pom.xml"));
    }

    /** Without it Maven writes other bytes each time. */
    private static String timestamp(String pom) throws Exception {
        Element project = xml(Files.readAllBytes(DocsTest.ROOT.resolve(pom)));
        return text(child(project, "properties"), "project.build.outputTimestamp");
    }

    /** The versions of the plugins that a pom manages. */
    private static Map<String, String> plugins(Path pom) throws Exception {
        Element build = child(xml(Files.readAllBytes(pom)), "build");
        NodeList all = child(build, "pluginManagement").getElementsByTagName("plugin");
        Map<String, String> versions = new LinkedHashMap<>();
        for (int i = 0; i < all.getLength(); i++) {
            Element plugin = (Element) all.item(i);
            versions.put(text(plugin, "artifactId"), text(plugin, "version"));
        }
        return versions;
    }

    /** The quickstart's own pom asks for this version and for artifacts that the bill names. */
    @Test
    void theQuickstartAsksForThisVersion() throws Exception {
        String page = Files.readString(DocsTest.ROOT.resolve("docs/quickstart.md"));
        String version = text(xml(Files.readAllBytes(DocsTest.ROOT.resolve("pom.xml"))), "version");
        String xml = page.substring(page.indexOf("```xml\n") + 7);
        Element pom = xml(xml.substring(0, xml.indexOf("```")).getBytes(StandardCharsets.UTF_8));
        Element managed =
                child(child(child(pom, "dependencyManagement"), "dependencies"), "dependency");
        assertEquals("cairn-bom", text(managed, "artifactId"));
        assertEquals(version, text(managed, "version"));
        assertEquals("import", text(managed, "scope"));
        NodeList asked = child(pom, "dependencies").getElementsByTagName("artifactId");
        for (int i = 0; i < asked.getLength(); i++) {
            assertTrue(
                    modules().contains(asked.item(i).getTextContent()),
                    asked.item(i)::getTextContent);
        }
        assertTrue(page.contains("platform('dev.cairn:cairn-bom:" + version + "')"), "Gradle");
    }

    private static Set<String> names(byte[] jar) throws IOException {
        Set<String> names = new TreeSet<>();
        try (ZipInputStream entries = new ZipInputStream(new ByteArrayInputStream(jar))) {
            for (ZipEntry entry = entries.getNextEntry();
                    entry != null;
                    entry = entries.getNextEntry()) {
                names.add(entry.getName());
            }
        }
        return names;
    }

    private static Element xml(byte[] text) throws Exception {
        try (InputStream in = new ByteArrayInputStream(text)) {
            Document read = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(in);
            return read.getDocumentElement();
        }
    }

    /** A child of this name, or null. */
    private static Element child(Element of, String name) {
        for (Node node = of.getFirstChild(); node != null; node = node.getNextSibling()) {
            if (node.getNodeName().equals(name)) {
                return (Element) node;
            }
        }
        return null;
    }

    private static String text(Element of, String name) {
        Element found = child(of, name);
        assertNotNull(found, of.getNodeName() + " has no " + name);
        return found.getTextContent().strip();
    }
}
