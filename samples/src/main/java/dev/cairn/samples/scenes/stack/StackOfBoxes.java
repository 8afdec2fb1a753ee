package dev.cairn.samples.scenes.stack;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * Unit boxes on each other: dropped from different heights, or built touching; of equal mass, or
 * heavy on light.
 *
 * <p>Truth, for restitution 0: they come to rest as a stack of touching boxes, the k-th at {@code k
 * + 1/2}; each level carries the weight above it; nothing creeps sideways. For restitution 1 and
 * friction 0 the energy stays what it was; friction takes it once a box has tilted.
 */
public final class StackOfBoxes {
    private static final double HALF = 0.5;

    /** Seconds that the stack is given to calm down after the last box should have landed. */
    private static final double CALM = 2;

    private StackOfBoxes() {}

    /** Masses of a stack, by the number that the user gives. */
    private static final int EQUAL = 0;

    private static final int ALTERNATING = 1;
    private static final int HEAVY_TOP = 2;

    /**
     * Four boxes that fall onto each other.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return entry(
                "stack-4",
                "Stack of four",
                "Four boxes fall from different heights onto each other and stand; with restitution"
                        + " 1 and friction 0 they bounce for ever.",
                parameters(4, 0.25, EQUAL, 1, 0),
                300);
    }

    /**
     * A tall stack, built touching and a little untidy.
     *
     * @return its entry for the registry
     */
    public static SampleScene tall() {
        return entry(
                "stack",
                "Tall stack",
                "Boxes stand on each other, each a little aside and turned; boxes=40 is a tower.",
                parameters(10, 0, EQUAL, 1, 1),
                600);
    }

    /**
     * A stack with heavy boxes on light ones.
     *
     * @return its entry for the registry
     */
    public static SampleScene massRatio() {
        return entry(
                "mass-ratio",
                "Heavy on light",
                "Ten boxes whose masses alternate 1:100 stand; with pattern=2 only the top is"
                        + " heavy, with boxes=2 it is a pair.",
                parameters(10, 0, ALTERNATING, 100, 1),
                600);
    }

    private static SampleScene entry(
            String id, String title, String description, List<Parameter> parameters, int ticks) {
        return new SampleScene(
                id,
                title,
                description,
                "stacks",
                parameters,
                ticks,
                Math.min(ticks, 240),
                StackOfBoxes::build);
    }

    private static List<Parameter> parameters(
            int boxes, double gap, int pattern, double ratio, double jitter) {
        return List.of(
                Parameter.count("boxes", boxes, 1, 400, "number of boxes"),
                Parameter.real("restitution", 0, 0, 1, "coefficient of restitution"),
                Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient"),
                Parameter.real("mass", 1, 1e-3, 1e6, "mass of each light box, kg"),
                Parameter.real(
                        "gap", gap, 0, 10, "free fall of each box relative to the one below, m"),
                Parameter.count(
                        "pattern",
                        pattern,
                        0,
                        2,
                        "masses: 0 equal, 1 every second one heavy, 2 the top heavy"),
                Parameter.real("ratio", ratio, 1e-9, 1e9, "mass of heavy boxes over light ones"),
                Parameter.real(
                        "jitter",
                        jitter,
                        0,
                        50,
                        "largest offset of a box, mm; turned by 10 mrad" + " for each"));
    }

    private static double massOf(int box, int boxes, int pattern, double mass, double ratio) {
        boolean heavy =
                switch (pattern) {
                    case ALTERNATING -> box % 2 == 1;
                    case HEAVY_TOP -> box == boxes - 1;
                    default -> false;
                };
        return heavy ? mass * ratio : mass;
    }

    private static void build(SceneBuilder scene) {
        int boxes = scene.count("boxes");
        double restitution = scene.get("restitution");
        double friction = scene.get("friction");
        double gap = scene.get("gap");
        double jitter = 1e-3 * scene.get("jitter");
        int pattern = scene.count("pattern");
        BodyRef floor = scene.floor(6, 6, friction, restitution);
        Box shape = Box.cubeOfHalfExtent(HALF);
        List<BodyRef> stack = new ArrayList<>();
        double[] masses = new double[boxes + 1];
        stack.add(floor);
        for (int k = 0; k < boxes; k++) {
            double mass = massOf(k, boxes, pattern, scene.get("mass"), scene.get("ratio"));
            masses[k + 1] = mass;
            Body body = Body.dynamic().mass(mass).name("box " + k);
            if (jitter > 0) {
                body.at(
                        scene.random(-jitter, jitter),
                        HALF + k + (k + 1) * gap,
                        scene.random(-jitter, jitter));
                body.rotationAbout(0, 1, 0, 10 * scene.random(-jitter, jitter));
            } else {
                body.at(0, HALF + k + (k + 1) * gap, 0);
            }
            stack.add(
                    scene.add(
                            shape,
                            mass > scene.get("mass") ? Palette.STONE : Palette.body(k),
                            body.material(Palette.material(friction, restitution))));
        }
        double distance = 4 + 1.4 * boxes;
        scene.view(
                new SceneView(
                        0.5 * distance, 0.35 * distance + 1, 0.9 * distance, 0, 0.5 * boxes, 0));

        if (restitution == 0) {
            Rest rest =
                    new Rest(
                            scene,
                            stack,
                            masses,
                            StrictMath.sqrt(2 * boxes * gap / SampleScene.GRAVITY) + CALM);
            scene.afterTick(rest::watch);
            scene.error("sagMetres", rest::sag);
            scene.error("driftMetres", rest::drift);
            scene.error("speedMetresPerSecond", rest::speed);
            scene.error("creepMetres", rest::creep);
            scene.error("forceRelative", rest::forceError);
        } else if (restitution == 1 && gap > 0) {
            double start = potential(stack, masses);
            scene.error(
                    "energyRelative",
                    () ->
                            Math.abs(
                                            scene.world().kineticEnergy()
                                                    + potential(stack, masses)
                                                    - start)
                                    / start);
        }
    }

