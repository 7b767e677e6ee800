package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.link.TestPorts;
import majic.script.help.Completion;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests which robot of a team is meant by the names of a serial port. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the folder of devices is that of Linux")
class SerialReconnectTest {
    private static final String LEFTY = "A50285BI";
    private static final String RIGHTY = "A6004XYZ";

    @TempDir
    static Path folder;

    @AutoClose
    private final TestPorts ports = new TestPorts(folder);

    @AutoClose
    private final ScriptFixture fixture = new ScriptFixture();

    @BeforeEach
    void addLefty() throws IOException, InterruptedException {
        ports.plug("/dev/null", "ttyUSB0", LEFTY);
        fixture.runPipe("add aibo:" + ports.device("ttyUSB0"), "1 name lefty");
    }

    private void plugInTurn() throws IOException {
        ports.unplugAll();
        ports.plug("/dev/zero", "ttyUSB0", RIGHTY);
        ports.plug("/dev/null", "ttyUSB1", LEFTY);
    }

    @Test
    void theSameDeviceUnderAnotherNameIsRefused() throws InterruptedException {
        assertThat(fixture.runPipe("add aibo:" + ports.named(LEFTY)))
                .anyMatch(line -> line.endsWith(ports.named(LEFTY) + ": robot 1 is connected to it already"));
        assertThat(fixture.team.members()).hasSize(1);
    }

    @Test
    void anotherAdapterUnderTheNameOfALostRobotIsAnotherRobot() throws IOException, InterruptedException {
        fixture.bot(1).cut();
        plugInTurn();

        fixture.runPipe("add aibo:" + ports.device("ttyUSB0"));

        assertThat(fixture.bot(1).isConnected()).isFalse();
        assertThat(fixture.bot(2).isConnected()).isTrue();
    }

    @Test
    void theAdapterOfALostRobotUnderAnotherNameIsThatRobot() throws IOException, InterruptedException {
        fixture.bot(1).cut();
        plugInTurn();

        assertThat(fixture.runPipe("add aibo:" + ports.device("ttyUSB1")))
                .contains("1: lefty (Aibo) at aibo:" + ports.device("ttyUSB1") + " connected again");
        assertThat(fixture.team.members()).hasSize(1);
    }

    @Test
    void aConnectionToTheSameDeviceEndsTheAlarm() throws IOException, InterruptedException {
        fixture.bot(1).cut();
        fixture.runPipe("stop");
        assertThat(fixture.team.stopStatus().problem(1)).isPresent();
        plugInTurn();

        fixture.runPipe("add aibo:" + ports.device("ttyUSB1"));

        WaitLimit.until(
                "the end of the alarm",
                () -> fixture.team.stopStatus().problem(1).isEmpty());
    }

    @Test
    void theNumberOfALostRobotIsTakenByTheUsersChoice() throws InterruptedException {
        fixture.bot(1).cut();
        fixture.runPipe("stop");

        List<String> answers = fixture.runPipe("add aibo://elsewhere as 1");

        assertThat(answers)
                .contains("1: the robot at aibo://elsewhere takes the number of the robot at aibo:"
                        + ports.device("ttyUSB0")
                        + ", whose connection was lost; if that is another robot, nothing stops it now");
        assertThat(fixture.bot(1).isConnected()).isTrue();
        assertThat(fixture.team.member(1).name()).isEqualTo("lefty");
        assertThat(fixture.team.stopStatus().problem(1)).isEmpty();
    }

    @Test
    void aRobotOfAnotherTypeDoesNotTakeTheNumber() throws InterruptedException {
        fixture.bot(1).cut();

        assertThat(fixture.runPipe("add pioneer://elsewhere as 1"))
                .anyMatch(line ->
                        line.endsWith("1: there is a robot 1 already, of another type (Aibo); remove it first"));
        assertThat(fixture.team.member(1).bot().type().name()).isEqualTo("aibo");
    }

    @Test
    void aRobotThatCannotBeReachedDoesNotTakeTheNumber() throws InterruptedException {
        fixture.bot(1).cut();
        fixture.aibo.prepare(made -> made.refuse(new BotException("nothing answers")));

        fixture.runPipe("add aibo://elsewhere as 1");

        assertThat(fixture.team.member(1).name()).isEqualTo("lefty");
        assertThat(fixture.bot(1).isConnected()).isFalse();
    }

    @Test
    void anotherAdapterTakesTheNumberByTheUsersChoice() throws InterruptedException {
        fixture.bot(1).cut();
        fixture.bot(1).refuse(new ConnectFailed(ConnectFailed.Reason.OTHER_ADAPTER, "another adapter"));

        fixture.runPipe("add aibo:" + ports.device("ttyUSB0") + " as 1");

        assertThat(fixture.bot(1).isConnected()).isTrue();
    }

    @Test
    void everyStopOfALostRobotSaysWhatEndsTheAlarm() throws InterruptedException {
        fixture.bot(1).cut();

        assertThat(fixture.runPipe("stop"))
                .anyMatch(
                        line -> line.contains("\"remove 1\" ends this alarm") && line.contains("\"add ADDRESS as 1\""));
    }

    @Test
    void theNamesThatStayAreOfferedWhileAnAddressIsTyped() {
        String offered = "add aibo:" + ports.named(LEFTY);

        assertThat(fixture.prompt.complete("add aibo:/", "add aibo:/".length()).entries())
                .extracting(Completion::text)
                .containsExactly(offered.substring("add ".length()));
        assertThat(fixture.prompt.complete(offered, offered.length()).entries()).isNotEmpty();
    }

    @Test
    void aProbeOfAPortNamesTheNameThatStays() throws InterruptedException {
        fixture.bot(1).cut();

        assertThat(fixture.runPipe("probe aibo:" + ports.device("ttyUSB0")))
                .anyMatch(line -> line.endsWith(
                        "answers; the name of this port can change, aibo:" + ports.named(LEFTY) + " stays"));
    }

    @Test
    void aProbeOfThePortOfARobotNamesTheRobot() throws InterruptedException {
        fixture.aibo.prepare(second -> second.refuse(new BotException("this program uses it already")));

        assertThat(fixture.runPipe("probe aibo:" + ports.named(LEFTY)))
                .anyMatch(line -> line.endsWith("robot 1 is connected to it already"));
    }
}
