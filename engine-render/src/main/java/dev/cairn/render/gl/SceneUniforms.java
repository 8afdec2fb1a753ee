package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;

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
    static final int MORE_SHADOWS = 6;
    static final int MORE_NUMBERS = 8;
    static final int SKY_TABLE = 10;
    static final int OPEN_SHARE = 11;

    /** How far beside a surface another one may lie that passes for the same, by its distance. */
    private static final double SAME_SURFACE = 0.004;

    private final int clipFromAnchored;
    private final int alpha;
    private final int motion;
    private final int look;
    private final int surface;
    private final int[] shadowMap = new int[ShadowCascades.MOST];
    private final int tileMetres;
    private final int eye;
    private final int sunDirection;
    private final int sunLight;
    private final int skyLight;
    private final int groundLight;
    private final int zenithColour;
    private final int horizonColour;
    private final int hazeMetres;
    private final int[] shadowFromAnchored = new int[ShadowCascades.MOST];
    private final int[] shadowTexelMetres = new int[ShadowCascades.MOST];
    private final int[] shadowBias = new int[ShadowCascades.MOST];

    // Only with the effects that need them.
    private final int[] shadowDepth = new int[ShadowCascades.MOST];
    private final int skyTable;
    private final int sceneDepth;
    private final int openShare;
    private final int depthTolerance;
    private final int finish;
    private final int opacity;

    SceneUniforms(ShaderProgram program) {
        clipFromAnchored = program.uniform("clipFromAnchored");
        alpha = program.uniform("alpha");
        motion = program.uniform("motion");
        look = program.uniform("look");
        surface = program.uniform("surface");
        tileMetres = program.uniform("tileMetres");
        eye = program.uniform("eye");
        sunDirection = program.uniform("sunDirection");
        sunLight = program.uniform("sunLight");
        skyLight = program.uniformIfUsed("skyLight");
        groundLight = program.uniformIfUsed("groundLight");
        skyTable = program.uniformIfUsed("skyTable");
        zenithColour = program.uniformIfUsed("zenithColour");
        horizonColour = program.uniformIfUsed("horizonColour");
        hazeMetres = program.uniform("hazeMetres");
        for (int i = 0; i < ShadowCascades.MOST; i++) {
            shadowMap[i] = program.uniformIfUsed("shadowMap" + i);
            shadowDepth[i] = program.uniformIfUsed("shadowDepth" + i);
            shadowFromAnchored[i] = program.uniformIfUsed("shadowFromAnchored[" + i + "]");
            shadowTexelMetres[i] = program.uniformIfUsed("shadowTexelMetres[" + i + "]");
            shadowBias[i] = program.uniformIfUsed("shadowBias[" + i + "]");
        }
        sceneDepth = program.uniformIfUsed("sceneDepth");
        openShare = program.uniformIfUsed("openShare");
        depthTolerance = program.uniformIfUsed("depthTolerance");
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
        ShaderProgram.set(eye, anchoredEye.x, anchoredEye.y, anchoredEye.z);
        ShaderProgram.set(sunDirection, sun.x, sun.y, sun.z);
        ShaderProgram.set(sunLight, light.sunRed(), light.sunGreen(), light.sunBlue());
        ShaderProgram.set(skyLight, light.skyRed(), light.skyGreen(), light.skyBlue());
        ShaderProgram.set(groundLight, light.groundRed(), light.groundGreen(), light.groundBlue());
        setColour(zenithColour, light.zenithRgb());
        setColour(horizonColour, light.horizonRgb());
        ShaderProgram.set(skyTable, SKY_TABLE);
        ShaderProgram.set(sceneDepth, SCENE_DEPTH);
        ShaderProgram.set(hazeMetres, light.hazeMetres());
    }

    /** Leaves another texture unit active. */
    void setShadows(@Nullable ShadowCascades shadows, boolean asNumbers) {
        for (int i = 0; i < ShadowCascades.MOST; i++) {
            ShaderProgram.set(shadowMap[i], ShadowCascades.unit(i));
            ShaderProgram.set(shadowDepth[i], ShadowCascades.numbersUnit(i));
            ShadowMap map = shadows == null ? null : shadows.map(i);
            if (map == null) {
                ShaderProgram.set(shadowTexelMetres[i], 0.0);
                continue;
            }
            if (asNumbers) {
                map.bindNumbers(ShadowCascades.numbersUnit(i));
            }
            glActiveTexture(GL_TEXTURE0 + ShadowCascades.unit(i));
            map.bindTexture();
            ShaderProgram.set(shadowFromAnchored[i], map.matrix());
            ShaderProgram.set(shadowTexelMetres[i], map.texelMetres());
            ShaderProgram.set(shadowBias[i], map.bias());
        }
    }

    /**
     * The depth of a point w metres ahead of the camera is f / (f - n) (1 - n / w), so that a share
     * s of w changes it by s n f / (f - n) / w.
     *
     * @param near distance of the near plane, m
     * @param far same
     */
    void setOcclusion(double near, double far) {
        ShaderProgram.set(openShare, OPEN_SHARE);
        ShaderProgram.set(depthTolerance, SAME_SURFACE * near * far / (far - near));
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
