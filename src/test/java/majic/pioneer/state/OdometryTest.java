package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Pose;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipBytes;
import org.junit.jupiter.api.Test;

class OdometryTest {
    private final Odometry odometry = new Odometry(Scaling.CURRENT, Pose.START);

    @Test
    void theFirstSipIsTheReference() {
        odometry.add(sip(1234, -77, 512));

        assertThat(odometry.pose()).isEqualTo(Pose.START);
    }

    @Test
    void differencesAreTurnedIntoTheFrameOfTheFirstSip() {
        odometry.add(sip(0, 0, 1024));
        odometry.add(sip(0, 100, 1024));

        assertThat(odometry.pose().xMm()).isCloseTo(100, within(0.01));
        assertThat(odometry.pose().yMm()).isCloseTo(0, within(0.01));
    }

    @Test
    void countersRollOverAtSixteenBits() {
        odometry.add(sip(32_750, 0, 0));
        odometry.add(sip(-32_617, 0, 0));
        odometry.add(sip(-32_717, 0, 0));

        assertThat(odometry.pose().xMm()).isCloseTo(69, within(0.01));
    }

    @Test
    void countersRollOverAtFifteenBitsAndMayHaveTheTopBitStuck() {
        odometry.add(sip(0x7FF0, 0, 0));
        odometry.add(sip(0x0010, 0, 0));
        odometry.add(sip(0x8020, 0, 0));

        assertThat(odometry.pose().xMm()).isCloseTo(48, within(0.01));
    }

    @Test
    void backwardAcrossZeroIsASmallStep() {
        odometry.add(sip(5, 0, 0));
        odometry.add(sip(-348, 0, 0));

        assertThat(odometry.pose().xMm()).isCloseTo(-353, within(0.01));
    }

    @Test
    void turnsAddUpBeyondAFullOne() {
        odometry.add(sip(0, 0, 0));
        for (int eighth = 1; eighth <= 12; eighth++) {
            int units = eighth * 512 % 4096;
            odometry.add(sip(0, 0, units < 2048 ? units : units - 4096));
        }

        assertThat(odometry.turnedDeg()).isCloseTo(540, within(0.01));
        assertThat(odometry.pose().headingDeg()).isCloseTo(180, within(0.01));
    }

    @Test
    void aResetOfTheRobotsOdometryIsNoJump() {
        odometry.add(sip(0, 0, 0));
        odometry.add(sip(9000, 9000, 1024));
        odometry.add(sip(9000, 9100, 1024));

        assertThat(odometry.pose().xMm()).isCloseTo(100, within(0.01));
        assertThat(odometry.turnedDeg()).isZero();
    }

    private static Sip sip(int x, int y, int heading) {
        return new SipBytes().pose(x, y, heading).sip();
    }
}
