package dev.cairn.physics.solver;

import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.row.ConstraintKind;
import dev.cairn.physics.solver.row.KindRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

import java.util.ArrayList;
import java.util.List;

/**
 * A kind of constraint of its own: massless rods that hold the centres of two bodies at a distance.
 * As small as a kind can be, with a warm start and rows in groups.
 */
final class Rods implements EdgeSource {
    /** Of a row: vector from A to B at the tick's start, length, impulse of the sub-step. */
    private static final int APART = 0;

    private static final int LENGTH = 3;
    private static final int IMPULSE = 4;
    private static final int FIELDS = 5;

    final List<int[]> ends = new ArrayList<>();
    final List<Double> length = new ArrayList<>();

    /** Of the last sub-step of the last tick, N s. */
    double[] impulse = new double[4096];

    void add(int a, int b, double metres) {
        ends.add(new int[] {a, b});
        length.add(metres);
    }

    ConstraintKind kind(int lanes) {
        return new ConstraintKind(this, new Rows(lanes, true), new Rows(lanes, false));
    }

    @Override
    public int edges() {
        return ends.size();
    }

    @Override
    public int capacity() {
        return edges();
    }

    @Override
    public int edgeRow(int i) {
        return i;
    }

    @Override
    public int edgeA(int i) {
        return ends.get(i)[0];
    }

    @Override
    public int edgeB(int i) {
        return ends.get(i)[1];
    }

    @Override
    public void leave(int slot) {}

    @Override
    public void forget(int slot) {}

    /** Rows in groups of lanes: field f of the row at place j lies at its group, f, its lane. */
    private final class Rows implements KindRows {
        private final int lanes;
        private final boolean isSingle;
        private double[] data = {};
        private int[] link = {};

        Rows(int lanes, boolean isSingle) {
            this.lanes = lanes;
            this.isSingle = isSingle;
        }

        private int at(int place, int field) {
            return (place / lanes * FIELDS + field) * lanes + place % lanes;
        }

        @Override
        public int group() {
            return lanes;
        }

        @Override
        public void ensurePlaces(int places) {
            if (3 * places > link.length) {
                link = new int[3 * places];
                data = new double[FIELDS * places];
            }
        }

        @Override
        public void bind(int place, int source, int offsetA, int offsetB, int variant) {
            link[3 * place] = offsetA;
            link[3 * place + 1] = offsetB;
            link[3 * place + 2] = source;
        }

        @Override
        public void pad(int place) {
            bind(place, -1, 0, 0, 0);
        }

        @Override
        public void prepare(SolverContext tick, SubStep sub, int from, int to) {
            for (int j = from; j < to; j++) {
                int source = link[3 * j + 2];
                if (source < 0) {
                    continue;
                }
                int a = ends.get(source)[0];
                int b = ends.get(source)[1];
                data[at(j, APART)] = tick.bodies.apartX(a, b);
                data[at(j, APART + 1)] = tick.bodies.apartY(a, b);
                data[at(j, APART + 2)] = tick.bodies.apartZ(a, b);
                data[at(j, LENGTH)] = length.get(source);
                data[at(j, IMPULSE)] = 0;
                push(tick.body, j, impulse[source] * sub.fillScale, true);
            }
        }

        @Override
        public void bias(SolverContext tick, SubStep sub, int from, int to, Scratch scratch) {
            sweep(tick, sub, from, to, true);
        }

        @Override
        public void relax(SolverContext tick, SubStep sub, int from, int to, Scratch scratch) {
            sweep(tick, sub, from, to, false);
        }

        private void sweep(SolverContext tick, SubStep sub, int from, int to, boolean soft) {
            double[] s = tick.body.state;
            for (int j = from; j < to; j++) {
                int a = link[3 * j];
                int b = link[3 * j + 1];
                double inverse = s[a + SolverBodies.MASS] + s[b + SolverBodies.MASS];
                if (link[3 * j + 2] < 0 || inverse == 0) {
                    continue;
                }
                double gap = stretch(s, j);
                double speed = 0;
                for (int k = 0; k < 3; k++) {
                    double v = value(tick.body, b + k) - value(tick.body, a + k);
                    speed += normal(s, j, k) * v;
                }
                double old = data[at(j, IMPULSE)];
                boolean isFixed = a == 0 || b == 0;
                double rate = isFixed ? sub.fixedRate : sub.rate;
                double massScale = isFixed ? sub.fixedMassScale : sub.massScale;
                double impulseScale = isFixed ? sub.fixedImpulseScale : sub.impulseScale;
                double change =
                        soft
                                ? -(massScale * speed + rate * gap) / inverse - impulseScale * old
                                : -speed / inverse;
                push(tick.body, j, change, false);
            }
        }

        private double apart(double[] s, int j, int k) {
            int p = SolverBodies.P + k;
            return data[at(j, APART + k)] + s[link[3 * j + 1] + p] - s[link[3 * j] + p];
        }

        private double stretch(double[] s, int j) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                sum += apart(s, j, k) * apart(s, j, k);
            }
            return Math.sqrt(sum) - data[at(j, LENGTH)];
        }

        private double normal(double[] s, int j, int k) {
            return apart(s, j, k) / (stretch(s, j) + data[at(j, LENGTH)]);
        }

        private double value(SolverBodies body, int at) {
            return isSingle ? body.floats[at] : body.state[at];
        }

        /** Adds an impulse to the row, and to the velocities or to the warm start. */
        private void push(SolverBodies body, int j, double change, boolean warm) {
            data[at(j, IMPULSE)] += change;
            for (int side = 0; side < 2; side++) {
                int o = link[3 * j + side];
                double m = body.state[o + SolverBodies.MASS] * (side == 0 ? -change : change);
                for (int k = 0; k < 3 && o > 0; k++) {
                    double v = m * normal(body.state, j, k);
                    if (warm) {
                        body.warm[o / SolverBodies.STRIDE * SolverBodies.HALF + k] += v;
                    } else if (isSingle) {
                        body.floats[o + k] += (float) v;
                    } else {
                        body.state[o + k] += v;
                    }
                }
            }
        }

        @Override
        public void store(SolverContext tick, SubStep sub, int from, int to) {
            for (int j = from; j < to; j++) {
                if (link[3 * j + 2] >= 0) {
                    impulse[link[3 * j + 2]] = data[at(j, IMPULSE)];
                }
            }
        }
    }
}
