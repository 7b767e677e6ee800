package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.Mockito.doAnswer;
import static org.mockito.Mockito.mock;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.MajicBot;
import majic.driver.RobotWait;
import majic.link.LinkAddress;
import majic.pioneer.arcos.Sip;
import majic.pioneer.line.ArcosConnection;
import majic.pioneer.session.ConnectWait;
import majic.pioneer.session.PioneerConnection;
import majic.time.LastWait;
import org.junit.jupiter.api.Test;

/** Connecting, up to the first readings, with usual and unusual answers. */
class ConnectingTest {
    private static final String MOTION = "(ENABLE|VEL|RVEL|VEL2|MOVE|ROTATE|HEAD|DHEAD).*";

    @Test
    void switchesNoMotorsOnAndMovesNothing() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            stage.line.pass(5);

            assertThat(robot.heard).startsWith("OPEN 1", "CONFIG 1").doesNotContain("SONAR 1");
            assertThat(robot.heard).noneMatch(command -> command.matches(MOTION));
            assertThat(stage.bot.get("motors")).hasToString("no");
            assertThat(stage.bot.get("model")).hasToString("p3dx-sh");
            assertThat(stage.bot.get("firmware")).hasToString("S.0");
        }
    }

    @Test
    void motorsThatAreAlreadyOnAreLeftOn() {
        ScriptedPioneer simulator = ScriptedPioneer.vendorSimulator();
        try (PioneerRig stage = PioneerRig.connected(simulator)) {
            stage.line.pass(5);

            assertThat(stage.bot.get("motors")).hasToString("yes");
            assertThat(simulator.heard).noneMatch(command -> command.matches(MOTION));
            assertThat(simulator.robot.x()).isZero();
        }
    }

    @Test
    void aSonarCountWithoutReadingsBehindItIsNoReading() {
        try (PioneerRig stage = PioneerRig.connected(ScriptedPioneer.vendorSimulator())) {
            stage.bot.set("sonarPower", "on");

            assertThat(stage.bot.get("distanceFront")).hasToString("clear");
        }
    }

    @Test
    void aSessionLeftOpenIsStoppedForGoodBeforeTheHandshake() {
        ScriptedPioneer robot = ScriptedPioneer.inOpenSession();
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(robot.heard).startsWith("ESTOP 0", "VEL 0", "RVEL 0", "ENABLE 0", "CLOSE 1", "OPEN 1");
            assertThat(stage.bot.get("motors")).hasToString("no");
        }
    }

    @Test
    void aSessionLeftOpenIsStoppedEvenIfItsSipsComeLate() {
        ScriptedPioneer robot = ScriptedPioneer.inOpenSession().every(400);
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(robot.orders()).startsWith("ESTOP 0", "VEL 0", "RVEL 0", "ENABLE 0", "CLOSE 1", "OPEN 1");
            assertThat(stage.bot.isConnected()).isTrue();
        }
    }

    @Test
    void theConfigurationIsRequestedWithoutWaitingForTheFirstData() {
        ScriptedPioneer robot = ScriptedPioneer.robot().every(500);
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(stage.bot.get("firmware")).hasToString("S.0");
            assertThat(robot.heardAt.get(robot.heard.indexOf("CONFIG 1")))
                    .isCloseTo(robot.heardAt.get(robot.heard.indexOf("OPEN 1")), within(5L));
        }
    }

    @Test
    void connectingGoesOnWhenTheFirstReportHasBeenTakenIn() {
        try (SteppedPeer line = new SteppedPeer(ScriptedPioneer.robot())) {
            LastWait last = new LastWait(line.time().signal());
            List<Boolean> wentOn = new CopyOnWriteArrayList<>();
            PioneerConnection.Listener listener = mock();
            doAnswer(sip -> wentOn.add(last.isOver())).when(listener).reported(any(Sip.class));
            ArcosConnection connection = new ArcosConnection(
                    LinkAddress.of(line.address(), 0, 0).newLink(),
                    new ConnectWait(new RobotWait(line.time(), last), () -> false));

            connection.open(listener);
            connection.close();

            assertThat(wentOn).startsWith(false);
        }
    }

    @Test
    void nothingIsSentForTheFirstQuarterOfASecond() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(robot.firstByteMs).isGreaterThanOrEqualTo(250);
            assertThat(stage.bot.isConnected()).isTrue();
        }
    }

    @Test
    void aRobotThatLosesStepOfTheHandshakeIsStartedOver() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.rejectsSyncs = 1;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(stage.bot.isConnected()).isTrue();
        }
    }

    @Test
    void aSyncWithoutAnswerIsRepeated() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.ignoresSyncs = 1;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(stage.bot.isConnected()).isTrue();
        }
    }

    @Test
    void aRobotWithoutConfigIsDrivenAsItsModel() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.answersConfig = false;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(robot.heard).contains("SETV 1000", "SETRV 100");
            assertThat(PioneerRig.amount(stage.bot.turn(-30))).isBetween(-31.0, -29.0);
        }
    }

    @Test
    void sonarsThatAreOffAreSwitchedOn() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.sonarsOff = true;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(robot.heard).contains("SONAR 1");
            assertThat(stage.bot.get("sonar0")).hasToString("clear");
        }
    }

    /** A quarter of a second of listening, the handshake, and the first SIP. */
    @Test
    void connectingEndsWithTheFirstReportAndReadingADistanceWaitsForTheSonars() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.sonarsOff = true;
        try (PioneerRig stage = new PioneerRig(robot)) {
            assertThat(stage.secondsOf(stage.bot::connect)).isLessThan(0.38);
            assertThat(stage.secondsOf(
                            () -> assertThat(stage.bot.get("distanceFront")).hasToString("clear")))
                    .isBetween(0.01, 0.3);
            assertThat(stage.bot.get("sonar15")).hasToString("clear");
        }
    }

    @Test
    void readingASonarThatNeverFiresWaitsOnlyInTheFirstSecond() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.rearSonar = 0;
        robot.answersConfig = false;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(stage.bot.get("sonar15")).hasToString("unknown (no reading yet)");
            assertThat(stage.secondsOf(() -> stage.bot.get("distanceBack"))).isLessThan(0.01);
        }
    }

    @Test
    void aPeerThatNeverAnswersIsGivenUpInTheReportedTime() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.ignoresSyncs = Integer.MAX_VALUE;
        try (PioneerRig stage = new PioneerRig(robot)) {
            double seconds = stage.secondsOf(() -> assertThatThrownBy(stage.bot::connect)
                    .isInstanceOf(BotException.class)
                    .hasMessageContaining("no Pioneer answers")
                    .hasMessageContaining("within 6 s"));

            assertThat(seconds).isBetween(6.0, 7.5);
            assertThat(stage.bot.connection()).isEqualTo(MajicBot.Connection.LOST);
        }
    }

    @Test
    void aPeerThatClosesInTheHandshakeIsReportedAsBusy() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.hangsUpAtSync = true;
        try (PioneerRig stage = new PioneerRig(robot)) {
            ConnectFailed failure = catchThrowableOfType(ConnectFailed.class, stage.bot::connect);

            assertThat(failure.reason()).isEqualTo(ConnectFailed.Reason.BUSY);
            assertThat(failure).hasMessageContaining("one program at a time");
        }
    }

    @Test
    void closingStopsSwitchesOffAndEndsTheSession() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        PioneerRig stage = PioneerRig.connected(robot);
        stage.bot.drive(100, 0);

        stage.close();

        assertThat(robot.heardLast("STOP 0", "VEL 0", "RVEL 0", "ENABLE 0", "CLOSE 1"))
                .isTrue();
    }
}
