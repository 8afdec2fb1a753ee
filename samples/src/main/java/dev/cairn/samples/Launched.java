package dev.cairn.samples;

/** What a process that the launcher has started owes it. */
public final class Launched {
    private static final int FAILED = 1;

    private Launched() {}

    /**
     * Ends this process when the launcher that started it is killed, so that no orphan keeps
     * computing.
     */
    @SuppressWarnings(
            "FutureReturnValueIgnored") // It ends the process; nobody is left to look at a result.
    public static void endWithLauncher() {
        Long launcher = Long.getLong("cairn.launcher");
        if (launcher != null) {
            ProcessHandle.of(launcher)
                    .ifPresent(handle ->
                            handle.onExit().thenRun(() -> Runtime.getRuntime().halt(FAILED)));
        }
    }
}
