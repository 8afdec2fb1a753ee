package dev.cairn.samples.replay;

import dev.cairn.core.state.StateException;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UTFDataFormatException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32C;
import java.util.zip.CheckedInputStream;
import java.util.zip.CheckedOutputStream;

/**
 * A recorded run as a file, numbers with their most significant byte first:
 *
 * <pre>
 *   "CAIRNRUN", version 1
 *   arguments of the run: how many, texts
 *   ticks: how many; of each its digest, and whether a keyframe follows: sums of columns and bodies
 *   CRC-32C of all before
 * </pre>
 *
 * @param arguments what was asked for: the scene and its settings
 * @param digests of the world after each tick, the first one before any
 * @param keyframes by tick
 */
public record RunFile(
        List<String> arguments, List<Long> digests, Map<Integer, Keyframe> keyframes) {
    private static final String MAGIC = "CAIRNRUN";
    private static final int VERSION = 1;
    private static final int MOST_ARGUMENTS = 1000;
    private static final int MOST = 10_000_001;

    /**
     * What a world was like, column by column and body by body.
     *
     * @param columns sum of each column, by name
     * @param bodies sum of each body's motion, in order
     */
    public record Keyframe(Map<String, Integer> columns, List<Long> bodies) {
        /**
         * The keyframe of a world, between steps.
         *
         * @param world any
         * @param room a state to be filled
         * @return sums
         */
        public static Keyframe of(PhysicsWorld world, WorldState room) {
            world.save(room);
            Map<String, Integer> columns = new LinkedHashMap<>();
            for (int i = 0; i < room.columnCount(); i++) {
                columns.merge(room.columnName(i), room.columnSum(i), (a, b) -> 31 * a + b);
            }
            List<Long> bodies = new ArrayList<>();
            for (BodyRef body : world.bodies()) {
                bodies.add(sum(body));
            }
            return new Keyframe(columns, bodies);
        }

        private static long sum(BodyRef body) {
            Vector3d v = new Vector3d();
            Quaterniond q = body.orientation(new Quaterniond());
            long sum = body.entity();
            sum = mix(sum, body.position(v));
            sum = mix(sum, body.velocity(v));
            sum = mix(sum, body.angularVelocity(v));
            sum = mix(sum, v.set(q.x, q.y, q.z));
            return 31 * sum + Double.doubleToRawLongBits(q.w);
        }

        private static long mix(long sum, Vector3d v) {
            long mixed = 31 * sum + Double.doubleToRawLongBits(v.x);
            mixed = 31 * mixed + Double.doubleToRawLongBits(v.y);
            return 31 * mixed + Double.doubleToRawLongBits(v.z);
        }
    }

    /**
     * Writes the file, in place of what it held.
     *
     * @param file where to
     * @throws IOException if that fails
     */
    public void write(Path file) throws IOException {
        CheckedOutputStream sum =
                new CheckedOutputStream(
                        new BufferedOutputStream(Files.newOutputStream(file)), new CRC32C());
        try (DataOutputStream out = new DataOutputStream(sum)) {
            out.writeBytes(MAGIC);
            out.writeInt(VERSION);
            out.writeInt(arguments.size());
            for (String argument : arguments) {
                out.writeUTF(argument);
            }
            out.writeInt(digests.size());
            for (int tick = 0; tick < digests.size(); tick++) {
                out.writeLong(digests.get(tick));
                Keyframe key = keyframes.get(tick);
                out.writeBoolean(key != null);
                if (key != null) {
                    write(key, out);
                }
            }
            out.writeLong(sum.getChecksum().getValue());
        }
    }

    private static void write(Keyframe key, DataOutputStream out) throws IOException {
        out.writeInt(key.columns.size());
        for (Map.Entry<String, Integer> column : key.columns.entrySet()) {
            out.writeUTF(column.getKey());
            out.writeInt(column.getValue());
        }
        out.writeInt(key.bodies.size());
        for (long body : key.bodies) {
            out.writeLong(body);
        }
    }

    /**
     * Reads a file.
     *
     * @param file what {@link #write} wrote
     * @return the run
     * @throws IOException if that fails
     * @throws StateException if it is no such file, of another version, or damaged
     */
    public static RunFile read(Path file) throws IOException {
        CheckedInputStream sum =
                new CheckedInputStream(
                        new BufferedInputStream(Files.newInputStream(file)), new CRC32C());
        try (DataInputStream in = new DataInputStream(sum)) {
            byte[] magic = in.readNBytes(MAGIC.length());
            if (!MAGIC.equals(new String(magic, StandardCharsets.US_ASCII))) {
                throw new StateException(
                        file + " is no recorded run: it does not begin with " + MAGIC);
            }
            int version = in.readInt();
            if (version != VERSION) {
                throw new StateException(
                        file + " is of version " + version + "; this program reads " + VERSION);
            }
            List<String> arguments = new ArrayList<>();
            for (int left = count(in, MOST_ARGUMENTS); left > 0; left--) {
                arguments.add(in.readUTF());
            }
            List<Long> digests = new ArrayList<>();
            Map<Integer, Keyframe> keyframes = new LinkedHashMap<>();
            int ticks = count(in, MOST);
            for (int tick = 0; tick < ticks; tick++) {
                digests.add(in.readLong());
                if (in.readBoolean()) {
                    keyframes.put(tick, readKeyframe(in));
                }
            }
            long expected = sum.getChecksum().getValue();
            if (in.readLong() != expected) {
                throw new StateException(file + " is damaged: the sum of its bytes is another one");
            }
            return new RunFile(arguments, digests, keyframes);
        } catch (EOFException end) {
            throw new StateException(file + " is not complete", end);
        } catch (UTFDataFormatException bad) {
            throw new StateException(file + " is damaged: a text in it is none", bad);
        }
    }

    private static Keyframe readKeyframe(DataInputStream in) throws IOException {
        Map<String, Integer> columns = new LinkedHashMap<>();
        for (int left = count(in, MOST); left > 0; left--) {
            columns.put(in.readUTF(), in.readInt());
        }
        List<Long> bodies = new ArrayList<>();
        for (int left = count(in, MOST); left > 0; left--) {
            bodies.add(in.readLong());
        }
        return new Keyframe(columns, bodies);
    }

    private static int count(DataInputStream in, int most) throws IOException {
        int count = in.readInt();
        if (count < 0 || count > most) {
            throw new StateException(
                    "a recorded run tells " + count + " entries; it must be 0 to " + most);
        }
        return count;
    }
}
