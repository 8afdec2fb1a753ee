package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.SplittableRandom;

/**
 * Discs that roll on their rim without slip, on planes of any direction with gravity along the
 * normal: they go round as Euler's disc does, and keep their energy.
 */
class RimTest {
    private static final double G = 9.81;
    private static final Material ROUGH = new Material(1, 0, 1000);

    /** Of a flat disc with its centre at rest: W² sin(tilt) = 4 g/a. */
    @ParameterizedTest
    @CsvSource({"0.1,60", "0.05,60", "0.02,60", "0.3,60", "0.1,480", "0.02,480"})
    void discGoesRoundAsEulersDoes(double tilt, int ticks) {
        double a = 0.0381;
        double half = 1e-5;
        double rate = StrictMath.sqrt(4 * G / (a * StrictMath.sin(tilt)));
        for (int seed = 1; seed <= 4; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            Quaterniond frame = seed == 1 ? new Quaterniond() : Scenes.turn(random);
            Vector3d up = frame.transform(new Vector3d(0, 1, 0));
            int sense = seed % 2 == 0 ? 1 : -1;
            try (PhysicsWorld world =
                    Scenes.awake().workers(1).gravity(-G * up.x, -G * up.y, -G * up.z).build()) {
                world.add(Body.fixed().shape(HalfSpace.of()).rotation(frame).material(ROUGH));
                // w lies along the line from the centre to the deepest point
                Vector3d w =
                        new Vector3d(StrictMath.cos(tilt), -StrictMath.sin(tilt), 0)
                                .mul(sense * rate * StrictMath.sin(tilt));
                frame.transform(w);
                double height = a * StrictMath.sin(tilt) + half * StrictMath.cos(tilt);
                BodyRef disc =
                        world.add(
                                Body.dynamic()
                                        .shape(Cylinder.of(a, half))
                                        .mass(0.4)
                                        .at(height * up.x, height * up.y, height * up.z)
                                        .rotation(new Quaterniond(frame).rotateZ(-tilt))
                                        .angularVelocity(w.x, w.y, w.z)
                                        .material(ROUGH));
                double energy = 0;
                double turned = 0;
                double last = 0;
                Vector3d axis = new Vector3d();
                for (int n = 1; n <= ticks / 2; n++) {
                    world.step(1.0 / ticks);
                    disc.orientation().transform(0, 1, 0, axis);
                    new Quaterniond(frame).conjugate().transform(axis);
                    double now = StrictMath.atan2(axis.z, axis.x);
                    double ahead = now - last - sense * rate / ticks;
                    turned += ahead - 2 * Math.PI * StrictMath.rint(ahead / (2 * Math.PI));
                    last = now;
                    double e = world.kineticEnergy() + 0.4 * G * disc.position().dot(up);
                    energy = n == 1 ? e : energy;
                    String where = "energy, seed " + seed + ", tick " + n;
                    assertTrue(e < energy * (1 + 1e-9), where + " rose by " + (e / energy - 1));
                    assertEquals(1, e / energy, 1e-7, where);
                }
                double share = turned / (rate / 2);
                assertTrue(Math.abs(share) < 1e-3, "seed " + seed + ": off by " + share);
            }
        }
    }
}
