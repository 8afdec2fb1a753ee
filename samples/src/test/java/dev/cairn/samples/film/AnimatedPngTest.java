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

    private static List<int[]> film() {
        SplittableRandom random = new SplittableRandom(3);
        List<int[]> frames = new ArrayList<>();
        int[] now = random.ints((long) WIDTH * HEIGHT).toArray();
        for (int f = 0; f < 12; f++) {
            // Nothing, a pixel at a corner, or a random part of the picture.
            for (int i = 0; i < (f == 3 ? 0 : f == 4 ? 1 : 40 * f); i++) {
                now[f == 4 ? now.length - 1 : random.nextInt(now.length)] = random.nextInt();
            }
            frames.add(now.clone());
        }
        return frames;
    }

    @Test
    void everyFrameIsReadBackAsItWasWritten() throws IOException {
        AnimatedPng animation = new AnimatedPng(WIDTH, HEIGHT, 50);
        List<int[]> film = film();
        film.forEach(animation::add);
        Path file = folder.resolve("film.png");
        animation.write(file);
        List<int[]> read = frames(file);
        assertEquals(film.size(), read.size());
        for (int f = 0; f < film.size(); f++) {
            int[] wanted = film.get(f).clone();
            for (int i = 0; i < wanted.length; i++) {
                int argb = AnimatedPng.round(wanted[i]);
                for (int shift = 0; shift <= 16; shift += 8) {
                    int off = Math.abs((argb >> shift & 255) - (wanted[i] >> shift & 255));
                    assertTrue(off <= 4, "rounded by " + off);
                }
                wanted[i] = argb;
            }
            assertArrayEquals(wanted, read.get(f), "frame " + f);
        }
        // A reader that knows no animation shows the first frame.
        assertEquals(read.get(0)[5], ImageIO.read(file.toFile()).getRGB(5, 0));
    }

    @Test
    void mistakesAreTold() {
        AnimatedPng animation = new AnimatedPng(2, 2, 50);
        assertThrows(IllegalStateException.class, () -> animation.write(folder.resolve("a.png")));
        assertThrows(IllegalArgumentException.class, () -> animation.add(new int[3]));
    }

    /** Plays a file: checks its sums, gives each frame's pixels a file of their own, composes. */
    private static List<int[]> frames(Path file) throws IOException {
        List<int[]> frames = new ArrayList<>();
        int[] screen = new int[WIDTH * HEIGHT];
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
                    BufferedImage part = picture(box[0], box[1], data.readAllBytes());
                    for (int y = 0; y < box[1]; y++) {
                        for (int x = 0; x < box[0]; x++) {
                            int argb = part.getRGB(x, y);
                            if (argb >>> 24 == 255 || over == 0) {
                                screen[(box[3] + y) * WIDTH + box[2] + x] = argb;
                            }
                        }
                    }
                    frames.add(screen.clone());
                }
                case "IEND" -> {
                    return frames;
                }
                default -> assertTrue(name.equals("IHDR") || name.equals("acTL"), name);
            }
        }
    }

    private static BufferedImage picture(int width, int height, byte[] pixels) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
        ByteArrayOutputStream head = new ByteArrayOutputStream();
        DataOutputStream to = new DataOutputStream(head);
        to.writeInt(width);
        to.writeInt(height);
        to.write(new byte[] {8, 6, 0, 0, 0});
        chunk(out, "IHDR", head.toByteArray());
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
