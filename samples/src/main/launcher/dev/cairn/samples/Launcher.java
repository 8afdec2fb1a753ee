package dev.cairn.samples;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;

/**
 * Starts a program of Cairn's, such as the samples, on a Java that can run it, with the flags that
 * it needs.
 *
 * <p>A jar's manifest can neither choose a Java nor add a module. So this class, compiled for Java
 * 8, looks at the Java that runs it. With the right release and flags it calls the program's {@code
 * Main} in place; otherwise it starts {@code Main} in a child process: on this Java if only flags
 * miss, else on a JDK 25 that {@link JdkSearch} finds. The child shares the console and gets the
 * user's own JVM options; its exit code becomes ours; and it ends when this process is told to end.
 * The child starts {@code Main}, not this class, so there is no way to relaunch for ever.
 */
public final class Launcher {

    private static final int EXIT_UNUSABLE = 2;

    /** Packages of the kernels in lanes. */
    static final List<String> IN_LANES =
            Arrays.asList("dev.cairn.physics.solver.wide", "dev.cairn.physics.narrowphase.wide");

    private static final byte[] WARNING =
            "WARNING: Using incubator modules: ".getBytes(StandardCharsets.US_ASCII);

    private Launcher() {}

    /**
     * Runs the samples and ends this process with their exit code.
     *
     * @param arguments the arguments of the samples; {@code --help} lists them
     */
    public static void main(String[] arguments) {
        launch("dev.cairn.samples.Main", "Cairn's samples", arguments);
    }

    /**
     * Runs a program and ends this process with its exit code.
     *
     * @param main name of the class whose {@code main} is called
     * @param name of the program in messages, a plural
     * @param arguments of the program
     */
    public static void launch(String main, String name, String[] arguments) {
        List<String> jvmOptions = ManagementFactory.getRuntimeMXBean().getInputArguments();
        File home = new File(System.getProperty("java.home", "."));
        boolean recent =
                JdkSearch.feature(System.getProperty("java.specification.version", ""))
                        >= JdkSearch.NEEDED;
        if (recent && missingFlags(home, jvmOptions).isEmpty()) {
            callMain(main, name, arguments);
            return;
        }
        if (!recent) {
            File found = JdkSearch.ofThisMachine().find();
            if (found == null) {
                System.err.println(
                        name
                                + " need a JDK "
                                + JdkSearch.NEEDED
                                + ", and this is Java "
                                + System.getProperty("java.version")
                                + ": install one (for example Temurin "
                                + JdkSearch.NEEDED
                                + " from https://adoptium.net), or set JAVA_HOME to one that is"
                                + " installed elsewhere.");
                System.exit(EXIT_UNUSABLE);
                return;
            }
            home = found;
        }
        System.exit(
                relaunch(
                        command(
                                home,
                                jvmOptions,
                                System.getProperty("java.class.path", "."),
                                main,
                                arguments)));
    }

    /** Returns those of the needed flags that the options do not have. */
    static List<String> missingFlags(File home, List<String> jvmOptions) {
        boolean elsewhere =
                isMac() && System.getenv("JAVA_STARTED_ON_FIRST_THREAD_" + processId()) == null;
        return missingFlags(home, jvmOptions, elsewhere);
    }

    /**
     * The same; macOS lets only a process's first thread have windows, which is not the one in
     * which Java calls {@code main} unless it is told to.
     */
    static List<String> missingFlags(
            File home, List<String> jvmOptions, boolean offTheFirstThreadOfAMac) {
        List<String> missing = new ArrayList<String>();
        if (JdkSearch.hasVectorModule(home)
                && !has(jvmOptions, "--add-modules=", "jdk.incubator.vector")) {
            missing.add("--add-modules=jdk.incubator.vector");
        }
        if (!has(jvmOptions, "--enable-native-access=", "")) {
            missing.add("--enable-native-access=ALL-UNNAMED");
        }
        if (!has(jvmOptions, "--sun-misc-unsafe-memory-access=", "")) {
            missing.add("--sun-misc-unsafe-memory-access=allow");
        }
        if (offTheFirstThreadOfAMac) {
            missing.add("-XstartOnFirstThread");
        }
        return missing;
    }

    private static boolean has(List<String> options, String prefix, String part) {
        for (String option : options) {
            if (option.startsWith(prefix) && option.contains(part)) {
                return true;
            }
        }
        return false;
    }

    private static boolean isMac() {
        return System.getProperty("os.name", "").toLowerCase(Locale.ROOT).contains("mac");
    }

    /** The id of this process; Java 8 knows it only as the head of the runtime's name. */
    private static String processId() {
        String name = ManagementFactory.getRuntimeMXBean().getName();
        int at = name.indexOf('@');
        return at < 0 ? name : name.substring(0, at);
    }

