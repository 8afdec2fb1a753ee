package dev.cairn.samples.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.zip.CRC32;

import javax.imageio.ImageIO;

/** The JDK's reader decodes each frame as a picture of its own; put together they are the input. */
class AnimatedPngTest {
    private static final int WIDTH = 37;
    private static final int HEIGHT = 23;

    @TempDir Path folder;

    /** As many colours as a table has. */
    private static List<int[]> film() {
        SplittableRandom random = new SplittableRandom(3);
        int[] colours = random.ints(ColourTable.MOST).map(rgb -> rgb | 0xFF000000).toArray();
        List<int[]> frames = new ArrayList<>();
        int[] now = new int[WIDTH * HEIGHT];
        for (int i = 0; i < now.length; i++) {
            now[i] = colours[i % colours.length];
        }
        for (int f = 0; f < 12; f++) {
            // Nothing, a pixel at a corner, or a random part of the picture.
            for (int i = 0; i < (f == 3 ? 0 : f == 4 ? 1 : 40 * f); i++) {
                now[f == 4 ? now.length - 1 : random.nextInt(now.length)] =
                        colours[random.nextInt(colours.length)];
            }
            frames.add(now.clone());
        }
        return frames;
    }

    private List<int[]> writtenAndRead(List<int[]> film, int width) throws IOException {
        AnimatedPng animation = new AnimatedPng(width, film.getFirst().length / width, 50);
        film.forEach(animation::add);
        Path file = folder.resolve("film.png");
        animation.write(file);
        List<int[]> read = frames(file, width, film.getFirst().length / width);
        assertEquals(film.size(), read.size());
        // A reader that knows no animation shows the first frame.
        assertEquals(read.get(0)[5], ImageIO.read(file.toFile()).getRGB(5, 0));
        return read;
    }

    @Test
    void everyFrameIsReadBackAsItWasWritten() throws IOException {
        List<int[]> film = film();
        List<int[]> read = writtenAndRead(film, WIDTH);
        for (int f = 0; f < film.size(); f++) {
            assertArrayEquals(film.get(f), read.get(f), "frame " + f);
        }
    }

    /**
     * A sky of 4096 colours and a patch that wanders over it: each square of 4 x 4 pixels has the
     * mean colour of its own to a level and a half, so that no band is seen, and what does not move
     * stays.
     */
    @Test
    void aSmoothSkyHasNoBands() throws IOException {
        int side = 64;
        List<int[]> film = new ArrayList<>();
        for (int f = 0; f < 6; f++) {
            int[] frame = new int[side * side];
            for (int i = 0; i < frame.length; i++) {
                int x = i % side;
                int y = i / side;
                boolean inPatch = x / 8 == f && y / 8 == 3;
                int sky = 0xFF000000 | (100 + x) << 16 | (130 + y) << 8 | (160 + (x + y) / 2);
                frame[i] = inPatch ? 0xFFC8553D : sky;
            }
            film.add(frame);
        }
        List<int[]> read = writtenAndRead(film, side);
        for (int f = 0; f < film.size(); f++) {
            for (int block = 0; block < side * side / 16; block++) {
                int at = block % (side / 4) * 4 + block / (side / 4) * 4 * side;
                for (int shift = 0; shift <= 16; shift += 8) {
                    double off = mean(read.get(f), at, side, shift);
                    off -= mean(film.get(f), at, side, shift);
                    assertEquals(0, off, 1.5, "square " + block + " of frame " + f);
                }
            }
            for (int i = 0; i < side * side && f > 0; i++) {
                if (film.get(f)[i] == film.get(f - 1)[i]) {
                    assertEquals(read.get(f - 1)[i], read.get(f)[i], "pixel " + i + " stays");
                }
            }
        }
    }

    private static double mean(int[] pixels, int at, int side, int shift) {
        double sum = 0;
        for (int i = 0; i < 16; i++) {
            sum += pixels[at + i % 4 + i / 4 * side] >> shift & 255;
        }
        return sum / 16;
    }

    @Test
    void mistakesAreTold() {
        AnimatedPng animation = new AnimatedPng(2, 2, 50);
        assertThrows(IllegalStateException.class, () -> animation.write(folder.resolve("a.png")));
        assertThrows(IllegalArgumentException.class, () -> animation.add(new int[3]));
    }

    /** Plays a file: checks its sums, gives each frame's pixels a file of their own, composes. */
    private static List<int[]> frames(Path file, int width, int height) throws IOException {
        List<int[]> frames = new ArrayList<>();
        int[] screen = new int[width * height];
        byte[] colours = {};
        int[] box = new int[4];
        int over = 0;
        int sequence = 0;
        DataInputStream in =
                new DataInputStream(new ByteArrayInputStream(Files.readAllBytes(file)));
        in.skipNBytes(8);
        while (true) {
            byte[] body = new byte[in.readInt() + 4];
            in.readFully(body);
            CRC32 sum = new CRC32();
            sum.update(body);
            assertEquals((int) sum.getValue(), in.readInt());
            String name = new String(body, 0, 4, StandardCharsets.US_ASCII);
            DataInputStream data = new DataInputStream(new ByteArrayInputStream(body, 4, 999_999));
            switch (name) {
                case "fcTL" -> {
                    assertEquals(sequence++, data.readInt());
                    for (int i = 0; i < 4; i++) {
                        box[i] = data.readInt();
                    }
                    assertEquals(50, data.readShort());
                    assertEquals(1000, data.readShort());
                    assertEquals(0, data.readByte());
                    over = data.readByte();
                }
                case "IDAT", "fdAT" -> {
                    if (name.equals("fdAT")) {
                        assertEquals(sequence++, data.readInt());
                    }
                    BufferedImage part = picture(box[0], box[1], colours, data.readAllBytes());
                    for (int y = 0; y < box[1]; y++) {
                        for (int x = 0; x < box[0]; x++) {
                            int argb = part.getRGB(x, y);
                            if (argb >>> 24 == 255 || over == 0) {
                                screen[(box[3] + y) * width + box[2] + x] = argb;
                            }
                        }
                    }
                    frames.add(screen.clone());
                }
                case "PLTE" -> colours = data.readAllBytes();
                case "tRNS" -> assertArrayEquals(new byte[1], data.readAllBytes());
                case "IEND" -> {
                    return frames;
                }
                default -> assertTrue(name.equals("IHDR") || name.equals("acTL"), name);
            }
        }
    }

    private static BufferedImage picture(int width, int height, byte[] colours, byte[] pixels)
            throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
        ByteArrayOutputStream head = new ByteArrayOutputStream();
        DataOutputStream to = new DataOutputStream(head);
        to.writeInt(width);
        to.writeInt(height);
        to.write(new byte[] {8, 3, 0, 0, 0});
        chunk(out, "IHDR", head.toByteArray());
        chunk(out, "PLTE", colours);
        chunk(out, "tRNS", new byte[1]);
        chunk(out, "IDAT", pixels);
        chunk(out, "IEND", new byte[0]);
        return ImageIO.read(new ByteArrayInputStream(bytes.toByteArray()));
    }

    private static void chunk(DataOutputStream out, String name, byte[] body) throws IOException {
        CRC32 sum = new CRC32();
        sum.update(name.getBytes(StandardCharsets.US_ASCII));
        sum.update(body);
        out.writeInt(body.length);
        out.writeBytes(name);
        out.write(body);
        out.writeInt((int) sum.getValue());
    }
}
