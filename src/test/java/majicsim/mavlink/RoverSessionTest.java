package majicsim.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import org.junit.jupiter.api.Test;

/** What was seen on a real ArduRover, row by row (sheet 12). */
class RoverSessionTest {
    private static final int POSITION = 0x0DFC;
    private static final int VELOCITY = 0x0DE7;
    private static final int VELOCITY_AND_YAW_RATE = 0x05E7;
    private static final int YAW_RATE = 0x05FF;
    private static final String TIMED_OUT = "target not received last 3secs, stopping";

    private final MavlinkStand rover = MavlinkStand.guidedRover();

    @Test
    void itStartsWithTextAndRefusesToArmForTheFirst44Seconds() {
        MavlinkStand cold = new MavlinkStand("rover");
        assertThat(new String(cold.bytes(), StandardCharsets.US_ASCII)).startsWith("\n\nInit ArduRover V4.6");
        cold.pass(4);
        assertThat(cold.arm()).isEqualTo(4);
        assertThat(cold.texts()).contains("Arm: Accels inconsistent");
        cold.pass(4);
        assertThat(cold.mode(MavlinkStand.GUIDED)).isZero();
        assertThat(cold.arm()).isEqualTo(4);
        assertThat(cold.texts()).contains("Arm: AHRS: waiting for home");
        cold.pass(33);
        assertThat(cold.arm()).isEqualTo(4);
        assertThat(cold.texts())
                .contains("Arm: AHRS: not using configured AHRS type")
                .doesNotContain("EKF3 IMU0 is using GPS");
        cold.pass(2);
        assertThat(cold.texts()).contains("EKF3 IMU0 is using GPS");
        assertThat(cold.arm()).isEqualTo(4);
        cold.pass(1.1);
        assertThat(cold.arm()).isZero();
        assertThat(cold.texts()).endsWith("Throttle armed");
    }

    @Test
    void itReportsNoPlaceBeforeTheFilterUsesSatellites() {
        MavlinkStand cold = new MavlinkStand("rover");
        cold.place(3, 4);
        cold.pass(5);
        assertThat(cold.last(MessageType.GLOBAL_POSITION_INT).number("lat")).isZero();
        assertThat(cold.last(MessageType.LOCAL_POSITION_NED).number("z")).isZero();
        cold.pass(20);
        assertThat(cold.last(MessageType.GLOBAL_POSITION_INT).number("lat")).isNotZero();
        assertThat(cold.last(MessageType.LOCAL_POSITION_NED).number("x")).isZero();
        assertThat(cold.last(MessageType.LOCAL_POSITION_NED).number("z")).isEqualTo(584);
        cold.place(5, 4);
        cold.pass(20);
        assertThat(cold.last(MessageType.LOCAL_POSITION_NED).number("x")).isCloseTo(2, within(1e-6));
        assertThat(cold.last(MessageType.LOCAL_POSITION_NED).number("z")).isZero();
    }

    @Test
    void aPositionThatIsSentOnceIsReached() {
        rover.send(MavlinkStand.target(MavlinkStand.FRAME_MAP, POSITION)
                .with("x", 6)
                .with("y", 3));
        double fastest = 0;
        double seconds = 0;
        while (rover.all(MessageType.MISSION_ITEM_REACHED).isEmpty() && seconds < 20) {
            rover.pass(0.1);
            seconds += 0.1;
            fastest = Math.max(fastest, rover.speed());
        }
        assertThat(seconds).isCloseTo(7, within(1.5));
        assertThat(fastest).isBetween(1.6, 2.0);
        rover.pass(2);
        assertThat(rover.speed()).isZero();
        assertThat(Math.hypot(rover.north() - 6, rover.east() - 3)).isLessThan(0.25);
        assertThat(rover.all(MessageType.MISSION_ITEM_REACHED)).hasSize(1);
        assertThat(rover.texts()).doesNotContain(TIMED_OUT);
    }

    @Test
    void aPositionFromHereIsInTheAxesOfTheVehicle() {
        rover.stream(MavlinkStand.FRAME_BODY, YAW_RATE, 0, Math.toRadians(45), 2)
                .pass(4);
        double yaw = Math.toRadians(rover.yaw());
        rover.send(MavlinkStand.target(MavlinkStand.FRAME_BODY, POSITION).with("x", 4));
        rover.pass(8);
        assertThat(rover.north()).isCloseTo(4 * Math.cos(yaw), within(0.2));
        assertThat(rover.east()).isCloseTo(4 * Math.sin(yaw), within(0.2));
    }

