package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Pose;
import majic.pioneer.arcos.SipBytes;
import org.junit.jupiter.api.Test;

class StateTrackerTest {
    private final StateTracker tracker = new StateTracker(Models.of("p3dx-sh"), Pose.START);

    @Test
    void theFirstSipIsTheReference() {
        PioneerState now = track(1234, -77, 512);

        assertThat(now.pose()).isEqualTo(Pose.START);
    }

    @Test
    void differencesAreTurnedIntoTheFrameOfTheFirstSip() {
        track(0, 0, 1024);
        PioneerState now = track(0, 100, 1024);

        assertThat(now.pose().xMm()).isCloseTo(100, within(0.01));
        assertThat(now.pose().yMm()).isCloseTo(0, within(0.01));
    }

    @Test
    void countersRollOverAtSixteenBits() {
        track(32_750, 0, 0);
        track(-32_617, 0, 0);
        PioneerState now = track(-32_717, 0, 0);

        assertThat(now.pose().xMm()).isCloseTo(69, within(0.01));
    }

    @Test
    void countersRollOverAtFifteenBitsAndMayHaveTheTopBitStuck() {
        track(0x7FF0, 0, 0);
        track(0x0010, 0, 0);
        PioneerState now = track(0x8020, 0, 0);

        assertThat(now.pose().xMm()).isCloseTo(48, within(0.01));
    }

    @Test
    void backwardAcrossZeroIsASmallStep() {
        track(5, 0, 0);
        PioneerState now = track(-348, 0, 0);

        assertThat(now.pose().xMm()).isCloseTo(-353, within(0.01));
    }

    @Test
    void turnsAddUpBeyondAFullOne() {
        PioneerState now = track(0, 0, 0);
        for (int eighth = 1; eighth <= 12; eighth++) {
            int units = eighth * 512 % 4096;
            now = track(0, 0, units < 2048 ? units : units - 4096);
        }

        assertThat(now.turnedDeg()).isCloseTo(540, within(0.01));
        assertThat(now.pose().headingDeg()).isCloseTo(180, within(0.01));
    }

    @Test
    void aResetOfTheRobotsOdometryIsNoJump() {
        track(0, 0, 0);
        track(9000, 9000, 1024);
        PioneerState now = track(9000, 9100, 1024);

        assertThat(now.pose().xMm()).isCloseTo(100, within(0.01));
        assertThat(now.turnedDeg()).isZero();
    }

    private PioneerState track(int x, int y, int heading) {
        return tracker.track(new SipBytes().pose(x, y, heading).sip(), 1);
    }
}
