package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.samples.SceneBuilder;

import org.joml.Vector3d;

import java.util.List;

/** The largest gap that a joint of a scene ever had. */
final class Gaps {
    private Gaps() {}

    /** Reports it as {@code gapMetres}, over a length if one is given as another error. */
    static void watch(SceneBuilder scene, String name, double length) {
        PhysicsWorld world = scene.world();
        List<JointRef> joints = world.joints().all();
        double[] worst = {0};
        scene.afterTick((tick, seconds) -> {
            for (int k = 0; k < joints.size(); k++) {
                JointRef joint = joints.get(k);
                if (joint.isAlive() && joint.isEnabled()) {
                    worst[0] = Math.max(worst[0], joint.gap() / length);
                }
            }
        });
        scene.error(name, () -> worst[0]);
    }

    /** Reports the largest distance of the two points of a joint of all that share one point. */
    static void watchPoints(SceneBuilder scene) {
        List<JointRef> joints = scene.world().joints().all();
        double[] worst = {0};
        Vector3d a = new Vector3d();
        Vector3d b = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            for (int k = 0; k < joints.size(); k++) {
                JointRef joint = joints.get(k);
                if (joint.isAlive() && joint.isEnabled()) {
                    worst[0] = Math.max(worst[0], joint.anchorA(a).distance(joint.anchorB(b)));
                }
            }
        });
        scene.error("gapMetres", () -> worst[0]);
    }
}
