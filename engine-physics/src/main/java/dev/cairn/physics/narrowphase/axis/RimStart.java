package dev.cairn.physics.narrowphase.axis;

/**
 * Where Newton starts near the axis of a rim, where the separation bends so sharply that from
 * anywhere else it would not arrive: in closed form, as if the sphere of axes were flat there.
 */
final class RimStart {
    /** Nearly a unit vector. */
    double x, y, z;

    /**
     * The best axis on the circle of a line: with h the angle that the circle passes the rim's axis
     * by, t the way from there along the circle, and g the slope but for the rim,
     *
     * <pre>
     *   s = g t - R sqrt(t t + h h)
     * </pre>
     *
     * <p>is best where t = h g / sqrt(R R - g g).
     *
     * @param way 1 or -1: the sense of the rim's axis
     * @param sign 1 when the line is A's, -1 when it is B's
     * @return false when it is best far away
     */
    boolean onCircle(
            CandidateFeatures own,
            int line,
            CandidateFeatures other,
            int rim,
            double way,
            double sign) {
        double ax = own.lineX[line];
        double ay = own.lineY[line];
        double az = own.lineZ[line];
        double dx = way * other.ax;
        double dy = way * other.ay;
        double dz = way * other.az;
        double level = own.level[line];
        double dot = dx * ax + dy * ay + dz * az;
        double mx = dx - dot * ax;
        double my = dy - dot * ay;
        double mz = dz - dot * az;
        double f = Math.sqrt((1 - level * level) / (mx * mx + my * my + mz * mz));
        mx *= f;
        my *= f;
        mz *= f;
        double tx = ay * mz - az * my;
        double ty = az * mx - ax * mz;
        double tz = ax * my - ay * mx;
        double length = Math.sqrt(tx * tx + ty * ty + tz * tz);
        x = level * ax + mx;
        y = level * ay + my;
        z = level * az + mz;
        double h = Math.sqrt((x - dx) * (x - dx) + (y - dy) * (y - dy) + (z - dz) * (z - dz));
        double cx = other.px[rim] - own.px[line];
        double cy = other.py[rim] - own.py[line];
        double cz = other.pz[rim] - own.pz[line];
        double g = sign * (tx * cx + ty * cy + tz * cz) / length;
        double radius = other.radius[rim];
        double square = (radius - g) * (radius + g);
        if (!(square > 0)) {
            return false;
        }
        double t = h * g / Math.sqrt(square) / length;
        x += t * tx;
        y += t * ty;
        z += t * tz;
        return true;
    }

    /**
     * The best axis between two rims whose axes a and b differ by little: with o the part of c,
     * from the one centre to the other, across a, and u = n - a, v = n - b,
     *
     * <pre>
     *   s = s(a) + o . u - RA |u| - RB |v|,
     * </pre>
     *
     * <p>so at the best n the radii of the rims to the point where they cross, RA u / |u| and RB v
     * / |v|, add up to o. That makes a triangle of which all sides are known, on either side of o;
     * n is where the ray from a along the one radius meets that from b along the other.
     *
     * @return false when the rims do not cross, or their rays do not meet
     */
    boolean ofRims(
            CandidateFeatures sideA,
            int i,
            double wayA,
            CandidateFeatures sideB,
            int j,
            double wayB,
            double cx,
            double cy,
            double cz) {
        double ax = wayA * sideA.ax;
        double ay = wayA * sideA.ay;
        double az = wayA * sideA.az;
        double bx = wayB * sideB.ax - ax;
        double by = wayB * sideB.ay - ay;
        double bz = wayB * sideB.az - az;
        double along = cx * ax + cy * ay + cz * az;
        double ox = cx - along * ax;
        double oy = cy - along * ay;
        double oz = cz - along * az;
        double wx = ay * oz - az * oy;
        double wy = az * ox - ax * oz;
        double wz = ax * oy - ay * ox;
        double square = ox * ox + oy * oy + oz * oz;
        double ra = sideA.radius[i];
        double rb = sideB.radius[j];
        // RA u / |u| = k o + side m w, and w is o turned by a right angle.
        double k = 0.5 + 0.5 * (ra - rb) * (ra + rb) / square;
        double height = ra * ra / square - k * k;
        if (!(height > 0)) {
            return false;
        }
        double m = Math.sqrt(height);
        double turned = -(bx * wx + by * wy + bz * wz);
        double straight = m * (bx * ox + by * oy + bz * oz);
        double side;
        if ((1 - k) * turned < straight && k * turned < -straight) {
            side = 1;
        } else if ((1 - k) * turned > -straight && k * turned > straight) {
            side = -1;
        } else {
            return false;
        }
        double far = (straight - side * (1 - k) * turned) / (m * square);
        x = ax + far * (k * ox + side * m * wx);
        y = ay + far * (k * oy + side * m * wy);
        z = az + far * (k * oz + side * m * wz);
        double length = Math.sqrt(x * x + y * y + z * z);
        x /= length;
        y /= length;
        z /= length;
        return true;
    }
}
