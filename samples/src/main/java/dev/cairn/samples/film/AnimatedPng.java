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
 * from frame to frame: the smallest rectangle, with pixels that stay left transparent. A pixel is
 * one byte, the place of its colour in a {@link ColourTable}. One thread.
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
        frames.add(argb.clone());
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
                    to.writeByte(3); // places in a table of colours
                    to.writeByte(0);
                    to.writeByte(0);
                    to.writeByte(0);
                });
        ColourTable table = new ColourTable(frames);
        chunk(
                out,
                "PLTE",
                to -> {
                    to.write(new byte[3]); // the first is what stays
                    for (int i = 0; i < table.size(); i++) {
                        to.writeByte(table.colour(i) >> 16);
                        to.writeByte(table.colour(i) >> 8);
                        to.writeByte(table.colour(i));
                    }
                });
        chunk(out, "tRNS", to -> to.writeByte(0));
        chunk(
                out,
                "acTL",
                to -> {
                    to.writeInt(frames.size());
                    to.writeInt(0);
                });
        int sequence = 0;
        byte @Nullable [] before = null;
        for (int i = 0; i < frames.size(); i++) {
            byte[] now = places(frames.get(i), table);
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
            before = now;
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
    private int[] changed(byte[] before, byte[] now) {
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

    /** Of each pixel the place of its colour; that of what is transparent is 0. */
    private byte[] places(int[] argb, ColourTable table) {
        byte[] places = new byte[argb.length];
        for (int i = 0; i < argb.length; i++) {
            places[i] = (byte) (1 + table.index(argb[i], i % width, i / width));
        }
        return places;
    }

    private byte[] compressed(byte[] now, byte @Nullable [] before, int[] box) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
        try (DeflaterOutputStream out = new DeflaterOutputStream(bytes, deflater)) {
            byte[] row = new byte[1 + box[2] - box[0]]; // begins with 0: no filter
            for (int y = box[1]; y < box[3]; y++) {
                for (int x = box[0]; x < box[2]; x++) {
                    int i = y * width + x;
                    row[1 + x - box[0]] = before != null && before[i] == now[i] ? 0 : now[i];
                }
                out.write(row);
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
