package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import majic.gui.kit.StateIcon;
import org.junit.jupiter.api.Test;

class RobotSummaryTest {
    private static RobotSummary summary(String problem, String activity) {
        BatteryLevel battery = new BatteryLevel("battery", OptionalInt.of(80), "80%");
        return new RobotSummary(
                StateIcon.MOVING, "Pioneer", "moving", problem, activity, battery, LinkMeter.MOST_BARS, false, false);
    }

    @Test
    void theShorterTheCardTheMoreImportantIsWhatItShows() {
        assertThat(summary("", "").line()).isEqualTo("moving");
        assertThat(summary("", "").shortest()).isEqualTo("Pioneer");
        assertThat(summary("", "00:07  Wander").line()).isEqualTo("00:07  Wander");
        assertThat(summary("connection lost", "00:07  Wander").shortest()).isEqualTo("connection lost");
    }

    @Test
    void theDescriptionHasEverythingOnce() {
        assertThat(summary("", "00:07  Wander").description()).isEqualTo("Pioneer, moving, 00:07  Wander, battery 80%");
    }
}
