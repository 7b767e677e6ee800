package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.BotException;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ReconnectTest {
    @AutoClose
    private final ScriptFixture fixture = new ScriptFixture();

    @BeforeEach
    void loseARobot() throws InterruptedException {
        fixture.runPipe("add sim:aibo");
        fixture.bot(1).cut();
    }

    @Test
    void theReportOfALossNamesTheLineThatConnectsAgain() {
        assertThat(fixture.answers()).contains("1: connection lost; \"add sim:aibo\" connects it again");
    }

    @Test
    void addingALostRobotAgainConnectsItUnderItsNumber() throws InterruptedException {
        assertThat(fixture.runPipe("add sim:aibo", "1 move 30")).contains("1: Aibo at sim:aibo connected again");
        assertThat(fixture.team.members()).hasSize(1);
        assertThat(fixture.bot(1).isConnected()).isTrue();
    }

    @Test
    void itsNumberMayBeNamed() throws InterruptedException {
        fixture.runPipe("add sim:aibo as 1");
        assertThat(fixture.bot(1).isConnected()).isTrue();
    }

    @Test
    void anotherNumberIsAnotherRobot() throws InterruptedException {
        fixture.runPipe("add sim:aibo as 2");
        assertThat(fixture.bot(1).isConnected()).isFalse();
        assertThat(fixture.bot(2).isConnected()).isTrue();
    }

    @Test
    void aRobotThatIsStillUnreachableKeepsItsNumber() throws InterruptedException {
        fixture.bot(1).refuse(new BotException("nobody answers"));
        assertThat(fixture.runPipe("add sim:aibo"))
                .contains("sim:aibo: nobody answers. Imagine it harder.")
                .doesNotContain("1: not connected");
        assertThat(fixture.team.members()).hasSize(1);
    }

    @Test
    void anAddressIsNotAddedTwiceAlthoughItsDeviceAcceptsSeveralConnections() throws InterruptedException {
        fixture.runPipe("add sim:aibo");

        assertThat(fixture.runPipe("add sim:aibo", "add SIM:Aibo as 5"))
                .filteredOn(line -> line.endsWith("sim:aibo: robot 1 is connected to it already")
                        || line.endsWith("SIM:Aibo: robot 1 is connected to it already"))
                .hasSize(2);
        assertThat(fixture.team.members()).hasSize(1);
    }

    @Test
    void oneRobotIsNotAddedTwiceUnderTwoFormsOfItsAddress() throws InterruptedException {
        fixture.runPipe("add aibo://dog as 7");

        assertThat(fixture.runPipe("add aibo:tcp://dog:1234", "add Aibo+liburbi://DOG"))
                .filteredOn(line -> line.endsWith("robot 7 is connected to it already"))
                .hasSize(2);
    }

    @Test
    void oneRobotIsNotAddedTwiceUnderAddressesThatOnlyTheConnectionShowsToBeOfOne() throws InterruptedException {
        fixture.aibo.prepare(bot -> bot.identity("the same base"));
        fixture.runPipe("add aibo://dog as 7");

        assertThat(fixture.runPipe("add aibo://hound")).contains("aibo://hound: robot 7 is connected to it already");
        fixture.bot(7).cut();
        assertThat(fixture.runPipe("add aibo://hound"))
                .contains(
                        "aibo://hound: it is robot 7, whose connection was lost; type \"add aibo://dog\" to connect it"
                                + " again");
        assertThat(fixture.team.members()).hasSize(2);
    }

    @Test
    void aRefusalOfATakenAddressNamesItsRobot() throws InterruptedException {
        fixture.runPipe("add sim:aibo");
        fixture.aibo.prepare(second -> second.refuse(new BotException("closed at once")));
        assertThat(fixture.runPipe("add sim:aibo")).contains("sim:aibo: robot 1 is connected to it already");
    }

    @Test
    void addingARobotThatIsBeingConnectedAgainWaitsForThatConnection() throws InterruptedException {
        fixture.bot(1).connectIn(2);
        fixture.time.thread("connecting", fixture.bot(1)::connect).start();
        fixture.pause(0.1);

        assertThat(fixture.runPipe("add sim:aibo", "add sim:aibo as 1")).contains("1: at sim:aibo, connected already");
        assertThat(fixture.team.members()).hasSize(1);
    }

    @Test
    void aConnectionMadePastTheScriptIsReportedAsWell() {
        fixture.bot(1).connect();
        assertThat(fixture.answers()).contains("1: Aibo at sim:aibo connected again");
    }
}
