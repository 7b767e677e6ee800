package majic.pioneer.aria;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.mockito.Mockito.when;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.pioneer.MajicPioneer;
import majic.pioneer.TestPioneers;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The whole driver over a double of ARIA. */
class AriaDriveTest {
    private AriaDouble aria;
    private MajicPioneer bot;
    private int openResult;

    private void create(long phaseMs) {
        aria = new AriaDouble(phaseMs);
        AriaRobot shared = new AriaRobot(aria.robot);
        AriaDevice device = new AriaDevice("tcp:robot:8101", () -> new AriaDevice.Opened(aria.device, openResult));
        bot = TestPioneers.over(
                wait -> new AriaConnection(shared, device, wait),
                new BotEnvironment(aria.clock().time(), Settings.inMemory()));
    }

    private void connect(long phaseMs) {
        create(phaseMs);
        bot.connect();
    }

    @AfterEach
    void everyCallWasMadeWithTheLockHeldAndWithoutWaiting() {
        bot.close();
        aria.close();
        assertThat(aria.violations).isEmpty();
    }

    private void pass(double seconds) {
        long until = aria.clock().time().nanos() + (long) (seconds * 1e9);
        aria.clock().until(() -> aria.clock().time().nanos() >= until);
    }

    @ParameterizedTest(name = "{0} mm, sent {1} ms after a SIP")
    @CsvSource({"1000, 2", "1000, 50", "-500, 99", "37, 99", "300, 30"})
    void aMoveEndsWithinTenMillimetres(double mm, long phaseMs) {
        connect(phaseMs);

        bot.move(mm);

        assertThat(aria.model.x()).isCloseTo(mm, within(10.0));
        assertThat(aria.model.isStationary()).isTrue();
    }

    @ParameterizedTest(name = "{0} deg, sent {1} ms after a SIP")
    @CsvSource({"90, 2", "-90, 50", "540, 99", "5, 99"})
    void aTurnEndsWithinADegree(double degrees, long phaseMs) {
        connect(phaseMs);

        bot.turn(degrees);

        assertThat(aria.model.heading()).isCloseTo(degrees, within(1.0));
        assertThat(aria.model.isStationary()).isTrue();
    }

    @Test
    void connectingMovesNothingAndSwitchesNoMotorsOn() {
        connect(50);

        assertThat(aria.calls)
                .containsSequence("setDeviceConnection", "blockingConnect", "runAsync")
                .contains("setTransVelMax 1000.0", "setTransAccel 300.0", "setTransDecel 500.0", "setRotAccel 100.0")
                .noneMatch(call -> call.matches("(enableMotors|setVel|setRotVel|stop)( .*)?"));
    }

    @Test
    void aStopDuringAMotionIsTheNextCallOfAria() {
        connect(50);
        CompletableFuture<?> motion = aria.clock().aside((Supplier<Object>) () -> bot.move(3000));
        aria.clock().until(() -> aria.model.x() > 200);
        aria.calls.clear();

        bot.stop();

        assertThat(aria.calls).startsWith("stop", "setVel 0.0", "setRotVel 0.0");
        assertThatThrownBy(() -> aria.clock().join(motion))
                .isInstanceOf(CompletionException.class)
                .hasCauseInstanceOf(MotionStopped.class);
        assertThat(aria.model.isStationary()).isTrue();
        assertThat(aria.calls).noneMatch(call -> call.matches("setVel -?[1-9].*"));
    }

    @Test
    void aRobotThatStopsReportingIsSentZeroVelocitiesAndGivenUp() {
        connect(50);
        bot.drive(200, 0);
        pass(0.3);
        aria.calls.clear();
        aria.silent = true;

        pass(0.75);
        assertThat(aria.calls).endsWith("setVel 0.0", "setRotVel 0.0");
        pass(0.5);

        assertThat(bot.connection()).isEqualTo(MajicBot.Connection.LOST);
        assertThat(bot.lostReason()).contains("connection lost: the robot has been silent for 1 s");
        aria.clock().until(() -> aria.calls.contains("stopRunning"));
    }

