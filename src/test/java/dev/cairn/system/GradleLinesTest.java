package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The lines for Gradle in the quickstart ask for what the pom beside them asks for. Where there is
 * a Gradle, they are run: by {@code MavenCommandsTest}.
 */
class GradleLinesTest {
    private final String page;
    private final String pom;
    private final String gradle;

    GradleLinesTest() throws IOException {
        page = Files.readString(DocsTest.ROOT.resolve("docs/quickstart.md"));
        pom = block("xml");
        gradle = block("groovy");
    }

    private String block(String language) {
        String fence = "```" + language + "\n";
        int begin = page.indexOf(fence);
        assertTrue(begin >= 0 && page.indexOf(fence, begin + 1) < 0, "one block of " + language);
        return page.substring(begin + fence.length(), page.indexOf("```", begin + fence.length()));
    }

    private static List<String> all(String pattern, String text) {
        List<String> found = new ArrayList<>();
        Matcher matcher = Pattern.compile(pattern, Pattern.DOTALL).matcher(text);
        while (matcher.find()) {
            StringBuilder joined = new StringBuilder(matcher.group(1));
            for (int i = 2; i <= matcher.groupCount(); i++) {
                joined.append(':').append(matcher.group(i));
            }
            found.add(joined.toString());
        }
        assertFalse(found.isEmpty(), pattern);
        return found;
    }

    @Test
    void theBillOfMaterialsAndTheArtifactsAreThoseOfThePom() {
        String whole =
                "<groupId>(dev.cairn)</groupId>\\s*<artifactId>([\\w-]+)</artifactId>\\s*"
                        + "<version>([^<]+)</version>";
        assertEquals(all(whole, pom), all("platform\\('([^']+)'\\)", gradle));
        String part = "<groupId>(dev.cairn)</groupId>\\s*<artifactId>([\\w-]+)</artifactId>\\s*";
        assertEquals(all(part + "</dependency>", pom), all("implementation '([^']+)'", gradle));
        assertEquals(
                all(part + "<scope>runtime</scope>", pom), all("runtimeOnly '([^']+)'", gradle));
    }

    @Test
    void theFlagsAndTheReleaseOfJavaAreThoseOfThePom() {
        String flags = all("applicationDefaultJvmArgs = \\[([^\\]]*)\\]", gradle).getFirst();
        assertEquals(all("<argument>(--[^<]+)</argument>", pom), all("'([^']+)'", flags));
        assertEquals(
                all("<maven.compiler.release>(\\d+)<", pom),
                all("JavaLanguageVersion\\.of\\((\\d+)\\)", gradle));
        String program = all("mainClass = '(\\w+)'", gradle).getFirst();
        assertTrue(page.contains("public class " + program + " {"), program);
    }

    /** What is installed from a clone is in the own machine's repository, the rest is not. */
    @Test
    void bothRepositoriesAreAsked() {
        assertTrue(gradle.contains("mavenLocal(); mavenCentral()"), gradle);
        assertEquals(count(gradle, '{'), count(gradle, '}'), gradle);
        assertEquals(count(gradle, '('), count(gradle, ')'), gradle);
        assertEquals(0, count(gradle, '\'') % 2, gradle);
    }

    private static long count(String text, char letter) {
        return text.chars().filter(c -> c == letter).count();
    }
}
