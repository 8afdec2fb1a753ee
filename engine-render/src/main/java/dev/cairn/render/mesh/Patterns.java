package dev.cairn.render.mesh;

/** Textures made by arithmetic. All are light, since the model's colour is multiplied in. */
final class Patterns {
    static final Texture GRID = grid(256).finish(0.9, 0);
    static final Texture PANEL = panel(128).finish(0.45, 0);
    static final Texture BEACH_BALL = beachBall(256, 128).finish(0.3, 0);
    static final Texture MISSING = missing(64);
    static final Texture METAL = Texture.WHITE.finish(0.25, 1);

    static final Texture GLASS = Texture.WHITE.finish(0.1, 0).opacity(0.16);

    private Patterns() {}

    private static Texture grid(int size) {
        int[] argb = new int[size * size];
        int square = size / 2;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                int shade = ((x / square) + (y / square)) % 2 == 0 ? 0xE8 : 0xD4;
                int edgeX = Math.min(x % square, square - 1 - x % square);
                int edgeY = Math.min(y % square, square - 1 - y % square);
                if (Math.min(edgeX, edgeY) < 1) {
                    shade = 0xB0;
                }
                argb[y * size + x] = grey(shade);
            }
        }
        return Texture.of("grid", size, size, argb);
    }

    private static Texture panel(int size) {
        int[] argb = new int[size * size];
        double rim = size / 14.0;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                double edge = Math.min(Math.min(x, size - 1 - x), Math.min(y, size - 1 - y));
                double inside = Math.clamp((edge - 0.35 * rim) / (0.65 * rim), 0.0, 1.0);
                double smooth = inside * inside * (3 - 2 * inside);
                argb[y * size + x] = grey((int) Math.round(0xB4 + (0xFA - 0xB4) * smooth));
            }
        }
        return Texture.of("panel", size, size, argb);
    }

    private static Texture missing(int size) {
        int[] argb = new int[size * size];
        int square = size / 4;
        for (int i = 0; i < argb.length; i++) {
            boolean even = (i % size / square + i / size / square) % 2 == 0;
            argb[i] = even ? 0xFFFF00FF : 0xFF000000;
        }
        return Texture.of("missing", size, size, argb);
    }

    private static Texture beachBall(int width, int height) {
        int[] argb = new int[width * height];
        int sector = width / 8;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                boolean band = Math.abs(2 * y + 1 - height) < height / 16;
                int shade = band ? 0x8C : (x / sector) % 2 == 0 ? 0xFF : 0xC4;
                argb[y * width + x] = grey(shade);
            }
        }
        return Texture.of("beach ball", width, height, argb);
    }

    private static int grey(int shade) {
        return 0xFF000000 | shade << 16 | shade << 8 | shade;
    }
}
