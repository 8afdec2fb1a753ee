package dev.cairn.samples.replay;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;

import java.util.ArrayList;
import java.util.List;

/**
 * What is done to the world of a scene before a tick, as it is written down.
 *
 * @param what what it is
 * @param entity what is taken or driven; else 0
 * @param numbers as {@link What} tells
 */
public record Act(What what, long entity, List<Double> numbers) {
    /** The scene's hooks before a tick run. */
    public static final Act BEFORE = new Act(What.BEFORE, 0, List.of());

    /** The scene's hooks after the tick before run. */
    public static final Act AFTER = new Act(What.AFTER, 0, List.of());

    /** How it becomes bytes. */
    static final StateCodec<Act> CODEC = StateCodec.of(Act.class, "act", Act::write, Act::read);

    /** What can be done. */
    public enum What {
        /** The scene's hooks before the coming tick run. */
        BEFORE(0),
        /** The scene's hooks after the tick before run: a recorder looks at the world first. */
        AFTER(0),
        /** A body is taken into the hand at a point of the world: its x, y, z, m. */
        GRAB(3),
        /** The hand pulls towards a point: its x, y, z, m. */
        PULL(3),
        /** The hand lets go. */
        RELEASE(0),
        /** A ball is thrown: place, m, velocity, m/s, radius, m, density, kg/m³, its number. */
        THROW(9),
        /** An explosion: place, m; radius, m; speed that it gives at its middle, m/s. */
        BLAST(5),
        /**
         * A key or a button pushes: along the world's axes x, y, z, m/s²; length of the tick, s.
         */
        PUSH(4),
        /**
         * A key or a button turns: about the world's axes x, y, z, rad/s²; length of the tick, s.
         */
        TURN(4),
        /** A key or a button kicks: along the world's axes x, y, z, m/s; length of the tick, s. */
        KICK(4),
        /** The number of sub-steps changes. */
        SUBSTEPS(1);

        private final int count;

        What(int count) {
            this.count = count;
        }

        /**
         * How many numbers go with it.
         *
         * @return the number
         */
        public int count() {
            return count;
        }
    }

    /** Copies the list, and checks how many numbers there are. */
    public Act {
        numbers = List.copyOf(numbers);
        if (numbers.size() != what.count()) {
            throw new IllegalArgumentException(
                    what + " goes with " + what.count() + " numbers, not " + numbers.size());
        }
    }

    private static void write(Act act, StateOutput out) {
        out.writeString(act.what.name());
        out.writeLong(act.entity);
        act.numbers.forEach(out::writeDouble);
    }

    private static Act read(StateInput in) {
        What what = What.valueOf(in.readString());
        long entity = in.readLong();
        List<Double> numbers = new ArrayList<>();
        for (int i = 0; i < what.count(); i++) {
            numbers.add(in.readDouble());
        }
        return new Act(what, entity, numbers);
    }
}
