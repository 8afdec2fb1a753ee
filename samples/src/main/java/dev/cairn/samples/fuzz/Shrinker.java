package dev.cairn.samples.fuzz;

import dev.cairn.physics.Material;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

/**
 * Makes a world that breaks a law as small as it goes: takes away bodies, motion, friction, bounce
 * and everything unusual one at a time, as long as the law stays broken.
 */
final class Shrinker {
    /** Runs that a world is worth; each is as long as the breach is late. */
    private static final int MOST_RUNS = 400;

    private final Law law;
    private FuzzWorld least;
    private int runs;
    private boolean smaller;

    private Shrinker(FuzzWorld fuzz, Law law) {
        least = fuzz;
        this.law = law;
    }

    /**
     * The least world found that still breaks the law.
     *
     * @param fuzz breaks it
     */
    static FuzzWorld shrink(FuzzWorld fuzz, Breach breach) {
        Shrinker shrinker = new Shrinker(fuzz, breach.law());
        boolean atOnce =
                switch (breach.law()) {
                    case OVERLAP, SLEEP -> false;
                    default -> true;
                };
        if (atOnce) {
            shrinker.attempt(fuzz.lasting(breach.tick(), fuzz.scene().tick().substeps()));
        }
        do {
            shrinker.smaller = false;
            shrinker.bodies();
            shrinker.joints();
            shrinker.calm();
            shrinker.plain();
        } while (shrinker.smaller && shrinker.runs < MOST_RUNS);
        return shrinker.least;
    }

    private void attempt(FuzzWorld candidate) {
        if (runs >= MOST_RUNS || candidate.equals(least)) {
            return;
        }
        runs++;
        Breach breach = Laws.broken(candidate, law == Law.BITS).get(law);
        if (breach != null) {
            least = candidate;
            smaller = true;
        }
    }

    private void bodies() {
        for (int i = least.scene().entities().size() - 1; i >= 0; i--) {
            // without a wall, to be beyond it breaks no law
            if (entity(i).name().isEmpty() || !(law == Law.WALLS || law == Law.SINK)) {
                attempt(least.without(i));
            }
        }
    }

    private void joints() {
        for (int i = least.scene().joints().size() - 1; i >= 0; i--) {
            attempt(least.withoutJoint(i));
        }
    }

    private void calm() {
        for (int i = 0; i < least.scene().entities().size(); i++) {
            EntitySpec e = entity(i);
            attempt(least.with(i, e.moving(e.velocity(), Xyz.ZERO)));
            e = entity(i);
            attempt(least.with(i, e.moving(Xyz.ZERO, e.angularVelocity())));
            e = entity(i);
            attempt(least.with(i, e.at(e.position(), Turn.NONE)));
            Material m = entity(i).material();
            attempt(least.with(i, entity(i).withMaterial(m.withFriction(0), entity(i).mass())));
            m = entity(i).material();
            attempt(least.with(i, entity(i).withMaterial(m.withRestitution(0), entity(i).mass())));
            if (!(entity(i).shape() instanceof ShapeSpec.BoxShape)
                    && Double.isFinite(Extent.outer(entity(i).shape()))) {
                ShapeSpec shape = entity(i).shape();
                double thin = Extent.inner(shape);
                double size = Extent.outer(shape);
                Xyz half = new Xyz(thin, Math.max(thin, size - thin), thin);
                attempt(least.with(i, entity(i).withShape(new ShapeSpec.BoxShape(half))));
            }
        }
    }

    private EntitySpec entity(int i) {
        return least.scene().entities().get(i);
    }

    /** Ticks and sub-steps of the defaults. */
    private void plain() {
        attempt(least.withPace(Pace.EVEN));
        attempt(least.lasting(least.scene().tick().ticks(), 4));
        SceneFile.TickSpec tick = least.scene().tick();
        attempt(
                least.withScene(
                        least.scene()
                                .withTick(
                                        new SceneFile.TickSpec(
                                                1.0 / 60,
                                                tick.substeps(),
                                                tick.ticks(),
                                                tick.pictureTick()))));
    }
}
