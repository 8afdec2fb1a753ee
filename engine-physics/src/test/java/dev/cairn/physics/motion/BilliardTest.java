package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.HashMap;
import java.util.Map;
import java.util.Random;

/** Two balls that meet off centre, anywhere within a tick, against the closed form. */
class BilliardTest {
    private static final long SEED = 20261122;
    private static final double TICK = 1.0 / 60;

    private static Vector3d direction(Random random) {
        return new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                .normalize();
    }

    /** Without friction no contact sees a spin: bounces are those of balls that do not turn. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1, 30, 300})
    void aSpinTakesNoBounceAway(double spin) {
        Random random = new Random(SEED);
        for (int n = 0; n < 100; n++) {
            double aside = 0.057 * (2 * random.nextDouble() - 1);
            double speed = 1 + 9 * random.nextDouble();
            double gravity = n % 2 == 0 ? 0 : 9.81;
            Vector3d axis = direction(random);
            Vector3d without = struck(gravity, aside, speed, new Vector3d());
            Vector3d with = struck(gravity, aside, speed, axis.mul(spin));
            assertEquals(0, without.distance(with), 1e-9 * speed, "hit " + n + ", m/s");
        }
    }

    /** Velocity of a ball at rest after another one has hit it. */
    private static Vector3d struck(double gravity, double aside, double speed, Vector3d spin) {
        Material surface = new Material(0, 0.95, 1000);
        try (PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -gravity, 0).sleeping(false).build()) {
            world.add(
                    Body.fixed()
                            .shape(HalfSpace.of())
                            .material(Material.DEFAULT.withFriction(0).withRestitution(0)));
            world.add(
                    Body.dynamic()
                            .shape(Sphere.of(0.03))
                            .material(surface)
                            .at(0, 0.03, 0)
                            .velocity(speed, 0, 0)
                            .angularVelocity(spin.x, spin.y, spin.z));
            BodyRef other =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.03))
                                    .material(surface)
                                    .at(0.3, 0.03, aside));
            for (int tick = 0; tick < 40; tick++) {
                world.step(TICK);
            }
            return other.velocity();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 9.81})
    void impulsesRunAlongTheLineOfCentresAtTheImpact(double gravity) {
        System.out.println("seed " + SEED);
        Random random = new Random(SEED);
        for (int n = 0; n < 200; n++) {
            double ra = 0.1 + 0.2 * random.nextDouble();
            double rb = 0.1 + 0.2 * random.nextDouble();
            double ma = 1 + 4 * random.nextDouble();
            double mb = 1 + 4 * random.nextDouble();
            double e = 0.3 + 0.7 * random.nextDouble();
            Vector3d heading = direction(random);
            double speed = 1 + 30 * random.nextDouble();
            double apart = (ra + rb) * (1.5 + random.nextDouble());
            // impact parameter up to 1.1 of the radii: one in ten passes by
            Vector3d aside = direction(random).cross(heading).normalize();
            double miss = 1.1 * random.nextDouble() * (ra + rb);
            Vector3d start = new Vector3d(heading).mul(-apart).fma(miss, aside);
            Vector3d drift = direction(random).mul(random.nextDouble());
            Material surface = new Material(0, e, 1000);
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .gravity(0, -gravity, 0)
                            .settings(PhysicsSettings.DEFAULT.withRestitutionThreshold(0))
                            .sleeping(false)
                            .build()) {
                Vector3d va = new Vector3d(heading).mul(speed).add(drift);
                BodyRef a =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(ra))
                                        .mass(ma)
                                        .material(surface)
                                        .at(start.x, start.y, start.z)
                                        .velocity(va.x, va.y, va.z));
                BodyRef b =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(rb))
                                        .mass(mb)
                                        .material(surface)
                                        .at(0, 0, 0)
                                        .velocity(drift.x, drift.y, drift.z));
                int ticks = 1 + (int) Math.ceil((apart + ra + rb) / speed / TICK);
                for (int tick = 0; tick < ticks; tick++) {
                    world.step(TICK);
                }
                Vector3d da = new Vector3d();
                Vector3d db = new Vector3d();
                double far = ra + rb;
                if (miss < far) {
                    // from A to B when they meet: along the heading sqrt(R² - miss²), aside -miss
                    Vector3d line =
                            new Vector3d(heading)
                                    .mul(Math.sqrt(far * far - miss * miss))
                                    .fma(-miss, aside)
                                    .div(far);
                    double closing = speed * line.dot(heading);
                    double impulse = (1 + e) * closing / (1 / ma + 1 / mb);
                    da.fma(-impulse / ma, line);
                    db.fma(impulse / mb, line);
                }
                double fall = gravity * ticks * TICK;
                Vector3d truthA = new Vector3d(va).add(da).sub(0, fall, 0);
                Vector3d truthB = new Vector3d(drift).add(db).sub(0, fall, 0);
                String what = n + ": miss " + miss / far + ", speed " + speed;
                assertEquals(0, a.velocity().distance(truthA), 1e-12 * speed + 1e-12 * fall, what);
                assertEquals(0, b.velocity().distance(truthB), 1e-12 * speed + 1e-12 * fall, what);
            }
        }
    }

    /** A crowd, where pairs meet several times in a tick, along other lines each time. */
    @Test
    void reportsAddUpWhereBallsMeetAgain() {
        System.out.println("seed " + SEED);
        Random random = new Random(SEED);
        Material surface = new Material(0, 1, 1000);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, 0, 0)
                        .settings(PhysicsSettings.DEFAULT.withRestitutionThreshold(0))
                        .sleeping(false)
                        .build()) {
            BodyRef[] balls = new BodyRef[125];
            for (int i = 0; i < balls.length; i++) {
                double x = 0.405 * (i % 5) + 0.01 * random.nextDouble();
                double y = 0.405 * (i / 5 % 5) + 0.01 * random.nextDouble();
                double z = 0.405 * (i / 25) + 0.01 * random.nextDouble();
                Vector3d v = direction(random).mul(10 * random.nextDouble());
                balls[i] =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.2))
                                        .mass(1 + i % 3)
                                        .material(surface)
                                        .at(x, y, z)
                                        .velocity(v.x, v.y, v.z));
            }
            Kinetics start = world.kinetics();
            Vector3d[] expected = new Vector3d[balls.length];
            Vector3d n = new Vector3d();
            for (int tick = 0; tick < 6; tick++) {
                Map<BodyRef, Vector3d> impulse = new HashMap<>();
                for (int i = 0; i < balls.length; i++) {
                    expected[i] = balls[i].velocity();
                    impulse.put(balls[i], new Vector3d());
                }
                world.step(TICK);
                Contacts contacts = world.contacts();
                for (int c = 0; c < contacts.count(); c++) {
                    contacts.normal(c, n);
                    assertEquals(1, n.length(), 1e-15);
                    double l = contacts.normalImpulse(c, 0);
                    impulse.get(contacts.bodyA(c)).fma(-l, n);
                    impulse.get(contacts.bodyB(c)).fma(l, n);
                }
                for (int i = 0; i < balls.length; i++) {
                    expected[i].fma(1 / balls[i].mass(), impulse.get(balls[i]));
                    double off = balls[i].velocity().distance(expected[i]);
                    assertEquals(0, off, 1e-12, "ball " + i + ", tick " + tick);
                }
            }
            Kinetics end = world.kinetics();
            assertEquals(start.angularMomentumX(), end.angularMomentumX(), 1e-11);
            assertEquals(start.angularMomentumY(), end.angularMomentumY(), 1e-11);
            assertEquals(start.angularMomentumZ(), end.angularMomentumZ(), 1e-11);
        }
    }
}
