package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.app.Blocks.Block;
import dev.cairn.render.app.Blocks.Hit;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.camera.Light;
import dev.cairn.render.gl.GlObjects;
import dev.cairn.render.mesh.Mesh;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;

/** Many things: right, without those out of sight, without leaks and without garbage. */
class CrowdTest extends Drawing {
    private static final int STATICS = 100;
    private static final int DYNAMICS = 10_000;

    private static Block block(SplittableRandom random, double spread, double low, double high) {
        return new Block(
                random.nextDouble(-spread, spread),
                random.nextDouble(-spread, spread),
                random.nextDouble(-spread, spread),
                Blocks.randomTurn(random),
                random.nextDouble(low, high),
                random.nextDouble(low, high),
                random.nextDouble(low, high),
                random.nextInt(1 << 24));
    }

    private static Block moved(Block b, double x, double y, double z) {
        return new Block(
                b.x() + x, b.y() + y, b.z() + z, b.turn(), b.hx(), b.hy(), b.hz(), b.rgb());
    }

    /** The nearest block on a ray; blocks whose sphere the ray misses are passed over first. */
    private static int colourOn(List<Block> blocks, Vector3d eye, Vector3d ray) {
        Hit best = null;
        Vector3d to = new Vector3d();
        for (Block b : blocks) {
            to.set(b.x(), b.y(), b.z()).sub(eye);
            double along = to.dot(ray);
            double square = b.hx() * b.hx() + b.hy() * b.hy() + b.hz() * b.hz();
            if (to.lengthSquared() - along * along <= square) {
                Hit hit = Blocks.hit(b, eye, ray, 0);
                if (hit != null && (best == null || hit.distance() < best.distance())) {
                    best = hit;
                }
            }
        }
        return best == null ? SKY : best.block().rgb();
    }

    @Test
    void hundredStaticAndTenThousandDynamicThingsAreDrawnRight() {
        SplittableRandom random = new SplittableRandom(41);
        List<Block> halfWay = new ArrayList<>();
        Camera camera = new Camera().lookAt(3, 5, 46, 0, 0, 0);
        try (Stage stage = new Stage()) {
            for (int i = 0; i < STATICS; i++) {
                Block b = block(random, 30, 0.5, 3);
                halfWay.add(b);
                stage.add(b, b.rgb());
            }
            long[] entities = new long[DYNAMICS];
            Block[] starts = new Block[DYNAMICS];
            for (int i = 0; i < DYNAMICS; i++) {
                starts[i] = block(random, 30, 0.1, 0.5);
                entities[i] = stage.add(starts[i], starts[i].rgb());
            }
            stage.publish();
            for (int i = 0; i < DYNAMICS; i++) {
                double x = random.nextDouble(-2, 2);
                double y = random.nextDouble(-2, 2);
                halfWay.add(moved(starts[i], x / 2, y / 2, 0));
                stage.set(entities[i], moved(starts[i], x, y, 0).pose());
            }
            Picture picture = draw(stage.step(), 0.5, camera, FLAT);
            Vector3d eye = camera.position(new Vector3d());
            Set<Integer> colours = new HashSet<>();
            int sure = 0;
            for (int k = 0; k < 500; k++) {
                int px = random.nextInt(WIDTH);
                int py = random.nextInt(HEIGHT);
                int rgb = SKY;
                boolean agreed = true;
                for (int s = 0; s < 9 && agreed; s++) {
                    double dx = px + 0.5 + (s % 3 - 1) * 0.75;
                    double dy = py + 0.5 + (s / 3 - 1) * 0.75;
                    Vector3d ray = Blocks.ray(camera, dx, dy, WIDTH, HEIGHT);
                    int hit = colourOn(halfWay, eye, ray);
                    agreed = s == 0 || hit == rgb;
                    rgb = hit;
                }
                if (agreed) {
                    sure++;
                    colours.add(rgb);
                    int shown = picture.at(px, py);
                    assertTrue(
                            Blocks.difference(rgb, shown) <= 3,
                            "seed 41, pixel %d,%d shows %06x, expected %06x"
                                    .formatted(px, py, shown & 0xFFFFFF, rgb));
                }
            }
            assertTrue(sure > 120 && colours.size() > 80, sure + " pixels, " + colours.size());
        }
    }

