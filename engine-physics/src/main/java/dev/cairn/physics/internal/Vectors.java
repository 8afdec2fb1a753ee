package dev.cairn.physics.internal;

/** Whether code of the Vector API may run in this JVM, and is worth it. Names no class of it. */
public final class Vectors {
    /** What the JVM must be started with. */
    public static final String MODULE = "jdk.incubator.vector";

    private Vectors() {}

    /**
     * Whether the JVM was started with the module. Any thread.
     *
     * @return false without {@code --add-modules jdk.incubator.vector}
     */
    public static boolean areThere() {
        return ModuleLayer.boot().findModule(MODULE).isPresent();
    }

    /**
     * Whether vectors stay in registers: without the C2 compiler each is an object on the heap, for
     * good. Any thread.
     *
     * @return false where only C1 or the interpreter runs
     */
    public static boolean areCompiled() {
        String mode = System.getProperty("java.vm.info", "");
        return !(mode.contains("emulated-client") || mode.contains("interpreted"));
    }
}
