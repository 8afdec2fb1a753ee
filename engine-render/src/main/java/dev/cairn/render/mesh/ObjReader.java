package dev.cairn.render.mesh;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Reads triangles from Wavefront {@code .obj} files. Read are {@code v}, {@code vt}, {@code vn} and
 * {@code f} with every form of index ({@code 1}, {@code 1/2}, {@code 1//3}, {@code 1/2/3}, negative
 * ones count back from the newest); polygons are cut into triangles; corners without a normal get
 * that of their flat face; {@code mtllib} and {@code usemtl} choose materials. Groups, smoothing,
 * lines, points and free-form statements are passed over. Anything else is an error that names the
 * file, the line, what was expected and what stands there. Any thread; no OpenGL.
 */
public final class ObjReader {
    /** The greatest number of {@code v}, {@code vt} or {@code vn} lines, and of triangles. */
    public static final int MAX_ELEMENTS = 4_000_000;

    /** Corners of a face that is cut ear by ear, which takes their square. */
    private static final int MAX_CONCAVE = 1000;

    private static final Set<String> PASSED_OVER =
            Set.of(
                    "o",
                    "g",
                    "s",
                    "mg",
                    "usemap",
                    "maplib",
                    "l",
                    "p",
                    "vp",
                    "cstype",
                    "deg",
                    "bmat",
                    "step",
                    "curv",
                    "curv2",
                    "surf",
                    "parm",
                    "trim",
                    "hole",
                    "scrv",
                    "sp",
                    "end",
                    "con",
                    "bevel",
                    "c_interp",
                    "d_interp",
                    "lod",
                    "shadow_obj",
                    "trace_obj",
                    "ctech",
                    "stech",
                    "call",
                    "scmp",
                    "csh");

    private final Path file;
    private final Numbers positions = new Numbers(3);
    private final Numbers coordinates = new Numbers(2);
    private final Numbers normals = new Numbers(3);
    private final MeshBuilder builder = new MeshBuilder();

    /**
     * Per position the newest vertex made from it, and per vertex the one before, its coordinate
     * and its normal or face.
     */
    private int[] newest = new int[0];

    private int[] older = new int[64];
    private int[] coordinateOf = new int[64];
    private int[] normalOf = new int[64];

    private int[] loop = new int[8];
    private int[] loopCoordinates = new int[8];
    private int[] loopNormals = new int[8];
    private int faces;
    private int line;

    /** Names of materials that faces use, and which one each triangle has; 0 is none. */
    private final Map<String, Integer> materials = new LinkedHashMap<>(Map.of("", 0));

    private final List<Library> libraries = new ArrayList<>();
    private int material;
    private int[] materialOfTriangle = new int[64];

    private record Library(String names, int line) {}

    private ObjReader(Path file) {
        this.file = file;
    }

    /**
     * Reads a file.
     *
     * @param file where it is
     * @return a mesh with at least one triangle; its {@link Mesh#points()} are all {@code v} lines
     *     in order
     * @throws ObjFormatException if the file is missing, cannot be read, is broken, has no face, or
     *     has more than {@value #MAX_ELEMENTS} elements of a kind
     */
    public static Mesh read(Path file) {
        return new ObjReader(file).run();
    }

    /**
     * Reads a file and the materials that it names.
     *
     * @param file where it is
     * @param problems hears, in one line each, of materials and pictures that cannot be used; the
     *     faces that wear them are shown with {@link Texture#missing}
     * @return mesh and look
     * @throws ObjFormatException as {@link #read}
     */
    public static ObjModel readModel(Path file, Consumer<String> problems) {
        ObjReader reader = new ObjReader(file);
        Mesh mesh = reader.run();
        return new ObjModel(mesh, reader.look(mesh, problems), reader.materials.size() > 1);
    }

    private ModelGroup look(Mesh mesh, Consumer<String> problems) {
        Map<String, MtlReader.Surface> known = new HashMap<>();
        known.put("", MtlReader.Surface.PLAIN);
        for (Library library : libraries) {
            // One statement may name several files, and a name may hold blanks.
            Path whole = file.resolveSibling(library.names());
            String[] names =
                    Files.isRegularFile(whole)
                            ? new String[] {library.names()}
                            : library.names().split("\\s+");
            for (String name : names) {
                try {
                    known.putAll(MtlReader.read(file.resolveSibling(name), problems));
                } catch (ObjFormatException unusable) {
                    problems.accept(file + ":" + library.line() + ": " + unusable.getMessage());
                }
            }
        }
        List<Model> parts = new ArrayList<>();
        materials.forEach((name, number) -> {
            Mesh part =
                    materials.size() == 1
                            ? mesh
                            : builder.part(
                                    file + (name.isEmpty() ? "" : ", material " + name),
                                    materialOfTriangle,
                                    number);
            if (part.triangleCount() == 0) {
                return;
            }
            MtlReader.Surface surface = known.get(name);
            if (surface == null) {
                problems.accept(file + ": no .mtl file of it defines the material '" + name + "'");
                surface = MtlReader.Surface.MISSING;
            }
            parts.add(Model.of(part).color(surface.rgb()).texture(surface.texture()));
        });
        return new ModelGroup(parts);
    }

    private Mesh run() {
        if (!Files.exists(file)) {
            throw new ObjFormatException(
                    file, 0, "expected an .obj file, found nothing there", null);
        }
        if (Files.isDirectory(file)) {
            throw new ObjFormatException(file, 0, "expected an .obj file, found a folder", null);
        }
        if (!Files.isRegularFile(file)) {
            // whoever reads a pipe may wait for ever
            throw new ObjFormatException(
                    file, 0, "expected an .obj file, found a pipe or a device", null);
        }
        try (BoundedLines reader = new BoundedLines(file)) {
            String text;
            while ((text = reader.next()) != null) {
                line++;
                int first = line;
                statement(text.endsWith("\\") ? continued(text, reader) : text, first);
            }
        } catch (IOException e) {
            throw new ObjFormatException(file, line, "expected a readable file, found: " + e, e);
        } catch (OutOfMemoryError e) {
            throw new ObjFormatException(
                    file,
                    line,
                    "expected a mesh that fits into memory, found too many elements; simplify it or"
                            + " raise -Xmx",
                    e);
        }
        if (builder.triangleCount() == 0) {
            throw new ObjFormatException(
                    file,
                    0,
                    "expected at least one face (f), found "
                            + positions.count
                            + " vertices (v) and no face",
                    null);
        }
        return builder.build(file.toString(), positions.toArray());
    }

    /** A line and those that its backslash, and theirs, joins to it. */
    private String continued(String begun, BoundedLines reader) throws IOException {
        StringBuilder whole = new StringBuilder();
        String text = begun;
        while (text.endsWith("\\")) {
            whole.append(text, 0, text.length() - 1).append(' ');
            if (whole.length() > BoundedLines.LONGEST) {
                throw new IOException("a line of more than " + BoundedLines.LONGEST);
            }
            text = reader.next();
            line++;
            if (text == null) {
                return whole.toString();
            }
        }
        return whole.append(text).toString();
    }

    private void statement(String raw, int at) {
        int hash = raw.indexOf('#');
        String text = (hash < 0 ? raw : raw.substring(0, hash)).strip();
        if (text.isEmpty()) {
            return;
        }
        String[] words = text.split("\\s+");
        switch (words[0]) {
            case "v" -> {
                // After x y z may come a weight or a colour.
                if (words.length < 4 || words.length > 8) {
                    throw error(
                            at,
                            "3 coordinates after v",
                            words.length - 1 + " numbers in '" + shown(text) + "'");
                }
                numbers(positions, words, 3, at);
            }
            case "vt" -> {
                if (words.length < 2 || words.length > 4) {
                    throw error(
                            at,
                            "1 to 3 numbers after vt",
                            words.length - 1 + " numbers in '" + shown(text) + "'");
                }
                numbers(coordinates, words, Math.min(2, words.length - 1), at);
            }
            case "vn" -> {
                if (words.length != 4) {
                    throw error(
                            at,
                            "3 numbers after vn",
                            words.length - 1 + " numbers in '" + shown(text) + "'");
                }
                numbers(normals, words, 3, at);
            }
            case "f", "fo" -> face(words, at);
            case "mtllib" ->
                    libraries.add(new Library(text.substring("mtllib".length()).strip(), at));
            case "usemtl" ->
                    material =
                            materials.computeIfAbsent(
                                    text.substring("usemtl".length()).strip(),
                                    name -> materials.size());
            default -> {
                if (!PASSED_OVER.contains(words[0])) {
                    throw error(
                            at,
                            "an .obj statement (v, vt, vn, f, g, usemtl, ...)",
                            "'" + shown(words[0]) + "'");
                }
            }
        }
    }

    private void numbers(Numbers into, String[] words, int count, int at) {
        if (into.count >= MAX_ELEMENTS) {
            throw error(
                    at,
                    "at most " + MAX_ELEMENTS + " lines of " + words[0],
                    "more; simplify the mesh");
        }
        int base = into.grow();
        for (int i = 0; i < count; i++) {
            into.values[base + i] = number(words[i + 1], words[0], at);
        }
    }

    private double number(String word, String statement, int at) {
        char last = word.charAt(word.length() - 1);
        if (last == '.' || (last >= '0' && last <= '9')) {
            try {
                double value = Double.parseDouble(word);
                if (Math.abs(value) <= Float.MAX_VALUE) {
                    return value;
                }
                throw error(
                        at, "numbers within +-3.4e38 after " + statement, "'" + shown(word) + "'");
            } catch (NumberFormatException e) {
                // Told below, like a word that does not end in a digit ("1.0f", "NaN").
            }
        }
        throw error(at, "a number after " + statement, "'" + shown(word) + "'");
    }

    private void face(String[] words, int at) {
        int count = words.length - 1;
        if (count < 3) {
            throw error(at, "at least 3 corners after f", count + "");
        }
        if (builder.triangleCount() + count - 2 > MAX_ELEMENTS) {
            throw error(at, "at most " + MAX_ELEMENTS + " triangles", "more; simplify the mesh");
        }
        if (loop.length < count) {
            loop = new int[2 * count];
            loopCoordinates = new int[2 * count];
            loopNormals = new int[2 * count];
        }
        for (int i = 0; i < count; i++) {
            corner(words[i + 1], i, at);
        }
        double[] normal = new double[3];
        Polygons.normal(positions.values, loop, count, normal);
        if (count > MAX_CONCAVE && !Polygons.isConvex(positions.values, loop, count, normal)) {
            throw error(
                    at,
                    "at most " + MAX_CONCAVE + " corners in a face that is not convex",
                    count + "; cut it into smaller ones");
        }
        int[] vertices = new int[count];
        faces++;
        for (int i = 0; i < count; i++) {
            vertices[i] = vertexOf(loop[i], loopCoordinates[i], loopNormals[i], normal);
        }
        int[] corners = new int[3 * (count - 2)];
        Polygons.triangulate(positions.values, loop, count, normal, corners);
        for (int i = 0; i < corners.length; i += 3) {
            int triangle = builder.triangleCount();
            if (triangle == materialOfTriangle.length) {
                materialOfTriangle = Arrays.copyOf(materialOfTriangle, 2 * triangle);
            }
            materialOfTriangle[triangle] = material;
            builder.triangle(
                    vertices[corners[i]], vertices[corners[i + 1]], vertices[corners[i + 2]]);
        }
    }

    private void corner(String word, int i, int at) {
        int slash = word.indexOf('/');
        int second = slash < 0 ? -1 : word.indexOf('/', slash + 1);
        String v = slash < 0 ? word : word.substring(0, slash);
        String vt =
                slash < 0
                        ? ""
                        : second < 0
                                ? word.substring(slash + 1)
                                : word.substring(slash + 1, second);
        String vn = second < 0 ? "" : word.substring(second + 1);
        loop[i] = index(v, word, "vertex (v)", positions.count, at);
        loopCoordinates[i] =
                vt.isEmpty()
                        ? -1
                        : index(vt, word, "texture coordinate (vt)", coordinates.count, at);
        loopNormals[i] = vn.isEmpty() ? -1 : index(vn, word, "normal (vn)", normals.count, at);
    }

    private int index(String digits, String word, String what, int count, int at) {
        int value;
        try {
            value = Integer.parseInt(digits);
        } catch (NumberFormatException e) {
            throw error(
                    at, "a corner as v, v/vt, v//vn or v/vt/vn after f", "'" + shown(word) + "'");
        }
        int index = value < 0 ? count + value : value - 1;
        if (value == 0 || index < 0 || index >= count) {
            String range =
                    count == 0
                            ? "none was defined before this line"
                            : "1.." + count + " or -" + count + "..-1";
            throw error(
                    at,
                    "the number of a " + what + " defined before this line (" + range + ")",
                    value + " in '" + shown(word) + "'");
        }
        return index;
    }

    /**
     * The vertex with this position, coordinate and normal; faces without normals share vertices
     * only within themselves.
     */
    private int vertexOf(int position, int coordinate, int normal, double[] flat) {
        if (newest.length <= position) {
            int old = newest.length;
            newest = Arrays.copyOf(newest, Math.max(positions.count, 2 * old));
            Arrays.fill(newest, old, newest.length, -1);
        }
        int normalKey = normal >= 0 ? normal : -1 - faces;
        for (int v = newest[position]; v >= 0; v = older[v]) {
            if (coordinateOf[v] == coordinate && normalOf[v] == normalKey) {
                return v;
            }
            if (normal < 0 && normalOf[v] < 0 && normalOf[v] != normalKey) {
                // of an earlier face, and so are all before it
                break;
            }
        }
        int v = addVertex(position, coordinate, normal, flat);
        if (older.length <= v) {
            older = Arrays.copyOf(older, 2 * v);
            coordinateOf = Arrays.copyOf(coordinateOf, 2 * v);
            normalOf = Arrays.copyOf(normalOf, 2 * v);
        }
        older[v] = newest[position];
        newest[position] = v;
        coordinateOf[v] = coordinate;
        normalOf[v] = normalKey;
        return v;
    }

    private int addVertex(int position, int coordinate, int normal, double[] flat) {
        double nx = flat[0];
        double ny = flat[1];
        double nz = flat[2];
        if (normal >= 0) {
            double x = normals.values[3 * normal];
            double y = normals.values[3 * normal + 1];
            double z = normals.values[3 * normal + 2];
            double length = Math.sqrt(x * x + y * y + z * z);
            // A normal of no length says nothing; the flat one stays.
            if (length > 0) {
                nx = x / length;
                ny = y / length;
                nz = z / length;
            }
        }
        double u = coordinate < 0 ? 0 : coordinates.values[2 * coordinate];
        double v = coordinate < 0 ? 0 : coordinates.values[2 * coordinate + 1];
        double[] p = positions.values;
        return builder.vertex(
                p[3 * position], p[3 * position + 1], p[3 * position + 2], nx, ny, nz, u, v);
    }

    private ObjFormatException error(int at, String expected, String found) {
        return new ObjFormatException(
                file, at, "expected " + expected + ", found " + found, (@Nullable Throwable) null);
    }

    /** At most 40 printable characters of what stands in the file, since it may be anything. */
    static String shown(String text) {
        String cut = text.length() > 40 ? text.substring(0, 40) + "..." : text;
        return cut.replaceAll("[^\\x20-\\x7e]", "?");
    }

    /** A growing list of small vectors. */
    private static final class Numbers {
        private final int stride;
        private double[] values;
        private int count;

        private Numbers(int stride) {
            this.stride = stride;
            this.values = new double[64 * stride];
        }

        /** Makes room for one more, set to zero, and returns where it starts. */
        private int grow() {
            int base = count++ * stride;
            if (base == values.length) {
                values = Arrays.copyOf(values, 2 * base);
            }
            return base;
        }

        private double[] toArray() {
            return Arrays.copyOf(values, count * stride);
        }
    }
}
