import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * Lays what was packaged out as Maven Central takes it, and zips it: {@code java build/Bundle.java
 * VERSION} in the repository's root, after {@code mvn package}. Files are not signed; the program
 * says what else Central will miss.
 */
final class Bundle {
    private static final String GROUP = "dev/cairn/";
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
                    new Artifact("cairn-natives", "cairn-natives", true, false));

    private Bundle() {}

    public static void main(String[] arguments) throws IOException {
        String version = arguments[0];
        Path target = Files.createDirectories(Path.of("target"));
        Path zip = target.resolve("cairn-" + version + "-bundle.zip");
        try (OutputStream out = Files.newOutputStream(zip);
                ZipOutputStream entries = new ZipOutputStream(out)) {
            for (Artifact artifact : ARTIFACTS) {
                add(artifact, version, entries);
            }
        }
        System.out.println("The bundle is " + zip.toAbsolutePath());
        for (String missing : missing(version)) {
            System.out.println("Maven Central will miss: " + missing);
        }
    }

    private static List<String> missing(String version) throws IOException {
        List<String> missing = new ArrayList<>(List.of("signatures (.asc) beside the files"));
        String parent = Files.readString(Path.of("pom.xml"));
        for (String element : new String[] {"<url>", "<scm>"}) {
            // Those of licences do not count: they are set in deeper.
            if (!parent.contains("\n  " + element)) {
                missing.add(element + " in pom.xml");
            }
        }
        if (version.endsWith("-SNAPSHOT")) {
            missing.add("a version that is released, not " + version);
        }
        return missing;
    }

    private static void add(Artifact artifact, String version, ZipOutputStream to)
            throws IOException {
        String stem = artifact.name() + "-" + version;
        String place = GROUP + artifact.name() + "/" + version + "/" + stem;
        Path folder = Path.of(artifact.folder());
        entry(to, place + ".pom", Files.readAllBytes(folder.resolve("pom.xml")));
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
            entry(to, place + kind + ".jar", Files.readAllBytes(file));
        }
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
