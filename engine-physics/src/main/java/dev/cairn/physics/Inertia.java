package dev.cairn.physics;

import dev.cairn.physics.shape.MassProperties;

/** The inverse of an inertia. */
final class Inertia {
    private Inertia() {}

    /**
     * The inverse's six entries xx, yy, zz, xy, xz, yz. The matrix is scaled by its trace first, so
     * that neither very small nor very large bodies leave the range of numbers.
     */
    static double[] inverse(MassProperties p) {
        double scale = p.ixx() + p.iyy() + p.izz();
        double xx = p.ixx() / scale;
        double yy = p.iyy() / scale;
        double zz = p.izz() / scale;
        double xy = p.ixy() / scale;
        double xz = p.ixz() / scale;
        double yz = p.iyz() / scale;
        double a = yy * zz - yz * yz;
        double b = xz * yz - xy * zz;
        double c = xy * yz - xz * yy;
        double determinant = xx * a + xy * b + xz * c;
        double f = 1 / (determinant * scale);
        double[] inverse = {
            a * f,
            (xx * zz - xz * xz) * f,
            (xx * yy - xy * xy) * f,
            b * f,
            c * f,
            (xy * xz - xx * yz) * f
        };
        for (double entry : inverse) {
            if (!(determinant > 0) || !Double.isFinite(entry)) {
                throw new IllegalArgumentException(
                        "inertia (xx "
                                + p.ixx()
                                + ", yy "
                                + p.iyy()
                                + ", zz "
                                + p.izz()
                                + ", xy "
                                + p.ixy()
                                + ", xz "
                                + p.ixz()
                                + ", yz "
                                + p.iyz()
                                + ") kg m² has no finite inverse; choose a less thin shape or"
                                + " another mass");
            }
        }
        return inverse;
    }
}
