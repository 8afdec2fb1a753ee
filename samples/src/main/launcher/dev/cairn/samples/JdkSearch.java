package dev.cairn.samples;

import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;

/**
 * Looks for an installed Java that can run Cairn, in the places where installers put them.
 *
 * <p>A folder counts when it has {@code bin/java} and a {@code release} file (the text file that
 * every JDK since 9 carries) that names a recent enough version. Nothing is started to find out.
 * Release 25 itself is preferred; of others, the first found. Compiled for Java 8, because an old
 * {@code java} runs it.
 */
final class JdkSearch {

    /** The oldest Java that runs Cairn. */
    static final int NEEDED = 25;

    private final Map<String, String> environment;
    private final File userHome;
    private final List<File> roots;

    /**
     * @param environment the environment variables, as from {@link System#getenv()}
     * @param userHome the user's home directory
     * @param roots directories whose children are JDKs; see {@link #installRoots}
     */
    JdkSearch(Map<String, String> environment, File userHome, List<File> roots) {
        this.environment = environment;
        this.userHome = userHome;
        this.roots = roots;
    }

    /** Returns a search over this machine. */
    static JdkSearch ofThisMachine() {
        return new JdkSearch(
                System.getenv(),
                new File(System.getProperty("user.home", ".")),
                installRoots(System.getenv()));
    }

    /** Returns where Linux, macOS and Windows installers put JDKs, one folder each. */
    static List<File> installRoots(Map<String, String> environment) {
        List<File> roots = new ArrayList<File>();
        for (String unix :
                new String[] {"/usr/lib/jvm", "/usr/lib64/jvm", "/usr/java", "/opt", "/opt/java"}) {
            roots.add(new File(unix));
        }
        roots.add(new File("/Library/Java/JavaVirtualMachines"));
        roots.add(new File("/opt/homebrew/opt"));
        roots.add(new File("/usr/local/opt"));
        for (String variable : new String[] {"ProgramFiles", "ProgramW6432"}) {
            String programs = environment.get(variable);
            if (programs != null) {
                for (String vendor :
                        new String[] {
                            "Java",
                            "Eclipse Adoptium",
                            "Microsoft",
                            "Zulu",
                            "Amazon Corretto",
                            "BellSoft",
                            "Semeru"
                        }) {
                    roots.add(new File(programs, vendor));
                }
            }
        }
        return roots;
    }

    /**
     * Finds a Java that can run Cairn.
     *
     * @return its home directory, or null if there is none
     */
    File find() {
        File newer = null;
        for (File home : candidates()) {
            int feature = featureOf(home);
            if (feature == NEEDED) {
                return home;
            }
            if (feature > NEEDED && newer == null) {
                newer = home;
            }
        }
        return newer;
    }

    /** Returns every directory worth a look, the user's explicit choices first. */
    private Set<File> candidates() {
        Set<File> homes = new LinkedHashSet<File>();
        addHome(homes, environment.get("JAVA_HOME"));
        addHome(homes, environment.get("JDK_HOME"));
        // Build services name their JDKs so: JAVA_HOME_25, JAVA_HOME_25_X64.
        for (Map.Entry<String, String> entry :
                new TreeMap<String, String>(environment).entrySet()) {
            if (entry.getKey().startsWith("JAVA_HOME_")) {
                addHome(homes, entry.getValue());
            }
        }
        String path = environment.get("PATH");
        if (path == null) {
            path = environment.get("Path");
        }
        if (path != null) {
            for (String directory : path.split(File.pathSeparator)) {
                addHomeOfBin(homes, new File(directory));
            }
        }
        for (File root : roots) {
            addChildren(homes, root);
        }
        addChildren(homes, new File(userHome, ".sdkman/candidates/java"));
        addChildren(homes, new File(userHome, ".jdks"));
        addChildren(homes, new File(userHome, ".gradle/jdks"));
        addChildren(homes, new File(userHome, ".asdf/installs/java"));
        addChildren(homes, new File(userHome, ".local/share/mise/installs/java"));
        addChildren(homes, new File(userHome, "Library/Java/JavaVirtualMachines"));
        return homes;
    }

    private static void addHome(Set<File> homes, String directory) {
        if (directory != null && !directory.isEmpty()) {
            homes.add(new File(directory));
        }
    }

    /**
     * A {@code java} on the PATH is often a chain of links; its home is the parent of the real
     * {@code bin}.
     */
    private static void addHomeOfBin(Set<File> homes, File bin) {
        File java = new File(bin, executableName());
        if (!java.isFile()) {
            return;
        }
        try {
            File realBin = java.getCanonicalFile().getParentFile();
            if (realBin != null && realBin.getParentFile() != null) {
                homes.add(realBin.getParentFile());
            }
        } catch (IOException unreadable) {
            // A link that leads nowhere is no candidate.
        }
    }

    private static void addChildren(Set<File> homes, File root) {
        File[] children = root.listFiles();
        if (children == null) {
            return;
        }
        Arrays.sort(children, Collections.<File>reverseOrder());
        for (File child : children) {
            homes.add(child);
            homes.add(new File(child, "Contents/Home"));
            homes.add(new File(child, "libexec/openjdk.jdk/Contents/Home"));
        }
    }

    /** Returns the {@code java} of a home directory. */
    static File executable(File home) {
        return new File(new File(home, "bin"), executableName());
    }

    private static String executableName() {
        return File.separatorChar == '\\' ? "java.exe" : "java";
    }

    /**
     * Returns the feature release (8, 17, 25 ...) of a home directory, or 0 if it is no usable
     * Java.
     */
    static int featureOf(File home) {
        if (!executable(home).isFile()) {
            return 0;
        }
        return feature(property(home, "JAVA_VERSION"));
    }

    /**
     * Says whether the Java at this home has the Vector API; a Java whose list of modules is
     * unknown counts as having it.
     */
    static boolean hasVectorModule(File home) {
        String modules = property(home, "MODULES");
        return modules.isEmpty() || (" " + modules + " ").contains(" jdk.incubator.vector ");
    }

    /**
     * Returns the feature release that a version text names ("1.8.0_392" is 8, "25.0.3" is 25), or
     * 0.
     */
    static int feature(String version) {
        String[] parts = version.split("[^0-9]+");
        int first = parts.length > 0 && !parts[0].isEmpty() ? parse(parts[0]) : 0;
        return first == 1 && parts.length > 1 ? parse(parts[1]) : first;
    }

    private static int parse(String digits) {
        return digits.length() > 6 ? 0 : Integer.parseInt(digits);
    }

    private static String property(File home, String name) {
        Properties release = new Properties();
        try {
            InputStream in = new FileInputStream(new File(home, "release"));
            try {
                release.load(in);
            } finally {
                in.close();
            }
        } catch (IOException missing) {
            return "";
        } catch (IllegalArgumentException malformed) {
            return "";
        }
        return release.getProperty(name, "").replace("\"", "");
    }
}
