package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.shape.mesh.TriangleSet;

/** Names of corners and edges that do not depend on the triangle that tells them. Stateless. */
final class TriangleFeatures {
    private TriangleFeatures() {}

    /** The name that a feature has in all triangles that share it. */
    static int shared(TriangleSet set, int t, int feature) {
        int kind = feature & FeatureIds.CLOSEST;
        if (kind == FeatureIds.VERTEX_A && (feature & 0x3FFFFFFF) < 3) {
            return set.vertex(t, feature & 0x3FFFFFFF);
        }
        int edge = feature >> 15 & 0x7FFF;
        if (kind != FeatureIds.CROSSING || edge > 2) {
            return feature;
        }
        int a = set.vertex(t, edge == 2 ? 1 : 0);
        int b = set.vertex(t, edge == 0 ? 1 : 2);
        long key = (long) Math.min(a, b) << 32 | Math.max(a, b);
        key = (key * 0x9E3779B97F4A7C15L ^ (feature & 0x7FFF)) * 0x9E3779B97F4A7C15L;
        return FeatureIds.CROSSING | (int) (key >>> 34);
    }
}
