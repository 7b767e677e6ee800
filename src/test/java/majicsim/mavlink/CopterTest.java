package majicsim.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import org.junit.jupiter.api.Test;

/** The copter: arming, take-off, flight, landing, and what makes it fall. */
class CopterTest {
    private static final int GUIDED = 4;
    private static final int LOITER = 5;
    private static final int RTL = 6;
    private static final int LAND = 9;
    private static final int BRAKE = 17;
    private static final int POSITION = 0x0DF8;
    private static final int VELOCITY = 0x0DC7;
    private static final int VELOCITY_AND_YAW_RATE = 0x05C7;
    private static final int ON_GROUND = 1;
    private static final int IN_AIR = 2;
    private static final int TAKING_OFF = 3;
    private static final int LANDING = 4;

    private final MavlinkStand copter = new MavlinkStand("copter+ready");

    private MavlinkStand flying(double height) {
        copter.pass(0.1);
        assertThat(copter.mode(GUIDED)).isZero();
        assertThat(copter.arm()).isZero();
        assertThat(takeOff(height)).isZero();
        return copter.pass(3 + height);
    }

    private int takeOff(double height) {
        return copter.command(22, 0, 0, 0, 0, 0, 0, height);
    }

    private double height() {
        return copter.handling().heightM();
    }

    private int landedState() {
        return copter.ask(MessageType.EXTENDED_SYS_STATE).integer("landed_state");
    }

    @Test
    void itTakesOffOnlyArmedAndInGuided() {
        copter.pass(0.1);
        assertThat(takeOff(3)).isEqualTo(4);
        copter.mode(GUIDED);
        assertThat(takeOff(3)).isEqualTo(4);
        copter.arm();
        assertThat(takeOff(3)).isZero();
        copter.pass(1);
        assertThat(landedState()).isEqualTo(TAKING_OFF);
        copter.pass(5);
        assertThat(height()).isCloseTo(3, within(0.15));
        assertThat(landedState()).isEqualTo(IN_AIR);
        assertThat(takeOff(5)).isEqualTo(4);
    }

    @Test
    void itReportsItsHeightInEachWay() {
        flying(3);
        Message global = copter.ask(MessageType.GLOBAL_POSITION_INT);
        assertThat(copter.ask(MessageType.LOCAL_POSITION_NED).number("z")).isCloseTo(-3, within(0.15));
        assertThat(global.number("relative_alt")).isCloseTo(3000, within(150.0));
        assertThat(global.number("alt")).isCloseTo(587_000, within(150.0));
        assertThat(copter.ask(MessageType.DISTANCE_SENSOR).integer("orientation"))
                .isEqualTo(25);
        assertThat(copter.last(MessageType.DISTANCE_SENSOR).number("current_distance"))
                .isCloseTo(300, within(15.0));
        assertThat(copter.last(MessageType.HEARTBEAT).integer("base_mode")).isEqualTo(217);
        assertThat(copter.last(MessageType.HEARTBEAT).integer("type")).isEqualTo(2);
    }

    @Test
    void withoutPositionItRefusesGuided() {
        MavlinkStand cold = new MavlinkStand("copter");
        cold.pass(10);
        assertThat(cold.mode(GUIDED)).isEqualTo(4);
        assertThat(cold.texts()).endsWith("Mode change to GUIDED failed: requires position");
        assertThat(cold.arm()).isEqualTo(4);
    }

