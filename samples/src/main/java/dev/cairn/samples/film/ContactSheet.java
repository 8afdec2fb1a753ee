package dev.cairn.samples.film;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;

import javax.imageio.ImageIO;

/** Puts small copies of pictures side by side, three in a row. Needs neither GL nor a display. */
public final class ContactSheet {
    private static final int COLUMNS = 3;
    private static final int WIDTH = 426;
    private static final int HEIGHT = 240;
    private static final int GAP = 4;

    private ContactSheet() {}

    /**
     * Writes the sheet.
     *
     * @param pictures .png files of 16:9, at least one
     * @param sheet where the sheet goes
     * @throws UncheckedIOException if a picture cannot be read or the sheet not be written
     */
    public static void write(List<Path> pictures, Path sheet) {
        int columns = Math.min(COLUMNS, pictures.size());
        int rows = (pictures.size() + COLUMNS - 1) / COLUMNS;
        BufferedImage all =
                new BufferedImage(
                        Math.max(1, columns * (WIDTH + GAP) - GAP),
                        Math.max(1, rows * (HEIGHT + GAP) - GAP),
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = all.createGraphics();
        try {
            pen.setBackground(Color.WHITE);
            pen.clearRect(0, 0, all.getWidth(), all.getHeight());
            pen.setRenderingHint(
                    RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            for (int i = 0; i < pictures.size(); i++) {
                BufferedImage picture = ImageIO.read(pictures.get(i).toFile());
                if (picture == null) {
                    throw new IOException(pictures.get(i) + " is no picture");
                }
                // A third in one bilinear step would skip pixels; the half first does not.
                BufferedImage half =
                        new BufferedImage(2 * WIDTH, 2 * HEIGHT, BufferedImage.TYPE_INT_RGB);
                Graphics2D halfPen = half.createGraphics();
                halfPen.setRenderingHint(
                        RenderingHints.KEY_INTERPOLATION,
                        RenderingHints.VALUE_INTERPOLATION_BILINEAR);
                halfPen.drawImage(picture, 0, 0, 2 * WIDTH, 2 * HEIGHT, null);
                halfPen.dispose();
                pen.drawImage(
                        half,
                        i % COLUMNS * (WIDTH + GAP),
                        i / COLUMNS * (HEIGHT + GAP),
                        WIDTH,
                        HEIGHT,
                        null);
            }
            ImageIO.write(all, "png", sheet.toFile());
        } catch (IOException failure) {
            throw new UncheckedIOException(
                    "the contact sheet " + sheet + " was not saved: " + failure.getMessage(),
                    failure);
        } finally {
            pen.dispose();
        }
    }
}
