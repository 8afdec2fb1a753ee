package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_BACK;
import static org.lwjgl.opengl.GL11.GL_BLEND;
import static org.lwjgl.opengl.GL11.GL_COLOR_BUFFER_BIT;
import static org.lwjgl.opengl.GL11.GL_CULL_FACE;
import static org.lwjgl.opengl.GL11.GL_DEPTH_BUFFER_BIT;
import static org.lwjgl.opengl.GL11.GL_DEPTH_TEST;
import static org.lwjgl.opengl.GL11.GL_LEQUAL;
import static org.lwjgl.opengl.GL11.GL_ONE;
import static org.lwjgl.opengl.GL11.GL_ONE_MINUS_SRC_ALPHA;
import static org.lwjgl.opengl.GL11.GL_SRC_ALPHA;
import static org.lwjgl.opengl.GL11.GL_TRIANGLES;
import static org.lwjgl.opengl.GL11.glClear;
import static org.lwjgl.opengl.GL11.glClearColor;
import static org.lwjgl.opengl.GL11.glCullFace;
import static org.lwjgl.opengl.GL11.glDepthFunc;
import static org.lwjgl.opengl.GL11.glDepthMask;
import static org.lwjgl.opengl.GL11.glDisable;
import static org.lwjgl.opengl.GL11.glDrawArrays;
import static org.lwjgl.opengl.GL11.glEnable;
import static org.lwjgl.opengl.GL11.glViewport;
import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;
import static org.lwjgl.opengl.GL14.glBlendFuncSeparate;
import static org.lwjgl.opengl.GL30.glBindVertexArray;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.camera.Light;

import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * Draws a snapshot into a target: shadows, then the scene, then the sky behind it. On the thread of
 * the context.
 */
public final class SceneRenderer implements AutoCloseable {
    private static final int MIN_SHADOW_SIZE = 512;
    private static final int MAX_SHADOW_SIZE = 2048;

    private final boolean frugal;
    private Effects effects;
    private Programs programs;

    private @Nullable Occlusion occlusion;

    private final int emptyVertexArray = GlObjects.vertexArray();
    private final Instances instances = new Instances();
    private final Pass pass = new Pass(instances, false);
    private @Nullable ShadowCascades shadowMap;
    private final SkyTable skyTable = new SkyTable();
    private @Nullable SceneOverlay overlay;

    private Tints.Kind tint = Tints.Kind.NONE;
    private int glassBatches;
    private final Vector3d eye = new Vector3d();
    private final Vector3d forward = new Vector3d();
    private final Vector3d right = new Vector3d();
    private final Vector3d up = new Vector3d();
    private final Vector3d sun = new Vector3d();
    private final Matrix4d clipFromAnchored = new Matrix4d();

