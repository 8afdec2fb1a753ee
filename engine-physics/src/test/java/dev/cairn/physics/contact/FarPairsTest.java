package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.PairFilter;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.tuning.Tuning;

import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * A pair that the boxes around its colliders tell to be far is further apart than its margin: by
 * the true distance, in any pose, moving and turning, near the origin and far from it.
 */
class FarPairsTest {
    private static final int SEED = 20261125;
    private static final int PAIRS = 20_000;
    private static final double STEP = 1 / 60.0;

    private final BodyStore bodies = new BodyStore();
    private final ColliderStore colliders = new ColliderStore(bodies);
    private final BroadPhase broadPhase = new BroadPhase(new PairFilter(colliders));
    private final BoundsStage bounds = new BoundsStage(colliders, Tuning.DEFAULT);
    private final Placement one = new Placement();
    private final Placement other = new Placement();

    private static Shape shape(SplittableRandom r) {
        double size = Math.pow(10, r.nextDouble(-2, 2));
        double slender = Math.pow(10, r.nextDouble(-2, 0));
        return switch (r.nextInt(4)) {
            case 0 -> Box.ofHalfExtents(size, size * slender, size * r.nextDouble(.1, 1));
            case 1 -> Sphere.of(size);
            case 2 -> Capsule.of(size * slender, size);
            default -> Cylinder.of(size, size * slender);
        };
    }

    private void body(int slot, Shape shape, SplittableRandom r, double place, double near) {
        colliders.attach(slot, shape);
        Quaterniond q =
                new Quaterniond(
                                r.nextDouble(-1, 1),
                                r.nextDouble(-1, 1),
                                r.nextDouble(-1, 1),
                                r.nextDouble(-1, 1))
                        .normalize();
        bodies.orientationX[slot] = q.x;
        bodies.orientationY[slot] = q.y;
        bodies.orientationZ[slot] = q.z;
        bodies.orientationW[slot] = q.w;
        bodies.positionX[slot] = place + near * r.nextDouble(-1, 1);
        bodies.positionY[slot] = near * r.nextDouble(-1, 1);
        bodies.positionZ[slot] = near * r.nextDouble(-1, 1);
        double speed = r.nextInt(3) == 0 ? 0 : Math.pow(10, r.nextDouble(-2, 1.5));
        bodies.velocityX[slot] = speed * r.nextDouble(-1, 1);
        bodies.velocityY[slot] = speed * r.nextDouble(-1, 1);
        bodies.angularVelocityZ[slot] = r.nextInt(3) == 0 ? 10 * r.nextDouble(-1, 1) : 0;
        bodies.inverseMass[slot] = 1;
    }

    private void place(Placement p, int slot) {
        p.set(
                colliders.shape[slot],
                bodies.positionX[slot],
                bodies.positionY[slot],
                bodies.positionZ[slot],
                bodies.orientationX[slot],
                bodies.orientationY[slot],
                bodies.orientationZ[slot],
                bodies.orientationW[slot]);
    }

    @Test
    void whatIsToldToBeFarIsFar() {
        SplittableRandom r = new SplittableRandom(SEED);
        ShapeQueries queries = new ShapeQueries();
        bodies.ensureCapacity(2);
        bodies.slotCount = 2;
        bounds.ensureSlots(2);
        broadPhase.ensureSlots(2);
        double reach = STEP * bounds.speculativeTime;
        int far = 0;
        int apart = 0;
        try (Jobs jobs = Jobs.of(1)) {
            for (int pair = 0; pair < PAIRS; pair++) {
                Shape a = shape(r);
                Shape b = shape(r);
                double place = r.nextInt(4) == 0 ? 1e6 : 0;
                body(0, a, r, place, 0);
                body(1, b, r, place, 1.5 * (a.outerRadius() + b.outerRadius()));
                bounds.run(broadPhase, new int[] {0, 1}, 2, 0, -9.81, 0, STEP, jobs);
                place(one, 0);
                place(other, 1);
                double margin =
                        bounds.margin(0, 1, reach, Math.min(a.innerRadius(), b.innerRadius()));
                boolean isApart = queries.distance(one, other) > margin;
                apart += isApart ? 1 : 0;
                if (bounds.isFar(0, 1, reach)) {
                    far++;
                    assertTrue(isApart, "seed " + SEED + " pair " + pair + " " + a + " " + b);
                }
            }
        }
        assertTrue(2 * far > apart, far + " of " + apart + " pairs that are apart");
    }

    @Test
    void nobodyIsFarFromEndlessGround() {
        bodies.ensureCapacity(2);
        bodies.slotCount = 2;
        bounds.ensureSlots(2);
        broadPhase.ensureSlots(2);
        SplittableRandom r = new SplittableRandom(SEED);
        body(0, Sphere.of(1), r, 0, 1);
        colliders.attach(1, HalfSpace.of());
        bodies.orientationW[1] = 1;
        bounds.placeFixed(broadPhase, 1, false);
        try (Jobs jobs = Jobs.of(1)) {
            bounds.run(broadPhase, new int[] {0}, 1, 0, 0, 0, STEP, jobs);
        }
        assertFalse(bounds.isFar(0, 1, STEP));
    }
}
