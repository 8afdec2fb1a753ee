package dev.cairn.samples.sandbox;

import dev.cairn.samples.SceneOptions;

import org.joml.Vector3d;

import java.util.Map;

/** What the panels show of a tick; a slot of a triple buffer. */
final class SandboxState {
    int scene;
    String id = "";
    SceneOptions options = new SceneOptions(Map.of(), SceneOptions.DEFAULT_SEED, null);
    long tick;
    double seconds;
    int workers = 1;
    int substeps = 1;
    int bodies;
    String problem = "";
    Sandbox.Ball ball = Sandbox.Ball.DEFAULT;

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
