package dev.cairn.samples.sandbox;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SceneBuilder;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * The past of the sandbox's scene: goes back to any moment of the last minutes and on from there,
 * and keeps one future to be compared with another. Simulation thread, between steps.
 */
final class Timeline {
    /** Two seconds of every tick, two minutes of every quarter of a second. */
    private static final int DENSE = 120;

    private static final int STRIDE = 15;
    private static final int SPARSE = 480;

    private final Moments moments =
            new Moments(
                    DENSE,
                    STRIDE,
                    SPARSE,
                    Math.min(256L << 20, Runtime.getRuntime().maxMemory() / 4));
    private @Nullable PhysicsWorld world;
    private @Nullable SceneBuilder scene;

    /** The moment that the world is at; the last one but after going back. */
    private int at;

    private final WorldState kept = new WorldState();
    private long keptTick = -1;
    private @Nullable OtherFuture writing;
    private @Nullable OtherFuture shown;

    /** Another scene begins, or the same one again; null if there is none to remember. */
    void begin(PhysicsWorld newWorld, @Nullable SceneBuilder newScene) {
        moments.clear();
        world = newWorld;
        scene = newScene;
        at = 0;
        forgetFutures();
        remember();
    }

    /** Before a tick: what was after this moment is another future now. */
    void goingOn() {
        if (at < moments.count() - 1) {
            moments.forgetAfter(at);
        }
    }

    /** After a tick. */
    void remember() {
        PhysicsWorld known = world;
        SceneBuilder now = scene;
        if (known == null || now == null) {
            return;
        }
        moments.add(known, now.tick());
        at = moments.count() - 1;
        OtherFuture future = writing;
        if (future != null && now.tick() > future.lastTick() && !future.add()) {
            writing = null;
            shown = future;
        }
    }

    /** Goes to the last moment not after a tick. */
    void goTo(long tick) {
        if (moments.count() > 0) {
            go(moments.indexAt(tick));
        }
    }

    /** Goes to the moment before. */
    void back() {
        if (at > 0) {
            go(at - 1);
        }
    }

    /** Goes to the moment after; false if there is none, since it was never computed. */
    boolean forth() {
        if (at >= moments.count() - 1) {
            return false;
        }
        go(at + 1);
        return true;
    }

    private void go(int index) {
        stopWriting();
        at = index;
        put(moments.state(index), moments.tick(index));
    }

    private void put(WorldState state, long tick) {
        PhysicsWorld known = world;
        SceneBuilder now = scene;
        if (known == null || now == null) {
            return;
        }
        known.restore(state);
        now.returnTo(tick);
        // A hand that held something then is no longer there.
        List<BodyRef> hands = new ArrayList<>();
        for (BodyRef body : known.bodies()) {
            if (body.isFixed() && body.name().equals("hand")) {
                hands.add(body);
            }
        }
        hands.forEach(BodyRef::remove);
    }

    /** Keeps this moment, and writes down what comes of it. */
    void keep() {
        PhysicsWorld known = world;
        SceneBuilder now = scene;
        if (known != null && now != null) {
            known.save(kept);
            keptTick = now.tick();
            shown = null;
            writing = new OtherFuture(known, keptTick);
        }
    }

    /** Goes back to the moment that was kept; what came of it is shown beside what comes now. */
    boolean backToKept() {
        if (keptTick < 0) {
            return false;
        }
        stopWriting();
        moments.forgetAfter(moments.indexAt(keptTick));
        at = moments.count() - 1;
        put(kept, keptTick);
        return true;
    }

    private void stopWriting() {
        if (writing != null) {
            shown = writing;
            writing = null;
        }
    }

    /** Shows no other future any more. */
    void forgetFutures() {
        writing = null;
        shown = null;
        keptTick = -1;
    }

    /** The first moment from a tick on at which the hand was empty; -1 if there is none. */
    int momentWithEmptyHand(long tick, Diary diary) {
        for (int i = moments.count() == 0 ? 0 : moments.indexAt(tick); i <= at; i++) {
            if (i < moments.count() && !diary.holdsAfter(moments.tick(i))) {
                return i;
            }
        }
        return -1;
    }

    long tick(int index) {
        return moments.tick(index);
    }

    WorldState state(int index) {
        return moments.state(index);
    }

    /** The oldest tick that can be gone back to. */
    long oldest() {
        return moments.count() == 0 ? Long.MAX_VALUE : moments.tick(0);
    }

    /** Tells the window. */
    void describe(SandboxState state) {
        SceneBuilder now = scene;
        boolean any = moments.count() > 0 && now != null;
        state.oldestTick = any ? moments.tick(0) : state.tick;
        state.newestTick = any ? moments.tick(moments.count() - 1) : state.tick;
        state.keptTick = keptTick;
        state.future = shown;
        state.apart = shown == null ? Double.NaN : shown.apart(state.tick);
    }
}
