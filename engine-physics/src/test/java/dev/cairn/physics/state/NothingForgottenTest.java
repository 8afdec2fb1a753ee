package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.junit.jupiter.api.Test;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * Whatever can change in a world is saved, or is named in {@code scratch.txt} as something that no
 * later tick reads: a walk over all objects that a world reaches, field by field.
 */
class NothingForgottenTest {
    private static final String REMEDY =
            "a field that can change is neither saved nor scratch. If the next tick reads what this"
                    + " one left in it, hand it to the visitor in the method state(StateVisitor) of"
                    + " its class (a column: in columns(Columns)). If every tick writes it before"
                    + " reading it, add a line to engine-physics/src/test/resources/dev/cairn/"
                    + "physics/state/scratch.txt";

    /** What was handed to a visitor: names by owner. */
    private static final class Recorder implements StateVisitor {
        final Map<Object, Set<String>> saved = new IdentityHashMap<>();
        private Set<String> now = new TreeSet<>();

        @Override
        public boolean isRestoring() {
            return false;
        }

        @Override
        public void section(String name, Object owner) {
            now = saved.computeIfAbsent(owner, key -> new TreeSet<>());
        }

        private <T> T note(String name, T value) {
            now.add(name);
            return value;
        }

        @Override
        public int value(String name, int value) {
            return note(name, value);
        }

        @Override
        public long value(String name, long value) {
            return note(name, value);
        }

        @Override
        public double value(String name, double value) {
            return note(name, value);
        }

        @Override
        public boolean value(String name, boolean value) {
            return note(name, value);
        }

        @Override
        public <T> T reference(String name, T value) {
            return note(name, value);
        }

        @Override
        public <A> A array(String name, A value, int from, int count, int room, boolean clears) {
            return note(name, value);
        }
    }

    @Test
    void everyFieldThatCanChangeIsSavedOrScratch() throws Exception {
        Set<String> scratch = scratch();
        Set<String> used = new TreeSet<>();
        Set<String> forgotten = new TreeSet<>();
        try (Jobs jobs = Jobs.of(2);
                PhysicsWorld world = world(jobs)) {
            Recorder recorder = new Recorder();
            Field root = PhysicsWorld.class.getDeclaredField("whole");
            root.setAccessible(true);
            ((Stateful) root.get(world)).state(recorder);
            assertTrue(recorder.saved.size() > 30, "visited only " + recorder.saved.size());
            new Walk(recorder.saved, scratch, used, forgotten).from(world);
        }
        assertEquals(Set.of(), forgotten, REMEDY);
        scratch.removeAll(used);
        assertEquals(Set.of(), scratch, "lines of scratch.txt that name nothing any more");
    }

