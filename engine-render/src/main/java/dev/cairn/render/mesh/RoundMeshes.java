package dev.cairn.render.mesh;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/** Meshes of what is turned on a lathe about the y axis, and of the ground. Stateless. */
final class RoundMeshes {
    private RoundMeshes() {}

    /** A frustum from y = -1 with radius 1 to y = 1; a radius of 0 makes a cone. */
    static Mesh turned(String name, double upperRadius, int sectors) {
        MeshBuilder builder = new MeshBuilder();
        double slope = (1 - upperRadius) / 2;
        double length = Math.sqrt(1 + slope * slope);
        for (int i = 0; i <= sectors; i++) {
            double u = (double) i / sectors;
            double angle = 2 * Math.PI * u;
            double x = Math.sin(angle);
            double z = Math.cos(angle);
            double across = 1 / length;
            double up = slope / length;
            builder.vertex(x, -1, z, x * across, up, z * across, 4 * u, 0);
            builder.vertex(
                    upperRadius * x, 1, upperRadius * z, x * across, up, z * across, 4 * u, 1);
        }
        for (int i = 0; i < sectors; i++) {
            builder.triangle(2 * i, 2 * i + 2, 2 * i + 3);
            if (upperRadius > 0) {
                builder.triangle(2 * i, 2 * i + 3, 2 * i + 1);
            }
        }
        cap(builder, -1, 1, sectors);
        if (upperRadius > 0) {
            cap(builder, 1, upperRadius, sectors);
        }
        return builder.build(name, null);
    }

    private static void cap(MeshBuilder builder, int side, double radius, int sectors) {
        int centre = builder.vertex(0, side, 0, 0, side, 0, 0.5, 0.5);
        int first = builder.vertexCount();
        for (int i = 0; i <= sectors; i++) {
            double angle = 2 * Math.PI * i / sectors;
            double x = Math.sin(angle);
            double z = Math.cos(angle);
            builder.vertex(
                    radius * x, side, radius * z, 0, side, 0, 0.5 + 0.5 * x, 0.5 - 0.5 * side * z);
        }
        for (int i = 0; i < sectors; i++) {
            int a = first + i;
            if (side > 0) {
                builder.triangle(centre, a, a + 1);
            } else {
                builder.triangle(centre, a + 1, a);
            }
        }
    }

    static Mesh capsule(double radius, double halfLength) {
        int sectors = 48;
        int half = 12;
        MeshBuilder builder = new MeshBuilder();
        double around = radius * Math.PI + 2 * halfLength;
        for (int stack = 0; stack <= 2 * half + 1; stack++) {
            boolean upper = stack <= half;
            double polar = Math.PI * (upper ? stack : stack - 1) / (2 * half);
            double shift = upper ? halfLength : -halfLength;
            double v = (polar * radius + (upper ? 0 : 2 * halfLength)) / around;
            for (int sector = 0; sector <= sectors; sector++) {
                double u = (double) sector / sectors;
                double angle = 2 * Math.PI * u;
                double x = Math.sin(polar) * Math.sin(angle);
                double y = Math.cos(polar);
                double z = Math.sin(polar) * Math.cos(angle);
                builder.vertex(radius * x, radius * y + shift, radius * z, x, y, z, u, 1 - v);
            }
        }
        for (int stack = 0; stack <= 2 * half; stack++) {
            for (int sector = 0; sector < sectors; sector++) {
                int upper = stack * (sectors + 1) + sector;
                int lower = upper + sectors + 1;
                if (stack > 0) {
                    builder.triangle(upper, lower, upper + 1);
                }
                if (stack < 2 * half) {
                    builder.triangle(upper + 1, lower, lower + 1);
                }
            }
        }
        return builder.build("capsule", null);
    }

    /** A level square; texture coordinates are metres. */
    static Mesh ground(double half) {
        MeshBuilder builder = new MeshBuilder();
        int a = builder.vertex(-half, 0, half, 0, 1, 0, -half, -half);
        int b = builder.vertex(half, 0, half, 0, 1, 0, half, -half);
        int c = builder.vertex(half, 0, -half, 0, 1, 0, half, half);
        int d = builder.vertex(-half, 0, -half, 0, 1, 0, -half, half);
        builder.triangle(a, b, c);
        builder.triangle(a, c, d);
        return builder.build(
                "ground",
                new double[] {-half, 0, half, half, 0, half, half, 0, -half, -half, 0, -half});
    }

    /** The mesh with its x and z scaled by a radius and its y by a height; normals follow. */
    static Mesh scaled(Mesh mesh, double radius, double height) {
        float[] v = mesh.vertices();
        for (int i = 0; i < v.length; i += Mesh.FLOATS_PER_VERTEX) {
            v[i] = (float) (v[i] * radius);
            v[i + 1] = (float) (v[i + 1] * height);
            v[i + 2] = (float) (v[i + 2] * radius);
            Vector3d n =
                    new Vector3d(v[i + 3] / radius, v[i + 4] / height, v[i + 5] / radius)
                            .normalize();
            v[i + 3] = (float) n.x;
            v[i + 4] = (float) n.y;
            v[i + 5] = (float) n.z;
        }
        return Mesh.of(mesh.name(), v, mesh.indices());
    }

    static Mesh placed(Mesh mesh, Vector3d at, Quaterniond turn) {
        float[] v = mesh.vertices();
        Vector3d p = new Vector3d();
        for (int i = 0; i < v.length; i += Mesh.FLOATS_PER_VERTEX) {
            turn.transform(p.set(v[i], v[i + 1], v[i + 2])).add(at);
            v[i] = (float) p.x;
            v[i + 1] = (float) p.y;
            v[i + 2] = (float) p.z;
            turn.transform(p.set(v[i + 3], v[i + 4], v[i + 5]));
            v[i + 3] = (float) p.x;
            v[i + 4] = (float) p.y;
            v[i + 5] = (float) p.z;
        }
        return Mesh.of(mesh.name(), v, mesh.indices());
    }
}
