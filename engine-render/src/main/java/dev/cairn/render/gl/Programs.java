package dev.cairn.render.gl;

import dev.cairn.render.camera.Effects;

/** The shaders of scene and sky for one choice of effects. */
final class Programs implements AutoCloseable {
    private static final int FRUGAL_TAPS = 4;
    private static final int MOST_TAPS = 12;

    final ShaderProgram scene;
    final SceneUniforms uniforms;
    final ShaderProgram sky;
    final int forward;
    final int right;
    final int up;
    final int zenith;
    final int horizon;

    Programs(boolean frugal, Effects effects) {
        String chosen =
                "#define SHADOW_TAPS %d\n#define SURFACE_TAPS %d\n"
                                .formatted(frugal ? 1 : 3, surfaceTaps(frugal))
                        + define("SOFT_SHADOWS", effects.softShadows())
                        + define("OCCLUSION", effects.occlusion())
                        + define("REFLECTIONS", effects.reflections())
                        + define("FILMIC", effects.filmic())
                        + define("HORIZON", effects.horizon())
                        + define("SKY_LIGHT", effects.skyLight())
                        + "#define SHADOW_MAPS %d%n"
                                .formatted(effects.cascades() ? ShadowCascades.MOST : 1);
        scene =
                new ShaderProgram(
                        "scene",
                        chosen,
                        new String[] {"instance.glsl", "scene.vert"},
                        new String[] {
                            "encode.glsl",
                            "sky.glsl",
                            "sampling.glsl",
                            "shadow.glsl",
                            "material.glsl",
                            "scene.frag"
                        });
        uniforms = new SceneUniforms(scene);
        sky =
                new ShaderProgram(
                        "sky",
                        chosen,
                        new String[] {"sky.vert"},
                        new String[] {"encode.glsl", "sky.glsl", "sky.frag"});
        forward = sky.uniform("rayForward");
        right = sky.uniform("rayRight");
        up = sky.uniform("rayUp");
        zenith = sky.uniform("zenithColour");
        horizon = sky.uniform("horizonColour");
    }

    private static String define(String name, boolean on) {
        return "#define " + name + (on ? " 1\n" : " 0\n");
    }

    /** Lookups along a pixel's footprint by the shader itself; see {@link GpuTexture}. */
    private static int surfaceTaps(boolean frugal) {
        return GpuTexture.isAnisotropic() ? 1 : frugal ? FRUGAL_TAPS : MOST_TAPS;
    }

    @Override
    public void close() {
        scene.close();
        sky.close();
    }
}
