package dev.cairn.core.ecs;

/** Carries what a system or an observer threw, with its place, to the world. */
final class SystemFailure extends RuntimeException {
    private static final long serialVersionUID = 1L;

    final String place;

    /** Whether the tick is published: observers are told of it. */
    final boolean isPublished;

    final Throwable failure;

    SystemFailure(String place, boolean isPublished, Throwable failure) {
        super(failure.toString(), failure, true, false);
        this.place = place;
        this.isPublished = isPublished;
        this.failure = failure;
    }

    /** Of a system, on one of its chunks or, with -1, of all. */
    static SystemFailure of(String system, int chunk, Throwable failure) {
        return new SystemFailure(
                "system '" + system + "'" + (chunk < 0 ? "" : " (chunk " + chunk + ")"),
                false,
                failure);
    }
}
