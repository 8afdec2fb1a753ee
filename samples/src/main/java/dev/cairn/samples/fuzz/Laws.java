package dev.cairn.samples.fuzz;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.samples.overlap.Penetration;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;

import org.joml.Matrix3d;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** Runs a world and looks which laws it breaks. One thread, an object to a run. */
public final class Laws {
    /** Visible rest: no point moves by more than this share of the outer radius in a second. */
    private static final double VISIBLE = 1e-3;

    /** Seconds of visible rest after which a body must sleep. */
    private static final double SLEEPS_WITHIN = 3;

    private static final double RESTS_FOR = 1;

    private final FuzzWorld fuzz;
    private final Map<Law, Breach> broken = new EnumMap<>(Law.class);
    private final List<BodyRef> bodies = new ArrayList<>();
    private final List<JointRef> joints = new ArrayList<>();
    private final Vector3d at = new Vector3d();
    private final Vector3d other = new Vector3d();

    /**
     * By body: centre of mass and outer radius at the start of its visible rest, and since when.
     */
    private double[] place = {};

    private double[] radius = {};
    private double[] mass = {};
    private double[] restsSince = {};

    /** By body: it has been beyond the edge of the floor, or hangs on who has. */
    private boolean[] gone = {};

    private double seconds;

    private double firstEnergy;
    private double energyScale;
    private final Vector3d firstMomentum = new Vector3d();
    private final Vector3d firstAngular = new Vector3d();
    private double momentumScale;
    private double angularScale;

    private Laws(FuzzWorld fuzz) {
        this.fuzz = fuzz;
    }

    /**
     * Runs a world.
     *
     * @param fuzz the world
     * @param bits whether it is run a second time, with another number of workers and lanes
     * @return the laws that it breaks, each with its first breach; empty if it breaks none
     */
    public static Map<Law, Breach> broken(FuzzWorld fuzz, boolean bits) {
        Laws laws = new Laws(fuzz);
        laws.run(bits);
        return laws.broken;
    }

    private void run(boolean bits) {
        double[] ticks = fuzz.tickSeconds();
        long[] digests = new long[bits ? ticks.length : 0];
        int tick = 0;
        try (PhysicsWorld world = fuzz.build(1, fuzz.settings(1), bodies)) {
            joints.addAll(world.joints().all());
            begin(world);
            for (; tick < ticks.length; tick++) {
                world.step(ticks[tick]);
                seconds += ticks[tick];
                look(world, tick + 1);
                if (bits) {
                    digests[tick] = world.digest();
                }
            }
            end(tick);
        } catch (RuntimeException | AssertionError failed) {
            breach(Law.FAILURE, 1, tick + 1, String.valueOf(failed));
            return;
        }
        if (bits) {
            again(ticks, digests);
        }
    }

    private void again(double[] ticks, long[] digests) {
        PhysicsSettings other = fuzz.settings(fuzz.index() % 2 == 0 ? 4 : 8);
        try (PhysicsWorld world = fuzz.build(2, other, new ArrayList<>())) {
            for (int t = 0; t < ticks.length; t++) {
                world.step(ticks[t]);
                if (world.digest() != digests[t]) {
                    breach(Law.BITS, 1, t + 1, "");
                    return;
                }
            }
        }
    }

    private void breach(Law law, double value, int tick, String note) {
        if (!(value <= law.bound())) {
            Breach known = broken.get(law);
            if (known == null) {
                broken.put(law, new Breach(law, value, tick, note));
            } else if (value > known.value()) {
                broken.put(law, new Breach(law, value, known.tick(), known.note()));
            }
        }
    }

    private void begin(PhysicsWorld world) {
        int n = bodies.size();
        place = new double[3 * n];
        radius = new double[n];
        mass = new double[n];
        restsSince = new double[n];
        gone = new boolean[n];
        double pull = -fuzz.scene().gravity().y();
        firstEnergy = world.kineticEnergy() + world.potentialEnergy();
        energyScale = firstEnergy;
        for (int i = 0; i < n; i++) {
            BodyRef body = bodies.get(i);
            EntitySpec entity = fuzz.scene().entities().get(i);
            if (!fuzz.scene().joints().isEmpty() || entity.body() == BodyKind.DYNAMIC) {
                radius[i] = Extent.outer(entity);
            }
            if (entity.body() != BodyKind.DYNAMIC) {
                continue;
            }
            mass[i] = body.mass();
            energyScale += mass[i] * pull * radius[i];
            body.centreOfMass(at);
            Vector3d momentum = body.velocity().mul(mass[i]);
            momentumScale += momentum.length();
            Vector3d spin = body.angularVelocity();
            if (spin.lengthSquared() > 0) {
                body.inverseInertia(new Matrix3d()).invert().transform(spin);
            }
            angularScale += spin.length() + momentum.length() * (at.length() + radius[i]);
        }
        Kinetics k = world.kinetics();
        firstMomentum.set(k.momentumX(), k.momentumY(), k.momentumZ());
        firstAngular.set(k.angularMomentumX(), k.angularMomentumY(), k.angularMomentumZ());
    }

