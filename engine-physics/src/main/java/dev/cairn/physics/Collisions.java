package dev.cairn.physics;

import dev.cairn.physics.collider.ContactHook;
import dev.cairn.physics.internal.Checks;

import org.jspecify.annotations.Nullable;

import java.util.Objects;
import java.util.function.BiPredicate;

/**
 * The rules of a world about which bodies collide, beside the filters of the colliders. Simulation
 * thread, between steps.
 */
public final class Collisions {
    private final PhysicsWorld world;
    private final ColliderTable table;

    Collisions(PhysicsWorld world) {
        this.world = world;
        table = world.physics.table.collision;
    }

    /**
     * Chooses a question to be asked of each pair of colliders whose boxes have come to overlap and
     * whose filters meet: once, and again whenever one of the boxes was moved while the pair is
     * refused, or a filter changes. It is asked on the simulation thread, within the step, in an
     * order that depends on the world's history alone.
     *
     * <p>It must be pure: the same answer for the same two, whatever happened meanwhile. When what
     * it depends on changes, set it again: all pairs are asked anew.
     *
     * @param collide whether the two collide, the lower slot first; {@code null} for all
     */
    public void setPairFilter(@Nullable BiPredicate<ColliderRef, ColliderRef> collide) {
        world.requireBetweenSteps("setPairFilter");
        table.ask(collide);
    }

    /**
     * Chooses the hook that looks at each contact before it is solved, and may change it for the
     * step.
     *
     * @param hook the hook; {@code null} for none
     */
    public void setHook(@Nullable ContactHook hook) {
        world.requireBetweenSteps("setHook");
        if (!Objects.equals(hook, world.physics.hooks.get())) {
            world.physics.wakeAll(); // it may let through what lies on a floor
        }
        world.physics.hooks.set(hook);
    }

    /**
     * Who looks at each contact before it is solved.
     *
     * @return the hook, or {@code null}
     */
    public @Nullable ContactHook hook() {
        return world.physics.hooks.get();
    }

    /**
     * Lets two bodies pass through each other, whatever their filters say. Counted: each call is
     * taken back by one of {@link #include}. A contact of the two ends in the next step.
     *
     * @param a a body
     * @param b another body
     * @throws IllegalArgumentException if both are the same
     */
    public void exclude(BodyRef a, BodyRef b) {
        world.requireBetweenSteps("exclude");
        two(a, b);
        table.rules.apart(a.alive(), b.alive());
    }

    /**
     * Takes back one call of {@link #exclude}; nothing if there was none.
     *
     * @param a a body
     * @param b another body
     */
    public void include(BodyRef a, BodyRef b) {
        world.requireBetweenSteps("include");
        two(a, b);
        table.rules.together(a.alive(), b.alive());
    }

    private static void two(BodyRef a, BodyRef b) {
        Checks.notNull("a", a);
        Checks.notNull("b", b);
        if (a == b) {
            throw new IllegalArgumentException(
                    a + " is both; a body does not collide with itself, pass two");
        }
    }
}
