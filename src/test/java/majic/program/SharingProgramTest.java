package majic.program;

import static majic.program.MajicProcesses.talk;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import majic.link.Loopback;
import majic.shared.broker.Mosquitto;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Whole programs that share robots, and one that does not. */
class SharingProgramTest {
    private static final String AIBO = "1: Aibo at sim:aibo connected";
    private static final String PIONEER = "2: Pioneer at sim:pioneer connected";
    private static final String HEMISSON = "3: Hemisson at sim:hemisson connected";

    private static final List<String> OF_SHARING =
            List.of(" com.hivemq.", " io.netty.", " io.reactivex.", " com.fasterxml.");

    @TempDir
    private Path folder;

    @AutoClose
    private final MajicProcesses programs = new MajicProcesses();

    private Process start(String home, List<String> java, String... arguments) throws IOException {
        return programs.start(folder.resolve(home), java, List.of(arguments));
    }

    /** Waits for lines in any order: the robots of the lab are connected side by side. */
    private static void awaitAll(BufferedReader printed, String... texts) throws IOException {
        List<String> missing = new ArrayList<>(List.of(texts));
        List<String> seen = new ArrayList<>();
        String line = "";
        while (line != null && !missing.isEmpty()) {
            line = printed.readLine();
            missing.removeIf(String.valueOf(line)::contains);
            seen.add(line);
        }
        assertThat(missing).as("not printed: %s", seen).isEmpty();
    }

    /** Reads what a program prints up to a line that contains a text. */
    private static void awaitLine(BufferedReader printed, String text) throws IOException {
        String line = printed.readLine();
        while (line != null && !line.contains(text)) {
            line = printed.readLine();
        }
        assertThat(line).as(text).isNotNull();
    }

    @Test
    void aProgramThatDoesNotShareLoadsNothingOfTheClientForBrokers() throws Exception {
        Process majic = start("one", List.of("-verbose:class"), "--lab", "--exact", "--console", "--speed", "3");

        String said = talk(majic, "2 move 100\nwait\nquit\n");

        assertThat(said).contains("2 move 100: done (", "majic.program.Program ");
        assertThat(said.lines().filter(line -> OF_SHARING.stream().anyMatch(line::contains)))
                .isEmpty();
    }

    @Test
    @EnabledIf("hasMosquitto")
    void aRobotOfOneProgramIsMovedFromAnother() throws Exception {
        try (Mosquitto broker = Mosquitto.start(folder)) {
            String site = "mqtt://127.0.0.1:" + broker.port() + "/lab";
            Process sharing =
                    start("sharing", List.of(), "--lab", "--exact", "--console", "--share", site, "--desk", "desk2");
            BufferedReader printed = sharing.inputReader();
            awaitAll(printed, "sharing robots as desk2 at " + site, AIBO, PIONEER, HEMISSON);
            Process using = start("using", List.of(), "--console", "--desk", "desk1", "--person", "Anna");

            String said = talk(using, "add " + site + "/desk2/2\n1 move 200\nwait\nall stop\nquit\n");

            assertThat(said).contains("1 move 200: done (");
            awaitLine(printed, "2 move 200 (Anna at desk1): done (");
            awaitLine(printed, "Anna at desk1");
        }
    }

    @Test
    @SuppressWarnings("try")
    @EnabledIf("hasMosquitto")
    void aDeskGoesOnByItselfWhileItsBrokerIsGoneAndSharesAgainAfterwards() throws Exception {
        int port = Loopback.freePort();
        String site = "mqtt://127.0.0.1:" + port + "/lab";
        Mosquitto broker = Mosquitto.start(folder, port, "allow_anonymous true");
        Process sharing =
                start("sharing", List.of(), "--lab", "--exact", "--console", "--share", site, "--desk", "desk2");
        BufferedReader printed = sharing.inputReader();
        awaitAll(printed, AIBO, PIONEER, HEMISSON);
        broker.close();
        awaitLine(printed, "sharing is interrupted");
        try (BufferedWriter lines = sharing.outputWriter()) {
            type(lines, "2 move 100");
            awaitLine(printed, "2 move 100: done (");
            type(lines, "all stop");
            awaitLine(printed, "STOP is latched");
            try (Mosquitto again = Mosquitto.start(folder, port, "allow_anonymous true")) {
                awaitLine(printed, "sharing goes on");
                Process using = start("using", List.of(), "--console", "--person", "Anna");

                assertThat(talk(using, "add " + site + "/desk2/2\n1 move 200\nwait\nquit\n"))
                        .contains("STOP");
            }
        }
    }

    private static void type(BufferedWriter lines, String line) throws IOException {
        lines.write(line + "\n");
        lines.flush();
    }

    static boolean hasMosquitto() {
        return Mosquitto.installed().isPresent();
    }

    @Test
    void aBrokerThatIsNotThereEndsTheStartWithOneSentence() throws Exception {
        String site = "mqtt://127.0.0.1:" + Loopback.freePort() + "/lab";
        Process majic = start("one", List.of(), "--console", "--share", site, "--desk", "desk2");

        String said = talk(majic, "");

        assertThat(majic.exitValue()).isEqualTo(3);
        assertThat(Stream.of(said.split("\n")).filter(line -> line.startsWith("majic: " + site)))
                .hasSize(1);
        assertThat(said).doesNotContain("\tat ");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "--share-only 1; go with --share",
                "--share http://broker/lab; not the address of a broker",
                "--share mqtt://anna:secret@broker/lab; do not belong into an address",
                "--share mqtt://broker/lab --desk 1st; the name of a desk is a letter",
                "--broker here; not an address"
            })
    void wrongOptionsAreRefusedBeforeAnythingStarts(String options, String sentence) throws Exception {
        List<String> arguments = new ArrayList<>(List.of("--console"));
        arguments.addAll(List.of(options.split(" ")));
        Process majic = start("one", List.of(), arguments.toArray(String[]::new));

        assertThat(talk(majic, "")).contains(sentence).doesNotContain("secret");
        assertThat(majic.exitValue()).isEqualTo(2);
    }
}
