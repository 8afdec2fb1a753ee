package dev.cairn.render.gl;

import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Texture;

import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/** The uniforms of the scene's shaders by name. */
final class SceneUniforms {
    /** Texture units beside those of surface, shadow map, motion and looks. */
    static final int SHADOW_NUMBERS = 4;

    static final int SCENE_DEPTH = 5;

    /** Radius of the neighbourhood that hides sky, by its distance from the eye. */
    static final double OCCLUSION_SHARE = 0.07;

    private final int clipFromAnchored;
    private final int alpha;
    private final int motion;
    private final int look;
    private final int surface;
    private final int shadowMap;
    private final int tileMetres;
    private final int eye;
    private final int sunDirection;
    private final int sunLight;
    private final int skyLight;
    private final int groundLight;
    private final int zenithColour;
    private final int horizonColour;
    private final int hazeMetres;
    private final int shadowFromAnchored;
    private final int shadowTexelMetres;
    private final int shadowBias;

    // Only with the effects that need them.
    private final int shadowDepth;
    private final int sceneDepth;
    private final int anchoredFromClip;
    private final int occlusionReach;
    private final int finish;
    private final int opacity;
    private final Matrix4d inverse = new Matrix4d();

    SceneUniforms(ShaderProgram program) {
        clipFromAnchored = program.uniform("clipFromAnchored");
        alpha = program.uniform("alpha");
        motion = program.uniform("motion");
        look = program.uniform("look");
        surface = program.uniform("surface");
        shadowMap = program.uniform("shadowMap");
        tileMetres = program.uniform("tileMetres");
        eye = program.uniform("eye");
        sunDirection = program.uniform("sunDirection");
        sunLight = program.uniform("sunLight");
        skyLight = program.uniform("skyLight");
        groundLight = program.uniform("groundLight");
        zenithColour = program.uniformIfUsed("zenithColour");
        horizonColour = program.uniform("horizonColour");
        hazeMetres = program.uniform("hazeMetres");
        shadowFromAnchored = program.uniform("shadowFromAnchored");
        shadowTexelMetres = program.uniform("shadowTexelMetres");
        shadowBias = program.uniform("shadowBias");
        shadowDepth = program.uniformIfUsed("shadowDepth");
        sceneDepth = program.uniformIfUsed("sceneDepth");
        anchoredFromClip = program.uniformIfUsed("anchoredFromClip");
        occlusionReach = program.uniformIfUsed("occlusionReach");
        finish = program.uniformIfUsed("finish");
        opacity = program.uniform("opacity");
    }

    void set(
            Light light,
            double interpolation,
            Matrix4d matrix,
            Vector3d anchoredEye,
            Vector3d sun) {
        ShaderProgram.set(clipFromAnchored, matrix);
        ShaderProgram.set(alpha, interpolation);
        ShaderProgram.set(motion, 2);
        ShaderProgram.set(look, 3);
        ShaderProgram.set(surface, 0);
        ShaderProgram.set(shadowMap, 1);
        ShaderProgram.set(eye, anchoredEye.x, anchoredEye.y, anchoredEye.z);
        ShaderProgram.set(sunDirection, sun.x, sun.y, sun.z);
        ShaderProgram.set(sunLight, light.sunRed(), light.sunGreen(), light.sunBlue());
        ShaderProgram.set(skyLight, light.skyRed(), light.skyGreen(), light.skyBlue());
        ShaderProgram.set(groundLight, light.groundRed(), light.groundGreen(), light.groundBlue());
        setColour(zenithColour, light.zenithRgb());
        setColour(horizonColour, light.horizonRgb());
        ShaderProgram.set(shadowDepth, SHADOW_NUMBERS);
        ShaderProgram.set(sceneDepth, SCENE_DEPTH);
        ShaderProgram.set(hazeMetres, light.hazeMetres());
    }

    /** With the shadow map's texture unit active. */
    void setShadows(@Nullable ShadowMap shadows) {
        if (shadows == null) {
            ShaderProgram.set(shadowTexelMetres, 0.0);
            return;
        }
        shadows.bindTexture();
        ShaderProgram.set(shadowFromAnchored, shadows.matrix());
        ShaderProgram.set(shadowTexelMetres, shadows.texelMetres());
        ShaderProgram.set(shadowBias, shadows.bias());
    }

    /**
     * Where points around a pixel lie.
     *
     * @param clipFromAnchored of the picture
     * @param tan of half the field of view, upwards
     * @param aspect width by height
     */
    void setOcclusion(Matrix4d clipFromAnchored, double tan, double aspect) {
        ShaderProgram.set(anchoredFromClip, clipFromAnchored.invert(inverse));
        double reach = 0.5 * OCCLUSION_SHARE / tan;
        ShaderProgram.set(occlusionReach, reach / aspect, reach);
    }

    void setTexture(Texture texture) {
        ShaderProgram.set(tileMetres, texture.tileMetres());
        ShaderProgram.set(finish, texture.roughness(), texture.metal());
        ShaderProgram.set(opacity, texture.opacity());
    }

    static void setColour(int uniform, int rgb) {
        ShaderProgram.set(uniform, Srgb.linear(rgb >> 16), Srgb.linear(rgb >> 8), Srgb.linear(rgb));
    }
}
