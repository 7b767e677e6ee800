package majic.mavlink;

import static majic.mavlink.VehicleFrames.fields;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Connecting to a rover: what is sent, what is reported, what is refused. */
class RoverConnectingTest {
    @AutoClose
    private final DrivenRover robot = new DrivenRover();

    private final ScriptedRover rover = robot.rover;
    private final MajicMavlink bot = robot.bot();

    @Test
    void connectingNeitherArmsNorMovesNorChangesTheMode() {
        bot.connect();
        robot.pass(2);

        assertThat(rover.commands(400)).isEmpty();
        assertThat(rover.commands(176)).isEmpty();
        assertThat(rover.targets()).isEmpty();
        assertThat(rover.armed).isFalse();
    }

    @Test
    void aHeartbeatOfAGroundStationIsSentOnceASecondFromTheStart() {
        bot.connect();
        int before = heartbeats();
        robot.pass(5);

        assertThat(before).isPositive();
        assertThat(heartbeats() - before).isBetween(4, 6);
        assertThat(rover.received).allMatch(got -> got.system() == 255 && got.component() == 190);
    }

    private int heartbeats() {
        return (int) rover.received.stream().filter(got -> got.id() == 0).count();
    }

    @Test
    void attitudeAndPositionAreAskedForTenTimesASecond() {
        bot.connect();

        assertThat(rover.commands(511)).anyMatch(got -> got.f32(0) == 30 && got.f32(4) == 100_000);
        assertThat(rover.commands(511)).anyMatch(got -> got.f32(0) == 32 && got.f32(4) == 100_000);
    }

