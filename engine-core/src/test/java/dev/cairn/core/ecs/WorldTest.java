package dev.cairn.core.ecs;

import static org.junit.jupiter.api.Assertions.*;

import dev.cairn.core.snapshot.*;

import org.junit.jupiter.api.Test;

class WorldTest {
    private record P(
            double x, float f, long l, int i, boolean b, byte y, short s, char c, String t) {}

    record V(double vx) {}

    static final Component<P> PC = Component.of(P.class);
    static final Component<V> VC = Component.of(V.class);
    static final DoubleField X = PC.doubleField("x");
    static final DoubleField VX = VC.doubleField("vx");

    static final class Move implements ChunkSystem {
        public void describe(Access a) {
            a.in(VC).out(PC);
        }

        public void run(Chunk c, Tick t) {
            double[] x = c.out(X), v = c.in(VX);
            for (int r = 0, n = c.size(); r < n; r++) x[r] += v[r] * t.stepSeconds();
        }
    }

    @Test
    void roundTrip() {
        P p = new P(1, 2, 3, 4, true, (byte) -5, (short) -6, 'q', "t");
        try (World w = World.builder().systems(new Move()).workers(2).build()) {
            long e = w.spawn(p);
            assertEquals(p, w.get(e, PC));
            w.add(e, new V(2));
            for (int i = 0; i < 3000; i++) w.spawn(p, new V(i));
            w.step(0.5);
            assertEquals(2.0, w.get(e, PC).x());
            assertEquals("t", w.get(e, PC).t());
            w.schedule().printGraph(System.out);
            System.out.println(w.digest());
        }
    }
}
