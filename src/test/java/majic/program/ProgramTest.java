package majic.program;

import static majic.program.MajicProcesses.talk;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import majic.bot.Pose;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the program as users start it: a process with arguments, input, output and an exit status. */
@Tag("jdk")
class ProgramTest {

    @TempDir
    private Path folder;

    @AutoClose
    private final MajicProcesses programs = new MajicProcesses();

    private Process start(String... arguments) throws IOException {
        return programs.start(folder, List.of(), List.of(arguments));
    }

    @Test
    void aPipeOfCommandsGetsAnAnswerALineAndTheLabAgrees() throws Exception {
        Process majic =
                start("--lab", "--exact", "--console", "--speed", "3", "--aibo-port", "0", "--pioneer-port", "0");

        String said = talk(majic, "2 move 1000\nwait\nlab\nquit\n");

        assertThat(said).contains("2 move 1000: done (").containsPattern("lab: pioneer x=-?\\d+ y=-?\\d+ heading=");
        assertThat(majic.exitValue()).as(said).isZero();
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "other systems have no DISPLAY")
    void aDisplayThatCannotBeUsedIsNamedInOneSentenceAndTheConsoleStarts() throws Exception {
        Process majic = programs.start(
                Map.of("DISPLAY", ":nowhere"), folder, List.of("-Djava.awt.headless=false"), List.of("--lab"));

        String said = talk(majic, "2 get model\nquit\n");

        assertThat(said)
                .containsOnlyOnce(
                        "majic: the display :nowhere, which DISPLAY names, cannot be used; this is the console")
                .contains("model = ")
                .doesNotContain("Exception", "Error", "\tat ");
        assertThat(majic.exitValue()).as(said).isZero();
    }

    @Test
    void aWrongLineMakesTheExitStatusOneAndShowsNoStackTrace() throws Exception {
        Process majic = start("--console");

        String said = talk(majic, "# a patrol\n7 move 100\n");

        assertThat(said).contains("line 2: 7: there is no robot 7").doesNotContain("Exception", "\tat ");
        assertThat(majic.exitValue()).isEqualTo(1);
    }

    @Test
    void aWrongOptionIsExplainedInALine() throws Exception {
        Process majic = start("--speeed", "3");

        String said = talk(majic, "");

        assertThat(said).startsWith("majic: ").doesNotContain("Exception", "\tat ");
        assertThat(majic.exitValue()).isEqualTo(2);
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '"',
            value = {
                "--console --exact, the options of the simulated lab need --lab",
                "--console --lab --seed many, 'many' is not a whole number",
                "--console --lab --speed fast, 'fast' is not a number",
                "package, package needs MAJIC's sources",
                "--add sim:aibo lab, lab runs the simulators alone",
                "lab --add sim:aibo, Unknown options: '--add'"
            })
    void optionsThatMakeNoSenseAreExplained(String arguments, String why) throws Exception {
        Process majic = start(arguments.split(" "));

        assertThat(talk(majic, "")).startsWith("majic: ").contains(why).doesNotContain("Exception");
        assertThat(majic.exitValue()).isEqualTo(2);
    }

    @Test
    void aWorldThatIsNoneIsExplainedInALine() throws Exception {
        Process majic = start(
                "--lab", "--console", "--world", folder.resolve("nowhere.map").toString());

        String said = talk(majic, "");

        assertThat(said).startsWith("majic: ").contains("nowhere.map").doesNotContain("Exception", "\tat ");
        assertThat(majic.exitValue()).isEqualTo(3);
    }

    @Test
    void aScriptRunsWithOptionsInAnyPlace() throws Exception {
        Path script = Files.writeString(folder.resolve("little.majic"), "2 turn 5\n");

        Process majic = start("--lab", "--exact", "--aibo-port", "0", "run", script.toString(), "--pioneer-port", "0");

        assertThat(talk(majic, "")).contains("2 turn 5: done (").contains("little.majic: done (");
        assertThat(majic.exitValue()).isZero();
    }

    @Test
    void versionAndHelpArePrinted() throws Exception {
        assertThat(talk(start("--version"), "")).contains("MAJIC");
        assertThat(talk(start("--help"), "")).contains("--lab", "--console", "--listen", "run", "lab");
    }

    @Test
    void atTerminationItStopsTheRobotsFirst() throws Exception {
        try (SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1)) {
            String hemisson = lab.address("hemisson").orElseThrow().toString();
            Process majic = start("--console", "--add", hemisson);
            BufferedReader said =
                    new BufferedReader(new InputStreamReader(majic.getInputStream(), StandardCharsets.UTF_8));
            said.readLine();
            OutputStream typing = majic.getOutputStream();
            typing.write("1 move 1500\n".getBytes(StandardCharsets.UTF_8));
            typing.flush();
            Pose start = lab.truePoses().get("hemisson");
            awaitMotion(lab, start);

            majic.destroy();

            majic.waitFor();
            Pose end = lab.truePoses().get("hemisson");
            lab.time().sleep(0.3);
            assertThat(lab.truePoses().get("hemisson")).isEqualTo(end);
            assertThat(end.distanceMm(start)).isLessThan(1000);
        }
    }

    private static void awaitMotion(SimulatedLab lab, Pose start) throws InterruptedException {
        while (lab.truePoses().get("hemisson").distanceMm(start) < 10) {
            lab.time().sleep(0.05);
        }
    }
}