    @Test
    void aVelocityIsFlownAndEndsAfterThreeSecondsInAHover() {
        flying(3);
        copter.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 3);
        assertThat(copter.ask(MessageType.LOCAL_POSITION_NED).number("vx")).isCloseTo(1, within(0.05));
        copter.pass(2.6);
        assertThat(copter.last(MessageType.LOCAL_POSITION_NED).number("vx")).isCloseTo(1, within(0.05));
        copter.pass(2);
        double north = copter.north();
        copter.pass(10);
        assertThat(copter.north()).isCloseTo(north, within(0.1));
        assertThat(height()).isCloseTo(3, within(0.2));
    }

    @Test
    void itFliesSidewaysUpAndTurns() {
        flying(3);
        for (int i = 0; i < 10; i++) {
            copter.send(MavlinkStand.target(MavlinkStand.FRAME_BODY, VELOCITY_AND_YAW_RATE)
                    .with("vy", 1)
                    .with("vz", -0.5)
                    .with("yaw_rate", 0.0));
            copter.pass(0.2);
        }
        assertThat(copter.east()).isBetween(1.3, 2.0);
        assertThat(height()).isBetween(3.6, 4.1);
        copter.stream(MavlinkStand.FRAME_BODY, VELOCITY_AND_YAW_RATE, 0, 0.5, 2);
        assertThat(copter.yaw()).isCloseTo(53, within(5.0));
    }

    @Test
    void itFliesToAPlaceWithItsNoseAhead() {
        flying(3);
        copter.send(MavlinkStand.target(MavlinkStand.FRAME_MAP, POSITION)
                .with("x", 0)
                .with("y", 10)
                .with("z", -5));
        copter.pass(15);
        assertThat(Math.hypot(copter.north(), copter.east() - 10)).isLessThan(0.1);
        assertThat(height()).isCloseTo(5, within(0.1));
        assertThat(copter.yaw()).isCloseTo(90, within(5.0));
    }

    @Test
    void aTargetThatIsNotPossibleEndsThePresentOne() {
        flying(3);
        copter.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 2);
        copter.velocity(20, VELOCITY, 2, 0);
        copter.pass(2);
        assertThat(copter.ask(MessageType.LOCAL_POSITION_NED).number("vx")).isCloseTo(0, within(0.1));
    }

    @Test
    void targetsOnTheGroundAreIgnored() {
        copter.pass(0.1);
        copter.mode(GUIDED);
        copter.arm();
        copter.stream(MavlinkStand.FRAME_BODY, VELOCITY, 1, 0, 2);
        assertThat(copter.north()).isZero();
        assertThat(height()).isZero();
    }

    @Test
    void brakeStopsItAndLaterTargetsDoNothing() {
        flying(3);
        copter.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 3);
        assertThat(copter.mode(BRAKE)).isZero();
        copter.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 2);
        double north = copter.north();
        copter.stream(MavlinkStand.FRAME_BODY, VELOCITY, 2, 0, 5);
        assertThat(copter.north()).isCloseTo(north, within(0.1));
        assertThat(height()).isCloseTo(3, within(0.2));
    }

    @Test
    void inLoiterItSinksWithALowThrottleAndStaysWithAMiddleOne() {
        flying(5);
        copter.handling().pilotStick(3, 1500);
        assertThat(copter.handling().pilotMode(LOITER)).isTrue();
        copter.pass(3);
        assertThat(height()).isCloseTo(5, within(0.2));
        copter.handling().pilotStick(3, 1000);
        copter.pass(1.5);
        assertThat(height()).isLessThan(4);
    }

    @Test
    void landingEndsDisarmedOnTheGround() {
        flying(3);
        assertThat(copter.command(21)).isZero();
        copter.pass(2);
        assertThat(landedState()).isEqualTo(LANDING);
        copter.pass(7);
        assertThat(height()).isZero();
        assertThat(copter.handling().isArmed()).isFalse();
        assertThat(copter.handling().crashes()).isZero();
        assertThat(landedState()).isEqualTo(ON_GROUND);
        assertThat(copter.handling().mode()).isEqualTo(LAND);
        assertThat(copter.arm()).isEqualTo(4);
        assertThat(copter.texts()).endsWith("Arm: LAND mode not armable");
    }

    @Test
    void returningClimbsFliesHomeAndLands() {
        flying(3);
        copter.send(MavlinkStand.target(MavlinkStand.FRAME_MAP, POSITION)
                .with("x", 20)
                .with("z", -3));
        copter.pass(15);
        assertThat(copter.mode(RTL)).isZero();
        copter.pass(6);
        assertThat(height()).isGreaterThan(10);
        copter.pass(60);
        assertThat(height()).isZero();
        assertThat(Math.hypot(copter.north(), copter.east())).isLessThan(0.6);
        assertThat(copter.handling().isArmed()).isFalse();
    }

    @Test
    void itDisarmsByItselfWhenItDoesNotTakeOff() {
        copter.pass(0.1);
        copter.mode(GUIDED);
        copter.arm();
        copter.pass(9.5);
        assertThat(copter.handling().isArmed()).isTrue();
        copter.pass(1);
        assertThat(copter.handling().isArmed()).isFalse();
    }

    @Test
    void aPlainDisarmInTheAirIsRefused() {
        flying(3);
        assertThat(copter.command(400, 0)).isEqualTo(4);
        copter.pass(1);
        assertThat(height()).isCloseTo(3, within(0.15));
        assertThat(copter.handling().disarmsInFlight()).isZero();
    }

    @Test
    void aForcedDisarmInTheAirIsACrash() {
        flying(3);
        assertThat(copter.command(400, 0, 21_196)).isZero();
        copter.pass(2);
        assertThat(height()).isZero();
        assertThat(copter.handling().disarmsInFlight()).isEqualTo(1);
        assertThat(copter.handling().crashes()).isEqualTo(1);
    }

    @Test
    void theFailsafeComesAfterFiveSecondsAndItsActionIsAParameter() {
        flying(3);
        copter.set("FS_GCS_ENABLE", 5);
        copter.pass(1);
        copter.silent(true);
        copter.pass(3.9);
        assertThat(copter.handling().mode()).isEqualTo(GUIDED);
        copter.pass(1.2);
        assertThat(copter.handling().mode()).isEqualTo(LAND);
        assertThat(copter.texts()).endsWith("GCS Failsafe");
        copter.silent(false);
        copter.pass(2);
        assertThat(copter.texts()).contains("GCS Failsafe Cleared");
        assertThat(copter.handling().mode()).isEqualTo(LAND);
    }

    @Test
    void withoutTheFailsafeItHoversOn() {
        flying(3);
        copter.silent(true);
        copter.pass(60);
        assertThat(height()).isCloseTo(3, within(0.2));
        assertThat(copter.handling().mode()).isEqualTo(GUIDED);
    }

    @Test
    void itFliesOverWallsButNotThroughThem() {
        copter.place(0, 18);
        flying(0.5);
        goTo(0, 24, 0.5);
        assertThat(copter.east()).isBetween(19.0, 19.8);
        goTo(0, 18, 3);
        goTo(0, 20.1, 3);
        assertThat(copter.east()).isCloseTo(20.1, within(0.1));
        copter.command(21);
        copter.pass(10);
        assertThat(height()).isEqualTo(Flight.WALL_M);
        assertThat(copter.handling().crashes()).isZero();
    }

    private void goTo(double north, double east, double height) {
        copter.send(MavlinkStand.target(MavlinkStand.FRAME_MAP, POSITION)
                .with("x", north)
                .with("y", east - 18)
                .with("z", -height));
        copter.pass(12);
    }

    @Test
    void hoveringEmptiesTheBattery() {
        flying(3);
        copter.pass(60);
        Message battery = copter.ask(MessageType.BATTERY_STATUS);
        assertThat(battery.number("battery_remaining")).isBetween(85.0, 95.0);
        assertThat(battery.number("current_battery")).isEqualTo(1800);
        copter.handling().charge(5);
        copter.pass(1);
        assertThat(copter.texts()).anySatisfy(text -> assertThat(text).startsWith("Battery 1 is low"));
    }
}
