package dev.cairn.samples.fuzz;

import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Draws what levels stand on: a half-space, a slab, tiles, triangles, heights. The lowest place of
 * each is at y = 0; those of triangles and heights may be rough.
 */
final class Grounds {
    private static final int MOST_TILES = 12;

    private final Draws draws;
    private final double size;
    private final List<EntitySpec> entities = new ArrayList<>();

    /** Half the width of what holds, and the height of what is highest, m. */
    private double half;

    private double top;

    private Grounds(Draws draws, double size) {
        this.draws = draws;
        this.size = size;
        half = 40 * size;
    }

    /**
     * Draws a ground.
     *
     * @param draws the stream
     * @param size of the things on it, m
     */
    static Grounds draw(Draws draws, double size) {
        Grounds grounds = new Grounds(draws, size);
        switch (draws.random.nextInt(5)) {
            case 0 -> {
                grounds.add(new ShapeSpec.GroundShape(), Xyz.ZERO, Turn.NONE);
                grounds.half = Double.POSITIVE_INFINITY;
            }
            case 1 -> {
                Xyz extents = new Xyz(grounds.half, size, grounds.half);
                grounds.add(new ShapeSpec.BoxShape(extents), new Xyz(0, -size, 0), Turn.NONE);
            }
            case 2 -> grounds.tiles();
            case 3 -> grounds.triangles();
            default -> grounds.heights();
        }
        return grounds;
    }

    /** The bodies that it is of, without material. */
    List<EntitySpec> entities() {
        return Collections.unmodifiableList(entities);
    }

    /** Half the width within which it holds, m. */
    double half() {
        return half;
    }

    /** The height of its highest place, m. */
    double top() {
        return top;
    }

    private void add(ShapeSpec shape, Xyz at, Turn turn) {
        entities.add(EntitySpec.of("floor", BodyKind.FIXED, shape).at(at, turn));
    }

    /** Flush boxes, turned as a whole. */
    private void tiles() {
        double tile = size * draws.power(-0.3, 0.7);
        int n = (int) Math.min(MOST_TILES, half / tile);
        double degrees = 360 * draws.random.nextDouble();
        Turn turn = Turn.about(new Xyz(0, 1, 0), degrees);
        double cos = StrictMath.cos(StrictMath.toRadians(degrees));
        double sin = StrictMath.sin(StrictMath.toRadians(degrees));
        ShapeSpec box = new ShapeSpec.BoxShape(new Xyz(tile, 0.2 * tile, tile));
        for (int i = -n; i < n; i++) {
            for (int k = -n; k < n; k++) {
                double x = (2 * i + 1) * tile;
                double z = (2 * k + 1) * tile;
                add(box, new Xyz(cos * x + sin * z, -0.2 * tile, cos * z - sin * x), turn);
            }
        }
        half = 1.4 * n * tile; // the circle in the square of 2 n tile, whatever the turn
    }

    /** A grid of triangles whose corners are moved at random; rough for every second one. */
    private void triangles() {
        int n = 2 + draws.random.nextInt(20);
        double cell = 2 * half / n;
        double shake = 0.4 * draws.random.nextDouble() * cell;
        double rough = draws.random.nextBoolean() ? 0 : 0.2 * draws.random.nextDouble() * cell;
        List<Xyz> points = new ArrayList<>();
        for (int i = 0; i <= n; i++) {
            for (int k = 0; k <= n; k++) {
                boolean inner = i > 0 && i < n && k > 0 && k < n;
                double dx = inner ? shake * draws.signed() : 0;
                double dz = inner ? shake * draws.signed() : 0;
                double y = rough * draws.random.nextDouble();
                top = Math.max(top, y);
                points.add(new Xyz(-half + i * cell + dx, y, -half + k * cell + dz));
            }
        }
        List<Integer> triangles = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < n; k++) {
                int a = i * (n + 1) + k;
                int c = a + n + 1;
                triangles.addAll(List.of(a, a + 1, c + 1, a, c + 1, c));
            }
        }
        add(new ShapeSpec.SurfaceShape(points, triangles, false), Xyz.ZERO, Turn.NONE);
    }

    /** A grid of heights; rough for every second one. */
    private void heights() {
        int n = 3 + draws.random.nextInt(30);
        double step = 2 * half / (n - 1);
        double rough = draws.random.nextBoolean() ? 0 : 0.2 * draws.random.nextDouble() * step;
        List<Double> heights = new ArrayList<>();
        for (int i = 0; i < n * n; i++) {
            double y = rough * draws.random.nextDouble();
            top = Math.max(top, y);
            heights.add(y);
        }
        ShapeSpec field = new ShapeSpec.FieldShape(n, step, step, size, heights, List.of());
        add(field, new Xyz(-half, 0, -half), Turn.NONE);
    }
}
