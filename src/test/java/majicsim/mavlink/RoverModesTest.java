package majicsim.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;

/** Modes, commands, the radio pilot, restarts, walls and noise of rovers and boats. */
class RoverModesTest {
    private static final int AUTO = 10;
    private static final int LOITER = 5;
    private static final int RTL = 11;
    private static final int MANUAL = 0;
    private static final int DO_REPOSITION = 192;
    private static final int VELOCITY = 0x0DE7;

    private final MavlinkStand rover = MavlinkStand.guidedRover();

    @Test
    void aModeThatDoesNotExistIsRefusedWithAText() {
        assertThat(rover.mode(99)).isEqualTo(4);
        assertThat(rover.texts()).endsWith("No such mode 99");
        assertThat(rover.handling().mode()).isEqualTo(MavlinkStand.GUIDED);
    }

    @Test
    void autoWithoutAMissionIsRefused() {
        assertThat(rover.mode(AUTO)).isEqualTo(4);
        assertThat(rover.texts()).endsWith("No Mission. Can't set AUTO.");
    }

    @Test
    void theHeartbeatTellsModeAndArmed() {
        rover.pass(1);
        Message heartbeat = rover.last(MessageType.HEARTBEAT);
        assertThat(heartbeat.integer("custom_mode")).isEqualTo(15);
        assertThat(heartbeat.integer("type")).isEqualTo(10);
        assertThat(heartbeat.integer("autopilot")).isEqualTo(3);
        assertThat(heartbeat.integer("base_mode")).isEqualTo(137);
        assertThat(heartbeat.integer("system_status")).isEqualTo(4);
        rover.mode(MavlinkStand.HOLD);
        rover.command(400, 0);
        rover.pass(1);
        assertThat(rover.last(MessageType.HEARTBEAT).integer("base_mode")).isEqualTo(1);
    }

    @Test
    void theOldWishForAModeIsAcknowledgedOnlyWithTheBitForCustomModes() {
        int before = rover.received();
        rover.send(new Message(MessageType.SET_MODE)
                .with("target_system", 1)
                .with("base_mode", 1)
                .with("custom_mode", 4));
        assertThat(rover.resultSince(before, 11)).isZero();
        before = rover.received();
        rover.send(new Message(MessageType.SET_MODE).with("target_system", 1).with("custom_mode", 0));
        assertThat(rover.resultSince(before, 11)).isEqualTo(-1);
        assertThat(rover.handling().mode()).isEqualTo(4);
    }

