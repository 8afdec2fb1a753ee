package dev.cairn.samples.scenefile;

import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.decomposition.Decomposition;
import dev.cairn.render.mesh.Mesh;

import org.jspecify.annotations.Nullable;

/** Meshes that are drawn as surfaces that collide, and as solids. Stateless. */
public final class MeshParts {
    private MeshParts() {}

    /**
     * The triangles as they are drawn; corners at one place become one.
     *
     * @param mesh what is drawn
     * @param x factor along x
     * @param y factor along y
     * @param z factor along z
     * @return the surface
     * @throws IllegalArgumentException if it has no triangle with an area
     */
    public static TriangleMesh surface(Mesh mesh, double x, double y, double z) {
        double[] scale = {x, y, z};
        float[] drawn = mesh.vertices();
        double[] xyz = new double[3 * mesh.vertexCount()];
        for (int i = 0; i < xyz.length; i++) {
            xyz[i] = scale[i % 3] * drawn[i / 3 * Mesh.FLOATS_PER_VERTEX + i % 3];
        }
        return TriangleMesh.of(xyz, mesh.indices());
    }

    /**
     * Mass, centre and inertia of the solid that was decomposed.
     *
     * @param parts its parts
     * @param density kg/m³
     * @param kilograms the mass, or null for density times volume
     * @return null if the mesh is not closed, or inside out: then they are those of the parts
     */
    public static @Nullable MassProperties mass(
            Decomposition parts, double density, @Nullable Double kilograms) {
        try {
            MassProperties solid = parts.massProperties(density);
            return kilograms == null ? solid : solid.times(kilograms / solid.mass());
        } catch (IllegalArgumentException open) {
            return null;
        }
    }
}
