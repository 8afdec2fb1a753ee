package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.CommonStep;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.kernel.ScalarNormals;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

import org.junit.jupiter.api.Test;

/**
 * The common step of a contact's points: mean speed right, symmetric answers to what is symmetric.
 */
class EvenStepTest {
    /** Without any sweep after it, the mean speed at the points that press is right already. */
    @Test
    void stopsTheMeanOfThePoints() {
        SolverScene s = new SolverScene();
        int plane = s.fixed();
        int box = s.box(3, 0.5, 0.5, 0.7, 0, 0.5, 0);
        s.boxOnPlane(plane, box, 0, 1, 0, 0, 0, 0);
        s.velocity(box, 0.3, -0.8, 0.1);
        s.spin(box, 0.4, 0.2, -0.3);
        s.collide();
        double[] warm = {0.1, 0.5, 0.2, 0.9};
        System.arraycopy(warm, 0, s.contacts.normalImpulse, 0, 4);
        SubStep sub = new SubStep();
        sub.set(1 / 60.0, 1 / 240.0, SolverScene.DOUBLES);
        SolverBodies bodies = new SolverBodies();
        bodies.ensureCapacity(s.bodies.slotCount);
        bodies.axes.update(s.bodies, box);
        bodies.loadBound(s.bodies, box, 1);
        ConstraintRows rows = new EdgeList().doubles;
        rows.ensurePlaces(1);
        rows.places = 1;
        int b = SolverBodies.offset(box);
        rows.link[ConstraintRows.BODY_B] = b;
        rows.link[ConstraintRows.COUNT] = 4;
        Scratch scratch = new Scratch();
        sub.fillScale = 1;
        new PrepareRow().fill(rows, bodies, s.contacts, sub, 0, 1, scratch);
        int o = rows.base(0);
        double[] v = bodies.state;
        ScalarNormals.harden(rows.doubles, o, 1, 4, sub, scratch.doubles);
        ScalarNormals.sweep(rows.doubles, o, 1, v, 0, b, 4, 0, CommonStep.HARD, scratch.doubles);
        double mean = 0;
        double change = 0;
        for (int p = 0; p < 4; p++) {
            int q = o + ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS;
            double speed =
                    v[b + 1]
                            + RowArithmetic.dot(
                                    rows.doubles, q + ConstraintRows.ARM_B, 1, v, b + 3);
            mean += speed / 4;
            double own = rows.doubles[q + ConstraintRows.IMPULSE] - warm[p];
            change = p == 0 ? own : change;
            assertEquals(change, own, 1e-15, "the same for all points");
        }
        assertEquals(0, mean, 1e-14, "m/s");
        // the corners are even, so the mean is the centre's: m 0.8 m/s over four points
        assertEquals(3 * 0.8 / 4, change, 1e-14);
    }

    /** It never pulls: the change is bounded by the least impulse. */
    @Test
    void aCubeThatLandsDoesNotCreepAside() {
        SolverScene s = new SolverScene();
        int plane = s.fixed();
        int box = s.box(1, 0.5, 0.5, 0.5, 0, 0.6, 0);
        int row = s.boxOnPlane(plane, box, 0, 1, 0, 0, 0.6, 0);
        for (int tick = 0; tick < 120; tick++) {
            s.tick(SolverScene.TICK);
            double least = Double.MAX_VALUE;
            double most = 0;
            for (int k = 0; k < s.contacts.pointCount[row]; k++) {
                least = Math.min(least, s.contacts.normalImpulse[4 * row + k]);
                most = Math.max(most, s.contacts.normalImpulse[4 * row + k]);
            }
            assertTrue(least >= 0 && most - least <= 1e-12 * most + 1e-15, "tick " + tick);
        }
        assertEquals(0, s.bodies.positionX[box], 1e-14, "m");
        assertEquals(0, s.bodies.positionZ[box], 1e-14, "m");
    }
}