    @Test
    void armingTwiceAndDisarmingWhileItDrivesAreAccepted() {
        assertThat(rover.arm()).isZero();
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 3);
        assertThat(rover.command(400, 0)).isZero();
        rover.pass(1.5);
        assertThat(rover.speed()).isZero();
        assertThat(rover.texts()).endsWith("Throttle disarmed");
    }

    @Test
    void aCommandThatIsUnknownOrForACopterIsUnsupported() {
        assertThat(rover.command(31_999)).isEqualTo(3);
        assertThat(rover.command(22, 0, 0, 0, 0, 0, 0, 5)).isEqualTo(3);
        assertThat(rover.command(21)).isEqualTo(3);
    }

    @Test
    void messagesForAnotherVehicleAreIgnored() {
        rover.send(MavlinkStand.target(MavlinkStand.FRAME_BODY, VELOCITY)
                .with("target_system", 2)
                .with("vx", 1));
        rover.pass(2);
        assertThat(rover.north()).isZero();
    }

    @Test
    void itGoesToAPlaceOnTheGlobeByAnIntegerCommandOnly() {
        rover.mode(MavlinkStand.HOLD);
        assertThat(rover.command(DO_REPOSITION, -1, 1, 0, 0, -35.36, 149.16, 0)).isEqualTo(3);
        Message here = rover.ask(MessageType.GLOBAL_POSITION_INT);
        Message goal = new Message(MessageType.COMMAND_INT)
                .with("command", DO_REPOSITION)
                .with("target_system", 1)
                .with("frame", 6)
                .with("param1", -1.0)
                .with("x", here.integer("lat") + 449)
                .with("y", here.integer("lon"));
        int before = rover.received();
        rover.send(goal);
        assertThat(rover.resultSince(before, DO_REPOSITION)).isEqualTo(2);
        before = rover.received();
        rover.send(goal.with("param2", 1));
        assertThat(rover.resultSince(before, DO_REPOSITION)).isZero();
        assertThat(rover.handling().mode()).isEqualTo(MavlinkStand.GUIDED);
        rover.pass(8);
        assertThat(rover.north()).isCloseTo(5, within(0.2));
        assertThat(rover.east()).isCloseTo(0, within(0.2));
    }

    @Test
    void itGoesToAGuidedMissionItemToo() {
        Message here = rover.ask(MessageType.GLOBAL_POSITION_INT);
        rover.send(new Message(MessageType.MISSION_ITEM)
                .with("target_system", 1)
                .with("current", 2)
                .with("frame", 3)
                .with("command", 16)
                .with("x", (here.integer("lat") + 900) / 1e7)
                .with("y", here.integer("lon") / 1e7));
        assertThat(rover.last(MessageType.MISSION_ACK).integer("type")).isZero();
        rover.pass(15);
        assertThat(Math.hypot(rover.north() - 10, rover.east())).isLessThan(2);
        assertThat(rover.north()).isGreaterThan(5);
    }

    @Test
    void theTargetIsEchoed() {
        assertThat(rover.command(511, 85, 100_000)).isZero();
        rover.pass(1);
        assertThat(rover.all(MessageType.POSITION_TARGET_LOCAL_NED)).isEmpty();
        rover.send(
                MavlinkStand.target(MavlinkStand.FRAME_MAP, 0x0DFC).with("x", 6).with("y", 3));
        rover.pass(1);
        Message echo = rover.last(MessageType.POSITION_TARGET_LOCAL_NED);
        assertThat(echo.number("x")).isEqualTo(6);
        assertThat(echo.integer("type_mask")).isEqualTo(0x0DFC);
    }

    @Test
    void theSpeedOnTheWayCanBeChanged() {
        rover.send(MavlinkStand.target(MavlinkStand.FRAME_MAP, 0x0DFC).with("x", 30));
        assertThat(rover.command(178, 1, 0.5)).isZero();
        rover.pass(4);
        assertThat(rover.speed()).isCloseTo(0.5, within(0.01));
    }

    @Test
    void returningDrivesToWhereItWasArmed() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 4);
        assertThat(rover.mode(RTL)).isZero();
        rover.pass(12);
        assertThat(Math.hypot(rover.north(), rover.east())).isLessThan(0.2);
        assertThat(rover.handling().mode()).isEqualTo(RTL);
    }

    @Test
    void theRadioPilotTakesOver() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 2);
        rover.handling().pilotStick(3, 1400);
        assertThat(rover.handling().pilotMode(MANUAL)).isTrue();
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 2);
        assertThat(rover.last(MessageType.HEARTBEAT).integer("custom_mode")).isZero();
        assertThat(rover.speed()).isNegative();
    }

    @Test
    void onlyTheOwnGroundStationOverridesTheSticks() {
        rover.mode(MANUAL);
        rover.sendFrom(254, new Message(MessageType.RC_CHANNELS_OVERRIDE).with("chan3_raw", 1700));
        rover.pass(1);
        assertThat(rover.north()).isZero();
    }

    @Test
    void aRestartForgetsArmingModeAndRates() {
        rover.command(511, 30, 100_000);
        rover.pass(5);
        rover.handling().restart();
        rover.forget();
        rover.pass(3);
        assertThat(rover.last(MessageType.ATTITUDE).number("time_boot_ms")).isLessThanOrEqualTo(3000);
        assertThat(rover.all(MessageType.ATTITUDE)).hasSize(3);
        assertThat(rover.handling().isArmed()).isFalse();
        assertThat(rover.handling().mode()).isEqualTo(MANUAL);
    }

    @Test
    void theCommandToRebootIsAnsweredFirst() {
        rover.command(400, 0);
        rover.pass(5);
        assertThat(rover.command(246, 1)).isZero();
        rover.pass(1.1);
        assertThat(rover.last(MessageType.ATTITUDE).number("time_boot_ms")).isLessThan(1200);
    }

    @Test
    void failsafesReturnHomeIfTheParameterSaysSo() {
        rover.set("FS_GCS_ENABLE", 1);
        rover.set("FS_ACTION", 1);
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 2);
        rover.silent(true);
        rover.pass(8);
        assertThat(rover.handling().mode()).isEqualTo(RTL);
    }

    @Test
    void aGroundStationThatWasNeverThereIsNotMissed() {
        MavlinkStand alone = new MavlinkStand("rover+ready");
        alone.silent(true);
        alone.set("FS_GCS_ENABLE", 1);
        alone.pass(20);
        assertThat(alone.texts()).doesNotContain("Radio Failsafe");
    }

    @Test
    void aWallStopsItAndTheRangeFindersSeeIt() {
        rover.place(0, 18);
        rover.send(MavlinkStand.target(MavlinkStand.FRAME_MAP, 0x09FF).with("yaw", Math.PI / 2));
        rover.pass(2.9);
        assertThat(rover.yaw()).isCloseTo(90, within(1.0));
        assertThat(rover.ask(MessageType.RANGEFINDER).number("distance")).isCloseTo(1.7, within(0.1));
        Message around = rover.ask(MessageType.OBSTACLE_DISTANCE);
        assertThat(around.number("distances", 0)).isCloseTo(200, within(5.0));
        assertThat(around.number("distances", 36)).isEqualTo(801);
        rover.ask(MessageType.DISTANCE_SENSOR);
        assertThat(rover.all(MessageType.DISTANCE_SENSOR))
                .anySatisfy(
                        distance -> assertThat(distance.integer("orientation")).isEqualTo(6));
        rover.stream(MavlinkStand.FRAME_BODY, 0x05E7, 1, 0, 4);
        assertThat(rover.east()).isBetween(19.5, 19.8);
        assertThat(rover.speed()).isZero();
    }

    @Test
    void aBoatKeepsItsPlaceWhereARoverStops() {
        MavlinkStand boat = new MavlinkStand("boat+ready");
        boat.pass(0.1);
        boat.mode(MavlinkStand.GUIDED);
        boat.arm();
        boat.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 2).pass(5);
        double stopped = boat.north();
        boat.place(stopped - 5, 0);
        boat.pass(10);
        assertThat(boat.north()).isCloseTo(stopped, within(2.0));
        assertThat(boat.mode(LOITER)).isZero();
        assertThat(boat.last(MessageType.HEARTBEAT).integer("type")).isEqualTo(11);
    }

    @Test
    void aStandingVehicleWandersALittleWithNoiseAndRepeatsItWithItsSeed() {
        MavlinkStand noisy = new MavlinkStand("rover+ready", Noise.seeded(5));
        noisy.command(511, 32, 200_000);
        noisy.pass(120);
        double farthest = noisy.all(MessageType.LOCAL_POSITION_NED).stream()
                .mapToDouble(place -> Math.hypot(place.number("x"), place.number("y")))
                .max()
                .orElseThrow();
        assertThat(farthest).isBetween(0.1, 0.45);
        assertThat(noisy.pose()).isEqualTo(new Pose(0, 0, 90));
        MavlinkStand again = new MavlinkStand("rover+ready", Noise.seeded(5));
        again.command(511, 32, 200_000);
        again.pass(120);
        assertThat(again.bytes()).isEqualTo(noisy.bytes());
    }
}
