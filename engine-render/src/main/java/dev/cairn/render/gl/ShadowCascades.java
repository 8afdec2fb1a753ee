package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * One map of shadows around all small models, or around the part of them near the view where they
 * are spread wide; with cascades a wider one, and up to two finer ones in it, nearer to the eye
 * (Engel, "Cascaded shadow maps", 2006). GL thread.
 */
final class ShadowCascades implements AutoCloseable {
    /** How many maps there are at most. */
    static final int MOST = 3;

    /**
     * Models with a greater radius do not make the region larger (floors, walls); they cast and
     * receive all the same.
     */
    static final double CASTER_LIMIT = 20;

    private static final double MAX_RADIUS = 60;
    private static final double MAX_WIDE_RADIUS = 240;

    /** Half widths of the finer maps, m; left out where the widest is not much wider. */
    private static final double[] FINER = {10, 45};

    /** How far ahead of the eye the middle of a finer map is, by its half width. */
    private static final double AHEAD = 0.75;

    /** A finer map is drawn if the widest is this much wider. */
    private static final double WORTH = 1.6;

    private final Instances instances;
    private final int size;
    private final @Nullable ShadowMap[] maps = new ShadowMap[MOST];
    private final Vector3d centre = new Vector3d();
    private final Vector3d finer = new Vector3d();
    private int count;

    /**
     * No maps yet.
     *
     * @param size texels a side of each
     * @param instances what casts
     */
    ShadowCascades(int size, Instances instances) {
        this.size = size;
        this.instances = instances;
    }

    int size() {
        return size;
    }

    /**
     * Draws the maps.
     *
     * @param alpha interpolation
     * @param sun unit direction to the sun
     * @param eye camera, anchored
     * @param forward unit view direction
     * @param several whether there may be more than one
     */
    void draw(double alpha, Vector3d sun, Vector3d eye, Vector3d forward, boolean several) {
        double limit = several ? MAX_WIDE_RADIUS : MAX_RADIUS;
        Vector3d min = instances.castersMin();
        Vector3d max = instances.castersMax();
        centre.set(forward).mul(limit / 2).add(eye);
        double radius = limit / 2;
        if (min.x <= max.x) {
            double diagonal = 0.5 * min.distance(max);
            if (diagonal <= limit) {
                centre.set(min).add(max).mul(0.5);
            } else {
                centre.max(min).min(max);
            }
            radius = Math.min(diagonal, limit);
        }
        count = 0;
        for (double each : FINER) {
            if (several && radius > WORTH * each) {
                finer.set(forward).mul(AHEAD * each).add(eye);
                next().draw(alpha, sun, finer, each);
            }
        }
        next().draw(alpha, sun, centre, radius);
    }

    private ShadowMap next() {
        ShadowMap map = maps[count];
        if (map == null) {
            glActiveTexture(GL_TEXTURE0 + unit(count));
            map = new ShadowMap(size, instances);
            maps[count] = map;
        }
        count++;
        return map;
    }

    /** The texture unit of a map. */
    static int unit(int map) {
        return map == 0 ? 1 : SceneUniforms.MORE_SHADOWS + map - 1;
    }

    /** The texture unit of a map as numbers. */
    static int numbersUnit(int map) {
        return map == 0 ? SceneUniforms.SHADOW_NUMBERS : SceneUniforms.MORE_NUMBERS + map - 1;
    }

    /** A map that was drawn, the finest first; null beyond the last. */
    @Nullable ShadowMap map(int index) {
        return index < count ? maps[index] : null;
    }

    @Override
    public void close() {
        for (ShadowMap map : maps) {
            if (map != null) {
                map.close();
            }
        }
    }
}
