package dev.cairn.samples.film;

import org.jspecify.annotations.Nullable;

import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Writes an animated .png: a first picture that every reader shows, and after it only what changes
 * from frame to frame: the smallest rectangle, with pixels that stay left transparent. Colours are
 * rounded to five bits a channel, which the eye does not see in motion and which makes the file
 * half as large. One thread.
 *
 * <p>Source: PNG, third edition (W3C, 2025), chunks acTL, fcTL and fdAT.
 */
final class AnimatedPng {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

    private final int width;
    private final int height;
    private final int delayMillis;
    private final List<int[]> frames = new ArrayList<>();

    /**
     * An animation without frames.
     *
     * @param width pixels
     * @param height pixels
     * @param delayMillis time that each frame is shown
     */
    AnimatedPng(int width, int height, int delayMillis) {
        this.width = width;
        this.height = height;
        this.delayMillis = delayMillis;
    }

    /**
     * Adds a frame.
     *
     * @param argb pixels, top row first; copied
     */
    void add(int[] argb) {
        if (argb.length != width * height) {
            throw new IllegalArgumentException(
                    "a frame of %d pixels, expected %d x %d".formatted(argb.length, width, height));
        }
        int[] rounded = new int[argb.length];
        for (int i = 0; i < argb.length; i++) {
            rounded[i] = round(argb[i]);
        }
        frames.add(rounded);
    }

    /** To five bits a channel; black stays black and white white. */
    static int round(int argb) {
        int rounded = 0xFF000000;
        for (int shift = 16; shift >= 0; shift -= 8) {
            int five = (int) Math.rint((argb >> shift & 255) * 31 / 255.0);
            rounded |= (int) Math.rint(five * 255 / 31.0) << shift;
        }
        return rounded;
    }

    /**
     * Writes the file; it plays without an end.
     *
     * @param file where
     * @throws UncheckedIOException if it cannot be written
     */
    void write(Path file) {
        if (frames.isEmpty()) {
            throw new IllegalStateException("an animation without a frame cannot be written");
        }
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            write(out);
        } catch (IOException unwritable) {
            throw new UncheckedIOException(
                    "the animation %s was not saved: %s".formatted(file, unwritable.getMessage()),
                    unwritable);
        }
    }

    private void write(OutputStream out) throws IOException {
        out.write(SIGNATURE);
        chunk(
                out,
                "IHDR",
                to -> {
                    to.writeInt(width);
                    to.writeInt(height);
                    to.writeByte(8); // bits a channel
                    to.writeByte(6); // red, green, blue, alpha
                    to.writeByte(0);
                    to.writeByte(0);
                    to.writeByte(0);
                });
        chunk(
                out,
                "acTL",
                to -> {
                    to.writeInt(frames.size());
                    to.writeInt(0);
                });
        int sequence = 0;
        for (int i = 0; i < frames.size(); i++) {
            int[] now = frames.get(i);
            int @Nullable [] before = i == 0 ? null : frames.get(i - 1);
            int[] box = before == null ? new int[] {0, 0, width, height} : changed(before, now);
            int number = sequence++;
            chunk(out, "fcTL", to -> control(to, number, box, number > 0));
            byte[] pixels = compressed(now, before, box);
            if (i == 0) {
                chunk(out, "IDAT", to -> to.write(pixels));
            } else {
                int next = sequence++;
                chunk(
                        out,
                        "fdAT",
                        to -> {
                            to.writeInt(next);
                            to.write(pixels);
                        });
            }
        }
        chunk(out, "IEND", to -> {});
    }

    private void control(DataOutputStream to, int number, int[] box, boolean over)
            throws IOException {
        to.writeInt(number);
        to.writeInt(box[2] - box[0]);
        to.writeInt(box[3] - box[1]);
        to.writeInt(box[0]);
        to.writeInt(box[1]);
        to.writeShort(delayMillis);
        to.writeShort(1000);
        to.writeByte(0); // leave the picture as it is afterwards
        to.writeByte(over ? 1 : 0); // draw over it
    }

    /** Left, top, right, bottom of what changed; a pixel at least. */
    private int[] changed(int[] before, int[] now) {
        int[] box = {width, height, 0, 0};
        for (int i = 0; i < now.length; i++) {
            if (now[i] != before[i]) {
                box[0] = Math.min(box[0], i % width);
                box[1] = Math.min(box[1], i / width);
                box[2] = Math.max(box[2], i % width + 1);
                box[3] = Math.max(box[3], i / width + 1);
            }
        }
        return box[2] == 0 ? new int[] {0, 0, 1, 1} : box;
    }

    private byte[] compressed(int[] now, int @Nullable [] before, int[] box) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
        try (DeflaterOutputStream out = new DeflaterOutputStream(bytes, deflater)) {
            int rowBytes = 4 * (box[2] - box[0]);
            byte[] row = new byte[rowBytes];
            byte[] above = new byte[rowBytes];
            for (int y = box[1]; y < box[3]; y++) {
                for (int x = box[0]; x < box[2]; x++) {
                    int i = y * width + x;
                    int argb = before != null && before[i] == now[i] ? 0 : now[i];
                    int at = 4 * (x - box[0]);
                    row[at] = (byte) (argb >> 16);
                    row[at + 1] = (byte) (argb >> 8);
                    row[at + 2] = (byte) argb;
                    row[at + 3] = (byte) (argb >>> 24);
                }
                // Differences from above suit a whole picture; the sparse rest is best as it is.
                out.write(before == null ? 2 : 0);
                for (int k = 0; k < rowBytes && before == null; k++) {
                    above[k] = (byte) (row[k] - above[k]);
                }
                out.write(before == null ? above : row);
                System.arraycopy(row, 0, above, 0, rowBytes);
            }
        } finally {
            deflater.end();
        }
        return bytes.toByteArray();
    }

    private interface Content {
        void write(DataOutputStream to) throws IOException;
    }

    private static void chunk(OutputStream out, String name, Content content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream data = new DataOutputStream(bytes);
        data.write(name.getBytes(StandardCharsets.US_ASCII));
        content.write(data);
        byte[] whole = bytes.toByteArray();
        CRC32 sum = new CRC32();
        sum.update(whole);
        DataOutputStream to = new DataOutputStream(out);
        to.writeInt(whole.length - 4);
        to.write(whole);
        to.writeInt((int) sum.getValue());
    }
}
