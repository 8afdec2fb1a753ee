package dev.cairn.samples.scenefile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.List;

/** What is wrong in a scene file is told in one line: where it stands, what was expected. */
class SceneMistakesTest {
    private static final String HEAD = "{\n\"format\": \"cairn-scene\",\n\"version\": 1,\n";

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\u0001',
            value = {
                "\"gravty\": [0,0,0], | 4 | $.gravty | did you mean gravity? | unknown field"
                        + " \"gravty\"",
                "\"gravity\": [0,0], | 4 | $.gravity | three numbers | a list of 2",
                "\"gravity\": [0,\"x\",0], | 4 | $.gravity[1] | a number | \"x\"",
                "\"gravity\": [0,1e999,0], | 4 | $.gravity[1] | within | 1e999",
                "\"gravity\": [0,NaN,0], | 4 | $.gravity[1] | JSON | malformed",
                "\"camera\": {\"fieldOfViewDegrees\": 0}, | 4 | $.camera.fieldOfViewDegrees | from"
                        + " 2 to 170 | 0",
                "\"tick\": {\"seconds\": 0}, | 4 | $.tick.seconds | above 0 | 0",
                "\"tick\": {\"substeps\": 1.5}, | 4 | $.tick.substeps | whole number from 1 to 64 |"
                        + " 1.5",
                "\"tick\": {\"ticks\": 5, \"pictureTick\": 6}, | 4 | $.tick.pictureTick | from 0 to"
                        + " 5 | 6",
                "\"light\": {\"horizon\": \"blue\"}, | 4 | $.light.horizon | #RRGGBB | \"blue\"",
                "\"light\": {\"sun\": [0,-1,0]}, | 4 | $.light.sun | at least 0 | -1",
                "\"light\": {\"sunDirection\": [1e308,-1.7e308,0]}, | 4 | $.light.sunDirection |"
                        + " finite vector | 1.7E308",
                "\"light\": {\"sunDirection\": [0,0,0]}, | 4 | $.light.sunDirection | a direction |"
                        + " [0, 0, 0]",
                "\"name\": null, | 4 | $.name | in quotes | null",
                "\"name\": \"a\", \"name\": \"b\", | 4 | $.name | each field once | again",
                "\"name\": \"a\" | 5 | $.name | JSON | Unterminated",
            })
    void aMistakeInTheHeadIsToldWhereItStands(
            String lines, int line, String path, String expected, String found) {
        refuses(HEAD + lines + "\n\"entities\": []}", line, path, expected, found);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\u0001',
            value = {
                "\"shape\": {\"type\": \"sphere\"} | $.entities[0].shape | \"radius\" | type",
                "\"shape\": {\"type\": \"ball\", \"radius\": 1} | $.entities[0].shape.type | one of"
                        + " the shapes | \"ball\"",
                "\"shape\": {\"type\": \"spere\", \"radius\": 1} | $.entities[0].shape.type | did"
                        + " you mean sphere? | \"spere\"",
                "\"shape\": {\"type\": \"box\", \"radius\": 1} | $.entities[0].shape.radius |"
                        + " halfExtents | unknown",
                "\"shape\": {\"type\": \"box\", \"halfExtents\": [1,0,1]} | $.entities[0].shape |"
                        + " half | 0",
                "\"shape\": {\"type\": \"sphere\", \"radius\": -1} | $.entities[0].shape.radius |"
                        + " above 0 | -1",
                "\"shape\": {\"type\": \"hull\", \"points\": [[0,0,0],[1,0,0],[0,1,0]]} |"
                        + " $.entities[0].shape | point | ",
                "\"shape\": {\"type\": \"moved\", \"shape\": {\"type\": \"mesh\", \"file\":"
                        + " \"a.obj\"}, \"position\": [0,0,0], \"rotation\": [0,0,0,1]} |"
                        + " $.entities[0].shape.shape | no mesh | mesh",
                "\"name\": \"x\" | $.entities[0] | \"shape\" | name",
                "SPHERE, \"body\": \"static\" | $.entities[0].body | \"dynamic\", \"fixed\","
                        + " \"kinematic\" or \"none\" | \"static\"",
                "SPHERE, \"mass\": 0 | $.entities[0].mass | above 0 | 0",
                "SPHERE, \"scale\": [1,2,1] | $.entities[0].shape | three equal | 2",
                "SPHERE, \"scale\": [1,1,0] | $.entities[0].scale | above 0 | 0",
                "SPHERE, \"rotation\": [0,0,0,2] | $.entities[0].rotation | 1 +- | 2",
                "SPHERE, \"rotation\": [0,0,1] | $.entities[0].rotation | [x, y, z, w] | a list of"
                        + " 3",
                "SPHERE, \"rotation\": {\"axis\": [0,0,0], \"degrees\": 1} | $.entities[0].rotation"
                        + " | axis | 0",
                "SPHERE, \"material\": {\"restitution\": 1.1} | $.entities[0].material.restitution"
                        + " | from 0 to 1 | 1.1",
                "SPHERE, \"material\": {\"friction\": \"high\"} | $.entities[0].material.friction |"
                        + " at least 0 | \"high\"",
                "SPHERE, \"material\": {\"colour\": 1} | $.entities[0].material.colour | friction,"
                        + " restitution, density | unknown",
                "SPHERE, \"look\": {\"texture\": \"builtin:wood\"} | $.entities[0].look.texture |"
                        + " builtin:grid | builtin:wood",
                "SPHERE, \"controls\": [{\"does\": \"push\", \"along\": [0,0,1]}] |"
                    + " $.entities[0].controls[0] | a field \"key\" or a field \"mouse\" | does",
                "SPHERE, \"controls\": [{\"key\": \"up\", \"does\": \"push\", \"along\":"
                        + " [0,0,1]}] | $.entities[0].controls[0].key | did you mean UP? | \"up\"",
                "SPHERE, \"controls\": [{\"key\": \"UP\", \"does\": \"pull\", \"along\": [0,0,1]}]"
                        + " | $.entities[0].controls[0].does | push, turn, kick | \"pull\"",
                "SPHERE, \"camera\": {\"offset\": [0,0,0]} | $.entities[0].camera | distance |"
                        + " (0, 0, 0)",
                "SPHERE, \"look\": {\"visible\": 1} | $.entities[0].look.visible | true or false |"
                        + " 1",
            })
    void aMistakeInAnEntityIsToldWhereItStands(
            String fields, String path, String expected, String found) {
        String sphere = "\"shape\": {\"type\": \"sphere\", \"radius\": 1}";
        String text = HEAD + "\"entities\": [\n{" + fields.replace("SPHERE", sphere) + "}]}";
        refuses(text, 5, path, expected, found);
    }

    private static void refuses(String text, int line, String path, String expected, String found) {
        SceneFileException told =
                assertThrows(SceneFileException.class, () -> SceneReader.parse("a.json", text));
        String message = String.valueOf(told.getMessage());
        assertTrue(message.startsWith("a.json:" + line + ": "), message);
        assertEquals(line, told.line(), message);
        assertEquals(path, told.path(), message);
        assertTrue(message.contains(expected), message);
        assertTrue(found == null || message.contains(found), message);
        assertEquals(1, message.lines().count(), message);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "[]",
                "7",
                "{}",
                "{\"format\": \"other\"}",
                "{\"format\": \"cairn-scene\", \"version\": 2, \"entities\": []}",
                "{\"format\": \"cairn-scene\", \"version\": 1}",
                "{\"format\": \"cairn-scene\", \"version\": 1, \"entities\": []} {}",
                "// comment\n{\"format\": \"cairn-scene\"}"
            })
    void whatIsNoSceneIsRefused(String text) {
        assertThrows(SceneFileException.class, () -> SceneReader.parse("a.json", text));
    }

    @Test
    void deepNestingIsRefusedAndNoCrash() {
        String text = "[".repeat(100_000);
        assertThrows(SceneFileException.class, () -> SceneReader.parse("a.json", text));
    }

    @Test
    void aMissingFileAndAFolderAreTold(@TempDir Path folder) {
        assertTrue(message(folder.resolve("no.json")).contains("nothing there"));
        assertTrue(message(folder).contains("a folder"));
    }

    private static String message(Path file) {
        return String.valueOf(
                assertThrows(SceneFileException.class, () -> SceneReader.read(file)).getMessage());
    }

    /** A name is a stranger's text: the message is one line of a terminal, and no book. */
    @Test
    void messageIsOneShortLineWhateverTheFileHolds() {
        String name = "\\u001b[31m\\n" + "x".repeat(1_000_000);
        for (String wrong :
                List.of(
                        HEAD + "\"entities\": [{\"" + name + "\": {\"a\": 1}}]}",
                        HEAD + "\"entities\": [{\"" + name + "\": 1, \"" + name + "\": 1}]}",
                        HEAD + "\"entities\": [{\"" + name + "\": tru}]}",
                        HEAD + "\"entities\": [{\"shape\": \"" + name + "\"}]}")) {
            String told =
                    assertThrows(
                                    SceneFileException.class,
                                    () -> SceneReader.parse("a\u001b[2Jb.json", wrong))
                            .getMessage();
            assertTrue(told.length() < 1000, () -> told.length() + " characters");
            assertTrue(told.chars().noneMatch(Character::isISOControl), told);
            assertFalse(told.contains("JsonReader"), told);
        }
    }

    /** A second a million values, not a minute: the place is looked up for what is wrong only. */
    @Test
    void longListIsReadInProportion() {
        String list = HEAD + "\"entities\": [" + "0,\n".repeat(3_000_000) + "0]}";
        SceneFileException told =
                assertThrows(SceneFileException.class, () -> SceneReader.parse("long", list));
        assertEquals(4, told.line());
        assertEquals("$.entities[0]", told.path());
        SceneFileException many =
                assertThrows(
                        SceneFileException.class,
                        () -> SceneReader.parse("many", "[" + "0,".repeat(4_000_000) + "0]"));
        assertTrue(many.getMessage().contains("at most 4000000 values"), many.getMessage());
    }
}
