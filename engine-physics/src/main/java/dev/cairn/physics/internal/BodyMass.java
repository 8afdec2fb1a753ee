package dev.cairn.physics.internal;

import dev.cairn.physics.shape.MassProperties;

import java.util.List;

/** Mass and inertia of a body, and their inverses. */
public final class BodyMass {
    private BodyMass() {}

    /**
     * Mass, centre and inertia: what the parts of a body sum up to, or what the user gave instead.
     *
     * @param shape what a message names
     * @param own mass, centre and inertia if the user gives none
     * @param isFixed whether it never moves
     * @param given what the user gave
     * @return with finite numbers and inverses, unless it is fixed
     */
    public static MassProperties of(
            Object shape, MassProperties own, boolean isFixed, MassOverride given) {
        MassProperties p = own;
        if (p.mass() == Double.POSITIVE_INFINITY) {
            if (given.hasCentre()) {
                throw new IllegalArgumentException(
                        shape
                                + " has no end and so no centre of mass, and is given one; give"
                                + " none, or take a large box");
            }
            if (!isFixed) {
                throw new IllegalArgumentException(
                        shape
                                + " has infinite mass, so it cannot move; make the body with"
                                + " Body.fixed()");
            }
            return new MassProperties(1, p.comX(), p.comY(), p.comZ(), 1, 1, 1, 0, 0, 0);
        }
        if (given.hasMass()) {
            double factor = given.kilograms() / p.mass();
            p =
                    new MassProperties(
                            given.kilograms(),
                            p.comX(),
                            p.comY(),
                            p.comZ(),
                            p.ixx() * factor,
                            p.iyy() * factor,
                            p.izz() * factor,
                            p.ixy() * factor,
                            p.ixz() * factor,
                            p.iyz() * factor);
        }
        if (given.hasInertia()) {
            p =
                    new MassProperties(
                            p.mass(),
                            p.comX(),
                            p.comY(),
                            p.comZ(),
                            given.xx(),
                            given.yy(),
                            given.zz(),
                            given.xy(),
                            given.xz(),
                            given.yz());
        }
        if (given.hasCentre()) {
            p =
                    new MassProperties(
                            p.mass(), given.x(), given.y(), given.z(), p.ixx(), p.iyy(), p.izz(),
                            p.ixy(), p.ixz(), p.iyz());
        }
        boolean usable =
                p.mass() > 0
                        && Double.isFinite(p.mass())
                        && Double.isFinite(1 / p.mass())
                        && p.ixx() > 0
                        && p.iyy() > 0
                        && p.izz() > 0
                        && Double.isFinite(p.ixx() + p.iyy() + p.izz());
        if (!isFixed && !usable) {
            throw new IllegalArgumentException(
                    "mass of "
                            + shape
                            + " is "
                            + p.mass()
                            + " kg with inertia ("
                            + p.ixx()
                            + ", "
                            + p.iyy()
                            + ", "
                            + p.izz()
                            + ") kg m²; these and their inverses must be finite and greater than 0:"
                            + " choose another size, density or mass");
        }
        return p;
    }

    /**
     * What several bodies rigidly joined are as one: with d from the common centre to that of a
     * part, I is the sum of I_i + m_i (d² 1 - d dᵀ) (Huygens and Steiner).
     *
     * @param parts each in the axes and from the origin of the body's frame
     * @return about the common centre; of infinite mass if a part is
     */
    public static MassProperties sum(List<MassProperties> parts) {
        double mass = 0;
        double x = 0;
        double y = 0;
        double z = 0;
        for (MassProperties p : parts) {
            if (p.mass() == Double.POSITIVE_INFINITY) {
                return new MassProperties(p.mass(), 0, 0, 0, 1, 1, 1, 0, 0, 0);
            }
            mass += p.mass();
            x += p.mass() * p.comX();
            y += p.mass() * p.comY();
            z += p.mass() * p.comZ();
        }
        x /= mass;
        y /= mass;
        z /= mass;
        double xx = 0;
        double yy = 0;
        double zz = 0;
        double xy = 0;
        double xz = 0;
        double yz = 0;
        for (MassProperties p : parts) {
            double dx = p.comX() - x;
            double dy = p.comY() - y;
            double dz = p.comZ() - z;
            xx += p.ixx() + p.mass() * (dy * dy + dz * dz);
            yy += p.iyy() + p.mass() * (dx * dx + dz * dz);
            zz += p.izz() + p.mass() * (dx * dx + dy * dy);
            xy += p.ixy() - p.mass() * dx * dy;
            xz += p.ixz() - p.mass() * dx * dz;
            yz += p.iyz() - p.mass() * dy * dz;
        }
        return new MassProperties(mass, x, y, z, xx, yy, zz, xy, xz, yz);
    }

    /**
     * The inverse's six entries xx, yy, zz, xy, xz, yz. The matrix is scaled by its trace first, so
     * that neither very small nor very large bodies leave the range of numbers.
     *
     * @return 1/(kg m²)
     */
    public static double[] inverseInertia(MassProperties p) {
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