    @Test
    void theSameRobotIsConnectedAgain() {
        connect(50);
        aria.connected = false;
        aria.clock().until(() -> !bot.isConnected());
        assertThat(bot.lostReason()).contains("connection lost: ARIA has lost the robot");

        bot.connect();
        bot.move(300);

        assertThat(aria.model.x()).isCloseTo(300, within(10.0));
        assertThat(aria.calls).filteredOn("blockingConnect"::equals).hasSize(2);
        assertThat(aria.calls.indexOf("stopRunning")).isLessThan(aria.calls.lastIndexOf("blockingConnect"));
    }

    @Test
    void closingStopsTheRobotAndEndsAriasThread() {
        connect(50);
        aria.calls.clear();

        bot.close();

        assertThat(aria.calls).startsWith("stop").endsWith("setRotVel 0.0", "disableMotors", "stopRunning");
    }

    @Test
    void aConnectionThatAriaCannotOpenIsReportedWithAriasReason() {
        create(50);
        openResult = 2;
        when(aria.device.getOpenMessage(2)).thenReturn("no route");

        assertThatThrownBy(bot::connect)
                .isInstanceOf(BotException.class)
                .hasMessage("ARIA cannot open tcp:robot:8101: no route");
        assertThat(aria.calls).doesNotContain("blockingConnect");
    }