    private void look(PhysicsWorld world, int tick) {
        breach(Law.FINITE, world.quarantined().size(), tick, "");
        if (energyScale > 0 && !fuzz.isDriven()) {
            double energy = world.kineticEnergy() + world.potentialEnergy();
            breach(Law.ENERGY, (energy - firstEnergy) / energyScale, tick, "");
        }
        if (fuzz.isFree() && momentumScale > 0) {
            Kinetics k = world.kinetics();
            at.set(k.momentumX(), k.momentumY(), k.momentumZ()).sub(firstMomentum);
            breach(Law.MOMENTUM, at.length() / momentumScale, tick, "");
            at.set(k.angularMomentumX(), k.angularMomentumY(), k.angularMomentumZ())
                    .sub(firstAngular);
            breach(Law.ANGULAR, at.length() / angularScale, tick, "");
        }
        for (int i = 0; i < mass.length; i++) {
            if (mass[i] > 0) {
                body(i, tick);
            }
        }
        for (int k = 0; k < joints.size(); k++) {
            JointSpec joint = fuzz.scene().joints().get(k);
            gone[joint.a()] |= gone[joint.b()];
            gone[joint.b()] |= gone[joint.a()];
            joint(k, tick);
        }
    }

    /** A gap is told as the larger of metres and radians, so the metres are looked at alone too. */
    private void joint(int k, int tick) {
        JointSpec spec = fuzz.scene().joints().get(k);
        JointRef joint = joints.get(k);
        double least = Math.min(radius[spec.a()], radius[spec.b()]);
        double gap = joint.gap() / Math.max(1, least);
        switch (spec.kind()) {
            case "rope", "rod", "slider" -> {}
            default ->
                    gap = Math.max(gap, joint.anchorA(at).distance(joint.anchorB(other)) / least);
        }
        breach(Law.GAP, gap, tick, spec.kind() + " " + k);
    }

    private void body(int i, int tick) {
        BodyRef body = bodies.get(i);
        body.centreOfMass(at);
        double out = -Double.MAX_VALUE;
        double room = fuzz.room();
        if (room < Double.POSITIVE_INFINITY) {
            out = Math.max(Math.abs(at.x), Math.abs(at.z)) - room;
            out = Math.max(out, at.y - 2 * room);
        }
        gone[i] |= Math.max(Math.abs(at.x), Math.abs(at.z)) >= fuzz.floor() - radius[i];
        if (fuzz.scene().gravity().y() != 0 && !gone[i]) {
            out = Math.max(out, -at.y);
        }
        breach(Law.WALLS, out / radius[i], tick, "body " + i);
        breach(Law.SINK, out / radius[i], tick, "body " + i);
        double turn = body.angularVelocity().length() * radius[i];
        double speed = body.velocity().length() + turn;
        double moved =
                Math.abs(at.x - place[3 * i])
                        + Math.abs(at.y - place[3 * i + 1])
                        + Math.abs(at.z - place[3 * i + 2]);
        boolean still = speed <= VISIBLE * radius[i] && moved <= 3 * VISIBLE * radius[i];
        if (!still) {
            restsSince[i] = seconds;
            place[3 * i] = at.x;
            place[3 * i + 1] = at.y;
            place[3 * i + 2] = at.z;
        }
    }

    private void end(int tick) {
        double longest = Double.POSITIVE_INFINITY;
        int awake = 0;
        for (int i = 0; i < mass.length; i++) {
            if (mass[i] > 0) {
                longest = Math.min(longest, seconds - restsSince[i]);
                awake += bodies.get(i).isAsleep() ? 0 : 1;
            }
        }
        if (fuzz.scene().gravity().y() == 0 || longest < RESTS_FOR || fuzz.movers() == 0) {
            return;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < mass.length; i++) {
            if (mass[i] > 0) {
                least = Math.min(least, Extent.inner(fuzz.scene().entities().get(i)));
            }
        }
        breach(Law.OVERLAP, Penetration.deepest(bodies, joints) / least, tick, "");
        if (fuzz.sleeping() && longest > SLEEPS_WITHIN) {
            breach(Law.SLEEP, awake, tick, "");
        }
    }
}
