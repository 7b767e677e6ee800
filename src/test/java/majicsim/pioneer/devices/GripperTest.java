package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;

import majicsim.pioneer.Rig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** GRIPPER, GRIPPERVAL and what SIP and packet 0xE0 report of it (ARCOS sheet 11.5). */
class GripperTest {
    private static final int GRIPPER = 33;
    private static final int GRIPPERVAL = 36;
    private static final int GRIPREQUEST = 37;
    private static final int OPEN = 0b000_0001;
    private static final int CLOSED = 0b000_0010;
    private static final int PADDLES_MOVE = 0b000_0100;
    private static final int UP = 0b001_0000;
    private static final int DOWN = 0b010_0000;
    private static final int LIFT_MOVES = 0b100_0000;

    private final Rig rig = Rig.open(Rig.EQUIPPED);

    @Test
    void itBeginsStoredAwayWithPaddlesClosedAndLiftUp() {
        assertThat(rig.nextSip().gripper()).isEqualTo(CLOSED | UP);
    }

    @Test
    void openingThePaddlesTakesTwoSeconds() {
        rig.command(GRIPPER, 1);
        assertThat(rig.nextSip().gripper()).isEqualTo(PADDLES_MOVE | UP);
        assertThat(rig.pulse(1.7).nextSip().gripper()).isEqualTo(PADDLES_MOVE | UP);
        assertThat(rig.pulse(0.2).nextSip().gripper()).isEqualTo(OPEN | UP);
    }

    @Test
    void loweringTheLiftTakesFourSeconds() {
        rig.command(GRIPPER, 5);
        assertThat(rig.pulse(3.7).nextSip().gripper()).isEqualTo(CLOSED | LIFT_MOVES);
        assertThat(rig.pulse(0.2).nextSip().gripper()).isEqualTo(CLOSED | DOWN);
    }

    @ParameterizedTest
    @CsvSource({"3, 1", "6, 5", "15, 8"})
    void stoppingLeavesItHalfWay(int stop, int begun) {
        rig.command(GRIPPER, begun).pulse(1).command(GRIPPER, stop);
        int standing = rig.nextSip().gripper();
        assertThat(standing & (PADDLES_MOVE | LIFT_MOVES)).isZero();
        assertThat(standing).isNotEqualTo(CLOSED | UP);
        assertThat(rig.pulse(5).nextSip().gripper()).isEqualTo(standing);
    }

    @Test
    void deployingOpensAndLowersAndStoringUndoesIt() {
        assertThat(rig.command(GRIPPER, 8).pulse(4.1).nextSip().gripper()).isEqualTo(OPEN | DOWN);
        assertThat(rig.command(GRIPPER, 7).pulse(4.1).nextSip().gripper()).isEqualTo(CLOSED | UP);
    }

    @Test
    void theLiftIsCarriedForTheTimeGiven() {
        rig.command(GRIPPER, 17).command(GRIPPERVAL, -50);
        assertThat(rig.pulse(0.8).nextSip().gripper()).isEqualTo(CLOSED | LIFT_MOVES);
        assertThat(rig.pulse(0.1).nextSip().gripper()).isEqualTo(CLOSED);
        rig.command(GRIPPER, 17).command(GRIPPERVAL, 100);
        assertThat(rig.pulse(1.1).nextSip().gripper()).isEqualTo(CLOSED | UP);
    }

    @Test
    void anObjectBetweenThePaddlesIsGraspedAndSeenInTheLightBeams() {
        rig.command(GRIPPER, 1).pulse(2.2);
        rig.robot.handling().putBetweenPaddles(true);
        rig.command(GRIPPER, 2).pulse(1.4);
        assertThat(rig.nextSip().gripper()).isEqualTo(CLOSED | UP);
        assertThat(packet()[5]).isEqualTo((byte) 0b11_1111);
    }

    @Test
    void thePacketReportsTypeSwitchesAndGraspTime() {
        rig.command(GRIPPER, 16).command(GRIPPERVAL, 10);
        assertThat(packet()).startsWith(0xFA, 0xFB, 6, 0xE0, 2, 0b11, 10);
    }

    @Test
    void aRobotWithoutGripperReportsNone() {
        Rig bare = Rig.open().command(GRIPPER, 1).command(GRIPREQUEST, 1);
        assertThat(bare.packets(0xE0, 0.1))
                .singleElement()
                .satisfies(bytes -> assertThat(bytes[4]).isZero());
        assertThat(bare.nextSip().gripper()).isZero();
        assertThat(bare.config().number("GRIPPER")).isZero();
    }

    @Test
    void itIsRequestedOnceOrEveryCycle() {
        assertThat(rig.command(GRIPREQUEST, 1).packets(0xE0, 0.5)).hasSize(1);
        assertThat(rig.command(GRIPREQUEST, 2).packets(0xE0, 0.5)).hasSize(5);
        assertThat(rig.command(GRIPREQUEST, 0).packets(0xE0, 0.5)).isEmpty();
    }

    private byte[] packet() {
        return rig.command(GRIPREQUEST, 1).packets(0xE0, 0.1).get(0);
    }
}