    @Test
    void aVelocityEndsThreeSecondsAfterItsLastMessage() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 4);
        assertThat(rover.speed()).isCloseTo(1, within(0.05));
        rover.pass(2.7);
        assertThat(rover.speed()).isCloseTo(1, within(0.05));
        assertThat(rover.texts()).doesNotContain(TIMED_OUT);
        double blind = rover.north();
        rover.pass(0.2);
        assertThat(rover.texts()).endsWith(TIMED_OUT);
        rover.pass(1);
        assertThat(rover.speed()).isZero();
        assertThat(rover.north() - blind).isLessThan(1);
        rover.pass(5);
        assertThat(rover.texts().stream().filter(TIMED_OUT::equals)).hasSize(1);
    }

    @Test
    void itHasTheWantedSpeedAfterOneAndAHalfSeconds() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 1.6);
        assertThat(rover.speed()).isCloseTo(1, within(0.05));
    }

    @Test
    void aPositiveYawRateTurnsToTheRight() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY_AND_YAW_RATE, 1, 0.3, 2);
        assertThat(rover.turning()).isCloseTo(17.2, within(0.5));
        assertThat(rover.yaw()).isPositive();
    }

    @Test
    void allZeroStopsWithinOneAndAHalfSeconds() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY_AND_YAW_RATE, 1, 0.3, 3);
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY_AND_YAW_RATE, 0, 0, 1.6);
        assertThat(rover.speed()).isZero();
        assertThat(rover.turning()).isZero();
    }

    @Test
    void aNegativeSpeedWithAYawRateDrivesBackwards() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY_AND_YAW_RATE, -1, 0, 3);
        assertThat(rover.speed()).isCloseTo(-1, within(0.05));
        assertThat(rover.yaw()).isCloseTo(0, within(0.1));
        assertThat(rover.north()).isLessThan(-2);
    }

    @Test
    void aNegativeSpeedWithoutAYawRateTurnsInCircles() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, -1, 0, 6);
        assertThat(Math.abs(rover.turning())).isCloseTo(120, within(5.0));
        assertThat(rover.speed()).isCloseTo(1, within(0.1));
        assertThat(Math.hypot(rover.north(), rover.east())).isLessThan(2);
    }

    @Test
    void zeroVelocityInTheMapTurnsToNorthOnTheSpot() {
        rover.stream(MavlinkStand.FRAME_BODY, YAW_RATE, 0, -1, 2);
        assertThat(rover.yaw()).isLessThan(-60);
        rover.stream(MavlinkStand.FRAME_MAP, VELOCITY, 0, 0, 4);
        assertThat(rover.yaw()).isCloseTo(0, within(1.0));
        assertThat(Math.hypot(rover.north(), rover.east())).isLessThan(0.01);
    }

    @Test
    void aYawRateAloneTurnsOnTheSpot() {
        rover.stream(MavlinkStand.FRAME_BODY, YAW_RATE, 0, -0.5, 2);
        assertThat(rover.turning()).isCloseTo(-28.6, within(0.5));
        assertThat(Math.hypot(rover.north(), rover.east())).isLessThan(0.01);
    }

    @Test
    void aSpeedThatIsTooHighIsLimitedInSilence() {
        rover.forget();
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 20, 0, 4);
        assertThat(rover.speed()).isCloseTo(2.05, within(0.1));
        assertThat(rover.texts()).isEmpty();
    }

    @Test
    void holdStopsWithinASecondAndLaterTargetsDoNothing() {
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 4);
        double start = rover.north();
        assertThat(rover.mode(MavlinkStand.HOLD)).isZero();
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 1.2);
        assertThat(rover.speed()).isZero();
        assertThat(rover.north() - start).isBetween(0.8, 1.3);
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 3);
        assertThat(rover.speed()).isZero();
        assertThat(rover.last(MessageType.HEARTBEAT).integer("system_status")).isEqualTo(3);
    }

    @Test
    void aTargetInAWrongModeFrameOrMaskIsDroppedInSilence() {
        rover.forget();
        rover.stream(20, VELOCITY, 1, 0, 1);
        rover.stream(MavlinkStand.FRAME_BODY, 0x0FF7, 1, 0, 1);
        rover.mode(MavlinkStand.HOLD);
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 1);
        assertThat(rover.north()).isZero();
        assertThat(rover.texts()).isEmpty();
    }

    @Test
    void anOverrideEndsThreeSecondsAfterItsLastMessage() {
        rover.mode(0);
        for (int i = 0; i < 30; i++) {
            rover.send(new Message(MessageType.RC_CHANNELS_OVERRIDE)
                    .with("target_system", 1)
                    .with("chan1_raw", 1600)
                    .with("chan3_raw", 1700));
            rover.pass(0.1);
        }
        assertThat(rover.speed()).isCloseTo(2.9, within(0.1));
        assertThat(rover.turning()).isPositive();
        rover.pass(2.8);
        assertThat(rover.speed()).isCloseTo(2.9, within(0.1));
        rover.pass(1.4);
        assertThat(rover.speed()).isZero();
    }

    @Test
    void aJoystickEndsThreeSecondsAfterItsLastMessage() {
        rover.mode(0);
        for (int i = 0; i < 30; i++) {
            rover.send(new Message(MessageType.MANUAL_CONTROL).with("target", 1).with("z", 400));
            rover.pass(0.1);
        }
        assertThat(rover.speed()).isCloseTo(2.9, within(0.1));
        rover.pass(2.8);
        assertThat(rover.speed()).isCloseTo(2.9, within(0.1));
        rover.pass(1.4);
        assertThat(rover.speed()).isZero();
    }

    @Test
    void withoutHeartbeatsItDrivesOnToItsTarget() {
        rover.pass(1);
        rover.silent(true);
        rover.send(MavlinkStand.target(MavlinkStand.FRAME_MAP, POSITION).with("x", 25));
        rover.pass(20);
        assertThat(rover.north()).isCloseTo(25, within(0.2));
    }

    @Test
    void withTheFailsafeOnItHoldsWhenHeartbeatsEndAndStaysInHoldWhenTheyComeBack() {
        rover.set("FS_GCS_ENABLE", 1);
        rover.pass(1);
        rover.silent(true);
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 5.8);
        assertThat(rover.handling().mode()).isEqualTo(MavlinkStand.GUIDED);
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 1.2);
        assertThat(rover.handling().mode()).isEqualTo(MavlinkStand.HOLD);
        assertThat(rover.texts()).endsWith("Radio Failsafe");
        rover.pass(1);
        assertThat(rover.last(MessageType.HEARTBEAT).integer("system_status")).isEqualTo(5);
        rover.silent(false);
        rover.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 3);
        assertThat(rover.texts()).endsWith("GCS Failsafe Cleared");
        assertThat(rover.handling().mode()).isEqualTo(MavlinkStand.HOLD);
        assertThat(rover.speed()).isZero();
    }
}