    /**
     * Compiles the shaders.
     *
     * @param frugal whether to save effort: shadows of one tap and half the resolution
     * @param effects what to draw beyond the plain picture
     */
    public SceneRenderer(boolean frugal, Effects effects) {
        this.frugal = frugal;
        this.effects = effects;
        programs = new Programs(frugal, effects);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_BACK);
        glClearColor(0, 0, 0, 1);
    }

    /**
     * Chooses what is drawn beyond the plain picture; other shaders are compiled if that changes.
     *
     * @param wanted the effects
     */
    public void effects(Effects wanted) {
        if (!wanted.equals(effects)) {
            Programs made = new Programs(frugal, wanted);
            programs.close();
            programs = made;
            effects = wanted;
        }
    }

    /**
     * Draws and resolves one frame.
     *
     * @param snapshot what
     * @param alpha 0 = the poses of the previous tick, 1 = those of the current one
     * @param camera from where; one that follows an entity is moved to it
     * @param light in which light
     * @param target into what
     */
    public void draw(
            PoseSnapshot snapshot, double alpha, Camera camera, Light light, FrameTarget target) {
        ride(snapshot, alpha, camera);
        camera.position(eye);
        camera.forward(forward);
        instances.update(snapshot, eye, ShadowCascades.CASTER_LIMIT, tint);
        Vector3d anchor = instances.anchor();
        eye.sub(anchor);
        light.towardsSun(sun);

        ShadowCascades shadows = light.shadows() ? shadowMap(target) : null;
        instances.bind();
        if (shadows != null) {
            shadows.draw(alpha, sun, eye, forward, effects.cascades());
        }
        double aspect = (double) target.width() / target.height();
        clipFromAnchored
                .setPerspective(camera.fieldOfView(), aspect, camera.near(), camera.far())
                .rotateX(-camera.pitch())
                .rotateY(camera.yaw())
                .translate(-eye.x, -eye.y, -eye.z);
        pass.cull(clipFromAnchored);
        if (effects.occlusion()) {
            occlusion(target)
                    .draw(pass, alpha, clipFromAnchored, eye, Math.tan(camera.fieldOfView() / 2));
        }
        target.bind();
        glViewport(0, 0, target.width(), target.height());
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        drawScene(alpha, light, shadows, camera);
        drawSky(camera, aspect, light);
        drawGlass();
        if (overlay != null) {
            overlay.draw(clipFromAnchored, anchor, target.width(), target.height());
        }
        target.resolve();
    }

    private void ride(PoseSnapshot snapshot, double alpha, Camera camera) {
        long entity = camera.followed();
        if (entity == Camera.NOTHING) {
            return;
        }
        for (int row = 0; row < snapshot.size(); row++) {
            if (snapshot.entity(row) == entity) {
                double[] a = snapshot.previous();
                double[] b = snapshot.current();
                int at = row * PoseSnapshot.STRIDE;
                camera.rideOn(
                        a[at] + alpha * (b[at] - a[at]),
                        a[at + 1] + alpha * (b[at + 1] - a[at + 1]),
                        a[at + 2] + alpha * (b[at + 2] - a[at + 2]),
                        2 * Math.atan2(mixed(a, b, at, 4, alpha), mixed(a, b, at, 6, alpha)));
                return;
            }
        }
    }

    /** A part of the orientation between two ticks, the short way round, not normalised. */
    private static double mixed(double[] a, double[] b, int at, int part, double alpha) {
        double same = 0;
        for (int i = 3; i < 7; i++) {
            same += a[at + i] * b[at + i];
        }
        double to = same < 0 ? -b[at + part] : b[at + part];
        return a[at + part] + alpha * (to - a[at + part]);
    }

    private ShadowCascades shadowMap(FrameTarget target) {
        int longer = Math.max(target.width(), target.height());
        int wanted = Integer.highestOneBit(Math.max(1, longer - 1)) << 1;
        int size = Math.clamp(frugal ? wanted / 2 : wanted, MIN_SHADOW_SIZE, MAX_SHADOW_SIZE);
        ShadowCascades map = shadowMap;
        if (map == null || map.size() != size) {
            if (map != null) {
                map.close();
            }
            map = new ShadowCascades(size, instances);
            shadowMap = map;
        }
        return map;
    }

    private Occlusion occlusion(FrameTarget target) {
        Occlusion map = occlusion;
        if (map == null || map.width != target.width() || map.height != target.height()) {
            if (map != null) {
                map.close();
            }
            map = new Occlusion(target.width(), target.height(), emptyVertexArray);
            occlusion = map;
        }
        return map;
    }

    private void drawScene(
            double alpha, Light light, @Nullable ShadowCascades shadows, Camera camera) {
        programs.scene.use();
        SceneUniforms uniforms = programs.uniforms;
        uniforms.set(light, alpha, clipFromAnchored, eye, sun);
        uniforms.setOcclusion(camera.near(), camera.far());
        if (effects.skyLight()) {
            skyTable.bind(light);
        }
        if (occlusion != null) {
            occlusion.bind();
        }
        uniforms.setShadows(shadows, effects.softShadows());
        glActiveTexture(GL_TEXTURE0);
        glassBatches = drawBatches(true);
    }

    /**
     * Draws the batches that are solid, or the others.
     *
     * @return how many there are of the others
     */
    private int drawBatches(boolean solid) {
        int others = 0;
        for (int b = 0; b < pass.batches(); b++) {
            GpuTexture texture = instances.batch(b).gpuTexture;
            if (texture == null || !pass.isVisible(b)) {
                continue;
            }
            if (pass.isSolid(b) == solid) {
                texture.bind();
                programs.uniforms.setTexture(instances.batch(b).texture);
                pass.draw(b);
            } else {
                others++;
            }
        }
        return others;
    }

    /** After all that may be seen through it. */
    private void drawGlass() {
        if (glassBatches == 0) {
            return;
        }
        programs.scene.use();
        glEnable(GL_BLEND);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glDepthMask(false);
        drawBatches(false);
        glDepthMask(true);
        glDisable(GL_BLEND);
    }

    private void drawSky(Camera camera, double aspect, Light light) {
        double tan = Math.tan(camera.fieldOfView() / 2);
        right.set(1, 0, 0).rotateY(-camera.yaw());
        up.set(right).cross(forward);
        Programs sky = programs;
        sky.sky.use();
        ShaderProgram.set(sky.forward, forward.x, forward.y, forward.z);
        ShaderProgram.set(
                sky.right, right.x * tan * aspect, right.y * tan * aspect, right.z * tan * aspect);
        ShaderProgram.set(sky.up, up.x * tan, up.y * tan, up.z * tan);
        SceneUniforms.setColour(sky.zenith, light.zenithRgb());
        SceneUniforms.setColour(sky.horizon, light.horizonRgb());
        glBindVertexArray(emptyVertexArray);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    /**
     * Chooses what the colours of bodies tell, where snapshots bring debug data.
     *
     * @param value which; {@code NONE} for their own colours
     */
    public void tint(Tints.Kind value) {
        tint = value;
    }

    /**
     * Chooses what is drawn over the scene and behind nothing, such as lines that explain it.
     *
     * @param value called in each frame, or null
     */
    public void overlay(@Nullable SceneOverlay value) {
        overlay = value;
    }

    /**
     * How often poses were written to graphics memory so far.
     *
     * @return the count; it does not grow when the same snapshot is drawn again
     */
    public int uploads() {
        return instances.uploads();
    }

    /**
     * How many models the last frame drew; the others were outside of the picture.
     *
     * @return the count
     */
    public int drawn() {
        return pass.drawn();
    }

    @Override
    public void close() {
        pass.close();
        if (shadowMap != null) {
            shadowMap.close();
        }
        instances.close();
        if (occlusion != null) {
            occlusion.close();
        }
        skyTable.close();
        programs.close();
        GlObjects.deleteVertexArray(emptyVertexArray);
    }
}
