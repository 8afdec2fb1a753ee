/**
 * Draws snapshots with OpenGL: window, input, camera, meshes, and the {@code Application} that
 * users extend.
 */
module dev.cairn.render {
    requires static org.jspecify;
    requires transitive dev.cairn.core;
    requires transitive dev.cairn.physics;
    requires transitive org.joml;
    requires org.lwjgl;
    requires org.lwjgl.glfw;
    requires org.lwjgl.nuklear;
    requires org.lwjgl.opengl;
    requires org.lwjgl.stb;

    exports dev.cairn.render.app;
    exports dev.cairn.render.camera;
    exports dev.cairn.render.input;
    exports dev.cairn.render.mesh;
    exports dev.cairn.render.ui;
}
