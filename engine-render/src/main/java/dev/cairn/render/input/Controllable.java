package dev.cairn.render.input;

import dev.cairn.core.ecs.component.Component;

import java.util.List;

/**
 * Component of an entity that the user drives, without code: what its keys and buttons do to it.
 * While such an entity is there, its keys do nothing else (the camera does not fly by them).
 *
 * <pre>{@code
 * scene.add(Body.dynamic().shape(Sphere.of(0.5)).with(Controllable.arrows(12, 5)));
 * }</pre>
 *
 * <p>It acts before each tick; not while the physics is paused. A fixed body stays where it is.
 * Immutable.
 *
 * @param controls what the user can do, in any order
 */
public record Controllable(List<Control> controls) {
    /** Key of this component. */
    public static final Component<Controllable> COMPONENT = Component.of(Controllable.class);

    /** Copies the list. */
    public Controllable {
        controls = List.copyOf(controls);
    }

    /**
     * Driven over the level by four keys, as the user sees it, and a fifth that jumps.
     *
     * @param away from the camera
     * @param towards the camera
     * @param left to the left
     * @param right to the right
     * @param jump upwards
     * @param acceleration m/s²
     * @param jumpSpeed m/s
     * @return the component
     */
    public static Controllable of(
            Key away,
            Key towards,
            Key left,
            Key right,
            Key jump,
            double acceleration,
            double jumpSpeed) {
        return new Controllable(
                List.of(
                        Control.of(away, Control.Effect.PUSH, 0, 0, -acceleration),
                        Control.of(towards, Control.Effect.PUSH, 0, 0, acceleration),
                        Control.of(left, Control.Effect.PUSH, -acceleration, 0, 0),
                        Control.of(right, Control.Effect.PUSH, acceleration, 0, 0),
                        Control.of(jump, Control.Effect.KICK, 0, jumpSpeed, 0)));
    }

    /**
     * Driven by the arrow keys; the right Control key jumps.
     *
     * @param acceleration m/s²
     * @param jumpSpeed m/s
     * @return the component
     */
    public static Controllable arrows(double acceleration, double jumpSpeed) {
        return of(
                Key.UP, Key.DOWN, Key.LEFT, Key.RIGHT, Key.RIGHT_CONTROL, acceleration, jumpSpeed);
    }
}