    /** Joules above the stack at rest. */
    private static double potential(List<BodyRef> stack, double[] masses) {
        double sum = 0;
        for (int k = 1; k < stack.size(); k++) {
            sum += masses[k] * SampleScene.GRAVITY * (stack.get(k).position().y - (k - HALF));
        }
        return sum;
    }

    /** Compares the stack with one at rest, once it has had time to come to rest. */
    private static final class Rest {
        private final SceneBuilder scene;
        private final List<BodyRef> stack;
        private final double[] masses;
        private final double calmSeconds;
        private final double[] startX;
        private final double[] startZ;
        private final double[] builtX;
        private final double[] builtZ;
        private final Vector3d at = new Vector3d();
        private boolean calm;

        Rest(SceneBuilder scene, List<BodyRef> stack, double[] masses, double calmSeconds) {
            this.scene = scene;
            this.stack = stack;
            this.masses = masses;
            this.calmSeconds = calmSeconds;
            this.startX = new double[stack.size()];
            this.startZ = new double[stack.size()];
            this.builtX = new double[stack.size()];
            this.builtZ = new double[stack.size()];
            for (int k = 1; k < builtX.length; k++) {
                stack.get(k).position(at);
                builtX[k] = at.x;
                builtZ[k] = at.z;
            }
        }

        void watch(long tick, double seconds) {
            if (calm || seconds < calmSeconds) {
                return;
            }
            calm = true;
            for (int k = 0; k < startX.length; k++) {
                stack.get(k).position(at);
                startX[k] = at.x;
                startZ[k] = at.z;
            }
        }

        double sag() {
            double worst = 0;
            for (int k = 1; k < startX.length; k++) {
                worst = Math.max(worst, Math.abs(stack.get(k).position(at).y - (k - HALF)));
            }
            return calm ? worst : Double.NaN;
        }

        /** How far a box is aside of where it was built. */
        double drift() {
            double worst = 0;
            for (int k = 1; k < startX.length; k++) {
                stack.get(k).position(at);
                double dx = at.x - builtX[k];
                double dz = at.z - builtZ[k];
                worst = Math.max(worst, StrictMath.sqrt(dx * dx + dz * dz));
            }
            return calm ? worst : Double.NaN;
        }

        double speed() {
            double worst = 0;
            for (int k = 1; k < startX.length; k++) {
                worst = Math.max(worst, stack.get(k).velocity(at).length());
            }
            return calm ? worst : Double.NaN;
        }

        double creep() {
            double worst = 0;
            for (int k = 1; k < startX.length; k++) {
                stack.get(k).position(at);
                double dx = at.x - startX[k];
                double dz = at.z - startZ[k];
                worst = Math.max(worst, StrictMath.sqrt(dx * dx + dz * dz));
            }
            return calm ? worst : Double.NaN;
        }

        /** The worst level's relative error of the force that it carries. */
        double forceError() {
            double worst = 0;
            double weight = 0;
            for (int k = startX.length - 1; k > 0; k--) {
                weight += masses[k] * SampleScene.GRAVITY;
                double carried = forceBetween(stack.get(k - 1), stack.get(k));
                worst = Math.max(worst, Math.abs(carried - weight) / weight);
            }
            return calm ? worst : Double.NaN;
        }

        private double forceBetween(BodyRef lower, BodyRef upper) {
            Contacts contacts = scene.world().contacts();
            double impulse = 0;
            for (int c = 0; c < contacts.count(); c++) {
                long a = contacts.bodyA(c).entity();
                long b = contacts.bodyB(c).entity();
                if ((a == lower.entity() && b == upper.entity())
                        || (a == upper.entity() && b == lower.entity())) {
                    for (int p = 0; p < contacts.pointCount(c); p++) {
                        impulse +=
                                contacts.normalImpulse(c, p) * Math.abs(contacts.normal(c, at).y);
                    }
                }
            }
            return impulse / SampleScene.STEP_SECONDS;
        }
    }
}
