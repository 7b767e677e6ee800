package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import majic.bot.BotAddress;
import majic.bot.FakeType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.Mosquitto;
import majic.shared.desk.DeskOptions;
import majic.shared.desk.DeskSharing;
import majic.team.Team;
import majic.time.TimeSource;
import majic.tool.Tool;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests the programs in Python that use a shared robot. They are run where Mosquitto is installed and Python, or the
 * one that the variable {@code PYTHON} names, has paho-mqtt 2.
 */
class SharedClientsTest {
    private static final Path EXAMPLES = Path.of("examples");
    private static final String PYTHON =
            Optional.ofNullable(System.getenv("PYTHON")).orElse("python3");

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"watch_shared.py", "move_shared.py"})
    void theProgramIsPythonThatCanBeRead(String program) throws Exception {
        Tool.require("python3");
        String file = EXAMPLES.resolve(program).toString();

        assertThat(Tool.run("python3", "-c", "import ast, sys; ast.parse(open(sys.argv[1]).read())", file))
                .isEmpty();
    }

    @Test
    void twentyLinesAreEnoughToWatchAndCommand() throws IOException {
        assertThat(Files.readAllLines(EXAMPLES.resolve("move_shared.py"))).hasSizeLessThanOrEqualTo(20);
    }

    @Test
    void theProgramInPythonPrintsTheStatesOfARobotMovesItAndPrintsItsAnswers() throws Exception {
        assumeTrue(Mosquitto.installed().isPresent() && hasClient(), "needs Mosquitto and paho-mqtt 2");
        try (Mosquitto broker = Mosquitto.start(folder);
                Team team = new Team(TimeSource.system())) {
            MajicBot robot = new FakeType().create(BotAddress.parse("fake:here"), BotEnvironment.plain());
            robot.connect();
            team.add(robot, OptionalInt.of(1));
            DeskSharing sharing = share(team, broker.port());
            try {
                String program = at(broker.port(), "move_shared.py").toString();
                assertThat(Tool.run(PYTHON, program, "127.0.0.1", "lab", "desk2", "1", "30"))
                        .containsSubsequence(
                                "'connection': 'connected'", "'desk': 'python'", "'outcome': 'done'", "'unit': 'mm'");
            } finally {
                sharing.close();
            }
        }
    }

    private static boolean hasClient() throws InterruptedException {
        try {
            return Tool.run(PYTHON, "-c", "from paho.mqtt.client import CallbackAPIVersion; print('found')")
                    .startsWith("found");
        } catch (IOException e) {
            return false;
        }
    }

    private static DeskSharing share(Team team, int port) {
        BrokerAddress address = BrokerAddress.parse("mqtt://127.0.0.1:" + port + "/lab");
        DeskSharing sharing = new DeskSharing(
                team,
                new DeskOptions("lab", "desk2", "Bert", "MAJIC", Set.of(), false),
                (id, will) -> BrokerConnection.open(
                        address, ConnectOptions.of(id, BotEnvironment.plain()).withWill(will)));
        sharing.start();
        return sharing;
    }

    /** Returns the program for another port than the usual one. */
    private Path at(int port, String program) throws IOException {
        String text = Files.readString(EXAMPLES.resolve(program))
                .replace("hostname=broker", "hostname=broker, port=" + port)
                .replace("connect(broker)", "connect(broker, " + port + ")");
        return Files.writeString(folder.resolve(program), text);
    }
}