    @Test
    void afterARestartTheyAreAskedForAgain() {
        bot.connect();
        robot.pass(3);
        int before = rover.commands(511).size();

        rover.restart();
        robot.pass(5);

        assertThat(rover.commands(511).size()).isGreaterThan(before);
        assertThat(robot.notices()).contains("the autopilot has restarted");
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aVehicleWhoseNavigationGoesOnWithoutMajicIsReported() {
        bot.connect();

        assertThat(robot.notices()).anyMatch(notice -> notice.contains("set param/FS_GCS_ENABLE 1"));
        assertThat(bot.get("failsafe").toString()).contains("FS_GCS_ENABLE is 0");
    }

    @Test
    void aVehicleWithAFailsafeIsNot() {
        rover.parameters.put("FS_GCS_ENABLE", 1f);

        bot.connect();

        assertThat(robot.notices()).noneMatch(notice -> notice.contains("FS_GCS_ENABLE"));
        assertThat(bot.get("failsafe").toString()).contains("goes to HOLD");
    }

    @Test
    void aVehicleOfMavlink1IsSentMavlink1() {
        rover.version = 1;

        bot.connect();

        assertThat(rover.commands(511)).isNotEmpty().allMatch(got -> got.version() == 1);
    }

    @Test
    void whatItReportsIsThere() {
        bot.connect();
        robot.pass(1.5);

        assertThat(bot.get("mode")).isEqualTo(Value.text("MANUAL"));
        assertThat(bot.get("armed")).isEqualTo(Value.yesNo(false));
        assertThat(bot.get("latitude").toString()).matches("47\\.000\\d{1,4} °");
        assertThat(bot.get("longitude").toString()).isEqualTo("9 °");
        assertThat(bot.get("satellites").number()).isEqualTo(11);
        assertThat(bot.get("fix")).isEqualTo(Value.text("3-D"));
        assertThat(bot.get("voltage").number()).isEqualTo(12.4);
        assertThat(bot.get("battery").number()).isEqualTo(80);
        assertThat(bot.get("model")).isEqualTo(Value.text("rover 4.6.0"));
        assertThat(bot.get("damagedFrames").number()).isZero();
    }

    @Test
    void aSecondBatteryDoesNotHideTheMainOne() {
        rover.batteries = List.of(ScriptedRover.battery(1, 25_200, 20));
        bot.connect();
        robot.pass(4);

        assertThat(bot.get("voltage").number()).isEqualTo(12.4);
        assertThat(bot.get("battery").number()).isEqualTo(80);
    }

    @Test
    void theMainBatteryIsTakenBeforeTheStatusAndWhatItLeavesOutFromTheStatus() {
        rover.batteries = List.of(ScriptedRover.battery(0, 12_100, -1), ScriptedRover.battery(1, 25_200, 20));
        bot.connect();
        robot.pass(4);

        assertThat(bot.get("voltage").number()).isEqualTo(12.1);
        assertThat(bot.get("battery").number()).isEqualTo(80);
    }

    @Test
    void aBatteryThatEndsItsReportsIsThatOfTheStatusAgain() {
        rover.batteries = List.of(ScriptedRover.battery(0, 12_100, 70));
        bot.connect();
        robot.pass(2);
        rover.batteries = List.of();
        robot.pass(4);

        assertThat(bot.get("voltage").number()).isEqualTo(12.4);
    }

    @Test
    void theFirstPoseIsTheStartWhereverTheVehicleIs() {
        bot.connect();

        assertThat(bot.state().pose().xMm()).isCloseTo(0, within(1e-6));
        assertThat(bot.state().pose().yMm()).isCloseTo(0, within(1e-6));
        assertThat(bot.state().pose().headingDeg()).isCloseTo(0, within(1e-6));
    }

    @Test
    void aVehicleThatSaysNothingIsNotConnected() {
        rover.silent = true;

        assertThatThrownBy(bot::connect)
                .isInstanceOf(ConnectFailed.class)
                .hasMessageContaining("no vehicle has sent anything");
    }

    @Test
    void anotherSystemThanTheOneThatIsWantedIsNamed() {
        try (DrivenRover other = new DrivenRover("?system=3")) {
            assertThatThrownBy(other.bot()::connect)
                    .isInstanceOf(ConnectFailed.class)
                    .hasMessageContaining("no vehicle with system 3")
                    .hasMessageContaining("1 (rover)");
        }
    }

    private void connectTo(int type, int autopilot, int major) {
        rover.type = type;
        rover.autopilot = autopilot;
        rover.major = major;
        bot.connect();
    }

    @Test
    void aCopterFliesOnlyInsideAFence() {
        connectTo(2, 3, 4);

        assertThat(robot.notices()).anyMatch(notice -> notice.contains("it flies only after"));
    }

    @Test
    void aRoverWithArduPilot4IsDrivenWithoutFurtherNotice() {
        connectTo(10, 3, 4);

        assertThat(robot.notices()).noneMatch(notice -> notice.contains("MAJIC shows"));
    }

    @Test
    void whatCanBeDoneWithPx4IsSaid() {
        connectTo(2, 12, 1);

        assertThat(robot.notices())
                .contains(
                        "its autopilot is PX4: MAJIC shows and stops it, but neither arms nor moves it otherwise than by"
                                + " hold, land, home");
    }

    @Test
    void whatCanBeDoneWithAPlaneIsSaid() {
        connectTo(1, 3, 4);

        assertThat(robot.notices())
                .contains(
                        "it is a plane: MAJIC shows and stops it, but neither arms nor moves it otherwise than by hold,"
                                + " home");
    }

    @Test
    void whatCanBeDoneWithASubmarineIsSaid() {
        connectTo(12, 3, 4);

        assertThat(robot.notices())
                .contains("it is a submarine: MAJIC shows and stops it, but neither arms nor moves it otherwise than by"
                        + " hold, surface");
    }

    @Test
    void whatCanBeDoneWithAnArduPilotBeforeVersion4IsSaid() {
        connectTo(10, 3, 3);

        assertThat(robot.notices())
                .contains("its autopilot is ArduPilot 3.6.0: MAJIC shows and stops it, but its motions fail, because"
                        + " versions before 4 ignore velocities");
    }

    @Test
    void anAutopilotThatDoesNotReportItsVersionMayBeAnOldOne() {
        connectTo(10, 3, 0);

        assertThat(robot.notices())
                .anyMatch(notice -> notice.contains("has not reported its version: before ArduPilot 4"));
    }

    @Test
    void silenceOfThreeSecondsIsALostLink() {
        bot.connect();
        robot.pass(1);
        long silentMs = robot.peer.millis();

        rover.silent = true;
        robot.clock().until(() -> !bot.isConnected());

        assertThat(robot.peer.millis() - silentMs).isBetween(2900L, 3500L);
        assertThat(bot.lostReason()).get().asString().contains("silent for 3 s");
    }

    @Test
    void groupsOfReportsAreNotAskedOfAVehicleThatAnswersAndHasNoPosition() {
        rover.withoutPosition = true;
        bot.connect();
        robot.pass(12);

        assertThat(rover.commands(511).size()).isGreaterThan(20);
        assertThat(rover.received).noneMatch(got -> got.id() == 66);
    }

    @Test
    void aSlowRadioIsAskedMoreAndMoreRarelyAndReportedOnce() {
        rover.leastPeriodMs = 250;
        bot.connect();
        robot.pass(60);
        int before = rover.commands(511).size();
        robot.pass(120);

        assertThat(before).isGreaterThan(30);
        assertThat(rover.commands(511).size() - before).isBetween(8, 24);
        assertThat(robot.notices())
                .filteredOn(notice -> notice.contains("come only"))
                .singleElement()
                .asString()
                .contains("its position and attitude come only 4 times a second, and MAJIC asks for 10");
    }

    @Test
    void aSlowRadioIsAskedAtOnceAfterARestart() {
        rover.leastPeriodMs = 250;
        bot.connect();
        robot.pass(100);
        int before = rover.commands(511).size();

        rover.restart();
        robot.pass(1.5);

        assertThat(rover.commands(511).size() - before).isGreaterThanOrEqualTo(8);
    }

    @Test
    void furtherRequestsAreSentOneByOne() {
        rover.leastPeriodMs = 250;
        bot.connect();
        robot.pass(1);
        for (int part = 0; part < 100; part++) {
            int before = rover.commands(511).size();
            robot.pass(0.1);
            assertThat(rover.commands(511).size() - before).isLessThanOrEqualTo(1);
        }
        assertThat(rover.commands(511).size()).isGreaterThan(16);
    }

    @Test
    void aVehicleThatIsFastIsNotReported() {
        bot.connect();
        robot.pass(30);

        assertThat(robot.notices()).noneMatch(notice -> notice.contains("come only"));
        assertThat(rover.commands(511)).hasSize(8);
    }

    @Test
    void afterALossTheRobotIsNotAnotherVehicle() {
        bot.connect();
        robot.cut();
        robot.clock().until(() -> !bot.isConnected());
        rover.system = 2;

        assertThatThrownBy(bot::connect)
                .isInstanceOf(ConnectFailed.class)
                .hasMessageContaining("no vehicle with system 1")
                .hasMessageContaining("2 (rover)");
    }

    @Test
    void aHeartbeatOfBeforeIsNoVehicle() {
        bot.connect();
        rover.system = 2;
        try (MajicMavlink second = robot.another("?system=2")) {
            second.connect();
            robot.clock().until(() -> !bot.isConnected());
            robot.pass(1);

            assertThatThrownBy(bot::connect)
                    .isInstanceOf(ConnectFailed.class)
                    .hasMessageContaining("no vehicle with system 1");
        }
    }

    /** A character of two bytes makes a full piece shorter than 50 characters. */
    @Test
    void theFirstPieceOfATextIsNotItsEndThoughItHasFewerCharacters() {
        bot.connect();
        byte[] full = "Motor 1 is hot: 95 \u00b0C, limit 90 \u00b0C, load 99 % no".getBytes(StandardCharsets.UTF_8);
        rover.send(253, fields(54).put((byte) 3).put(full).putShort((short) 7).put((byte) 0));
        rover.send(
                253,
                fields(54)
                        .put((byte) 3)
                        .put(Arrays.copyOf("w".getBytes(StandardCharsets.UTF_8), 50))
                        .putShort((short) 7)
                        .put((byte) 1));
        robot.pass(0.5);

        assertThat(full).hasSize(50);
        assertThat(bot.get("message")).hasToString("Motor 1 is hot: 95 \u00b0C, limit 90 \u00b0C, load 99 % now");
    }

    @Test
    void theModeOfAnAutopilotThatIsSilentIsUnknown() {
        bot.connect();
        robot.pass(1);
        rover.component = 100;
        robot.pass(4);

        assertThat(bot.isConnected()).isTrue();
        assertThat(bot.get("mode").toString()).contains("does not report it");
    }

    @Test
    void theRestartOfAVehicleWithoutAPositionIsSeenToo() {
        rover.withoutPosition = true;
        bot.connect();
        robot.pass(5);

        rover.restart();
        robot.pass(2);

        assertThat(robot.notices()).contains("the autopilot has restarted");
    }

    @Test
    void itKeepsItsKindWhenItCannotBeConnectedAgain() {
        bot.connect();
        robot.fallSilent();
        robot.pass(5);

        assertThatThrownBy(bot::connect).isInstanceOf(BotException.class);
        assertThat(bot.kind()).isEqualTo("Rover");
    }
}
