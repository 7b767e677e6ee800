package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Pose;
import majic.pioneer.arcos.SipBytes;
import org.junit.jupiter.api.Test;

class SonarScanTest {
    private static final int NOTHING = 5000;
    private static final long SECOND = 1_000_000_000;

    private final StateTracker tracker = new StateTracker(Models.of("p3dx-sh"), Pose.START);

    @Test
    void nothingInRangeIsInfinitelyFar() {
        assertThat(tracker.track(scan(0).sip(), SECOND).gaps())
                .hasSize(4)
                .allSatisfy((side, gap) -> assertThat(gap).isInfinite());
    }

    @Test
    void aSideIsUnknownUntilAllItsDiscsHaveFired() {
        PioneerState state = tracker.track(
                new SipBytes().sonar(3, 800).sonar(0, 900).sonar(15, 900).sip(), SECOND);

        assertThat(state.gaps()).containsOnlyKeys(Side.LEFT);
    }

    @Test
    void distancesCountFromTheHull() {
        PioneerState state =
                tracker.track(scan(0, 3, 500, 0, 400, 7, 300, 12, 600).sip(), SECOND);

        assertThat(state.gaps().get(Side.FRONT)).isCloseTo(166 + 492 - 210.5, within(2.0));
        assertThat(state.gaps().get(Side.LEFT)).isCloseTo(136 + 400 - 212.5, within(1.0));
        assertThat(state.gaps().get(Side.RIGHT)).isCloseTo(136 + 300 - 212.5, within(1.0));
        assertThat(state.gaps().get(Side.BACK)).isCloseTo(255 + 591 - 300.5, within(2.0));
    }

    @Test
    void anObstacleInThePathIsAheadWhicheverDiscDetectsIt() {
        assertThat(tracker.track(scan(0, 1, 370).sip(), SECOND).gaps().get(Side.FRONT))
                .isBetween(100.0, 200.0);
    }

    @Test
    void anObstacleBesideThePathIsNotAhead() {
        assertThat(tracker.track(scan(0, 1, 900).sip(), SECOND).gaps().get(Side.FRONT))
                .isInfinite();
    }

    @Test
    void aLostEchoIsRememberedAndCarriedAlongForAWhile() {
        tracker.track(scan(0, 3, 1000).sip(), SECOND);
        PioneerState driven = tracker.track(scan(300).sip(), 2 * SECOND);
        PioneerState later = tracker.track(scan(300).sip(), 3 * SECOND);

        assertThat(driven.gaps().get(Side.FRONT)).isCloseTo(166 + 985 - 210.5 - 300, within(3.0));
        assertThat(later.gaps().get(Side.FRONT)).isInfinite();
    }

    @Test
    void discsWithoutRecentReadingsDoNotCount() {
        tracker.track(scan(0).sip(), SECOND);

        assertThat(tracker.track(new SipBytes().sip(), 4 * SECOND).gaps()).isEmpty();
    }

    @Test
    void echoesAreDroppedWhenTheSonarsAreSwitchedOff() {
        tracker.track(scan(0).state(0, 0x1F).sip(), SECOND);
        PioneerState blind = tracker.track(new SipBytes().state(0, 0x01).sip(), SECOND + 1);

        assertThat(blind.gaps()).isEmpty();
        assertThat(blind.sonar().hasReading(3)).isFalse();
    }

    @Test
    void anArrayThatIsSwitchedOffLeavesTheOther() {
        tracker.track(scan(0).state(0, 0x1F).sip(), SECOND);
        PioneerState halfBlind = tracker.track(new SipBytes().state(0, 0x1B).sip(), SECOND + 1);

        assertThat(halfBlind.gaps()).containsOnlyKeys(Side.FRONT);
        assertThat(halfBlind.sonar().hasReading(8)).isFalse();
    }

    @Test
    void aSideIsNeverClearOnlyBecauseItsEchoesAreForgotten() {
        tracker.track(scan(0, 3, 300).sip(), SECOND);

        assertThat(tracker.track(new SipBytes().sip(), SECOND + 1_600_000_000L).gaps())
                .isEmpty();
    }

    @Test
    void readingsOfDiscsThatDoNotExistAreIgnored() {
        assertThat(tracker.track(scan(0, 200, 100, 31, 100).sip(), SECOND)
                        .gaps()
                        .get(Side.FRONT))
                .isInfinite();
    }

    /** Readings without echoes, except for the discs named with their ranges. */
    private static SipBytes scan(int x, int... discsAndRanges) {
        SipBytes sip = new SipBytes().pose(x, 0, 0);
        for (int disc = 0; disc < 16; disc++) {
            sip.sonar(disc, NOTHING);
        }
        for (int index = 0; index < discsAndRanges.length; index += 2) {
            sip.sonar(discsAndRanges[index], discsAndRanges[index + 1]);
        }
        return sip;
    }
}
