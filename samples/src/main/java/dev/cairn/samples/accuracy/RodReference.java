package dev.cairn.samples.accuracy;

import org.joml.Vector3d;

/**
 * A rod and a ball in a plane that bounce without friction: both fly free between blows, and when
 * they touch is found by steps of a microsecond and halving. Shares no code with the engine.
 */
final class RodReference {
    private static final double HALF = 2;
    private static final double THICK = 0.02;
    private static final double RADIUS = 0.1;
    private static final double ROD = 10;
    private static final double BALL = 1;
    private static final double INERTIA = ROD * 4 * (HALF * HALF + THICK * THICK) / 12;
    private static final double STEP = 1e-6;

    /** Of the rod. */
    private double x, y, angle, vx, vy, w;

    /** Of the ball. */
    private double px, py, ux, uy;

    /** From rod to ball at the last look, and the rod's nearest point from its middle. */
    private double nx, ny, rx, ry;

    void begin(double spin, double ballX, double ballY) {
        x = y = angle = vx = vy = ux = uy = 0;
        w = spin;
        px = ballX;
        py = ballY;
    }

    void run(double seconds) {
        double t = 0;
        double before = gap(0);
        while (t < seconds) {
            double h = Math.min(STEP, seconds - t);
            double after = gap(h);
            if (!(before > 0 && after <= 0)) {
                move(h);
                t += h;
                before = after;
                continue;
            }
            double low = 0;
            double high = h;
            for (int k = 0; k < 60; k++) {
                double mid = (low + high) / 2;
                if (gap(mid) > 0) {
                    low = mid;
                } else {
                    high = mid;
                }
            }
            gap(high);
            move(high);
            t += high;
            strike();
            before = Double.MIN_VALUE;
        }
    }

    private void strike() {
        double lever = rx * ny - ry * nx;
        double v = nx * (ux - vx) + ny * (uy - vy) - lever * w;
        double j = -2 * v / (1 / BALL + 1 / ROD + lever * lever / INERTIA);
        vx -= j / ROD * nx;
        vy -= j / ROD * ny;
        w -= j * lever / INERTIA;
        ux += j / BALL * nx;
        uy += j / BALL * ny;
    }

    private double gap(double t) {
        double c = StrictMath.cos(angle + w * t);
        double s = StrictMath.sin(angle + w * t);
        double dx = px + ux * t - x - vx * t;
        double dy = py + uy * t - y - vy * t;
        double along = c * dx + s * dy;
        double across = c * dy - s * dx;
        double a = Math.max(-HALF, Math.min(along, HALF));
        double b = Math.max(-THICK, Math.min(across, THICK));
        double far = StrictMath.hypot(along - a, across - b);
        nx = (c * (along - a) - s * (across - b)) / far;
        ny = (s * (along - a) + c * (across - b)) / far;
        rx = c * a - s * b;
        ry = s * a + c * b;
        return far - RADIUS;
    }

    private void move(double t) {
        x += t * vx;
        y += t * vy;
        angle += t * w;
        px += t * ux;
        py += t * uy;
    }

    /** How far both are from it, as a share of the ball's speed. */
    double error(Vector3d ball, double spin) {
        double speed = StrictMath.hypot(ux, uy);
        double off = StrictMath.hypot(ball.x - ux, ball.y - uy) / speed;
        return Math.max(off, Math.abs(spin - w) * StrictMath.sqrt(INERTIA / BALL) / speed);
    }
}
