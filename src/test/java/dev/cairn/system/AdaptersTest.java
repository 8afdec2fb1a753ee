package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The adapters of docs/coming-from.md, compiled against the libraries that they are for and run: a
 * point of a body is where Cairn says.
 */
final class AdaptersTest {
    private static final Quaterniond TURN = new Quaterniond().rotationXYZ(0.3, -1.1, 2.4);

    private static final Vector3d PLACE = new Vector3d(3, -4, 5);
    private static final Vector3d POINT = new Vector3d(0.25, 2, -1.5);

    /** Where the point of the body is, by JOML. */
    private static final Vector3d THERE =
            new Matrix4d().translationRotate(PLACE, TURN).transformPosition(new Vector3d(POINT));

    @Test
    void jMonkeyEngine(@TempDir Path folder) throws Exception {
        requireLibrary("com.jme3.scene.Node");
        Class<?> adapter = compiled("JmeAdapter", folder);
        Object node = Class.forName("com.jme3.scene.Node").getConstructor().newInstance();
        adapter.getMethod(
                        "place",
                        Vector3d.class,
                        Quaterniond.class,
                        Class.forName("com.jme3.scene.Spatial"))
                .invoke(null, PLACE, TURN, node);
        Class<?> vector = Class.forName("com.jme3.math.Vector3f");
        Object point =
                vector.getConstructor(float.class, float.class, float.class)
                        .newInstance((float) POINT.x, (float) POINT.y, (float) POINT.z);
        Object there =
                node.getClass()
                        .getMethod("localToWorld", vector, vector)
                        .invoke(node, point, vector.getConstructor().newInstance());
        assertThere(there);
        assertBack(adapter, Class.forName("com.jme3.scene.Spatial"), node);
    }

    @Test
    void libGdx(@TempDir Path folder) throws Exception {
        requireLibrary("com.badlogic.gdx.math.Matrix4");
        Class<?> adapter = compiled("GdxAdapter", folder);
        Class<?> matrix = Class.forName("com.badlogic.gdx.math.Matrix4");
        Object transform = matrix.getConstructor().newInstance();
        adapter.getMethod("place", Vector3d.class, Quaterniond.class, matrix)
                .invoke(null, PLACE, TURN, transform);
        Class<?> vector = Class.forName("com.badlogic.gdx.math.Vector3");
        Object point =
                vector.getConstructor(float.class, float.class, float.class)
                        .newInstance((float) POINT.x, (float) POINT.y, (float) POINT.z);
        assertThere(vector.getMethod("mul", matrix).invoke(point, transform));
        assertBack(adapter, matrix, transform);
    }

    private static void assertThere(Object vector) throws ReflectiveOperationException {
        assertEquals(THERE.x, number(vector, "x"), 1e-5);
        assertEquals(THERE.y, number(vector, "y"), 1e-5);
        assertEquals(THERE.z, number(vector, "z"), 1e-5);
    }

    /** Their pose as ours again. */
    private static void assertBack(Class<?> adapter, Class<?> type, Object theirs)
            throws ReflectiveOperationException {
        Vector3d place = new Vector3d();
        Quaterniond turn = new Quaterniond();
        adapter.getMethod("read", type, Vector3d.class, Quaterniond.class)
                .invoke(null, theirs, place, turn);
        assertEquals(0, place.distance(PLACE), 1e-5);
        // q and -q are the same rotation.
        assertEquals(1, Math.abs(turn.dot(TURN)), 1e-6);
    }

    private static double number(Object vector, String name) throws ReflectiveOperationException {
        return vector.getClass().getField(name).getFloat(vector);
    }

    private static void requireLibrary(String type) {
        try {
            Class.forName(type);
        } catch (ClassNotFoundException absent) {
            assumeTrue(false, type + " is on the class path of Maven's tests only");
        }
    }

    private static Class<?> compiled(String name, Path folder)
            throws IOException, ClassNotFoundException {
        String page = Files.readString(DocsTest.ROOT.resolve("docs/coming-from.md"));
        Matcher block = Pattern.compile("```java\\n(.*?)```", Pattern.DOTALL).matcher(page);
        while (block.find()) {
            if (block.group(1).contains("class " + name + " ")) {
                Path file = folder.resolve(name + ".java");
                Files.writeString(file, block.group(1));
                DocsTest.compile(file, folder);
                URL[] urls = {folder.toUri().toURL()};
                return new URLClassLoader(urls, AdaptersTest.class.getClassLoader())
                        .loadClass(name);
            }
        }
        throw new AssertionError("the page has no " + name);
    }
}
