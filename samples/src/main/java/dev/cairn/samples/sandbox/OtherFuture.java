package dev.cairn.samples.sandbox;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.render.app.View;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * What the bodies of a world have done from a moment on, to be drawn beside what they do another
 * time. The simulation thread writes it down, with room taken once; after that nobody changes it,
 * and the window's thread draws it.
 */
final class OtherFuture {
    private static final int MOST_TICKS = 3600;
    private static final int STRIDE = 7;

    /** Most memory of one future, in numbers: 32 MB. */
    private static final long MOST_NUMBERS = 4L << 20;

    private static final int GHOST = 0xB388FF;

    private final long firstTick;
    private final List<BodyRef> bodies = new ArrayList<>();
    private final List<double[]> wires = new ArrayList<>();

    /** Of each tick and body the place of its frame and its turn; NaN where it was gone. */
    private final double[] poses;

    private final int mostTicks;
    private int ticks;
    private final Vector3d place = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    // The window thread's own.
    private final Quaterniond drawnTurn = new Quaterniond();
    private final Vector3d from = new Vector3d();
    private final Vector3d to = new Vector3d();

    /** Begins with the present moment. */
    OtherFuture(PhysicsWorld world, long tick) {
        firstTick = tick;
        for (BodyRef body : world.bodies()) {
            if (body.type() != BodyType.FIXED) {
                bodies.add(body);
                wires.add(Wire.of(body));
            }
        }
        long room = MOST_NUMBERS / (STRIDE * Math.max(1L, bodies.size()));
        mostTicks = Math.clamp(room, 1, MOST_TICKS);
        poses = new double[mostTicks * bodies.size() * STRIDE];
        write();
    }

    /** Writes down one more tick; false if there is no room left. */
    boolean add() {
        if (ticks == mostTicks) {
            return false;
        }
        write();
        return true;
    }

    private void write() {
        int at = ticks * bodies.size() * STRIDE;
        for (int i = 0; i < bodies.size(); i++, at += STRIDE) {
            BodyRef body = bodies.get(i);
            if (!body.isAlive()) {
                poses[at] = Double.NaN;
                continue;
            }
            body.position(place);
            body.orientation(turn);
            poses[at] = place.x;
            poses[at + 1] = place.y;
            poses[at + 2] = place.z;
            poses[at + 3] = turn.x;
            poses[at + 4] = turn.y;
            poses[at + 5] = turn.z;
            poses[at + 6] = turn.w;
        }
        ticks++;
    }

    /** The moment that it begins with. */
    long firstTick() {
        return firstTick;
    }

    long lastTick() {
        return firstTick + ticks - 1;
    }

    boolean has(long tick) {
        return tick >= firstTick && tick <= lastTick();
    }

    /**
     * How far the body is from where it was then that is farthest, m; NaN beyond the ticks known.
     */
    double apart(long tick) {
        if (!has(tick)) {
            return Double.NaN;
        }
        double most = 0;
        int at = (int) (tick - firstTick) * bodies.size() * STRIDE;
        for (int i = 0; i < bodies.size(); i++, at += STRIDE) {
            BodyRef body = bodies.get(i);
            if (body.isAlive() && !Double.isNaN(poses[at])) {
                body.position(place);
                most = Math.max(most, place.distance(poses[at], poses[at + 1], poses[at + 2]));
            }
        }
        return most;
    }

    /** Draws the bodies as they were at a tick; window thread. */
    void draw(View view, long tick) {
        if (!has(tick)) {
            return;
        }
        int at = (int) (tick - firstTick) * wires.size() * STRIDE;
        for (int i = 0; i < wires.size(); i++, at += STRIDE) {
            if (Double.isNaN(poses[at])) {
                continue;
            }
            drawnTurn.set(poses[at + 3], poses[at + 4], poses[at + 5], poses[at + 6]);
            double[] wire = wires.get(i);
            for (int k = 0; k < wire.length; k += 6) {
                drawnTurn.transform(from.set(wire[k], wire[k + 1], wire[k + 2]));
                drawnTurn.transform(to.set(wire[k + 3], wire[k + 4], wire[k + 5]));
                view.line(
                        poses[at] + from.x,
                        poses[at + 1] + from.y,
                        poses[at + 2] + from.z,
                        poses[at] + to.x,
                        poses[at + 1] + to.y,
                        poses[at + 2] + to.z,
                        GHOST,
                        1.5);
            }
        }
    }
}
