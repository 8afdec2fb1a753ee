package dev.cairn.benchmarks.peer;

/**
 * Compares what an engine says a body has with what it was given. A setter that does nothing would
 * otherwise pass for a slow or an inaccurate engine.
 */
final class ReadBack {
    private static final double TOLERANCE = 1e-4;

    private ReadBack() {}

    /** Checks the diagonal of a movable body's inertia, kg m². */
    static void inertia(
            Engine engine, SceneDescription.Solid solid, double xx, double yy, double zz) {
        check(engine, solid.inertia().m00(), xx);
        check(engine, solid.inertia().m11(), yy);
        check(engine, solid.inertia().m22(), zz);
    }

    private static void check(Engine engine, double wanted, double got) {
        if (!(Math.abs(got - wanted) <= TOLERANCE * Math.abs(wanted))) {
            throw new IllegalStateException(
                    "%s: its adapter set an inertia of %g kg m² and read back %g"
                            .formatted(engine.title(), wanted, got));
        }
    }
}
