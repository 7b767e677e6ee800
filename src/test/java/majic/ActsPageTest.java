package majic;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.act.NoActs;
import majic.cli.ActCommand;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Tests the page on behaviours: its sources compile, and every command on it works as described. */
@Tag("jdk")
class ActsPageTest {
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

    /** Runs {@code ./majic act …}; the file is written beside its source, on the page into the current folder. */
    private void runInAShell(String line) {
        String[] words = (line.contains("make") ? line + " -o There.act" : line)
                .replace("./majic act ", "")
                .split(" ");
        String[] inFolder = Arrays.stream(words).map(this::here).toArray(String[]::new);
        StringWriter err = new StringWriter();
        int code = new CommandLine(new ActCommand())
                .setOut(new PrintWriter(new StringWriter()))
                .setErr(new PrintWriter(err))
                .execute(inFolder);
        assertThat(code).as(err.toString()).isZero();
    }
}
