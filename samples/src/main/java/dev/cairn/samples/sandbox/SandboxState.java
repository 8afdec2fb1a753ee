package dev.cairn.samples.sandbox;

import dev.cairn.samples.SceneOptions;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.Map;

/** What the panels show of a tick; a slot of a triple buffer. */
final class SandboxState {
    int scene;
    String id = "";
    SceneOptions options = new SceneOptions(Map.of(), SceneOptions.DEFAULT_SEED, null);
    long tick;
    double seconds;

    /** The first and the last tick that can be gone back to. */
    long oldestTick;

    long newestTick;

    /** The moment that was kept for comparing, or -1. */
    long keptTick = -1;

    /** What came of it the first time, and how far a body is from there, m; NaN if not known. */
    @Nullable OtherFuture future;

    double apart = Double.NaN;
    int workers = 1;
    int substeps = 1;
    int bodies;
    String problem = "";
    Thrower.Ball ball = Thrower.Ball.DEFAULT;

    /** The world's entity for each of the edited scene's, and what the world said about it. */
    long[] entities = {};

    String notes = "";

    /** The body that was picked last; empty if there was none. */
    String held = "";

    boolean pulling;
    boolean heldIsFixed;
    double heldMass;
    double heldSpeed;
    final Vector3d heldAt = new Vector3d();

    /** Where the hand holds the body, and where it wants it. */
    final Vector3d pullFrom = new Vector3d();

    final Vector3d pullTo = new Vector3d();

    final PlotHistory history = new PlotHistory();
}
