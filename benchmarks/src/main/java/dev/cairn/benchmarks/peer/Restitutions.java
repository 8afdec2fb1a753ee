package dev.cairn.benchmarks.peer;

/**
 * For engines that multiply the restitutions of a pair, where the description wants the larger one.
 * If all bodies that bounce share one coefficient e, then e on the bouncing bodies that move and 1
 * on the fixed ones gives the right product whenever a moving body hits a fixed one.
 */
final class Restitutions {
    private Restitutions() {}

    /** Returns the scene's only restitution above 0, or 0 if there is none or more than one. */
    static double common(SceneDescription scene) {
        double common = 0;
        for (SceneDescription.Solid solid : scene.bodies()) {
            double e = solid.restitution();
            if (e > 0 && common > 0 && e != common) {
                return 0;
            }
            common = Math.max(common, e);
        }
        return common;
    }

    /** Returns what a body carries. */
    static double factor(SceneDescription.Solid solid, double common) {
        if (common == 0) {
            return solid.restitution();
        }
        return solid.fixed() ? 1 : common;
    }
}
