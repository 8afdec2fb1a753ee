package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/**
 * What the joints of plane mechanisms bear, against the closed form of inverse dynamics: a crank
 * turns at a constant rate, so all places, rates and accelerations follow from its angle, and the
 * forces from Newton's and Euler's laws, pin by pin.
 *
 * <p>Read-outs are means of a sub-step; the truth is that of its middle.
 */
final class MechanismReactionsTest {
    private static final double STEP = 1 / 60.0;
    private static final double SUBSTEP = STEP / 4;
    private static final double G = 9.81;
    private static final double BAR = 1e-4;
    private static final double SPEED = 4;

    private final Vector3d p = new Vector3d();

    /** A bar of the plane: its mass, inertia, length; its angle with two derivatives. */
    private static final class Rod {
        final BodyRef body;
        final double mass;
        final double inertia;
        final double length;
        double angle;
        double rate;
        double acceleration;

        Rod(PhysicsWorld world, double mass, double x0, double y0, double x1, double y1) {
            double dx = x1 - x0;
            double dy = y1 - y0;
            length = Math.sqrt(dx * dx + dy * dy);
            this.mass = mass;
            body =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.5 * length, 0.06, 0.04))
                                    .mass(mass)
                                    .at(0.5 * (x0 + x1), 0.5 * (y0 + y1), 0)
                                    .rotationAbout(0, 0, 1, StrictMath.atan2(dy, dx)));
            inertia = 1 / body.inverseInertia(new Matrix3d()).m22();
        }

        double cos() {
            return StrictMath.cos(angle);
        }

        double sin() {
            return StrictMath.sin(angle);
        }

        /** Acceleration of a point at {@code s} from the first pin, which has that of x and y. */
        double alongX(double x, double s) {
            return x - s * (acceleration * sin() + rate * rate * cos());
        }

        double alongY(double y, double s) {
            return y + s * (acceleration * cos() - rate * rate * sin());
        }
    }

    private static PhysicsWorld world() {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build();
        world.collisions().setPairFilter((a, b) -> false);
        return world;
    }

    private static BodyRef ground(PhysicsWorld world) {
        return world.add(Body.fixed().shape(Sphere.of(0.1)).at(0, 0, -3));
    }

    private static Joint hinge(BodyRef a, BodyRef b, double x, double y) {
        return Joint.hinge(a, b).at(x, y, 0).axis(0, 0, 1);
    }

    /** Largest difference of read-outs and truth, over the largest force, resp. torque. */
    private static final class Worst {
        double miss;
        double size;

        void see(double read, double truth) {
            miss = Math.max(miss, Math.abs(read - truth));
            size = Math.max(size, Math.abs(truth));
        }

        double relative() {
            return miss / size;
        }
    }

    private static void holds(String text, double value) {
        System.out.println(text + " " + value);
        assertTrue(value < BAR, () -> text + " " + value);
    }

    /** The slider is at {@code r cos a + l cos b}, {@code r sin a + l sin b = 0}. */
    @Test
    void sliderCrank() {
        double r = 0.5;
        double l = 1.5;
        double slides = 3;
        try (PhysicsWorld world = world()) {
            BodyRef base = ground(world);
            double x = Math.sqrt(l * l - r * r);
            Rod crank = new Rod(world, 1, 0, 0, 0, r);
            Rod rod = new Rod(world, 3, 0, r, x, 0);
            BodyRef slider =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.2, 0.15, 0.1))
                                    .mass(slides)
                                    .at(x, 0, 0));
            Joint driven = hinge(base, crank.body, 0, 0);
            JointRef motor = world.add(driven.motor(SPEED, Double.POSITIVE_INFINITY));
            JointRef pin = world.add(hinge(crank.body, rod.body, 0, r));
            JointRef wrist = world.add(hinge(rod.body, slider, x, 0));
            JointRef rail = world.add(Joint.slider(base, slider).at(x, 0, 0).axis(1, 0, 0));
            Worst place = new Worst();
            Worst force = new Worst();
            Worst torque = new Worst();
            for (int tick = 1; tick <= 240; tick++) {
                world.step(STEP);
                crank.body.position(p);
                double now = StrictMath.atan2(p.y, p.x);
                double sinNow = -r * StrictMath.sin(now) / l;
                double end = r * StrictMath.cos(now) + l * Math.sqrt(1 - sinNow * sinNow);
                place.see(slider.position(p).x, end);
                if (tick < 10) {
                    continue; // the first tick brings it to its speed
                }
                crank.angle = now - 0.5 * SUBSTEP * SPEED;
                crank.rate = SPEED;
                // r sin a + l sin b = 0 and its derivatives
                rod.angle = StrictMath.asin(-r * crank.sin() / l);
                rod.rate = -r * SPEED * crank.cos() / (l * rod.cos());
                double turn = r * SPEED * SPEED * crank.sin() + l * rod.rate * rod.rate * rod.sin();
                rod.acceleration = turn / (l * rod.cos());
                double pinX = crank.alongX(0, r);
                double pinY = crank.alongY(0, r);
                // slider: only the rod pushes it along; rod: Newton, and Euler about its centre
                double wristX = slides * rod.alongX(pinX, l);
                double forceX = rod.mass * rod.alongX(pinX, 0.5 * l) + wristX;
                double weighs = rod.mass * (rod.alongY(pinY, 0.5 * l) + G);
                // I b" = -l/2 e x (F + W), F of the pin, W on the slider, F_y = weighs + W_y
                double sum = rod.sin() * (forceX + wristX) - 2 * rod.inertia * rod.acceleration / l;
                double forceY = 0.5 * (sum / rod.cos() + weighs);
                double wristY = forceY - weighs;
                double baseX = crank.mass * crank.alongX(0, 0.5 * r) + forceX;
                double baseY = crank.mass * (crank.alongY(0, 0.5 * r) + G) + forceY;
                double drives =
                        0.5 * r * (crank.cos() * (baseY + forceY) - crank.sin() * (baseX + forceX));
                see(force, pin, forceX, forceY);
                see(force, wrist, wristX, wristY);
                see(force, motor, baseX, baseY);
                see(force, rail, 0, slides * G - wristY);
                torque.see(motor.torque(p).z, drives);
            }
            holds("slider-crank: place", place.relative());
            holds("slider-crank: reaction", force.relative());
            holds("slider-crank: torque", torque.relative());
        }
    }

    private void see(Worst worst, JointRef joint, double x, double y) {
        joint.force(p);
        worst.see(p.x, x);
        worst.see(p.y, y);
    }

    /**
     * {@code r u + l e = d + L f} with u, e, f along crank, coupler and rocker at angles a, b, c;
     * its derivatives dotted with e and f give the rates and accelerations of b and c.
     */
    @Test
    void fourBar() {
        double r = 0.5;
        double l = 1.8;
        double span = 2;
        double rocks = 1.2;
        double[] end = new double[2];
        try (PhysicsWorld world = world()) {
            BodyRef base = ground(world);
            meet(0, r, l, span, rocks, end);
            Rod crank = new Rod(world, 1, 0, 0, 0, r);
            Rod rod = new Rod(world, 3.6, 0, r, end[0], end[1]);
            Rod rocker = new Rod(world, 2.4, span, 0, end[0], end[1]);
            Joint driven = hinge(base, crank.body, 0, 0);
            JointRef motor = world.add(driven.motor(SPEED, Double.POSITIVE_INFINITY));
            JointRef pin = world.add(hinge(crank.body, rod.body, 0, r));
            JointRef wrist = world.add(hinge(rod.body, rocker.body, end[0], end[1]));
            JointRef foot = world.add(hinge(base, rocker.body, span, 0));
            Worst place = new Worst();
            Worst force = new Worst();
            Worst torque = new Worst();
            for (int tick = 1; tick <= 240; tick++) {
                world.step(STEP);
                crank.body.position(p);
                double now = StrictMath.atan2(p.y, p.x);
                meet(r * StrictMath.cos(now), r * StrictMath.sin(now), l, span, rocks, end);
                rocker.body.position(p);
                place.see(2 * p.x - span, end[0]);
                place.see(2 * p.y, end[1]);
                if (tick < 10) {
                    continue; // the first tick brings it to its speed
                }
                double a = now - 0.5 * SUBSTEP * SPEED;
                crank.angle = a;
                crank.rate = SPEED;
                meet(r * crank.cos(), r * crank.sin(), l, span, rocks, end);
                rod.angle = StrictMath.atan2(end[1] - r * crank.sin(), end[0] - r * crank.cos());
                rocker.angle = StrictMath.atan2(end[1], end[0] - span);
                double sin = StrictMath.sin(rocker.angle - rod.angle);
                double cos = StrictMath.cos(rocker.angle - rod.angle);
                rod.rate = -r * SPEED * StrictMath.sin(rocker.angle - a) / (l * sin);
                rocker.rate = -r * SPEED * StrictMath.sin(rod.angle - a) / (rocks * sin);
                double turns = r * SPEED * SPEED;
                double rods = l * rod.rate * rod.rate;
                double rockers = rocks * rocker.rate * rocker.rate;
                double b2 = turns * StrictMath.cos(a - rocker.angle) + rods * cos - rockers;
                double c2 = turns * StrictMath.cos(a - rod.angle) + rods - rockers * cos;
                rod.acceleration = b2 / (l * sin);
                rocker.acceleration = c2 / (rocks * sin);
                double pinX = crank.alongX(0, r);
                double pinY = crank.alongY(0, r);
                double needX = rod.mass * rod.alongX(pinX, 0.5 * l);
                double needY = rod.mass * (rod.alongY(pinY, 0.5 * l) + G);
                // Q on the rocker: e x Q = s by Euler for the coupler, f x Q = q for the rocker
                double s =
                        -rod.inertia * rod.acceleration / l
                                - 0.5 * (rod.cos() * needY - rod.sin() * needX);
                double about = rocker.inertia + 0.25 * rocker.mass * rocks * rocks;
                double q =
                        about * rocker.acceleration / rocks + 0.5 * rocker.mass * G * rocker.cos();
                double wristX = -(rod.cos() * q - rocker.cos() * s) / sin;
                double wristY = -(rod.sin() * q - rocker.sin() * s) / sin;
                double forceX = needX + wristX;
                double forceY = needY + wristY;
                double baseX = crank.mass * crank.alongX(0, 0.5 * r) + forceX;
                double baseY = crank.mass * (crank.alongY(0, 0.5 * r) + G) + forceY;
                double footX = rocker.mass * rocker.alongX(0, 0.5 * rocks) - wristX;
                double footY = rocker.mass * (rocker.alongY(0, 0.5 * rocks) + G) - wristY;
                see(force, pin, forceX, forceY);
                see(force, wrist, wristX, wristY);
                see(force, motor, baseX, baseY);
                see(force, foot, footX, footY);
                double drives =
                        0.5 * r * (crank.cos() * (baseY + forceY) - crank.sin() * (baseX + forceX));
                torque.see(motor.torque(p).z, drives);
            }
            holds("four-bar: place", place.relative());
            holds("four-bar: reaction", force.relative());
            holds("four-bar: torque", torque.relative());
        }
    }

    /** The upper point {@code l} from a point and {@code rocks} from {@code (span, 0)}. */
    private static void meet(
            double x, double y, double l, double span, double rocks, double[] into) {
        double dx = span - x;
        double dy = -y;
        double d = Math.sqrt(dx * dx + dy * dy);
        double along = (l * l - rocks * rocks + d * d) / (2 * d);
        double up = Math.sqrt(l * l - along * along);
        into[0] = x + (along * dx - up * dy) / d;
        into[1] = y + (along * dy + up * dx) / d;
    }
}
