package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.refresh.JacobianRefresh;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;

import org.junit.jupiter.api.Test;

/** Levers that are renewed within a tick: momentum, its threshold, and who is left alone. */
class JacobianRefreshTest {
    /** Angular momentum of two balls about the origin. */
    private static double momentum(SolverScene s, int i) {
        double m = 1 / s.bodies.inverseMass[i];
        return m
                        * (s.bodies.positionX[i] * s.bodies.velocityY[i]
                                - s.bodies.positionY[i] * s.bodies.velocityX[i])
                + s.spinMomentum(i)[2];
    }

    /** Two rough balls that graze each other in free space keep their angular momentum. */
    @Test
    void whatPassesByMakesNoAngularMomentum() {
        SolverScene s = new SolverScene();
        s.gy = 0;
        int a = s.sphere(1, 0.5, -1.2, 0.3, 0);
        int b = s.sphere(2, 0.5, 0.3, -0.35, 0);
        s.velocity(a, 4, 0, 0);
        s.velocity(b, -1, 0.5, 0);
        s.spin(a, 0, 0, 7);
        s.sphereOnSphere(a, b, 0.6, 0);
        double before = momentum(s, a) + momentum(s, b);
        double spin = s.bodies.angularVelocityZ[b];
        s.run(1);
        assertTrue(
                Math.abs(s.bodies.angularVelocityZ[b] - spin) > 0.1, "they must rub on each other");
        double after = momentum(s, a) + momentum(s, b);
        assertEquals(before, after, 1e-13 * Math.abs(before), "kg m²/s");
    }

    private static boolean found(double speed) {
        SolverScene s = new SolverScene();
        int plane = s.fixed();
        int box = s.box(1, 0.5, 0.5, 0.5, 0, 0.5, 0);
        s.bodies.innerRadius[box] = 0.5;
        s.bodies.outerRadius[box] = 0.5;
        s.boxOnPlane(plane, box, 0, 1, 0, 0, 0.5, 0);
        s.collide();
        s.spin(box, 0, speed, 0);
        JacobianRefresh renewal = new JacobianRefresh();
        renewal.ensureCapacity(s.bodies.slotCount);
        ConstraintRows rows = new EdgeList().doubles;
        rows.ensurePlaces(1);
        rows.link[ConstraintRows.BODY_B] = SolverBodies.offset(box);
        rows.link[ConstraintRows.COUNT] = 4;
        renewal.ensurePlaces(rows, true);
        renewal.look(s.bodies, box, 9.81, 1 / 60.0, false);
        boolean any = renewal.find(rows, s.contacts, s.bodies, 9.81, 0, 1);
        assertEquals(any, renewal.hasRenewedRow(box));
        return any;
    }

    @Test
    void whoIsSlowIsLeftAlone() {
        // surface speed over sqrt(g r): 0.045
        double limit = 0.045 * Math.sqrt(9.81 * 0.5) / 0.5;
        assertEquals(false, found(0.999 * limit));
        assertEquals(true, found(1.001 * limit));
    }

    /** A stack, alone or beside a spinning box that it does not touch. */
    private static double[] stack(boolean beside) {
        SolverScene s = new SolverScene();
        int plane = s.fixed();
        int below = s.box(1, 0.5, 0.5, 0.5, 0, 0.5, 0);
        int above = s.box(1, 0.5, 0.5, 0.5, 0.1, 1.52, 0);
        int other = s.box(1, 0.5, 0.2, 0.4, 5, 0.3, 0);
        s.boxOnPlane(plane, below, 0, 1, 0, 0, 0.5, 0);
        s.boxOnBox(below, above, 0.5, 0);
        s.boxOnPlane(plane, other, 0, 1, 0, 0, 0.5, 0);
        s.spin(other, 0.1, beside ? 40 : 0, 0.2);
        s.run(0.5);
        return new double[] {
            s.bodies.positionX[above],
            s.bodies.positionY[above],
            s.bodies.velocityY[above],
            s.bodies.angularVelocityZ[above],
            s.bodies.positionY[below],
        };
    }

    @Test
    void whatTurnsChangesNoBitOfWhatItDoesNotTouch() {
        assertArrayEquals(stack(false), stack(true), 0.0);
    }

    /** The points that collision gave are the same after the tick as before it. */
    @Test
    void contactsGetTheirPointsBack() {
        SolverScene s = new SolverScene();
        int plane = s.fixed();
        int box = s.box(1, 0.5, 0.2, 0.4, 0, 0.21, 0);
        s.spin(box, 1, 30, 2);
        s.boxOnPlane(plane, box, 0, 1, 0, 0, 0.5, 0);
        s.collide();
        double[] anchors = s.contacts.anchors.clone();
        double[] separations = s.contacts.separation.clone();
        s.solver.step(s.bodies, s.contacts, 0, -9.81, 0, SolverScene.TICK, s.jobs);
        assertArrayEquals(anchors, s.contacts.anchors, 0.0);
        assertArrayEquals(separations, s.contacts.separation, 0.0);
    }
}
