package majic.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LinkWatchTest {

    @ParameterizedTest(name = "silent {0} s, nothing sent for {1} s, moving {2}: {3}")
    @CsvSource({
        "0.1, 0.1, true, WAIT",
        "0.1, 0.3, true, PULSE",
        "0.1, 0.3, false, PULSE",
        "0.5, 0.3, true, HOLD",
        "0.9, 0.9, true, HOLD",
        "1.0, 0.5, true, GIVE_UP",
        "1.5, 0.3, false, PULSE",
        "3.0, 0.1, false, GIVE_UP"
    })
    void silenceIsJudgedByWhetherTheRobotMoves(
            double silenceS, double unsentS, boolean moving, LinkWatch.Verdict expected) {
        assertThat(LinkWatch.judge(silenceS, unsentS, moving)).isEqualTo(expected);
    }

    @ParameterizedTest(name = "silent {0} s, nothing sent for {1} s, moving {2}: again after {3} s")
    @CsvSource({
        "0.1, 0.0, false, 0.3",
        "0.1, 0.2, false, 0.1",
        "0.3, 0.0, false, 0.1",
        "3.0, 0.2, false, 0.1",
        "0.1, 0.0, true, 0.1",
        "0.1, 0.3, false, 0.004"
    })
    void aStationaryRobotThatReportsIsCheckedWhenItsNextPulseIsDue(
            double silenceS, double unsentS, boolean moving, double expectedS) {
        assertThat(LinkWatch.againS(silenceS, unsentS, moving)).isCloseTo(expectedS, within(1e-9));
    }
}
