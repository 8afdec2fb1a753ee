package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.pair.Pair;

/** The point of a shape's core that is farthest in a direction. One worker's. */
final class Deepest {
    /** From the shape's centre, mesh axes, m. */
    double x, y, z;

    /**
     * Finds it.
     *
     * @param p whose A is the shape, with its orientation in the mesh's axes
     * @param ux direction, mesh axes, any length
     */
    void find(Pair p, double ux, double uy, double uz) {
        p.solidA.restart();
        int v =
                p.supportA(
                        p.w00 * ux + p.w10 * uy + p.w20 * uz,
                        p.w01 * ux + p.w11 * uy + p.w21 * uz,
                        p.w02 * ux + p.w12 * uy + p.w22 * uz,
                        0);
        double a = p.vertexAX(v);
        double b = p.vertexAY(v);
        double c = p.vertexAZ(v);
        x = p.w00 * a + p.w01 * b + p.w02 * c;
        y = p.w10 * a + p.w11 * b + p.w12 * c;
        z = p.w20 * a + p.w21 * b + p.w22 * c;
    }
}
