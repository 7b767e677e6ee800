package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.act.NoActs;
import majic.cli.ActCommand;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Tests the page on behaviours: its sources compile, and every command on it works as described. */
@Tag("jdk")
class ActsPageTest {
    private static final Pattern WORD = Pattern.compile("\"[^\"]*\"|[^\" ]+");
    private static final Pattern HASH = Pattern.compile("trust \\S+ (\"[0-9a-f]{8}\")$");

    @TempDir
    private Path folder;

    private final Page page = Page.of("docs/acts.md");

    private List<String> block(String language, String part) {
        return page.block(language, part).lines();
    }

    private Path write(String name, List<String> lines) throws IOException {
        return Files.write(folder.resolve(name), lines);
    }

    /** Runs a line of the page, with its files in the test's folder. */
    private String here(String line) {
        return Pattern.compile("\\S+\\.(java|act|majic)\\b")
                .matcher(line)
                .replaceAll(file ->
                        Matcher.quoteReplacement(folder.resolve(file.group()).toString()));
    }

    @Test
    void itListsEveryBehaviourThatThereIs() {
        assertThat(NoActs.here().names())
                .allSatisfy(name -> assertThat(page.text()).containsPattern("(?m)^\\| `" + name + "` \\|"));
    }

    @Test
    void theLinesToTryAreDone() throws InterruptedException {
        try (LabRig rig = LabRig.exact().withAllRobots()) {
            for (String line : block("majic", "1 act AiboSquare")) {
                rig.say(line);
                rig.lab().time().sleep(2);
                assertThat(rig.said()).as(line).noneMatch(said -> said.contains("failed") || said.contains("no "));
            }
            assertThat(rig.team().member(1).owner()).isNull();
            assertThat(rig.team().member(2).owner()).isNotNull();
        }
    }

    @Test
    void theScriptGoesThereAndBack() throws Exception {
        write("patrol.majic", block("majic", "me turn 180"));
        try (LabRig rig = LabRig.exact().withAllRobots()) {
            double before = rig.truePose("pioneer").xMm();
            String line = here(block("majic", "patrol.majic").get(0));
            assertThat(rig.run(line)).anyMatch(said -> said.startsWith(line + ": done"));
            assertThat(rig.truePose("pioneer").xMm() - before).isBetween(400.0, 600.0);
        }
    }

    @Test
    void theClassIsMadeIntoAFileAgreedToAndRun() throws Exception {
        write("There.java", block("java", "class There"));
        block("sh", "act make").forEach(this::runInAShell);
        try (LabRig rig = LabRig.exact().withAllRobots()) {
            List<String> lines = block("majic", "trust There.act");
            String hash = rig.run(here(lines.get(0))).stream()
                    .map(HASH::matcher)
                    .filter(Matcher::find)
                    .map(found -> found.group(1))
                    .findFirst()
                    .orElseThrow();
            assertThat(rig.run(here(lines.get(1)).replace("HASH", hash))).anyMatch(said -> said.endsWith(": done"));
            assertThat(rig.run(here(lines.get(2)))).contains("2: There: there").anyMatch(said -> said.contains("done"));
            assertThat(rig.run(here("trust off There.act"))).anyMatch(said -> said.endsWith(": done"));
            assertThat(page.text()).contains("`trust off There.act`");
        }
    }

    /** On the page, a line of dots stands for further lines. The version and the hash depend on the build. */
    @Test
    void theProgrammersGuideShowsWhatMakingAndShowingPrint() throws IOException {
        write("There.java", block("java", "class There"));
        StringBuilder printed = new StringBuilder();
        StringBuilder expected = new StringBuilder();
        for (String line : Page.of("docs/programmers-guide.md")
                .block("console", "act make")
                .lines()) {
            if (line.startsWith("$ ")) {
                printed.append(runInAShell(line.substring(2)).replace(folder + File.separator, ""));
            } else {
                expected.append(line.equals("...") ? "(.*\\R)*?" : pattern(line) + "\\R");
            }
        }
        assertThat(printed.toString()).matches(expected.toString());
    }

    private static String pattern(String line) {
        int colon = line.indexOf(':');
        boolean varies = line.startsWith("made with:") || line.startsWith("SHA-256:");
        return varies ? line.substring(0, colon) + ": \\S.*" : Pattern.quote(line);
    }

    /**
     * Runs {@code ./majic act …}; the file is written beside its source, on the page into the current folder. Returns
     * what is printed.
     */
    private String runInAShell(String line) {
        String[] words = WORD.matcher(
                        (line.contains("make") ? line + " -o There.act" : line).replace("./majic act ", ""))
                .results()
                .map(word -> here(word.group().replace("\"", "")))
                .toArray(String[]::new);
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = new CommandLine(new ActCommand())
                .setOut(new PrintWriter(out))
                .setErr(new PrintWriter(err))
                .execute(words);
        assertThat(code).as(err.toString()).isZero();
        return out.toString();
    }
}
