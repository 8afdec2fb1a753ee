package dev.cairn.physics.state;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.List;
import java.util.SplittableRandom;

/**
 * A user who does to a world what users do while it runs: adds, removes, pushes, moves, retunes.
 * What is done at a tick is a function of the seed, the tick and how many bodies and joints there
 * are, so that equal worlds are treated alike. Axes are not locked: of what joints do to bodies
 * with locked axes not all is bounded yet, see docs/joints.md.
 */
final class RandomUser {
    /** Odd, so that neighbouring ticks share no stream. */
    private static final long STRIDE = 0x9E3779B97F4A7C15L;

    private static final int MOST_BODIES = 24;

    private final PhysicsWorld world;
    final RandomRules rules;
    private SplittableRandom random = new SplittableRandom();

    /** What was done at the last tick, for messages. */
    final StringBuilder done = new StringBuilder();

    RandomUser(PhysicsWorld world, long seed) {
        this.world = world;
        rules = new RandomRules(world, seed);
    }

    /** What there is at first: a floor, a wall that may be moved, some bodies. */
    void begin(long seed) {
        random = new SplittableRandom(seed * STRIDE);
        Body floor =
                random.nextBoolean()
                        ? Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0)
                        : Body.fixed().shape(HalfSpace.of());
        world.add(floor.material(material()));
        world.add(
                Body.kinematic()
                        .shape(Box.ofHalfExtents(2, 0.2, 2))
                        .at(0, 0.2, 0)
                        .velocity(0, 0, 0.3)
                        .angularVelocity(0, 0.2, 0));
        int count = 3 + random.nextInt(8);
        for (int i = 0; i < count; i++) {
            world.add(body());
        }
    }

    /** Length of the step at a tick, s. */
    static double step(long seed, int tick) {
        SplittableRandom own = new SplittableRandom(seed * STRIDE + tick);
        return seed % 4 == 0 && own.nextInt(8) == 0 ? own.nextDouble(0.001, 0.034) : 1.0 / 60;
    }

    /** Acts before a tick: none, one or a few times. */
    void act(long seed, int tick) {
        random = new SplittableRandom(seed * STRIDE ^ (tick * 0x632BE59BD9B4E019L + 7));
        done.setLength(0);
        if (tick % 97 < 30 && seed % 3 == 0) {
            return; // time to rest
        }
        int actions = random.nextInt(4) - 1;
        for (int i = 0; i < actions; i++) {
            // each has numbers of its own, so that one may be left out in search of a cause
            random = new SplittableRandom(seed * STRIDE ^ ((4L * tick + i) * 0x632BE59BD9B4E019L));
            try {
                one();
            } catch (IllegalArgumentException | IllegalStateException refused) {
                done.append(" refused: ").append(refused.getMessage());
            }
        }
    }

    private void one() {
        List<BodyRef> bodies = world.bodies();
        int kind = random.nextInt(40 + RandomRules.KINDS);
        if (kind < 5 && bodies.size() < MOST_BODIES) {
            note("add");
            world.add(body());
            return;
        }
        BodyRef body = bodies.get(random.nextInt(bodies.size()));
        List<JointRef> joints = world.joints().all();
        done.append(" body ").append(bodies.indexOf(body));
        switch (kind) {
            case 0, 1, 2, 3, 4, 5 -> {
                if (bodies.size() > 4) {
                    note("remove");
                    body.remove();
                }
            }
            case 6 -> {
                note("applyImpulse");
                double m = body.mass();
                body.applyImpulse(m * speed(), m * speed(), m * speed());
            }
            case 7 -> {
                note("applyForceAt");
                Vector3d at = body.position(new Vector3d());
                double m = 20 * body.mass();
                body.applyForceAt(m * speed(), m * speed(), 0, at.x + 0.1, at.y, at.z);
            }
            case 8 -> {
                note("applyTorque");
                body.applyTorque(body.mass() * near(), 0, body.mass() * near());
            }
            case 9 -> {
                note("setVelocity");
                body.setVelocity(speed(), speed(), speed());
            }
            case 10 -> {
                note("setAngularVelocity");
                body.setAngularVelocity(speed(), speed(), speed());
            }
            case 11 -> {
                note("teleport");
                body.teleport(near(), 3 + near(), near());
            }
            case 12 -> {
                note("teleport turned");
                body.teleport(new Vector3d(near(), 2 + near(), near()), turn());
            }
            case 13 -> {
                note("moveTo");
                Vector3d at = body.position(new Vector3d());
                body.moveTo(at.x + 0.05 * near(), at.y + 0.02 * near(), at.z);
            }
            case 14 -> {
                BodyType type = BodyType.values()[random.nextInt(3)];
                note("setType " + type);
                body.setType(type);
            }
            case 15, 16 -> {
                note("setShape");
                body.setShape(shape());
            }
            case 17 -> {
                note("setMaterial");
                body.setMaterial(material());
            }
            case 18 -> {
                note("setMass");
                body.setMass(Math.pow(10, random.nextDouble(-1, 3)));
            }
            case 19 -> {
                note("setInertia");
                double m = random.nextDouble(0.1, 10);
                body.setInertia(m, m * random.nextDouble(1, 1.5), m * random.nextDouble(1, 1.5));
            }
            case 20 -> {
                note("setCentreOfMass");
                body.setCentreOfMass(0.1 * near(), 0.1 * near(), 0.1 * near());
            }
            case 21 -> {
                note("setCanSleep");
                body.setCanSleep(random.nextBoolean());
            }
            case 22 -> {
                note("wake");
                body.wake();
            }
            case 23 -> {
                note("sleep");
                body.sleep();
            }
            case 24 -> {
                note("add collider");
                body.add(Collider.of(shape()).at(0.3 * near(), 0.3 * near(), 0));
            }
            case 25 -> {
                note("add sensor");
                body.add(Collider.of(shape()).sensor(true));
            }
            case 26 -> {
                List<ColliderRef> all = body.colliders();
                note("remove collider");
                all.get(random.nextInt(all.size())).remove();
            }
            case 27 -> {
                List<ColliderRef> all = body.colliders();
                note("replace collider");
                all.get(random.nextInt(all.size())).replace(Collider.of(shape()));
            }
            case 28 -> {
                note("setFilter");
                body.setFilter(random.nextInt(3) > 0 ? Filter.ALL : Filter.NOTHING);
            }
            case 29 -> {
                note("setGravityScale");
                body.setGravityScale(random.nextInt(4) - 1);
            }
            case 30 -> {
                note("setUserData");
                body.setUserData(kind);
            }
            case 31 -> {
                note("setDamping, setSpeedLimit");
                body.setDamping(random.nextDouble(), random.nextDouble());
                body.setSpeedLimit(random.nextDouble(1, 100));
            }
            case 32, 33, 34, 35 -> joint(bodies, body);
            case 36 -> {
                if (!joints.isEmpty()) {
                    note("remove joint");
                    joints.get(random.nextInt(joints.size())).remove();
                }
            }
            case 37 -> {
                if (!joints.isEmpty()) {
                    JointRef joint = joints.get(random.nextInt(joints.size()));
                    note("retune joint");
                    joint.setEnabled(random.nextBoolean());
                    joint.breakAt(random.nextDouble(10, 10_000), random.nextDouble(10, 10_000));
                    joint.motor(JointAxis.TWIST, speed(), 100);
                }
            }
            case 38 -> {
                note("setGravity");
                world.setGravity(0.2 * near(), random.nextInt(4) == 0 ? 0 : -9.81, 0.2 * near());
            }
            case 39 -> {
                note("setSubsteps");
                world.setSubsteps(1 + random.nextInt(8));
            }
            default -> done.append(rules.change(kind - 40, random, body));
        }
    }

    private void joint(List<BodyRef> bodies, BodyRef a) {
        BodyRef b = bodies.get(random.nextInt(bodies.size()));
        int kind = random.nextInt(10);
        note("joint " + kind + " with body " + bodies.indexOf(b));
        Joint joint =
                switch (kind) {
                    case 0 -> Joint.ball(a, b);
                    case 1 -> Joint.hinge(a, b).axis(0, 0, 1).limits(-1, 1);
                    case 2 -> Joint.slider(a, b).axis(1, 0, 0).motor(1, 50);
                    case 3 -> Joint.fixed(a, b);
                    case 4 -> Joint.rod(a, b);
                    case 5 -> Joint.rope(a, b);
                    case 6 -> Joint.spring(a, b, 2, 0.3);
                    case 7 -> Joint.universal(a, b);
                    case 8 -> Joint.cylindrical(a, b).axis(0, 1, 0);
                    default -> Joint.parallel(a, b);
                };
        Vector3d at = a.position(new Vector3d()).add(b.position(new Vector3d())).mul(0.5);
        joint = kind == 4 || kind == 5 || kind == 6 ? joint : joint.at(at.x, at.y, at.z);
        if (random.nextInt(4) == 0) {
            joint = joint.breakAt(500, 500);
        }
        world.add(joint.collide(random.nextBoolean()));
    }

    private void note(String what) {
        done.append(' ').append(what).append(';');
    }

    private Body body() {
        Body body = random.nextInt(8) == 0 ? Body.kinematic() : Body.dynamic();
        body.shape(shape())
                .at(near(), 1 + 2 * random.nextDouble(), near())
                .rotation(turn())
                .material(material());
        if (random.nextInt(3) == 0) {
            body.collider(Collider.of(shape()).at(0.4 * near(), 0.2, 0).rotation(turn()));
        }
        if (random.nextInt(3) == 0) {
            body.velocity(speed(), speed(), speed()).angularVelocity(speed(), speed(), speed());
        }
        return body;
    }

    private Shape shape() {
        double r = random.nextInt(8) == 0 ? 0.02 : random.nextDouble(0.1, 0.6);
        return switch (random.nextInt(7)) {
            case 0, 1 -> Box.ofHalfExtents(r, random.nextDouble(0.05, 0.5), 0.4);
            case 2 -> Sphere.of(r);
            case 3 -> Capsule.of(r, 0.3);
            case 4 -> Cylinder.of(r, 0.2);
            case 5 -> Cone.of(r, 0.3);
            default -> {
                double[] points = new double[30];
                for (int i = 0; i < points.length; i++) {
                    points[i] = random.nextDouble(-0.4, 0.4);
                }
                yield ConvexHull.of(points);
            }
        };
    }

    private Material material() {
        double e = random.nextInt(3) == 0 ? random.nextDouble() : 0;
        return new Material(random.nextDouble(), e, Math.pow(10, random.nextDouble(2, 4)));
    }

    private Quaterniond turn() {
        return random.nextBoolean()
                ? new Quaterniond()
                : new Quaterniond(near(), near(), near(), 1 + random.nextDouble()).normalize();
    }

    private double speed() {
        return random.nextDouble(-5, 5);
    }

    private double near() {
        return random.nextDouble(-2, 2);
    }
}
