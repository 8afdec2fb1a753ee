package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.ecs.component.FloatField;

import java.util.function.BiConsumer;
import java.util.function.Consumer;

/** Components and systems that the tests share. */
final class Fixtures {
    record Position(double x, double y) {}

    record Velocity(double vx, double vy) {}

    record Force(float f) {}

    record Tag() {}

    record Mixed(
            double x,
            float f,
            long l,
            int i,
            boolean flag,
            byte small,
            short medium,
            char letter,
            String text) {}

    static final Component<Position> POSITION = Component.of(Position.class);
    static final Component<Velocity> VELOCITY = Component.of(Velocity.class);
    static final Component<Force> FORCE = Component.of(Force.class);
    static final Component<Tag> TAG = Component.of(Tag.class);
    static final Component<Mixed> MIXED = Component.of(Mixed.class);
    static final DoubleField X = POSITION.doubleField("x");
    static final DoubleField Y = POSITION.doubleField("y");
    static final DoubleField VX = VELOCITY.doubleField("vx");
    static final FloatField F = FORCE.floatField("f");

    private Fixtures() {}

    /** A chunk system from lambdas. */
    static ChunkSystem chunks(String name, Consumer<Access> access, BiConsumer<Chunk, Tick> body) {
        return new ChunkSystem() {
            @Override
            public String name() {
                return name;
            }

            @Override
            public void describe(Access a) {
                access.accept(a);
            }

            @Override
            public void run(Chunk chunk, Tick tick) {
                body.accept(chunk, tick);
            }
        };
    }

    /** A world system from lambdas. */
    static WorldSystem world(String name, Consumer<Access> access, Consumer<Tick> body) {
        return new WorldSystem() {
            @Override
            public String name() {
                return name;
            }

            @Override
            public void describe(Access a) {
                access.accept(a);
            }

            @Override
            public void run(Tick tick) {
                body.accept(tick);
            }
        };
    }

    /** x += vx * h. */
    static ChunkSystem move() {
        return chunks(
                "move",
                a -> a.in(VELOCITY).out(POSITION),
                (chunk, tick) -> {
                    double[] x = chunk.out(X);
                    double[] vx = chunk.in(VX);
                    double h = tick.stepSeconds();
                    for (int row = 0, n = chunk.size(); row < n; row++) {
                        x[row] += vx[row] * h;
                    }
                });
    }
}
