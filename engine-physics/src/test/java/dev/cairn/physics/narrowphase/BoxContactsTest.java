package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.box.BoxContacts;
import dev.cairn.physics.narrowphase.oracle.Scene;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.wide.BoxBatch;
import dev.cairn.physics.shape.Box;

import org.joml.Quaterniond;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * Batches of boxes against the single path, which brute force holds: the same word, names, normal
 * and points, bit for bit, over sequences of poses that hand the words on.
 */
class BoxContactsTest {
    private static final int TICKS = 6;

    enum Poses {
        RANDOM {
            @Override
            Scene first(SplittableRandom r) {
                return Scene.random(r, Scene.box(r), Scene.box(r));
            }
        },
        STACKED {
            @Override
            Scene first(SplittableRandom r) {
                return stacked(
                        r,
                        Box.cubeOfHalfExtent(.5),
                        Box.cubeOfHalfExtent(.5),
                        1e-4,
                        .5 * r.nextInt(3));
            }
        },
        OVERHANGING {
            @Override
            Scene first(SplittableRandom r) {
                Box a = Scene.box(r);
                Box b = Scene.box(r);
                double inner = Math.min(a.innerRadius(), b.innerRadius());
                return stacked(r, a, b, 1e-3 * inner, r.nextDouble());
            }
        },
        NEARLY_PARALLEL {
            @Override
            Scene first(SplittableRandom r) {
                Scene s = stacked(r, Scene.box(r), Scene.box(r), 0, .4 * r.nextDouble());
                double tilt = StrictMath.pow(10, -1 - 13 * r.nextDouble());
                s.qb.rotateX(tilt * Scene.gauss(r)).rotateZ(tilt * Scene.gauss(r));
                return s;
            }
        },
        TURNED {
            @Override
            Scene first(SplittableRandom r) {
                Scene s = stacked(r, Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5), 1e-3, 0);
                s.qb.rotateY(Math.PI / 4 * r.nextInt(3) + 1e-3 * Scene.gauss(r));
                return s;
            }
        },
        ON_A_LATTICE {
            @Override
            Scene first(SplittableRandom r) {
                Scene s = new Scene(Box.ofHalfExtents(.5, .5, 1), Box.ofHalfExtents(.5, .25, 1));
                s.at(r.nextInt(13) - 6, r.nextInt(13) - 6, r.nextInt(17) - 8).d.mul(.125);
                s.qb.rotateY(Math.PI / 2 * r.nextInt(4)).rotateX(Math.PI / 2 * r.nextInt(4));
                return s;
            }
        },
        CONCENTRIC {
            @Override
            Scene first(SplittableRandom r) {
                Scene s = Scene.random(r, Scene.box(r), Scene.box(r));
                s.d.mul(r.nextInt(2) * 1e-9);
                return s;
            }
        },
        OF_ANOTHER_SIZE {
            @Override
            Scene first(SplittableRandom r) {
                double half = Scene.logUniform(r, 1e-6, 1e6);
                return stacked(
                        r,
                        Box.cubeOfHalfExtent(half),
                        Box.ofHalfExtents(.5, .4, .3),
                        1e-7,
                        r.nextDouble());
            }
        },
        SCALED {
            @Override
            Scene first(SplittableRandom r) {
                double scale = StrictMath.scalb(1, 30 * (2 * r.nextInt(2) - 1));
                Box a = Box.ofHalfExtents(scale * (.1 + r.nextDouble()), scale, .7 * scale);
                return Scene.random(r, a, Box.ofHalfExtents(.3 * scale, .5 * scale, scale));
            }
        },
        /** Any face on any face, overlapping at a corner or along a side. */
        CORNER_TO_CORNER {
            @Override
            Scene first(SplittableRandom r) {
                Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.45));
                double half = Math.PI / 2;
                s.qb.rotateXYZ(half * r.nextInt(4), half * r.nextInt(4), half * r.nextInt(4));
                s.qb.rotateXYZ(1e-4 * Scene.gauss(r), 1e-4 * Scene.gauss(r), 1e-4 * Scene.gauss(r));
                int axis = r.nextInt(3);
                for (int k = 0; k < 3; k++) {
                    double sign = 2 * r.nextInt(2) - 1;
                    double beside = r.nextInt(4) == 0 ? .02 : .1 + .8 * r.nextDouble();
                    s.d.setComponent(k, sign * (k == axis ? .949 : beside));
                }
                return r.nextBoolean() ? s : s.swapped();
            }
        },
        /** Corners a little beyond a side, within what a point of the last tick may be. */
        NEARLY_FLUSH {
            @Override
            Scene first(SplittableRandom r) {
                Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5));
                double half = Math.PI / 2;
                s.qb.rotateXYZ(half * r.nextInt(4), half * r.nextInt(4), half * r.nextInt(4));
                int axis = r.nextInt(3);
                for (int k = 0; k < 3; k++) {
                    double beside = r.nextBoolean() ? Scene.logUniform(r, 1e-6, 2e-3) : .4;
                    double sign = 2 * r.nextInt(2) - 1;
                    s.d.setComponent(k, sign * (k == axis ? .999 : beside));
                }
                return r.nextBoolean() ? s : s.swapped();
            }
        },
        /** Beside the face by nearly all of its width, tilted: faces and edges take turns. */
        ON_THE_BRINK {
            @Override
            Scene first(SplittableRandom r) {
                Scene s = new Scene(Box.cubeOfHalfExtent(.5), Box.cubeOfHalfExtent(.5));
                double beside = .9 + .1 * r.nextDouble();
                s.at(beside, .99 - .1 * r.nextDouble(), .3 * Scene.gauss(r));
                s.qb.rotateXYZ(.05 * Scene.gauss(r), .2 * Scene.gauss(r), .05 * Scene.gauss(r));
                return r.nextBoolean() ? s : s.swapped();
            }

            @Override
            double sway(SplittableRandom r) {
                return .05 * r.nextDouble();
            }
        },
        FLAT {
            @Override
            Scene first(SplittableRandom r) {
                double thin = Scene.logUniform(r, 1e-7, .1);
                return Scene.random(
                        r, Box.ofHalfExtents(1, thin, 1), Box.ofHalfExtents(.1, .5, thin));
            }
        };

        abstract Scene first(SplittableRandom r);

        /** Of the inner radius and of a radian, in a tick. */
        double sway(SplittableRandom r) {
            return StrictMath.pow(10, -8 + 7 * r.nextDouble());
        }

        /** B rests on A's upper face, beside its middle by a share of the extents, both turned. */
        static Scene stacked(SplittableRandom r, Box a, Box b, double depth, double beside) {
            Scene s = new Scene(a, b);
            double x = beside * (a.halfX() + b.halfX()) * (2 * r.nextInt(2) - 1);
            s.at(x, a.halfY() + b.halfY() - depth, beside * .1 * Scene.gauss(r));
            s.qb.rotateY(r.nextInt(2) * 1e-3 * Scene.gauss(r));
            if (r.nextInt(2) == 0) {
                Quaterniond turn = Scene.turn(r);
                turn.transform(s.d);
                s.qa.premul(turn);
                s.qb.premul(turn);
            }
            return r.nextBoolean() ? s : s.swapped();
        }
    }

    private static double inner(Scene s) {
        return Math.min(s.a.innerRadius(), s.b.innerRadius());
    }

    private static void sway(Scene s, SplittableRandom r, double share) {
        double step = share * inner(s);
        s.d.add(step * Scene.gauss(r), step * Scene.gauss(r), step * Scene.gauss(r));
        s.qb.rotateXYZ(share * Scene.gauss(r), share * Scene.gauss(r), share * Scene.gauss(r));
    }

    private static void put(BoxContacts batch, int i, Scene s, double margin, long word) {
        batch.put(
                i, (Box) s.a, (Box) s.b, s.qa.x, s.qa.y, s.qa.z, s.qa.w, s.qb.x, s.qb.y, s.qb.z,
                s.qb.w, s.d.x, s.d.y, s.d.z, inner(s), margin, word);
    }

    private static void same(Manifold expected, Manifold actual, String where) {
        assertArrayEquals(names(expected), names(actual), where);
        for (int p = 0; p < expected.pointCount; p++) {
            assertEquals(expected.separation[p], actual.separation[p], 0.0, where);
            assertEquals(expected.pointX[p], actual.pointX[p], 0.0, where);
            assertEquals(expected.pointY[p], actual.pointY[p], 0.0, where);
            assertEquals(expected.pointZ[p], actual.pointZ[p], 0.0, where);
        }
        if (expected.pointCount > 0) {
            assertEquals(expected.normalX, actual.normalX, 0.0, where);
            assertEquals(expected.normalY, actual.normalY, 0.0, where);
            assertEquals(expected.normalZ, actual.normalZ, 0.0, where);
            assertTrue(actual.bound >= .99 * expected.bound, where);
        }
    }

    private static int[] names(Manifold m) {
        return Arrays.copyOf(m.feature, m.pointCount);
    }

    @ParameterizedTest
    @EnumSource
    void aBatchGivesTheBitsOfTheSinglePath(Poses poses) {
        SplittableRandom r = new SplittableRandom(71);
        NarrowPhase single = new NarrowPhase();
        BoxContacts batch = new BoxContacts(new NarrowPhase());
        Manifold expected = new Manifold();
        Manifold actual = new Manifold();
        Scene[] scenes = new Scene[BoxBatch.CAPACITY];
        long[] words = new long[scenes.length];
        int touching = 0;
        for (int round = 0; round < 30; round++) {
            int count = 1 + r.nextInt(scenes.length);
            double share = poses.sway(r);
            Arrays.fill(words, 0);
            for (int i = 0; i < count; i++) {
                scenes[i] = poses.first(r);
            }
            for (int tick = 0; tick < TICKS; tick++) {
                for (int i = 0; i < count; i++) {
                    put(batch, i, scenes[i], .02 * inner(scenes[i]), words[i]);
                }
                batch.useLanes(round % 3 > 0);
                batch.run(count);
                for (int i = 0; i < count; i++) {
                    Scene s = scenes[i];
                    String where = "seed 71 round " + round + " tick " + tick + " pair " + i;
                    double margin = .02 * inner(s);
                    long word = s.collide(single, margin, words[i], expected);
                    long got = batch.take(i, (Box) s.a, (Box) s.b, actual);
                    same(expected, actual, where);
                    assertEquals(word, got, where);
                    touching += expected.pointCount > 0 ? 1 : 0;
                    words[i] = word;
                    sway(s, r, share);
                }
            }
        }
        assertTrue(touching > 500, poses + ": " + touching + " contacts");
    }
}
