package dev.cairn.render.mesh;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import java.util.Objects;

/**
 * How an entity looks: a mesh, scaled and shifted, with a texture and a colour. It is what {@code
 * Visual.model} holds. Immutable; the {@code with}-like methods return changed copies. Entities
 * that share mesh and texture are drawn in one call, whatever their colours and scales.
 *
 * @param mesh triangles, in the mesh's frame
 * @param texture picture; its colour is multiplied by {@code rgb}
 * @param rgb colour, 0xRRGGBB in sRGB
 * @param scaleX factor along the mesh's x axis, &gt; 0
 * @param scaleY factor along the mesh's y axis, &gt; 0
 * @param scaleZ factor along the mesh's z axis, &gt; 0
 * @param originX the point of the scaled mesh that lies at the entity's pose, metres, x
 * @param originY same, y
 * @param originZ same, z
 */
public record Model(
        Mesh mesh,
        Texture texture,
        int rgb,
        double scaleX,
        double scaleY,
        double scaleZ,
        double originX,
        double originY,
        double originZ) {
    private static final int[] PALETTE = {
        0xE07A5F, 0x3D8BBD, 0xF2B84B, 0x5FA777, 0xB76BA3, 0x4E5D8C, 0xD9573F, 0x6BBFB0, 0xC9A66B,
        0x8F6BC2, 0x9DBF4F, 0xE29BB1
    };

    /** Checks the ranges. */
    public Model {
        Objects.requireNonNull(mesh, "mesh");
        Objects.requireNonNull(texture, "texture");
        checkScale("scaleX", scaleX);
        checkScale("scaleY", scaleY);
        checkScale("scaleZ", scaleZ);
        checkFinite("originX", originX);
        checkFinite("originY", originY);
        checkFinite("originZ", originZ);
    }

    /**
     * A mesh without texture, in light grey, at its own size.
     *
     * @param mesh what to draw
     * @return the model
     */
    public static Model of(Mesh mesh) {
        return new Model(mesh, Texture.WHITE, 0xD9D9D9, 1, 1, 1, 0, 0, 0);
    }

    /**
     * A collision shape as it is, in the shape's frame.
     *
     * @param shape which one
     * @return the model; all boxes share one mesh, so do all spheres, cylinders, cones and
     *     half-spaces; each hull, capsule and moved shape has one
     */
    public static Model of(Shape shape) {
        return switch (shape) {
            case Box box ->
                    of(Meshes.CUBE)
                            .texture(Texture.panel())
                            .scale(box.halfX(), box.halfY(), box.halfZ());
            case Sphere sphere ->
                    of(Meshes.BALL).texture(Texture.beachBall()).scale(sphere.radius());
            case ConvexHull hull -> of(Meshes.hull(hull));
            case Cylinder cylinder ->
                    of(Meshes.CYLINDER)
                            .texture(Texture.panel())
                            .scale(cylinder.radius(), cylinder.halfHeight(), cylinder.radius());
            case Cone cone ->
                    of(Meshes.CONE)
                            .texture(Texture.panel())
                            .scale(cone.radius(), cone.halfHeight(), cone.radius());
            case Capsule capsule -> of(Meshes.of(capsule)).texture(Texture.beachBall());
            case HalfSpace ground -> of(Meshes.GROUND).texture(Texture.grid().tiledEvery(2));
            case TriangleMesh mesh ->
                    of(Meshes.triangles(mesh)).texture(Texture.grid().tiledEvery(2));
            case HeightField field ->
                    of(Meshes.ground(field)).texture(Texture.grid().tiledEvery(2));
            case Moved moved -> of(Meshes.of(moved));
        };
    }

    /**
     * A collision shape as a floor or a wall: grey, with a grid of one-metre squares.
     *
     * @param shape which one
     * @return the model
     */
    public static Model ground(Shape shape) {
        return of(shape).texture(Texture.grid().tiledEvery(2)).color(0xC9CDD2);
    }

    /**
     * What is drawn where a mesh cannot be read: a cube from (-1, -1, -1) to (1, 1, 1) with a
     * checker of magenta and black.
     *
     * @return the model
     */
    public static Model placeholder() {
        return of(Meshes.CUBE).texture(Texture.missing()).color(0xFFFFFF);
    }

    /**
     * One of twelve colours that can be told apart and look well together.
     *
     * @param index any number; they repeat
     * @return 0xRRGGBB in sRGB
     */
    public static int paletteColor(int index) {
        return PALETTE[Math.floorMod(index, PALETTE.length)];
    }

    /**
     * The same in another colour.
     *
     * @param newRgb 0xRRGGBB in sRGB
     * @return a copy
     */
    public Model color(int newRgb) {
        return new Model(mesh, texture, newRgb, scaleX, scaleY, scaleZ, originX, originY, originZ);
    }

    /**
     * The same with another texture.
     *
     * @param newTexture picture
     * @return a copy
     */
    public Model texture(Texture newTexture) {
        return new Model(mesh, newTexture, rgb, scaleX, scaleY, scaleZ, originX, originY, originZ);
    }

    /**
     * The same at another size, on top of the present scale.
     *
     * @param factor &gt; 0
     * @return a copy
     */
    public Model scale(double factor) {
        return scale(factor, factor, factor);
    }

    /**
     * The same at another size along each axis of the mesh, on top of the present scale.
     *
     * @param x factor, &gt; 0
     * @param y factor, &gt; 0
     * @param z factor, &gt; 0
     * @return a copy
     */
    public Model scale(double x, double y, double z) {
        return new Model(
                mesh,
                texture,
                rgb,
                scaleX * x,
                scaleY * y,
                scaleZ * z,
                originX * x,
                originY * y,
                originZ * z);
    }

    /**
     * The same, with another point of the scaled mesh at the entity's pose.
     *
     * @param x metres in the mesh's frame after scaling
     * @param y metres
     * @param z metres
     * @return a copy
     */
    public Model origin(double x, double y, double z) {
        return new Model(mesh, texture, rgb, scaleX, scaleY, scaleZ, x, y, z);
    }

    /**
     * The farthest that any point of the model can be from the entity's position.
     *
     * @return metres
     */
    public double radius() {
        return mesh.radius() * Math.max(scaleX, Math.max(scaleY, scaleZ))
                + Math.sqrt(originX * originX + originY * originY + originZ * originZ);
    }

    private static void checkScale(String name, double value) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(name + " is " + value + ", expected > 0 and finite");
        }
    }

    private static void checkFinite(String name, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(
                    name + " is " + value + ", expected a finite number");
        }
    }
}