    /** Returns the child's command line. */
    static List<String> command(
            File home, List<String> jvmOptions, String classPath, String main, String[] arguments) {
        List<String> command = new ArrayList<String>();
        command.add(JdkSearch.executable(home).getPath());
        for (String option : jvmOptions) {
            // A debugger's or agent's port is taken by this process already.
            if (!option.startsWith("-agentlib:") && !option.startsWith("-javaagent:")) {
                command.add(option);
            }
        }
        command.addAll(missingFlags(home, jvmOptions));
        command.addAll(earlyLanes(home));
        command.add("-Dcairn.launcher=" + processId());
        command.add("-classpath");
        command.add(classPath);
        command.add(main);
        command.addAll(Arrays.asList(arguments));
        return command;
    }

    /**
     * Options that are worth no child of their own: kernels in lanes, which are some hundred times
     * slower before they are compiled, are compiled after a tenth of the usual number of calls.
     */
    static List<String> earlyLanes(File home) {
        List<String> options = new ArrayList<String>();
        if (JdkSearch.hasVectorModule(home)) {
            options.add("-XX:CompileCommand=quiet");
            for (String kernels : IN_LANES) {
                options.add("-XX:CompileCommand=CompileThresholdScaling," + kernels + ".*::*,0.1");
            }
        }
        return options;
    }

    /** Runs the command on our console, and returns its exit code. */
    static int relaunch(List<String> command) {
        final Process child;
        try {
            child =
                    new ProcessBuilder(command)
                            .redirectInput(ProcessBuilder.Redirect.INHERIT)
                            .redirectOutput(ProcessBuilder.Redirect.INHERIT)
                            .start();
        } catch (IOException failure) {
            System.err.println("Cannot start " + command.get(0) + ": " + failure.getMessage());
            return EXIT_UNUSABLE;
        }
        Runtime.getRuntime()
                .addShutdownHook(
                        new Thread("end of child") {
                            @Override
                            public void run() {
                                endOf(child);
                            }
                        });
        Thread errors =
                new Thread("errors of child") {
                    @Override
                    public void run() {
                        try {
                            copyWithoutWarning(child.getErrorStream(), System.err);
                        } catch (IOException ignored) {
                            // The child is gone, and with it all that it could still say.
                        }
                    }
                };
        errors.setDaemon(true);
        errors.start();
        while (true) {
            try {
                int code = child.waitFor();
                errors.join(1000);
                return code;
            } catch (InterruptedException ignored) {
                // Nobody interrupts this thread; wait on.
            }
        }
    }

    /**
     * Copies what the child says on standard error, less the one line in which every JVM announces
     * an incubating module. No option silences that line, and it would stand before each of our own
     * messages.
     */
    static void copyWithoutWarning(InputStream from, OutputStream to) throws IOException {
        byte[] buffer = new byte[4096];
        boolean seen = false;
        boolean skipping = false;
        // Bytes of the warning that stood at the start of this line and are held back; -1: others.
        int held = 0;
        for (int n = from.read(buffer); n >= 0; n = from.read(buffer)) {
            for (int i = 0; i < n; i++) {
                byte next = buffer[i];
                if (skipping) {
                    skipping = next != '\n';
                } else if (!seen && held >= 0 && next == WARNING[held]) {
                    held++;
                    if (held == WARNING.length) {
                        seen = true;
                        skipping = true;
                        held = 0;
                    }
                } else {
                    to.write(WARNING, 0, Math.max(0, held));
                    to.write(next);
                    held = next == '\n' ? 0 : -1;
                }
            }
            to.flush();
        }
        to.write(WARNING, 0, Math.max(0, held));
        to.flush();
    }

    /** Asks the child to end, as a terminal's Ctrl-C does, and insists after some seconds. */
    private static void endOf(Process child) {
        child.destroy();
        try {
            if (!child.waitFor(5, TimeUnit.SECONDS)) {
                child.destroyForcibly();
            }
        } catch (InterruptedException interrupted) {
            child.destroyForcibly();
        }
    }

    private static void callMain(String main, String name, String[] arguments) {
        try {
            Method method = Class.forName(main).getMethod("main", String[].class);
            method.invoke(null, (Object) arguments);
        } catch (InvocationTargetException failure) {
            Throwable cause = failure.getCause();
            System.err.println(name + " failed: " + cause);
            cause.printStackTrace();
            System.exit(1);
        } catch (ReflectiveOperationException incomplete) {
            System.err.println(
                    "This jar is incomplete, build it again with `mvn package`: " + incomplete);
            System.exit(EXIT_UNUSABLE);
        }
    }
}
