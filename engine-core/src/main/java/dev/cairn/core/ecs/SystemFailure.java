package dev.cairn.core.ecs;

/** Carries what a system threw, with its place, from a worker to the world. */
final class SystemFailure extends RuntimeException {
    private static final long serialVersionUID = 1L;

    final String system;
    final int chunk;
    final Throwable failure;

    SystemFailure(String system, int chunk, Throwable failure) {
        super(failure.toString(), failure, true, false);
        this.system = system;
        this.chunk = chunk;
        this.failure = failure;
    }

    String place() {
        return "system '" + system + "'" + (chunk < 0 ? "" : " (chunk " + chunk + ")");
    }
}
