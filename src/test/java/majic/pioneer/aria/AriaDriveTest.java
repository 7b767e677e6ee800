package majic.pioneer.aria;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.mockito.Mockito.when;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
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
    private final List<String> notices = new CopyOnWriteArrayList<>();
    private int openResult;

    private void create(long phaseMs) {
        aria = new AriaDouble(phaseMs);
        AriaRobot shared = new AriaRobot(aria.robot, aria.laser.of(aria.robot));
        AriaDevice device = new AriaDevice("tcp:robot:8101", () -> new AriaDevice.Opened(aria.device, openResult));
        bot = TestPioneers.over(
                wait -> new AriaConnection(shared, device, wait),
                new BotEnvironment(aria.clock().time(), Settings.inMemory()));
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot from, String message) {
                notices.add(message);
            }
        });
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
    void aLaserThatAriaConnectsToIsDescribedByItsFirstScan() {
        create(50);
        aria.laser.add();
        bot.connect();
        pass(0.5);

        RangeSensor laser = bot.rangeSensors().get(1);

        assertThat(laser.name()).isEqualTo("laser");
        assertThat(laser.isLaser()).isTrue();
        assertThat(laser.beams()).hasSize(181);
        assertThat(laser.beams().get(0).mount()).isEqualTo(new Pose(21, 0, -90));
        assertThat(laser.beams().get(180).mount()).isEqualTo(new Pose(21, 0, 90));
        assertThat(laser.beams().get(90).reachMm()).isEqualTo(8000);
        assertThat(bot.get("laser")).hasToString("2000 mm, 2000 mm, 1500 mm, 1500 mm, 2000 mm, clear");
    }

    @Test
    void aScanHasThePoseAndTheTimeAtWhichItWasMeasured() {
        create(50);
        aria.laser.add();
        aria.model.pose(1000, 0, 0);
        bot.connect();
        List<RangeScan> scans = new CopyOnWriteArrayList<>();
        bot.addScanListener(scan -> {
            if (scan.sensor().isLaser()) {
                scans.add(scan);
            }
        });
        bot.drive(300, 0);
        pass(2);
        List<AriaLaserDouble.Taken> taken = aria.laser.taken();

        assertThat(scans).hasSizeGreaterThan(8);
        assertThat(scans).extracting(RangeScan::timeS).doesNotHaveDuplicates();
        assertThat(scans)
                .allSatisfy(scan -> assertThat(taken).anySatisfy(at -> {
                    assertThat(scan.timeS()).isCloseTo(at.ms() / 1000.0, within(0.0015));
                    assertThat(scan.odometry().xMm()).isCloseTo(at.xMm() - 1000, within(1.0));
                }));
        RangeScan last = scans.get(scans.size() - 1);
        assertThat(last.rangeMm(90)).isEqualTo(1500);
        assertThat(last.rangeMm(30)).as("ignored by ARIA").isNaN();
        assertThat(last.rangeMm(170)).as("beyond its reach").isInfinite();
    }

    @Test
    void aRobotWithoutALaserHasNoneAndNothingIsSaidAboutIt() {
        connect(50);
        pass(1);

        assertThat(bot.rangeSensors()).extracting(RangeSensor::name).containsExactly("sonar");
        assertThat(notices).isEmpty();
    }

    @Test
    void aLaserThatAriaCannotReachIsANoticeOfAConnectedRobot() {
        create(50);
        aria.laser.reached = false;
        bot.connect();
        pass(1);

        assertThat(notices).containsExactly("ARIA cannot reach the robot's laser; see its messages in the terminal");
        assertThat(bot.isConnected()).isTrue();
        assertThat(bot.rangeSensors()).hasSize(1);
    }

    @Test
    void aRobotIsDrivenAndStoppedWhileAriaConnectsToItsLaser() {
        create(50);
        aria.laser.add();
        CompletableFuture<Void> answer = new CompletableFuture<>();
        aria.laser.delay = () -> aria.clock().until(answer::isDone);
        bot.connect();

        bot.drive(200, 0);
        pass(0.5);
        bot.stop();

        assertThat(aria.model.isStationary()).isTrue();
        assertThat(bot.rangeSensors()).hasSize(1);
        answer.complete(null);
        aria.clock().until(() -> bot.rangeSensors().size() == 2);
    }

    @Test
    void aLaserThatIsReachedAfterTheRobotWasClosedIsDisconnected() {
        create(50);
        aria.laser.add();
        CompletableFuture<Void> answer = new CompletableFuture<>();
        aria.laser.delay = () -> aria.clock().until(answer::isDone);
        bot.connect();
        bot.close();
        answer.complete(null);

        aria.clock().until(() -> aria.laser.calls.contains("disconnect"));
    }

    @Test
    void aLaserThatDeliversNothingForASecondShowsNoOldReading() {
        create(50);
        aria.laser.add();
        bot.connect();
        pass(0.5);
        aria.laser.silent = true;

        pass(1);

        assertThat(bot.get("laser")).hasToString("unknown (no reading of late)");
        assertThat(bot.isConnected()).isTrue();
        aria.laser.silent = false;
        pass(0.5);
        assertThat(bot.get("laser").toString()).startsWith("2000 mm");
    }

    @Test
    void theLaserIsConnectedAgainWithTheRobotByTheSameConnector() {
        create(50);
        aria.laser.add();
        bot.connect();
        pass(0.5);
        aria.connected = false;
        aria.clock().until(() -> !bot.isConnected());
        aria.clock().until(() -> aria.laser.calls.contains("disconnect"));

        bot.connect();
        pass(0.5);

        assertThat(bot.rangeSensors()).hasSize(2);
        assertThat(aria.laser.calls)
                .containsExactly("new ArLaserConnector", "connectLasers", "disconnect", "connectLasers");
    }

    @Test
    void anErrorInTheLaserLeavesTheRobotConnected() {
        create(50);
        aria.laser.add();
        aria.laser.error = new NoSuchMethodError("getRawReadingsAsVector");
        bot.connect();
        pass(1);

        assertThat(notices)
                .containsExactly("ARIA failed to read the robot's laser: java.lang.NoSuchMethodError:"
                        + " getRawReadingsAsVector");
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void anOlderAriaWithoutLasersIsUsedAllTheSame() {
        create(50);
        aria.laser.missing = true;
        bot.connect();
        pass(1);

        assertThat(notices).isEmpty();
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aLostRobotIsNotMovedAgainByAria() {
        connect(50);
        aria.connected = false;
        aria.clock().until(() -> !bot.isConnected());

        assertThatThrownBy(() -> bot.drive(100, 0)).isInstanceOf(LinkLost.class);
    }
}
