package dev.cairn.benchmarks.peer;

import com.github.stephengold.joltjni.AllHitCollideShapeCollector;
import com.github.stephengold.joltjni.BoxShape;
import com.github.stephengold.joltjni.CapsuleShape;
import com.github.stephengold.joltjni.CollideShapeSettings;
import com.github.stephengold.joltjni.CollisionDispatch;
import com.github.stephengold.joltjni.ConvexHullShapeSettings;
import com.github.stephengold.joltjni.Jolt;
import com.github.stephengold.joltjni.Mat44;
import com.github.stephengold.joltjni.Quat;
import com.github.stephengold.joltjni.ShapeFilter;
import com.github.stephengold.joltjni.ShapeResult;
import com.github.stephengold.joltjni.SphereShape;
import com.github.stephengold.joltjni.SubShapeIdCreator;
import com.github.stephengold.joltjni.Vec3;
import com.github.stephengold.joltjni.enumerate.ECollectFacesMode;
import com.github.stephengold.joltjni.readonly.ConstShape;
import com.github.stephengold.joltjni.readonly.Vec3Arg;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniondc;
import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;

/**
 * Jolt's {@code CollisionDispatch::sCollideShapeVsShape}: axis, depth and the two faces, which Jolt
 * clips afterwards, when it makes a manifold. Default convex radius.
 */
final class JoltPairs implements PairCalls {
    private final List<ConstShape> a = new ArrayList<>(), b = new ArrayList<>();
    private final List<Mat44> poseA = new ArrayList<>(), poseB = new ArrayList<>();
    private final IdentityHashMap<Shape, ConstShape> made = new IdentityHashMap<>();
    private final List<Object> kept = new ArrayList<>();
    private final Vec3 one = new Vec3(1, 1, 1);
    private final SubShapeIdCreator idA, idB;
    private final CollideShapeSettings settings;
    private final ShapeFilter filter;

    JoltPairs() {
        JoltPeer.prepare();
        idA = new SubShapeIdCreator();
        idB = new SubShapeIdCreator();
        filter = new ShapeFilter();
        settings = new CollideShapeSettings();
        settings.setCollectFacesMode(ECollectFacesMode.CollectFaces);
        settings.setMaxSeparationDistance(0.02f);
    }

    @Override
    public String title() {
        return Engine.JOLT.version() + ", sCollideShapeVsShape";
    }

    @Override
    public void add(Shape a, Quaterniondc turnA, Shape b, Quaterniondc turnB, Vector3dc offset) {
        this.a.add(made.computeIfAbsent(a, this::shape));
        this.b.add(made.computeIfAbsent(b, this::shape));
        poseA.add(Mat44.sRotation(quaternion(turnA)));
        Vec3 at = new Vec3((float) offset.x(), (float) offset.y(), (float) offset.z());
        poseB.add(Mat44.sRotationTranslation(quaternion(turnB), at));
    }

    private static Quat quaternion(Quaterniondc q) {
        return new Quat((float) q.x(), (float) q.y(), (float) q.z(), (float) q.w());
    }

    private ConstShape shape(Shape shape) {
        return switch (shape) {
            case Box x ->
                    new BoxShape(new Vec3((float) x.halfX(), (float) x.halfY(), (float) x.halfZ()));
            case Sphere s -> new SphereShape((float) s.radius());
            case Capsule c -> new CapsuleShape((float) c.halfLength(), (float) c.radius());
            case ConvexHull h -> {
                float[] xyz = SceneDescription.Solid.points(h);
                List<Vec3Arg> points = new ArrayList<>();
                for (int i = 0; i < xyz.length; i += 3) {
                    points.add(new Vec3(xyz[i], xyz[i + 1], xyz[i + 2]));
                }
                ConvexHullShapeSettings recipe =
                        new ConvexHullShapeSettings(points, Jolt.cDefaultConvexRadius);
                ShapeResult result = recipe.create();
                kept.add(recipe);
                kept.add(result);
                yield result.get();
            }
            default -> throw new IllegalArgumentException("Jolt pairs: no " + shape);
        };
    }

    @Override
    public int run() {
        AllHitCollideShapeCollector hits = new AllHitCollideShapeCollector();
        for (int i = 0; i < a.size(); i++) {
            CollisionDispatch.sCollideShapeVsShape(
                    a.get(i),
                    b.get(i),
                    one,
                    one,
                    poseA.get(i),
                    poseB.get(i),
                    idA,
                    idB,
                    settings,
                    hits,
                    filter);
        }
        return hits.getHits().size();
    }

    @Override
    public long cross() {
        long sum = 0;
        for (int i = 0; i < a.size(); i++) {
            sum += a.get(i).getSubShapeIdBitsRecursive();
        }
        return sum;
    }
}
