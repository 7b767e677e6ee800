package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.BotException;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(10)
class ReconnectTest {
    @AutoClose
    private final Desk desk = new Desk();

    @BeforeEach
    void loseARobot() throws InterruptedException {
        desk.runPipe("add sim:aibo");
        desk.bot(1).cut();
    }

    @Test
    void theLossSaysHowToConnectAgain() {
        assertThat(desk.said()).contains("1: connection lost; \"add sim:aibo\" connects it again");
    }

    @Test
    void addingALostRobotAgainConnectsItUnderItsNumber() throws InterruptedException {
        assertThat(desk.runPipe("add sim:aibo", "1 move 30")).contains("1: Aibo at sim:aibo connected again");
        assertThat(desk.team.members()).hasSize(1);
        assertThat(desk.bot(1).isConnected()).isTrue();
    }

    @Test
    void itsNumberMayBeNamed() throws InterruptedException {
        desk.runPipe("add sim:aibo as 1");
        assertThat(desk.bot(1).isConnected()).isTrue();
    }

    @Test
    void anotherNumberIsAnotherRobot() throws InterruptedException {
        desk.runPipe("add sim:aibo as 2");
        assertThat(desk.bot(1).isConnected()).isFalse();
        assertThat(desk.bot(2).isConnected()).isTrue();
    }

    @Test
    void aRobotThatIsStillAwayKeepsItsPlaceForTheNextTry() throws InterruptedException {
        desk.bot(1).refuse(new BotException("nobody answers"));
        assertThat(desk.runPipe("add sim:aibo"))
                .contains("sim:aibo: nobody answers. Imagine it harder.")
                .doesNotContain("1: not connected");
        assertThat(desk.team.members()).hasSize(1);
    }

    @Test
    void aSecondRobotAtATakenAddressIsToldWhoHasIt() throws InterruptedException {
        desk.runPipe("add sim:aibo");
        desk.aibo.prepare(second -> second.refuse(new BotException("closed at once")));
        assertThat(desk.runPipe("add sim:aibo")).contains("sim:aibo: robot 1 is connected to it already");
    }

    @Test
    void oneThatIsConnectedAgainPastTheScriptIsToldAsWell() {
        desk.bot(1).connect();
        assertThat(desk.said()).contains("1: Aibo at sim:aibo connected again");
    }
}
