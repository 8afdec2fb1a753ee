package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.sweep.Flight;
import dev.cairn.physics.sweep.FreeRotationPath;

import java.util.Arrays;

/** What impacts leave to do after the solve: bodies that end the tick somewhere, and events. */
final class ImpactResults {
    /** Numbers to a body that is put somewhere: way, orientation, start, velocities. */
    private static final int STOP = 16;

    private final ColliderStore colliders;
    private final ContactStore contacts;

    /** Bodies that are put somewhere, and where. */
    private int[] stopped = {};

    double[] stops = {};
    private int stopCount;

    /** Rows with impacts: how many points they had, and impulses. */
    private int[] hitRow = {}, hitPoints = {};

    private double[] hitImpulse = {};
    private int hitCount;

    ImpactResults(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
    }

    void clear() {
        stopCount = 0;
        hitCount = 0;
    }

    /** Makes room for all bodies and rows, so that no tick with more impacts than others grows. */
    void reserve(int bodies, int rows) {
        if (stopped.length < bodies) {
            stopped = new int[bodies];
            stops = new double[STOP * bodies];
        }
        if (hitRow.length < rows) {
            hitRow = new int[rows];
            hitPoints = new int[rows];
            hitImpulse = new double[3 * rows];
        }
    }

    /** A place among those that are put somewhere after the solve: there, as the flight is now. */
    int put(int body, Flight f) {
        BodyStore s = colliders.bodies;
        int at = STOP * stopCount;
        stopped[stopCount++] = body;
        stops[at] = f.x;
        stops[at + 1] = f.y;
        stops[at + 2] = f.z;
        stops[at + 3] = f.qx;
        stops[at + 4] = f.qy;
        stops[at + 5] = f.qz;
        stops[at + 6] = f.qw;
        FreeRotationPath.unit(stops, at + 3);
        stops[at + 7] = s.positionX[body];
        stops[at + 8] = s.positionY[body];
        stops[at + 9] = s.positionZ[body];
        return at;
    }

    /** Puts those that were stopped where they were; after the solve. */
    private void putAll() {
        BodyStore s = colliders.bodies;
        for (int i = 0; i < stopCount; i++) {
            int body = stopped[i];
            int at = STOP * i;
            s.move(
                    body,
                    stops[at + 7] - s.positionX[body] + stops[at],
                    stops[at + 8] - s.positionY[body] + stops[at + 1],
                    stops[at + 9] - s.positionZ[body] + stops[at + 2]);
            s.orientationX[body] = stops[at + 3];
            s.orientationY[body] = stops[at + 4];
            s.orientationZ[body] = stops[at + 5];
            s.orientationW[body] = stops[at + 6];
            s.velocityX[body] = stops[at + 10];
            s.velocityY[body] = stops[at + 11];
            s.velocityZ[body] = stops[at + 12];
            s.angularVelocityX[body] = stops[at + 13];
            s.angularVelocityY[body] = stops[at + 14];
            s.angularVelocityZ[body] = stops[at + 15];
        }
        stopCount = 0;
    }

    /** Keeps what a row's events tell. */
    void note(int row, Manifold m, double sum) {
        if (row < 0) {
            return;
        }
        int i = 0;
        while (i < hitCount && hitRow[i] != row) {
            i++;
        }
        if (i == hitCount) {
            hitRow[hitCount] = row;
            Arrays.fill(hitImpulse, 3 * hitCount, 3 * hitCount + 3, 0.0);
            hitCount++;
        }
        hitPoints[i] = m.pointCount;
        hitImpulse[3 * i] += sum * m.normalX;
        hitImpulse[3 * i + 1] += sum * m.normalY;
        hitImpulse[3 * i + 2] += sum * m.normalZ;
    }

    /** Tells rows what they struck with; after the solve. */
    void report() {
        putAll();
        for (int i = 0; i < hitCount; i++) {
            report(hitRow[i], i);
        }
    }

    /** A row tells the sum of what it struck and pressed with, along one normal. */
    private void report(int row, int i) {
        ContactStore c = contacts;
        int first = ContactStore.POINTS * row;
        double x = hitImpulse[3 * i];
        double y = hitImpulse[3 * i + 1];
        double z = hitImpulse[3 * i + 2];
        if (c.pointCount[row] == 0) {
            c.pointCount[row] = Math.max(1, hitPoints[i]);
            Arrays.fill(c.totalNormalImpulse, first, first + c.pointCount[row], 0.0);
            Arrays.fill(c.normalImpulse, first, first + c.pointCount[row], 0.0);
        }
        double pressed = c.normalImpulse(row);
        x += pressed * c.normalX(row);
        y += pressed * c.normalY(row);
        z += pressed * c.normalZ(row);
        double sum = Math.sqrt(x * x + y * y + z * z);
        if (sum > 0) {
            c.setNormal(row, x / sum, y / sum, z / sum);
            Arrays.fill(
                    c.totalNormalImpulse,
                    first,
                    first + c.pointCount[row],
                    sum / c.pointCount[row]);
        }
    }
}
