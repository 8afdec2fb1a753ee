package dev.cairn.physics.narrowphase.oracle;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.SplittableRandom;

/** A pair with poses, and random ones. */
public final class Scene {
    public Shape a, b;
    public Quaterniond qa = new Quaterniond(), qb = new Quaterniond();
    public Vector3d d = new Vector3d();

    public Scene(Shape a, Shape b) {
        this.a = a;
        this.b = b;
    }

    public Scene at(double x, double y, double z) {
        d.set(x, y, z);
        return this;
    }

    public Scene swapped() {
        Scene s = new Scene(b, a);
        s.qa = qb;
        s.qb = qa;
        s.d = d.negate(new Vector3d());
        return s;
    }

    public double distance(NarrowPhase n) {
        return n.distance(a, b, qa.x, qa.y, qa.z, qa.w, qb.x, qb.y, qb.z, qb.w, d.x, d.y, d.z);
    }

    public long collide(NarrowPhase n, double margin, long cache, Manifold out) {
        return n.collide(
                a, b, qa.x, qa.y, qa.z, qa.w, qb.x, qb.y, qb.z, qb.w, d.x, d.y, d.z, margin, cache,
                out);
    }

    public ConvexOracle.Placed placedA() {
        return new ConvexOracle.Placed(a, qa, 0, 0, 0);
    }

    public ConvexOracle.Placed placedB() {
        return new ConvexOracle.Placed(b, qb, d.x, d.y, d.z);
    }

    public double size() {
        return a.outerRadius() + b.outerRadius();
    }

    public static double gauss(SplittableRandom r) {
        return r.nextDouble() + r.nextDouble() + r.nextDouble() - 1.5;
    }

    public static Quaterniond turn(SplittableRandom r) {
        return new Quaterniond(gauss(r), gauss(r), gauss(r), gauss(r)).normalize();
    }

    public static Vector3d direction(SplittableRandom r) {
        return new Vector3d(gauss(r), gauss(r), gauss(r)).normalize();
    }

    public static double logUniform(SplittableRandom r, double low, double high) {
        return low * StrictMath.exp(r.nextDouble() * StrictMath.log(high / low));
    }

    public static Box box(SplittableRandom r) {
        return Box.ofHalfExtents(
                logUniform(r, .1, 10), logUniform(r, .1, 10), logUniform(r, .1, 10));
    }

    public static ConvexHull hull(SplittableRandom r, int points, double size) {
        double[] xyz = new double[3 * points];
        for (int i = 0; i < points; i++) {
            Vector3d p = direction(r).mul(size * (.5 + .5 * r.nextDouble()));
            xyz[3 * i] = p.x;
            xyz[3 * i + 1] = p.y;
            xyz[3 * i + 2] = p.z;
        }
        return ConvexHull.of(xyz);
    }

    /** Random turns; the centres so far apart that about half of the pairs overlap. */
    public static Scene random(SplittableRandom r, Shape a, Shape b) {
        Scene s = new Scene(a, b);
        s.qa = turn(r);
        s.qb = turn(r);
        s.d = direction(r).mul(r.nextDouble() * .9 * s.size());
        return s;
    }
}
