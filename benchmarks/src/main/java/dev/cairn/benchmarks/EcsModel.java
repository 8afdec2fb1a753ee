package dev.cairn.benchmarks;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.FloatField;

/**
 * The two components of the ECS suites, for each engine: three {@code float} each. Immutable
 * records for Cairn; mutable objects for Dominion and Artemis-odb, as their manuals show.
 */
public final class EcsModel {

    /** Velocity lost per tick. */
    static final float DRAG = 0.999f;

    /** Seconds per tick. */
    static final float STEP = 1.0f / 60.0f;

    /**
     * Cairn's position, metres.
     *
     * @param x along x
     * @param y along y
     * @param z along z
     */
    public record Position(float x, float y, float z) {}

    /**
     * Cairn's velocity, metres per second.
     *
     * @param x along x
     * @param y along y
     * @param z along z
     */
    public record Velocity(float x, float y, float z) {}

    static final Component<Position> POSITION = Component.of(Position.class);
    static final FloatField PX = POSITION.floatField("x");
    static final FloatField PY = POSITION.floatField("y");
    static final FloatField PZ = POSITION.floatField("z");
    static final Component<Velocity> VELOCITY = Component.of(Velocity.class);
    static final FloatField VX = VELOCITY.floatField("x");
    static final FloatField VY = VELOCITY.floatField("y");
    static final FloatField VZ = VELOCITY.floatField("z");

    /** Dominion's position. */
    static final class MutablePosition {
        float x;
        float y;
        float z;

        MutablePosition(float x, float y, float z) {
            this.x = x;
            this.y = y;
            this.z = z;
        }
    }

    /** Dominion's velocity. */
    static final class MutableVelocity {
        float x;
        float y;
        float z;

        MutableVelocity(float x, float y, float z) {
            this.x = x;
            this.y = y;
            this.z = z;
        }
    }

    /** Artemis-odb's position; it makes components by their public constructor. */
    public static final class ArtemisPosition extends com.artemis.Component {
        float x;
        float y;
        float z;
    }

    /** Artemis-odb's velocity. */
    public static final class ArtemisVelocity extends com.artemis.Component {
        float x;
        float y;
        float z;
    }

    /** The work, on one axis. The arrays to write may be those that are read. */
    static void advance(
            int rows,
            float[] position,
            float[] velocity,
            float[] nextPosition,
            float[] nextVelocity) {
        for (int row = 0; row < rows; row++) {
            float damped = velocity[row] * DRAG;
            nextVelocity[row] = damped;
            nextPosition[row] = position[row] + damped * STEP;
        }
    }

    private EcsModel() {}
}
