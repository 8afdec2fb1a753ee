package dev.cairn.physics.narrowphase.oracle;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/** Poses of two shapes that something failed on, and the true distance. */
public class FailureCases {
    /** Rotation and position, as the issues print them. */
    public record Pose(Quaterniond turn, Vector3d at) {
        public static Pose at(double x, double y, double z) {
            return new Pose(new Quaterniond(), new Vector3d(x, y, z));
        }

        public static Pose rows(double... m) {
            Matrix3d r = new Matrix3d(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]);
            Quaterniond q = new Quaterniond().setFromUnnormalized(r).normalize();
            return new Pose(q, new Vector3d(m[3], m[7], m[11]));
        }
    }

    public record Case(String source, Scene scene, double truth) {
        @Override
        public String toString() {
            return source;
        }
    }

    protected static Vector3d at(double x, double y, double z) {
        return new Vector3d(x, y, z);
    }

    protected static Box box(double x, double y, double z) {
        return Box.ofHalfExtents(x / 2, y / 2, z / 2);
    }

    /** A cylinder along z. */
    protected static Shape cylinder(double radius, double length) {
        Quaterniond upright = new Quaterniond().rotationX(StrictMath.PI / 2);
        return Cylinder.of(radius, length / 2).moved(0, 0, 0, upright);
    }

    protected static Scene scene(Shape a, Pose pa, Shape b, Pose pb) {
        Scene s = new Scene(a, b);
        s.qa = pa.turn;
        s.qb = pb.turn;
        s.d = pb.at.sub(pa.at, new Vector3d());
        return s;
    }

    public final List<Case> cases = new ArrayList<>();

    protected final void boxes(String source, Box a, Pose pa, Box b, Pose pb) {
        Scene s = scene(a, pa, b, pb);
        double truth = ConvexOracle.separatingAxes(s.placedA(), s.placedB());
        if (truth > 0) {
            truth = ConvexOracle.distance(s.placedA(), s.placedB());
        }
        cases.add(new Case(source, s, truth));
    }

    protected final void known(String source, Shape a, Pose pa, Shape b, Pose pb, double truth) {
        cases.add(new Case(source, scene(a, pa, b, pb), truth));
    }

    protected final void reach(String source, Shape a, Pose pa, Shape b, Pose pb) {
        cases.add(new Case(source, scene(a, pa, b, pb), Double.NaN));
    }
}
