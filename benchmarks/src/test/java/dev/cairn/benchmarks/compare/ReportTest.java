package dev.cairn.benchmarks.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.ColdStart;
import dev.cairn.benchmarks.compare.measure.Judge;
import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.Peer;
import dev.cairn.benchmarks.peer.PeerSettings;
import dev.cairn.samples.scenes.BouncingBall;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.xml.sax.InputSource;

import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

import javax.xml.parsers.DocumentBuilderFactory;

/** The page, the tables and the truths, without an engine. */
class ReportTest {
    private static Results.Point point(Engine engine, int n, Double error, String failure) {
        Protocol.Answer judged =
                new Protocol.Answer(
                        failure,
                        false,
                        error,
                        Map.of(),
                        1e-3,
                        4,
                        Peer.UNKNOWN,
                        4,
                        300,
                        null,
                        null,
                        null,
                        -1,
                        List.of(),
                        List.of("a <note> & more"));
        List<Protocol.Answer> rounds = new ArrayList<>();
        for (double cpu : new double[] {3 * n, 1 * n, 2 * n}) {
            rounds.add(Protocol.Answer.timed(4, 300, cpu, 0.1, 0.2, 0));
        }
        return new Results.Point("stack-4", Map.of("boxes", "4"), engine, set(n), judged, rounds);
    }

    private static final Results RESULTS =
            new Results(
                    Map.of("processor", "a & b"),
                    Map.of("rounds", "3"),
                    List.of(
                            point(Engine.CAIRN, 1, 1e-3, null),
                            point(Engine.CAIRN, 4, 0.0, null),
                            point(Engine.JOLT, 1, null, "fell <over>"),
                            new Results.Point(
                                    "stack-4",
                                    Map.of("boxes", "4"),
                                    Engine.PHYSX,
                                    set(1),
                                    Protocol.Answer.failed("PhysX is not here", true),
                                    List.of())),
                    List.of(new Budget("stack-4", Engine.CAIRN, Map.of(Budget.BASE, 1e-3))),
                    List.of(
                            new Results.Cold(
                                    "pyramid",
                                    Engine.CAIRN,
                                    List.of(400.0, 20.0, 600.0, 2.0, 4000.0, 0.2),
                                    Map.of(ColdStart.FIRST_TICK, 20.0, ColdStart.SIXTY, 0.46))));

    private static PeerSettings set(int n) {
        return new PeerSettings(1, n, false, PeerSettings.Tuning.DEFAULT);
    }

    private static Document parse(String xml) throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setFeature("http://apache.org/xml/features/nonvalidating/load-external-dtd", false);
        return factory.newDocumentBuilder().parse(new InputSource(new StringReader(xml)));
    }

    @Test
    void pageIsWellFormedAndSaysWhatFailed() throws Exception {
        Page page = new Page(RESULTS);
        Document document = parse(page.write());
        String text = document.getDocumentElement().getTextContent().replaceAll("\\s+", " ");
        assertTrue(text.contains("better is down-left"));
        assertTrue(text.contains("fell <over>"));
        assertTrue(text.contains("not measured: PhysX is not here"));
        assertTrue(text.contains("a <note> & more"));
        assertEquals(3, document.getElementsByTagName("img").getLength());
        assertTrue(text.contains("Cold start"));
        assertTrue(text.contains("settled, s Cairn20.00.460––––"), text);
        assertTrue(text.contains("Where the error comes from"));
        for (String svg : page.svgs().values()) {
            assertTrue(parse(svg).getElementsByTagName("path").getLength() > 10);
        }
    }

    @Test
    void oneReasonStandsOnceForAllItsSubsteps() {
        Html html = new Html();
        SceneTables.failures(
                html,
                List.of(
                        point(Engine.JOLT, 1, null, "fell"),
                        point(Engine.JOLT, 2, 1e-3, null),
                        point(Engine.JOLT, 4, null, "fell"),
                        point(Engine.JOLT, 8, null, "too slow")));
        assertTrue(html.toString().contains("<li>Jolt – N = 1, 4: fell; N = 8: too slow</li>"));
    }

    @Test
    void readmeShowsEachEngineThatWasMeasured() throws Exception {
        ReadmePart part = new ReadmePart(RESULTS);
        String table = part.table();
        assertTrue(table.contains("| Cairn this build | **0** | **8.00** |"), table);
        assertFalse(table.contains("Jolt"), "not measured at N = 4: " + table);
        assertTrue(parse(part.picture()).getElementsByTagName("path").getLength() > 10);
    }

    @Test
    void medianAndRangeAreThoseOfTheRounds() {
        Results.Point point = point(Engine.CAIRN, 4, 1e-3, null);
        assertEquals(8, point.cpuMicros());
        assertEquals(4, point.cpuLow());
        assertEquals(12, point.cpuHigh());
    }

    @Test
    void tablesHaveARowPerPoint(@TempDir Path folder) throws Exception {
        RESULTS.writeCsv(folder.resolve("r.csv"));
        List<String> lines = Files.readAllLines(folder.resolve("r.csv"));
        assertEquals(5, lines.size());
        assertTrue(lines.get(1).startsWith("stack-4,{boxes=4},cairn,"));
        RESULTS.writeJson(folder.resolve("r.json"));
        assertFalse(Files.readString(folder.resolve("r.json")).contains("NaN"));
    }

    /** Heights of a ball dropped from 1 m with e = 0.5: 2nd apex 0.25 m, by energy. */
    @Test
    void bounceMeetsItsApexes() {
        double fall = Math.sqrt(2 / 9.81);
        assertEquals(1, BouncingBall.height(1, 0.5, 0));
        assertEquals(0, BouncingBall.height(1, 0.5, fall), 1e-12);
        assertEquals(0.25, BouncingBall.height(1, 0.5, 1.5 * fall), 1e-12);
        assertEquals(0, BouncingBall.height(1, 0.5, 2 * fall), 1e-12);
        assertTrue(Double.isNaN(BouncingBall.height(1, 0.5, 2.1 * fall)));
    }

    @Test
    void numbersAreShort() {
        assertEquals("0.123", Html.number(0.1234));
        assertEquals("12.3", Html.number(12.34));
        assertEquals("1.23e-8", Html.number(1.234e-8));
        assertEquals("0", Html.number(0));
        assertEquals("–", Html.number(Double.NaN));
    }

    @Test
    void everyCaseDrawsAMetricThatItsSceneHas() {
        for (Case scene : Case.all()) {
            try (Judge judge = new Judge(scene)) {
                assertTrue(judge.description().movable() > 0, scene.id());
            }
        }
    }
}
