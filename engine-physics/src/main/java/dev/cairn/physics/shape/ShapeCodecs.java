package dev.cairn.physics.shape;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Function;

/**
 * How shapes become bytes: by what they were made of, so that they come back with the same bits. A
 * hull is written with its faces, since what finds them may find them in another order.
 */
public final class ShapeCodecs {
    private ShapeCodecs() {}

    /**
     * A codec to each kind of shape.
     *
     * @return codecs
     */
    public static List<StateCodec<?>> all() {
        return List.of(
                codec(
                        Sphere.class,
                        (s, out) -> out.writeDouble(s.radius()),
                        in -> Sphere.of(in.readDouble())),
                codec(
                        Box.class,
                        (s, out) -> {
                            out.writeDouble(s.halfX());
                            out.writeDouble(s.halfY());
                            out.writeDouble(s.halfZ());
                        },
                        in -> Box.ofHalfExtents(in.readDouble(), in.readDouble(), in.readDouble())),
                codec(
                        Capsule.class,
                        (s, out) -> {
                            out.writeDouble(s.radius());
                            out.writeDouble(s.halfLength());
                        },
                        in -> Capsule.of(in.readDouble(), in.readDouble())),
                codec(
                        Cylinder.class,
                        (s, out) -> {
                            out.writeDouble(s.radius());
                            out.writeDouble(s.halfHeight());
                        },
                        in -> Cylinder.of(in.readDouble(), in.readDouble())),
                codec(
                        Cone.class,
                        (s, out) -> {
                            out.writeDouble(s.radius());
                            out.writeDouble(s.halfHeight());
                        },
                        in -> Cone.of(in.readDouble(), in.readDouble())),
                codec(HalfSpace.class, (s, out) -> {}, in -> HalfSpace.of()),
                codec(ConvexHull.class, ShapeCodecs::write, ShapeCodecs::readHull),
                codec(TriangleMesh.class, TriangleMesh::write, TriangleMesh::read),
                codec(HeightField.class, HeightField::write, HeightField::read),
                codec(Moved.class, ShapeCodecs::write, ShapeCodecs::readMoved));
    }

    private static void write(ConvexHull hull, StateOutput out) {
        out.writeDoubles(hull.vertices());
        MassProperties unit = hull.massProperties(1);
        out.writeDoubles(
                new double[] {
                    unit.mass(),
                    unit.comX(),
                    unit.comY(),
                    unit.comZ(),
                    unit.ixx(),
                    unit.iyy(),
                    unit.izz(),
                    unit.ixy(),
                    unit.ixz(),
                    unit.iyz()
                });
        int[][] loops = hull.faceLoops();
        out.writeInt(loops.length);
        for (int[] loop : loops) {
            out.writeInts(loop);
        }
    }

    private static ConvexHull readHull(StateInput in) {
        double[] corners = in.readDoubles();
        double[] m = in.readDoubles();
        int faces = in.readInt();
        if (faces < 4 || faces > Polyhedron.MAX_VERTICES * 2 || m.length != 10) {
            throw new IllegalArgumentException("a hull with " + faces + " faces");
        }
        int[][] loops = new int[faces][];
        for (int f = 0; f < faces; f++) {
            loops[f] = in.readInts();
        }
        MassProperties unit =
                new MassProperties(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9]);
        return ConvexHull.restored(corners, unit, loops);
    }

    private static void write(Moved s, StateOutput out) {
        out.writeObject(s.inner());
        out.writeDoubles(s.numbers());
    }

    private static Moved readMoved(StateInput in) {
        Shape inner = in.readObject(Shape.class);
        double[] n = in.readDoubles();
        return new Moved(inner, n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
    }

    private static <S extends Shape> StateCodec<S> codec(
            Class<S> type, BiConsumer<S, StateOutput> writing, Function<StateInput, S> reading) {
        return StateCodec.of(type, "shape." + type.getSimpleName(), writing, reading);
    }
}
