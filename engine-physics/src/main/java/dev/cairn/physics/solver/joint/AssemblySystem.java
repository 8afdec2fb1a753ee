package dev.cairn.physics.solver.joint;

/** The linear system of an assembly: bodies and joints are its nodes, in this order. */
interface AssemblySystem {
    /** First unknown of a node. */
    int unknown(int node);

    /** Right-hand side, then the solution. */
    double[] x();
}
