/**
 * Rigid bodies on the ECS core: broad phase, GJK and EPA narrow phase, sub-stepped soft contacts.
 */
module dev.cairn.physics {
    requires static org.jspecify;
    requires static jdk.incubator.vector;
    requires static jdk.jfr;
    requires transitive dev.cairn.core;
    requires transitive org.joml;

    exports dev.cairn.physics;
    exports dev.cairn.physics.hand;
    exports dev.cairn.physics.joint;
    exports dev.cairn.physics.collider;
    exports dev.cairn.physics.body;
    exports dev.cairn.physics.component;
    exports dev.cairn.physics.profile;
    exports dev.cairn.physics.query;
    exports dev.cairn.physics.shape;
    exports dev.cairn.physics.shape.decomposition;
    exports dev.cairn.physics.time;
    exports dev.cairn.physics.tuning;
}
