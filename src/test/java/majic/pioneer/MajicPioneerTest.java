package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotEnvironment;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver against a peer on loopback, in real time. */
@Timeout(30)
class MajicPioneerTest {
    private Peer peer;
    private MajicPioneer bot;
    private final List<String> notices = new CopyOnWriteArrayList<>();

    @AfterEach
    void closeAll() throws IOException {
        bot.close();
        peer.close();
    }

    @Test
    void connectingSwitchesNoMotorsOnAndMovesNothing() throws Exception {
        connect(Peer.Quirk.NONE);

        assertThat(peer.hears("SONAR 1")).isTrue();
        assertThat(peer.heard()).startsWith("OPEN 1", "CONFIG 1");
        assertThat(peer.heard()).noneMatch(command -> command.matches("(ENABLE|VEL|RVEL|MOVE|HEAD).*"));
        assertThat(bot.get("motors")).hasToString("off");
        assertThat(bot.get("model")).hasToString("p3dx-sh");
        assertThat(bot.get("firmware")).hasToString("S.0");
    }

    @Test
    void moveSwitchesMotorsOnAndArrives() throws IOException {
        connect(Peer.Quirk.NONE);

        MotionReport report = bot.move(150);

        assertThat(number(report)).isCloseTo(150, within(10.0));
        assertThat(bot.state().pose().xMm()).isCloseTo(150, within(10.0));
        assertThat(bot.state().speedMmPerSec()).isZero();
        assertThat(notices).containsOnlyOnce("motors on");
    }

    @Test
    void turnArrivesOnTheRight() throws IOException {
        connect(Peer.Quirk.NO_CONFIG);

        assertThat(number(bot.turn(-30))).isCloseTo(-30, within(1.0));
    }

    @Test
    void aSessionLeftOpenIsStoppedForGoodBeforeTheHandshake() throws IOException {
        connect(Peer.Quirk.IN_OPEN_SESSION);

        assertThat(peer.heard()).startsWith("ESTOP 0", "VEL 0", "RVEL 0", "ENABLE 0", "CLOSE 1", "OPEN 1");
    }

    @Test
    void aRobotThatLosesStepOfTheHandshakeIsStartedOver() throws IOException {
        connect(Peer.Quirk.LOSES_STEP_ONCE);

        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aSyncWithoutAnswerIsRepeated() throws IOException {
        connect(Peer.Quirk.DEAF_TO_FIRST_SYNC);

        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aPeerThatNeverAnswersIsGivenUp() {
        assertThatThrownBy(() -> connect(Peer.Quirk.NEVER_ANSWERS))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("no Pioneer answers")
                .hasMessageContaining("6 s");
        assertThat(bot.connection()).isEqualTo(MajicBot.Connection.LOST);
    }

    @Test
    void aPeerThatHangsUpInTheHandshakeIsSaidToBeTaken() {
        assertThatThrownBy(() -> connect(Peer.Quirk.HANGS_UP)).hasMessageContaining("one program at a time");
    }

    @Test
    void aStallEndsTheMotionWithTheWayCovered() throws IOException {
        connect(Peer.Quirk.NONE);
        bot.addListener(whenBeyond(50, peer::stall));

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageMatching("stalled after \\d+(\\.\\d)? mm");
        assertThat(peer.heard()).endsWith("STOP 0", "VEL 0", "RVEL 0");
    }

    @Test
    void theStopButtonEndsTheMotion() throws IOException {
        connect(Peer.Quirk.NONE);
        bot.addListener(whenBeyond(50, peer::pressStopButton));

        assertThatThrownBy(() -> bot.move(1000)).hasMessageStartingWith("STOP button pressed after");
    }

    @Test
    void aSilentRobotIsToldToStandAndThenGivenUp() throws IOException {
        connect(Peer.Quirk.NONE);
        bot.addListener(whenBeyond(50, peer::fallSilent));

        assertThatThrownBy(() -> bot.move(1000)).hasMessage("connection lost: the robot has been silent for 1 s");

        List<String> heard = peer.heard();
        assertThat(heard.subList(heard.size() - 2, heard.size())).containsExactly("VEL 0", "RVEL 0");
    }

    @Test
    void aRobotThatHangsUpIsLostAtOnceAndCanBeConnectedAgain() throws IOException {
        connect(Peer.Quirk.NONE);
        bot.addListener(whenBeyond(50, this::hangUp));

        assertThatThrownBy(() -> bot.move(1000)).hasMessageStartingWith("connection lost");
        bot.connect();

        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void closingStopsSwitchesOffAndSaysGoodBye() throws IOException {
        connect(Peer.Quirk.NONE);
        bot.drive(100, 0);

        bot.close();

        assertThat(peer.heard()).endsWith("STOP 0", "VEL 0", "RVEL 0", "ENABLE 0", "CLOSE 1");
    }

    private void hangUp() {
        try {
            peer.hangUp();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static BotListener whenBeyond(double mm, Runnable event) {
        return new BotListener() {
            @Override
            public void stateChanged(MajicBot moving, BotState state) {
                if (state.pose().xMm() > mm) {
                    moving.removeListener(this);
                    event.run();
                }
            }
        };
    }

    private void connect(Peer.Quirk quirk) throws IOException {
        peer = new Peer(quirk);
        bot = new MajicPioneer(peer.address(), BotEnvironment.plain());
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot from, String message) {
                notices.add(message);
            }
        });
        bot.connect();
    }

    private static double number(MotionReport report) {
        return report.amount() == null ? Double.NaN : report.amount().number();
    }
}