    @Test
    void whatIsOutOfSightIsLeftOutAndNothingElse() {
        SplittableRandom random = new SplittableRandom(42);
        List<Block> blocks = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
            blocks.add(block(random, 9, 0.3, 1.5));
        }
        try (Stage stage = new Stage()) {
            blocks.forEach(b -> stage.add(b, b.rgb()));
            PoseSnapshot snapshot = stage.publish();
            int least = Integer.MAX_VALUE;
            for (int i = 0; i < 5; i += 2) {
                // From amid the blocks, all around.
                Camera camera =
                        new Camera()
                                .lookAt(0, 0, 0, Math.sin(i), 0.3 * Math.cos(3 * i), Math.cos(i));
                camera.range(0.01, 100);
                List<Block> around = new ArrayList<>(blocks);
                around.removeIf(b -> new Vector3d(b.x(), b.y(), b.z()).length() < 3);
                try (Stage without = new Stage()) {
                    around.forEach(b -> without.add(b, b.rgb()));
                    compare(draw(without.publish(), 1, camera, FLAT), camera, around, FLAT);
                    least = Math.min(least, view.drawn());
                    assertTrue(view.drawn() < around.size(), "all " + around.size() + " drawn");
                }
            }
            assertTrue(least > 0, "nothing was drawn");
            Camera away = new Camera().lookAt(0, 0, 100, 0, 0, 200);
            draw(snapshot, 1, away, FLAT);
            assertEquals(0, view.drawn());
        }
    }

    @Test
    void thingsOutsideOfThePictureCastTheirShadowsIntoIt() {
        List<Block> blocks =
                List.of(
                        new Block(0, -1, 0, new Quaterniond(), 30, 1, 30, 0xC0C0C0),
                        new Block(1, 9, 0, new Quaterniond(), 2, 0.3, 2, 0x804020),
                        new Block(-4.5, 15, 1, new Quaterniond(), 0.7, 3, 0.7, 0x408020));
        Light light = SUNNY.from(-0.3, 1, 0.1);
        Camera camera = new Camera().lookAt(3, 4, 7, 2, 0, -1);
        try (Stage stage = new Stage()) {
            blocks.forEach(b -> stage.add(b, b.rgb()));
            int[] counts = compare(draw(stage.publish(), 1, camera, light), camera, blocks, light);
            assertEquals(1, view.drawn(), "only the floor is in the picture");
            assertTrue(counts[Seen.SHADED] > 300, "shaded pixels " + counts[Seen.SHADED]);
        }
    }

    @Test
    void thousandRestartsLeakNoObject() {
        view.close();
        try (Offscreen small = Offscreen.open(24, 16)) {
            restart(small);
        } finally {
            assertEquals(0, GlObjects.live(), "objects after closing");
            view = Offscreen.open(WIDTH, HEIGHT);
            view.effects(Effects.PLAIN);
        }
    }

    private static void restart(Offscreen small) {
        long madeBefore = GlObjects.made(GlObjects.Kind.BUFFER);
        Camera camera = new Camera().lookAt(0, 1, 5, 0, 0, 0);
        long first = -1;
        for (int scene = 0; scene < 1000; scene++) {
            try (Stage stage = new Stage()) {
                Mesh own = Meshes.box(0.5, 0.5, 0.5 + scene);
                Texture colour = Texture.of("one", 1, 1, new int[] {0xFF00FF00 + scene});
                stage.add(Pose.at(0, 0, 0), Model.of(own).texture(colour));
                stage.add(Pose.at(2, 0, 0), Model.of(Meshes.CUBE));
                small.draw(stage.publish(), 1, camera, scene % 100 == 0 ? SUNNY : FLAT);
            }
            if (first < 0) {
                first = GlObjects.live();
            }
            assertEquals(first, GlObjects.live(), "objects after restart " + scene);
        }
        assertTrue(GlObjects.made(GlObjects.Kind.BUFFER) - madeBefore >= 2000, "nothing was made");
    }

    @Test
    void steadyFramesAllocateNothing() {
        view.close();
        try (Offscreen small = Offscreen.open(64, 36)) {
            measureBytes(small);
        } finally {
            view = Offscreen.open(WIDTH, HEIGHT);
            view.effects(Effects.PLAIN);
        }
    }

    private static void measureBytes(Offscreen small) {
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        SplittableRandom random = new SplittableRandom(43);
        Camera camera = new Camera();
        try (Stage stage = new Stage()) {
            for (int i = 0; i < 200; i++) {
                Block b = block(random, 5, 0.1, 0.5);
                stage.add(b, b.rgb());
            }
            long least = Long.MAX_VALUE;
            for (int round = 0; round < 5; round++) {
                long bytes = 0;
                for (int frame = 0; frame < 20; frame++) {
                    PoseSnapshot snapshot = frame % 2 == 0 ? stage.step() : stage.publish();
                    camera.lookAt(frame * 0.1, 2, 12, 0, 0, 0);
                    long start = threads.getCurrentThreadAllocatedBytes();
                    small.draw(snapshot, frame * 0.05, camera, SUNNY);
                    bytes += threads.getCurrentThreadAllocatedBytes() - start;
                }
                least = Math.min(least, bytes);
            }
            assertEquals(0, least, "bytes of 20 frames, the quietest round of five");
        }
    }
}
