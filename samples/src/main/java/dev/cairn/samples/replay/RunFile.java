package dev.cairn.samples.replay;

import dev.cairn.core.state.Frame;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.StateException;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.time.Recording;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.UsageException;

import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A run of a scene as a file: which scene it is, and behind that a {@link Recording}. A saved
 * moment is a recording without ticks. Both parts are framed as the library frames a state, with a
 * version and a sum:
 *
 * <pre>
 *   scene      arguments that lead to it (how many, texts), number of the tick it begins with, the
 *              text of its scene file, empty for a scene of the list
 *   recording  as {@link Recording#writeTo} writes it
 * </pre>
 */
public final class RunFile {
    private static final Frame FRAME = new Frame("CAIRNRN4", "recorded run");

    private final Path file;
    private final List<String> arguments;
    private final long tick;
    private final String sceneText;
    private final byte[] recording;

    private RunFile(
            Path file, List<String> arguments, long tick, String sceneText, byte[] recording) {
        this.file = file;
        this.arguments = arguments;
        this.tick = tick;
        this.sceneText = sceneText;
        this.recording = recording;
    }

    /**
     * Writes a file, in place of what it held.
     *
     * @param file where to
     * @param arguments options that lead to the scene
     * @param sceneText the scene as a scene file; empty if it is one of the list
     * @param tick number of the tick that the recording begins with
     * @param recording what was written down
     * @param looks those of the scene
     * @throws IOException if that fails
     * @throws StateException if the world holds objects that have no codec
     */
    public static void write(
            Path file,
            List<String> arguments,
            String sceneText,
            long tick,
            Recording<Act> recording,
            Looks looks)
            throws IOException {
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            FRAME.write(
                    out, StateCodecs.STANDARD, head -> writeHead(arguments, tick, sceneText, head));
            recording.writeTo(out, looks.codecs());
        }
    }

    private static void writeHead(
            List<String> arguments, long tick, String sceneText, StateOutput out) {
        out.writeInt(arguments.size());
        arguments.forEach(out::writeString);
        out.writeLong(tick);
        out.writeString(sceneText);
    }

    /**
     * Reads which scene it is.
     *
     * @param file what {@link #write} wrote
     * @return the file; {@link #recording} reads the rest
     * @throws IOException if that fails
     * @throws StateException if it is no such file, of another version, or damaged
     */
    public static RunFile open(Path file) throws IOException {
        byte[] all = Files.readAllBytes(file);
        ByteArrayInputStream in = new ByteArrayInputStream(all);
        try {
            return FRAME.read(in, StateCodecs.STANDARD, head -> readHead(file, head, in));
        } catch (StateException told) {
            throw about(file, told);
        }
    }

    private static RunFile readHead(Path file, StateInput head, ByteArrayInputStream in) {
        List<String> arguments = new ArrayList<>();
        for (int left = head.requireCount(4, head.readInt()); left > 0; left--) {
            arguments.add(head.readString());
        }
        long tick = head.readLong();
        if (tick < 0) {
            throw new StateException("it begins with tick " + tick + "; ticks begin with 0");
        }
        String sceneText = head.readString();
        return new RunFile(file, List.copyOf(arguments), tick, sceneText, in.readAllBytes());
    }

    private static StateException about(Path file, StateException told) {
        return new StateException(file + ": " + told.getMessage(), told);
    }

    /**
     * Options that lead to the scene.
     *
     * @return the scene and its settings
     */
    public List<String> arguments() {
        return arguments;
    }

    /**
     * The scene, if it is none of the list.
     *
     * @return the text of a scene file, or nothing
     */
    public String sceneText() {
        return sceneText;
    }

    /**
     * The tick that the recording begins with.
     *
     * @return its number, at least 0
     */
    public long tick() {
        return tick;
    }

    /**
     * What was written down.
     *
     * @param looks those of the same scene
     * @return the recording
     * @throws StateException if it is damaged, or of another scene
     */
    public Recording<Act> recording(Looks looks) {
        ByteArrayInputStream in = new ByteArrayInputStream(recording);
        try {
            Recording<Act> read = Recording.read(in, looks.codecs(), Act.class);
            if (in.available() > 0) {
                throw new StateException(in.available() + " bytes follow the end of the recording");
            }
            return read;
        } catch (StateException told) {
            throw about(file, told);
        } catch (IOException impossible) {
            throw new IllegalStateException("bytes in memory cannot be read", impossible);
        }
    }

    /**
     * Puts a scene to the moment that the file begins with.
     *
     * @param world in which the same scene was just built
     * @param scene the same
     * @throws UsageException if the file is damaged, or of another scene
     */
    public void putBack(PhysicsWorld world, SceneBuilder scene) {
        try {
            restore(world, scene);
        } catch (StateException told) {
            String reason = String.valueOf(told.getMessage());
            String prefix = reason.startsWith(file.toString()) ? "" : file + ": ";
            throw new UsageException("--from " + prefix + reason, told);
        }
    }

    /**
     * The same, as the library tells of mistakes.
     *
     * @param world in which the same scene was just built
     * @param scene the same
     * @throws StateException if the file is damaged, or of another scene; the world is as it was
     */
    public void restore(PhysicsWorld world, SceneBuilder scene) {
        world.restore(recording(new Looks(world)).state(0));
        scene.returnTo(tick);
    }
}