    /** A world in which as much as possible has happened: all columns are in use. */
    private static PhysicsWorld world(Jobs jobs) {
        PhysicsWorld world =
                PhysicsWorld.builder()
                        .jobs(jobs)
                        .settings(PhysicsSettings.DEFAULT.withSleepSeconds(0.1))
                        .build();
        world.contacts().setHitSpeed(0.5);
        world.collisions().setHook(contact -> {});
        Material rough = new Material(0.6, 0.2, 1000, 0.001);
        Collider belt = Collider.of(Box.ofHalfExtents(20, 1, 20)).surfaceVelocity(0.1, 0, 0);
        world.add(Body.fixed().collider(belt).at(0, -1, 0));
        double[] corners = {30, 0, -9, 30, 0, 9, 50, 1, 9, 50, 0, -9};
        TriangleMesh ground = TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3});
        world.add(Body.fixed().shape(ground));
        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(40, 2, 0));
        HeightField field = HeightField.of(3, 3, 5, 5, new double[9]).withHole(0, 0, 1, 1, true);
        BodyRef hill = world.add(Body.fixed().shape(field).at(30, 0, 20));
        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(37, 1, 27));
        BodyRef lift = world.add(Body.kinematic().shape(Box.cubeOfHalfExtent(1)).at(-4, 2, 0));
        BodyRef last = null;
        for (int i = 0; i < 12; i++) {
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.4))
                                    .material(rough)
                                    .with(new Force(1, 0, 0))
                                    .at(i, 3, 0));
            world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.4)).at(i, 0.4, 3));
            world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.4)).at(i, 1.2, 3));
            world.add(Body.dynamic().shape(Cylinder.of(0.4, 0.4)).at(i, 0.4, 6));
            world.add(
                    Body.dynamic()
                            .collider(Collider.of(Box.cubeOfHalfExtent(0.3)))
                            .collider(Collider.of(Sphere.of(0.3)).at(0, 0.6, 0))
                            .at(i, 0.3, 9));
            if (last != null) {
                world.add(Joint.ball(last, ball).at(i - 0.5, 3, 0));
            }
            last = ball;
        }
        // It falls asleep under a ball that spins on.
        world.add(Body.fixed().shape(Box.cubeOfHalfExtent(1)).at(0, -1, 40));
        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.4)).at(0, 0.4, 40));
        world.add(Body.dynamic().shape(Sphere.of(0.4)).at(0, 1.2, 40).angularVelocity(0, 5, 0));
        for (int tick = 0; tick < 60; tick++) {
            lift.moveTo(-4, 2 + 0.01 * tick, 0);
            hill.setShape(field.withHeights(1, 1, 1, new double[] {0.01 * tick}));
            world.step(tick < 30 ? 1.0 / 60 : 1.0 / 90);
        }
        return world;
    }

    private static Set<String> scratch() throws IOException {
        Set<String> lines = new TreeSet<>();
        try (InputStream in = NothingForgottenTest.class.getResourceAsStream("scratch.txt");
                BufferedReader reader =
                        new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                String name = line.replaceAll("#.*", "").strip();
                if (!name.isEmpty()) {
                    assertTrue(lines.add(name), name + " is there twice");
                }
            }
        }
        return lines;
    }

    private record Walk(
            Map<Object, Set<String>> saved,
            Set<String> scratch,
            Set<String> used,
            Set<String> forgotten) {

        void from(Object root) throws IllegalAccessException {
            Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
            ArrayDeque<Object> open = new ArrayDeque<>();
            open.add(root);
            seen.add(root);
            while (!open.isEmpty()) {
                for (Object next : look(open.remove())) {
                    if (seen.add(next)) {
                        open.add(next);
                    }
                }
            }
        }

        /** Judges the fields of an object; what is behind them. */
        private Collection<Object> look(Object object) throws IllegalAccessException {
            ArrayDeque<Object> behind = new ArrayDeque<>();
            if (object instanceof Object[] array) {
                for (Object each : array) {
                    enter(each, behind);
                }
                return behind;
            }
            if (object instanceof Collection<?> list) {
                list.forEach(each -> enter(each, behind));
                return behind;
            }
            for (Class<?> type = object.getClass();
                    type != null && isOurs(type);
                    type = type.getSuperclass()) {
                if (takes(name(type))) {
                    return behind;
                }
                for (Field field : type.getDeclaredFields()) {
                    if (!Modifier.isStatic(field.getModifiers())) {
                        judge(object, type, field, behind);
                    }
                }
            }
            return behind;
        }

        private void judge(Object owner, Class<?> type, Field field, ArrayDeque<Object> behind)
                throws IllegalAccessException {
            field.setAccessible(true);
            Object value = field.get(owner);
            String full = name(type) + "." + field.getName();
            boolean isSaved = isSaved(owner.getClass(), type, field.getName());
            boolean isScratch = takes(full);
            boolean isWay = takes(full + " >");
            if (canChange(field) && !isSaved && !isScratch && !isWay) {
                forgotten.add(full);
            }
            if (!isScratch) {
                enter(value, behind);
            }
        }

        /**
         * Whether the field was handed over by this object or another one of its class: stages hold
         * empty stores until they are given the world's own.
         */
        private boolean isSaved(Class<?> owner, Class<?> type, String name) {
            return saved.entrySet().stream()
                    .anyMatch(e ->
                            type.isInstance(e.getKey())
                                    && e.getKey().getClass() == owner
                                    && e.getValue().contains(name));
        }

        /** Whether a line names it; such a line is of use. */
        private boolean takes(String name) {
            return scratch.contains(name) && (used.add(name) || true);
        }

        private static boolean canChange(Field field) {
            return !Modifier.isFinal(field.getModifiers())
                    || field.getType().isArray()
                    || Collection.class.isAssignableFrom(field.getType())
                    || Map.class.isAssignableFrom(field.getType());
        }

        private static void enter(Object value, Collection<Object> behind) {
            if (value == null || value instanceof Shape) {
                return; // shapes never change
            }
            Class<?> type = value.getClass();
            boolean isArray = type.isArray() && !type.getComponentType().isPrimitive();
            if (isArray && Array.getLength(value) > 0
                    || value instanceof Collection<?>
                    || isOurs(type)) {
                behind.add(value);
            }
        }

        private static boolean isOurs(Class<?> type) {
            return type.getName().startsWith("dev.cairn.")
                    && !type.isHidden()
                    && !type.isEnum()
                    && !type.isRecord();
        }

        private static String name(Class<?> type) {
            return type.getName().replace("dev.cairn.", "").replace('$', '.');
        }
    }
}
