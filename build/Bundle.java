import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;

/**
 * Lays what was packaged out as Maven Central takes it, and zips it: {@code java build/Bundle.java
 * VERSION ADDRESS} in the repository's root, after {@code mvn package}. Each pom gets the address
 * as its {@code <url>} and {@code <scm>}, which depend on where the source is published and so are
 * known then only. Files are not signed; the program says what else Central will miss.
 */
public final class Bundle {
    private static final String GROUP = "dev/cairn/";
    private static final String[] LICENCE = {"LICENSE", "NOTICE"};
    private static final String[] CHECKSUMS = {"MD5", "SHA-1", "SHA-256"};

    /** An artifact and the folder that it is built in; libraries have jars, the others a pom. */
    private record Artifact(String name, String folder, boolean isLibrary, boolean hasCode) {}

    private static final List<Artifact> ARTIFACTS =
            List.of(
                    new Artifact("cairn-parent", ".", false, false),
                    new Artifact("cairn-bom", "cairn-bom", false, false),
                    new Artifact("engine-core", "engine-core", true, true),
                    new Artifact("engine-physics", "engine-physics", true, true),
                    new Artifact("engine-render", "engine-render", true, true),
                    new Artifact("cairn-natives", "cairn-natives", true, false),
                    new Artifact("samples", "samples", true, true));

    private Bundle() {}

    public static void main(String[] arguments) throws IOException {
        String version = arguments[0];
        String address = arguments.length > 1 ? arguments[1].strip() : "";
        if (!address.isEmpty() && !address.matches("https?://[\\w./~:-]+")) {
            throw new IllegalArgumentException(
                    "cairn.url is \"%s\", expected the page of the source, https://.."
                            .formatted(address));
        }
        Path target = Files.createDirectories(Path.of("target"));
        Path zip = target.resolve("cairn-" + version + "-bundle.zip");
        try (OutputStream out = Files.newOutputStream(zip);
                ZipOutputStream entries = new ZipOutputStream(out)) {
            for (Artifact artifact : ARTIFACTS) {
                add(artifact, version, address, entries);
            }
        }
        System.out.println("The bundle is " + zip.toAbsolutePath());
        for (String missing : missing(version, address)) {
            System.out.println("Maven Central will miss: " + missing);
        }
    }

    private static List<String> missing(String version, String address) {
        List<String> missing = new ArrayList<>(List.of("signatures (.asc) beside the files"));
        if (address.isEmpty()) {
            missing.add("<url> and <scm>: name the page of the source by -Dcairn.url=https://..");
        }
        if (version.endsWith("-SNAPSHOT")) {
            missing.add("a version that is released, not " + version);
        }
        return missing;
    }

    private static void add(Artifact artifact, String version, String address, ZipOutputStream to)
            throws IOException {
        String stem = artifact.name() + "-" + version;
        String place = GROUP + artifact.name() + "/" + version + "/" + stem;
        Path folder = Path.of(artifact.folder());
        String pom = published(Files.readString(folder.resolve("pom.xml")), address);
        entry(to, place + ".pom", pom.getBytes(StandardCharsets.UTF_8));
        if (!artifact.isLibrary()) {
            return;
        }
        Path jar = folder.resolve("target").resolve(stem + ".jar");
        for (String kind : new String[] {"", "-sources", "-javadoc"}) {
            // What has no code still needs these two; there they hold licence and notice alone.
            Path file = artifact.hasCode() ? jar.resolveSibling(stem + kind + ".jar") : jar;
            if (!Files.isRegularFile(file)) {
                throw new IOException(file + " is missing: run mvn -Prelease");
            }
            boolean isJavadoc = artifact.hasCode() && kind.equals("-javadoc");
            entry(to, place + kind + ".jar", isJavadoc ? withLicence(file) : licensed(file));
        }
    }

    /** A pom with the address of the source, behind its description. */
    private static String published(String pom, String address) throws IOException {
        if (address.isEmpty()) {
            return pom;
        }
        String behind = "</description>\n";
        int at = pom.indexOf(behind);
        if (at < 0) {
            throw new IOException("a pom without a description: " + pom);
        }
        int next = at + behind.length();
        // A child would append its own name to what it inherits; so each says both itself.
        String page = "  <url>" + address + "</url>\n";
        String source =
                "  <scm>\n    <connection>scm:git:%s</connection>\n    <url>%s</url>\n  </scm>\n"
                        .formatted(address, address);
        return pom.substring(0, next) + page + source + pom.substring(next);
    }

    private static byte[] licensed(Path jar) throws IOException {
        try (ZipFile entries = new ZipFile(jar.toFile())) {
            for (String name : LICENCE) {
                if (entries.getEntry("META-INF/" + name) == null) {
                    throw new IOException(jar + " has no META-INF/" + name);
                }
            }
        }
        return Files.readAllBytes(jar);
    }

    /** The javadoc tool packs no resources, so they are put into its jar here. */
    private static byte[] withLicence(Path jar) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipFile from = new ZipFile(jar.toFile());
                ZipOutputStream to = new ZipOutputStream(bytes)) {
            for (ZipEntry entry : Collections.list(from.entries())) {
                write(to, entry.getName(), from.getInputStream(entry).readAllBytes());
            }
            for (String name : LICENCE) {
                if (from.getEntry("META-INF/" + name) == null) {
                    write(to, "META-INF/" + name, Files.readAllBytes(Path.of(name)));
                }
            }
        }
        return bytes.toByteArray();
    }

    private static void entry(ZipOutputStream to, String name, byte[] bytes) throws IOException {
        write(to, name, bytes);
        for (String algorithm : CHECKSUMS) {
            String suffix = "." + algorithm.replace("-", "").toLowerCase(java.util.Locale.ROOT);
            write(to, name + suffix, digest(algorithm, bytes).getBytes(StandardCharsets.US_ASCII));
        }
    }

    private static void write(ZipOutputStream to, String name, byte[] bytes) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTime(0);
        to.putNextEntry(entry);
        to.write(bytes);
        to.closeEntry();
    }

    private static String digest(String algorithm, byte[] bytes) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance(algorithm).digest(bytes));
        } catch (NoSuchAlgorithmException impossible) {
            throw new UncheckedIOException(new IOException(algorithm, impossible));
        }
    }
}
