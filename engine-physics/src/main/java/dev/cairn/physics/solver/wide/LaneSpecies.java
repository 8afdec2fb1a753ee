package dev.cairn.physics.solver.wide;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodHandles.Lookup;

/** The vector shape of a kernel's class, which was made for one number of lanes. */
final class LaneSpecies {
    private LaneSpecies() {}

    /** Of a hidden class whose class data is its number of lanes, 4 or 8. */
    static VectorSpecies<Double> doubles(Lookup kernel) {
        return lanes(kernel) == 4 ? DoubleVector.SPECIES_256 : DoubleVector.SPECIES_512;
    }

    /** The same in single precision. */
    static VectorSpecies<Float> floats(Lookup kernel) {
        return lanes(kernel) == 4 ? FloatVector.SPECIES_128 : FloatVector.SPECIES_256;
    }

    private static int lanes(Lookup kernel) {
        try {
            return MethodHandles.classData(kernel, "_", Integer.class);
        } catch (IllegalAccessException refused) {
            throw new ExceptionInInitializerError(refused);
        }
    }
}