    @Test
    void aPeerThatDoesNotAnswerAriaIsReported() {
        create(50);
        aria.others.put("blockingConnect", () -> false);

        assertThatThrownBy(bot::connect)
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("ARIA finds no Pioneer at tcp:robot:8101");

        aria.others.clear();
        bot.connect();
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aMethodThatTheInstalledAriaLacksIsReportedInASentence() {
        create(50);
        aria.others.put("blockingConnect", () -> {
            throw new UnsatisfiedLinkError("ArRobot_blockingConnect");
        });

        assertThatThrownBy(bot::connect)
                .isInstanceOf(BotException.class)
                .hasMessage("ARIA failed while connecting to tcp:robot:8101: "
                        + "java.lang.UnsatisfiedLinkError: ArRobot_blockingConnect");
    }

    @Test
    void anErrorInAGetterEndsTheConnection() {
        connect(50);
        aria.others.put("getFlags", () -> {
            throw new NoSuchMethodError("getFlags");
        });

        aria.clock().until(() -> !bot.isConnected());

        assertThat(bot.lostReason()).contains("connection lost: ARIA failed: java.lang.NoSuchMethodError: getFlags");
    }

    @Test
    void anyErrorInAriasReportsEndsTheConnection() {
        connect(50);
        aria.others.put("getX", () -> {
            throw new AssertionError("made up");
        });

        aria.clock().until(() -> !bot.isConnected());

        assertThat(bot.lostReason()).contains("connection lost: ARIA failed: java.lang.AssertionError: made up");
        aria.clock().until(() -> aria.calls.contains("stopRunning"));
    }

    @ParameterizedTest
    @CsvSource({
        "getChargeState, charging",
        "getTemperature, temperature",
        "getDigIn, ''",
        "getRobotName, ''",
        "hasFrontBumpers, ''",
        "getCompass, ''",
        "getControl, ''",
        "getIOAnalogSize, ''",
        "getLeftEncoder, ''"
    })
    void aValueThatTheInstalledAriaDoesNotTellLeavesTheRobotConnected(String method, String parameter) {
        create(50);
        aria.others.put(method, () -> {
            if (method.equals("getChargeState")) {
                throw new IllegalArgumentException("a state that the wrapper does not know");
            }
            throw new NoSuchMethodError(method);
        });
        bot.connect();

        pass(1);

        assertThat(bot.isConnected()).isTrue();
        if (!parameter.isEmpty()) {
            assertThat(bot.get(parameter).toString()).startsWith("unknown (");
        }
    }

    @Test
    void aMethodWithoutWhichNoReportCanBeMadeIsNamedWhenConnecting() {
        create(50);
        aria.others.put("getFlags", () -> {
            throw new NoSuchMethodError("getFlags");
        });

        assertThatThrownBy(bot::connect)
                .isInstanceOf(BotException.class)
                .hasMessageContaining("ARIA failed: java.lang.NoSuchMethodError: getFlags");
        aria.clock().until(() -> aria.calls.contains("stopRunning"));
    }

    @Test
    void aCommandThatTheInstalledAriaLacksEndsTheConnection() {
        connect(50);
        aria.others.put("setVel", () -> {
            throw new NoSuchMethodError("setVel");
        });

        assertThatThrownBy(() -> bot.drive(100, 0))
                .isInstanceOf(LinkLost.class)
                .hasMessage("connection lost: ARIA failed: java.lang.NoSuchMethodError: setVel");

        aria.clock().until(() -> bot.connection() == MajicBot.Connection.LOST);
    }

    @Test
    void anAriaThatHangsIsALostConnection() {
        connect(50);
        aria.others.put("tryLock", () -> 3);

        assertThatThrownBy(() -> bot.drive(100, 0)).isInstanceOf(LinkLost.class).hasMessageContaining("not reacted");

        aria.clock().until(() -> bot.connection() == MajicBot.Connection.LOST);
        aria.others.clear();
    }

    @ParameterizedTest
    @ValueSource(strings = {"getLastOdometryTime", "getSonarReading"})
    void anOlderAriaWithoutTimesOfReadingsIsUsedAllTheSame(String method) {
        create(50);
        aria.others.put(method, () -> {
            throw new NoSuchMethodError(method);
        });
        aria.others.put("getCounter", () -> aria.clock().time().nanos() / 100_000_000);
        aria.others.put("getMotorPacCount", () -> 10);
        bot.connect();

        bot.move(500);

        assertThat(aria.model.x()).isCloseTo(500, within(10.0));
    }

    @Test
    void anAttemptToConnectCanBeCanceled() {
        create(50);
        CompletableFuture<Void> answer = new CompletableFuture<>();
        aria.others.put("setDeviceConnection", () -> {
            aria.clock().until(answer::isDone);
            return null;
        });
        CompletableFuture<Void> attempt = aria.clock().aside(bot::connect);
        aria.clock().until(() -> bot.connection() == MajicBot.Connection.CONNECTING);
        pass(0.5);

        CompletableFuture<Void> closing = aria.clock().aside(bot::close);
        assertThatThrownBy(() -> aria.clock().join(attempt)).hasRootCauseInstanceOf(BotException.class);
        answer.complete(null);
        aria.clock().join(closing);

        aria.clock().until(() -> aria.calls.contains("stopRunning"));
    }

    @Test
    void valuesThatAriaDoesNotTellSaySo() {
        connect(50);

        assertThat(bot.get("model")).hasToString("p3dx-sh");
        assertThat(bot.get("robotName")).hasToString("Rosa");
        assertThat(bot.get("voltage").number()).isEqualTo(12.5);
        assertThat(bot.get("sonar0").number()).isInfinite();
        for (String name :
                new String[] {"serialNumber", "lowVoltage", "watchdog", "damagedPackets", "gyro", "joystickX"}) {
            assertThat(bot.get(name)).as(name).hasToString("unknown (ARIA does not tell)");
        }
    }

    @Test
    void aLostRobotIsNotMovedAgainByAria() {
        connect(50);
        aria.connected = false;
        aria.clock().until(() -> !bot.isConnected());

        assertThatThrownBy(() -> bot.drive(100, 0)).isInstanceOf(LinkLost.class);
    }
}
