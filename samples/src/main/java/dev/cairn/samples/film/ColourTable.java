package dev.cairn.samples.film;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The colours of an animation, at most {@value #MOST}, and which of them stands for a pixel. What
 * has no more colours keeps all of them; else colours that are alike are joined, and neighbouring
 * pixels round up and down in turns, so that a smooth sky shows no bands. What a pixel becomes
 * depends on its colour and its place alone: what stands still stays as it is. One thread.
 *
 * <p>Sources: P. Heckbert, Color image quantization for frame buffer display, 1982; boxes are
 * divided at the mean of the channel of greatest variance, as X. Wu, 1992. B. E. Bayer, An optimum
 * method for two-level rendition of continuous-tone pictures, 1973.
 */
final class ColourTable {
    /** One place of 256 is for what is transparent. */
    static final int MOST = 255;

    /** Bayer's order of the places of a square of 4 x 4 pixels. */
    private static final int[] ORDER = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

    private final int[] colours;

    /** By how much the places of a square differ at most before they are rounded, levels of 255. */
    private final double spread;

    private final Map<Integer, Integer> nearest = new HashMap<>();

    /**
     * Chooses the colours.
     *
     * @param frames pixels of each, 0xRRGGBB or 0xAARRGGBB; a pixel that stays counts once
     */
    ColourTable(List<int[]> frames) {
        Map<Integer, int[]> counts = new HashMap<>();
        int @Nullable [] before = null;
        for (int[] frame : frames) {
            for (int i = 0; i < frame.length; i++) {
                if (before == null || frame[i] != before[i]) {
                    counts.computeIfAbsent(frame[i] & 0xFFFFFF, none -> new int[1])[0]++;
                }
            }
            before = frame;
        }
        int[] seen = counts.keySet().stream().mapToInt(Integer::intValue).sorted().toArray();
        List<Box> boxes = new ArrayList<>();
        boxes.add(new Box(seen, counts));
        while (boxes.size() < MOST) {
            int worst = 0;
            for (int i = 1; i < boxes.size(); i++) {
                worst = boxes.get(i).error > boxes.get(worst).error ? i : worst;
            }
            Box widest = boxes.get(worst);
            if (widest.error == 0) {
                break;
            }
            boxes.set(worst, new Box(widest.half(false), counts));
            boxes.add(new Box(widest.half(true), counts));
        }
        colours = boxes.stream().mapToInt(box -> box.mean).toArray();
        double error = boxes.stream().mapToDouble(box -> box.error).sum();
        double pixels = boxes.stream().mapToDouble(box -> box.pixels).sum();
        // Twice the usual distance of a pixel from its colour in a channel reaches the next one.
        spread = 2 * Math.sqrt(error / pixels / 3);
    }

    /** Colours that are alike. */
    private static final class Box {
        private final int[] members;
        private final int mean;
        private final double pixels;

        /** Sum of the squares of the distances from the mean, levels of 255. */
        private final double error;

        private int shift;
        private double cut;

        private Box(int[] members, Map<Integer, int[]> counts) {
            this.members = members;
            double weight = 0;
            double[] sums = new double[3];
            double[] squares = new double[3];
            for (int rgb : members) {
                int[] count = counts.get(rgb);
                double n = count == null ? 0 : count[0];
                weight += n;
                for (int c = 0; c < 3; c++) {
                    double level = (rgb >> (8 * c)) & 255;
                    sums[c] += n * level;
                    squares[c] += n * level * level;
                }
            }
            pixels = weight;
            int rounded = 0;
            double all = 0;
            double most = -1;
            for (int c = 0; c < 3; c++) {
                double middle = sums[c] / weight;
                rounded |= (int) Math.rint(middle) << (8 * c);
                double own = squares[c] - sums[c] * middle;
                all += own;
                if (own > most) {
                    most = own;
                    shift = 8 * c;
                    cut = middle;
                }
            }
            mean = rounded;
            error = members.length == 1 ? 0 : all;
        }

        /** The members above the mean of the channel that varies most, or the others. */
        private int[] half(boolean upper) {
            return Arrays.stream(members)
                    .filter(rgb -> (rgb >> shift & 255) > cut == upper)
                    .toArray();
        }
    }

    /**
     * How many colours there are.
     *
     * @return 1 to {@value #MOST}
     */
    int size() {
        return colours.length;
    }

    /**
     * One of the colours.
     *
     * @param index from 0
     * @return 0xRRGGBB
     */
    int colour(int index) {
        return colours[index];
    }

    /**
     * Which colour stands for a pixel.
     *
     * @param rgb its colour; what is above 24 bits does not count
     * @param x its column
     * @param y its row
     * @return index of the colour
     */
    int index(int rgb, int x, int y) {
        double share = (ORDER[4 * (y & 3) + (x & 3)] + 0.5) / ORDER.length - 0.5;
        int moved = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
            int level = (int) Math.rint((rgb >> shift & 255) + spread * share);
            moved |= Math.clamp(level, 0, 255) << shift;
        }
        Integer known = nearest.get(moved);
        if (known == null) {
            known = search(moved);
            nearest.put(moved, known);
        }
        return known;
    }

    private int search(int rgb) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < colours.length; i++) {
            int distance = 0;
            for (int shift = 0; shift <= 16; shift += 8) {
                int off = (rgb >> shift & 255) - (colours[i] >> shift & 255);
                distance += off * off;
            }
            if (distance < least) {
                least = distance;
                best = i;
            }
        }
        return best;
    }
}
