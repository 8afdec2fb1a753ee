package dev.cairn.benchmarks.peer;

import com.jme3.bullet.PhysicsSpace;
import com.jme3.bullet.collision.shapes.BoxCollisionShape;
import com.jme3.bullet.collision.shapes.CapsuleCollisionShape;
import com.jme3.bullet.collision.shapes.CollisionShape;
import com.jme3.bullet.collision.shapes.HullCollisionShape;
import com.jme3.bullet.collision.shapes.SphereCollisionShape;
import com.jme3.bullet.objects.PhysicsRigidBody;
import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;

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
 * Bullet's {@code contactPairTest}: it makes a collision algorithm for the pair, runs it and throws
 * it away. Default margin.
 */
final class BulletPairs implements PairCalls {
    private final List<PhysicsRigidBody> a = new ArrayList<>(), b = new ArrayList<>();
    private final IdentityHashMap<Shape, CollisionShape> made = new IdentityHashMap<>();
    private final PhysicsSpace space;

    BulletPairs() {
        BulletPeer.prepare();
        space = new PhysicsSpace(PhysicsSpace.BroadphaseType.DBVT);
    }

    @Override
    public String title() {
        return Engine.BULLET.version() + ", pairTest";
    }

    @Override
    public void add(Shape a, Quaterniondc turnA, Shape b, Quaterniondc turnB, Vector3dc offset) {
        this.a.add(body(a, turnA, 0, 0, 0));
        this.b.add(body(b, turnB, offset.x(), offset.y(), offset.z()));
    }

    private PhysicsRigidBody body(Shape shape, Quaterniondc q, double x, double y, double z) {
        CollisionShape of = made.computeIfAbsent(shape, BulletPairs::shape);
        PhysicsRigidBody body = new PhysicsRigidBody(of, 1);
        body.setPhysicsLocation(new Vector3f((float) x, (float) y, (float) z));
        body.setPhysicsRotation(
                new Quaternion((float) q.x(), (float) q.y(), (float) q.z(), (float) q.w()));
        return body;
    }

    private static CollisionShape shape(Shape shape) {
        return switch (shape) {
            case Box x ->
                    new BoxCollisionShape((float) x.halfX(), (float) x.halfY(), (float) x.halfZ());
            case Sphere s -> new SphereCollisionShape((float) s.radius());
            case Capsule c ->
                    new CapsuleCollisionShape((float) c.radius(), (float) (2 * c.halfLength()), 1);
            case ConvexHull h -> new HullCollisionShape(SceneDescription.Solid.points(h));
            default -> throw new IllegalArgumentException("Bullet pairs: no " + shape);
        };
    }

    @Override
    public int run() {
        int points = 0;
        for (int i = 0; i < a.size(); i++) {
            points += space.pairTest(a.get(i), b.get(i), null);
        }
        return points;
    }

    @Override
    public long cross() {
        long sum = 0;
        for (PhysicsRigidBody body : a) {
            sum += body.userIndex();
        }
        return sum;
    }
}
