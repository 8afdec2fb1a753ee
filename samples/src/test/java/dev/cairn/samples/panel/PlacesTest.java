package dev.cairn.samples.panel;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** In a window of any size no panel leaves it, and none is too small to be used. */
class PlacesTest {
    private static final double LEAST = 120;

    @Test
    void whatIsBelowThePictureStaysInTheWindow() {
        for (double width = 320; width < 4000; width++) {
            double left = Places.belowLeft(width);
            double right = left + Places.belowWidth(width);
            assertTrue(left >= Places.GAP && right <= width - Places.GAP, "window of " + width);
            assertTrue(right - left >= LEAST, "window of " + width);
            boolean beside = left >= Places.GAP + Places.WIDTH + Places.GAP;
            assertTrue(beside == Places.hasBelow(width), "window of " + width);
        }
        assertTrue(!Places.hasBelow(320) && Places.hasBelow(640) && Places.hasBelow(1280));
    }

    @Test
    void bothPanelsOfAColumnHaveRoom() {
        for (double height = 180; height < 3000; height++) {
            double upper = Places.upperHeight(height);
            double lower = height - upper - Places.GAP;
            assertTrue(upper >= Math.min(height / 2, 420), "column of " + height);
            assertTrue(lower >= Math.min(height / 3, 140), "column of " + height);
        }
    }
}
