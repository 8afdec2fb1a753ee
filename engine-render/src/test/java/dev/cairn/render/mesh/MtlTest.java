package dev.cairn.render.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import javax.imageio.ImageIO;

/** Materials of .obj files: which triangle wears what, and what is said of broken ones. */
class MtlTest {
    private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    @TempDir Path folder;
    private final List<String> problems = new ArrayList<>();

    private ObjModel read(String obj, String mtl) throws IOException {
        Files.writeString(folder.resolve("my materials.mtl"), mtl);
        Path file = Files.writeString(folder.resolve("a.obj"), obj);
        return ObjReader.readModel(file, problems::add);
    }

    @Test
    void eachMaterialIsAPartWithItsTrianglesColourAndPicture() throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0x123456);
        Files.createDirectories(folder.resolve("a b"));
        ImageIO.write(image, "png", folder.resolve("a b/the picture.png").toFile());
        ObjModel model =
                read(
                        "mtllib my materials.mtl\n"
                                + SQUARE
                                + "usemtl red one\nf 1 2 3\nusemtl pic\nf 1 3 4\n"
                                + "usemtl red one\nf 4 3 2\nusemtl unused\n",
                        "newmtl red one\nKd 1 0 0.2 # a comment\nNs 12\nillum 2\n"
                                + "newmtl pic\nmap_Kd -s 1 2 -o 0 a b\\the picture.png\n"
                                + "newmtl unused\nKd 0.5\n");
        assertEquals(List.of(), problems);
        assertTrue(model.hasMaterials());
        assertEquals(3, model.mesh().triangleCount());
        assertEquals(2, model.look().parts().size());
        Model red = model.look().parts().get(0);
        Model pic = model.look().parts().get(1);
        assertEquals(0xFF0033, red.rgb());
        assertEquals(Texture.WHITE, red.texture());
        assertEquals(2, red.mesh().triangleCount());
        assertEquals(6, red.mesh().vertexCount());
        assertEquals(1, pic.mesh().triangleCount());
        assertEquals(0xFFFFFF, pic.rgb());
        assertArrayEquals(new int[] {0xFF123456, 0xFF000000}, pic.texture().argb());
        // The part keeps its corners' places: 1, 3 and 4.
        float[] v = pic.mesh().vertices();
        assertArrayEquals(
                new float[] {0, 0, 1, 1, 0, 1}, new float[] {v[0], v[1], v[8], v[9], v[16], v[17]});
    }

    @Test
    void withoutMaterialsItIsOnePart() throws IOException {
        ObjModel model = read(SQUARE + "f 1 2 3 4\n", "");
        assertFalse(model.hasMaterials());
        assertEquals(model.mesh(), model.look().parts().get(0).mesh());
        assertEquals(List.of(), problems);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "newmtl a;Kd 1 0       | my materials.mtl:2: expected 3 numbers from 0 to 1",
                "newmtl a;;Kd 1 0 2    | my materials.mtl:3: expected numbers from 0 to 1 after Kd,"
                        + " found '2'",
                "newmtl a;Kd 1 0 x     | found 'x'",
                "Kd 1 0 0              | my materials.mtl:1: expected newmtl before Kd",
                "newmtl a;map_Kd       | my materials.mtl:2: expected the path of a picture",
                "newmtl a;map_Kd no.png | no.png: expected a picture file",
                "newmtl a;hello        | expected an .mtl statement",
                "newmtl                | expected a name after newmtl",
                "newmtl b;Kd 1 1 1     | no .mtl file of it defines the material 'a'",
            })
    void whatIsBrokenIsToldAndShownAsMissing(String mtl, String told) throws IOException {
        ObjModel model =
                read(
                        "mtllib my materials.mtl\n" + SQUARE + "usemtl a\nf 1 2 3\n",
                        mtl.replace(';', '\n'));
        assertTrue(problems.stream().anyMatch(line -> line.contains(told)), problems.toString());
        assertEquals(Texture.missing(), model.look().parts().get(0).texture());
    }

    @Test
    void aMissingMaterialFileNamesTheLineThatAsksForIt() throws IOException {
        ObjModel model = read("# one\nmtllib no.mtl\n" + SQUARE + "usemtl a\nf 1 2 3\n", "");
        assertTrue(problems.get(0).contains("a.obj:2: "), problems.toString());
        assertTrue(problems.get(0).contains("no.mtl: expected an .mtl file"), problems.toString());
        assertEquals(1, model.look().parts().size());
    }
}
