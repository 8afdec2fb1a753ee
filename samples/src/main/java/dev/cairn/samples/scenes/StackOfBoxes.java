package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * Unit boxes dropped from different heights onto each other.
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

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "stack-4",
                "Stack of four",
                "Four boxes fall from different heights onto each other and stand; with restitution"
                        + " 1 and friction 0 they bounce for ever.",
                "stacks",
                List.of(
                        Parameter.count("boxes", 4, 1, 100, "number of boxes"),
                        Parameter.real("restitution", 0, 0, 1, "coefficient of restitution"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient"),
                        Parameter.real("mass", 1, 1e-3, 1e6, "mass of each box, kg"),
                        Parameter.real(
                                "gap",
                                0.25,
                                0,
                                10,
                                "free fall of each box relative to the one below, m")),
                300,
                240,
                StackOfBoxes::build);
    }

    private static void build(SceneBuilder scene) {
        int boxes = scene.count("boxes");
        double restitution = scene.get("restitution");
        double friction = scene.get("friction");
        double mass = scene.get("mass");
        double gap = scene.get("gap");
        BodyRef floor = scene.floor(6, 6, friction, restitution);
        Box shape = Box.cube(HALF);
        List<BodyRef> stack = new ArrayList<>();
        stack.add(floor);
        for (int k = 0; k < boxes; k++) {
            stack.add(
                    scene.add(
                            shape,
                            Palette.body(k),
                            Body.dynamic()
                                    .at(0, HALF + k + (k + 1) * gap, 0)
                                    .mass(mass)
                                    .material(Palette.material(friction, restitution))
                                    .name("box " + k)));
        }
        double distance = 4 + 1.4 * boxes;
        scene.view(
                new SceneBuilder.View(
                        0.5 * distance, 0.35 * distance + 1, 0.9 * distance, 0, 0.5 * boxes, 0));

        if (restitution == 0) {
            Rest rest =
                    new Rest(
                            scene,
                            stack,
                            mass,
                            StrictMath.sqrt(2 * boxes * gap / SampleScene.GRAVITY) + CALM);
            scene.afterTick(rest::watch);
            scene.error("sagMetres", rest::sag);
            scene.error("creepMetres", rest::creep);
            scene.error("forceRelative", rest::forceError);
        } else if (restitution == 1 && gap > 0) {
            double start = potential(stack, mass);
            scene.error(
                    "energyRelative",
                    () ->
                            Math.abs(scene.world().kineticEnergy() + potential(stack, mass) - start)
                                    / start);
        }
    }

    /** Joules above the stack at rest. */
    private static double potential(List<BodyRef> stack, double mass) {
        double sum = 0;
        for (int k = 1; k < stack.size(); k++) {
            sum += mass * SampleScene.GRAVITY * (stack.get(k).position().y - (k - HALF));
        }
        return sum;
    }

    /** Compares the stack with one at rest, once it has had time to come to rest. */
    private static final class Rest {
        private final SceneBuilder scene;
        private final List<BodyRef> stack;
        private final double mass;
        private final double calmSeconds;
        private final double[] startX;
        private final double[] startZ;
        private final Vector3d at = new Vector3d();
        private boolean calm;

        Rest(SceneBuilder scene, List<BodyRef> stack, double mass, double calmSeconds) {
            this.scene = scene;
            this.stack = stack;
            this.mass = mass;
            this.calmSeconds = calmSeconds;
            this.startX = new double[stack.size()];
            this.startZ = new double[stack.size()];
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
            for (int k = 1; k < startX.length; k++) {
                double weight = (startX.length - k) * mass * SampleScene.GRAVITY;
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
