package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import majic.gui.kit.StateIcon;
import org.junit.jupiter.api.Test;

class RobotSummaryTest {
    private static RobotSummary summary(String problem, String activity, String actTime) {
        BatteryLevel battery = new BatteryLevel("battery", OptionalInt.of(80), "80 %");
        return new RobotSummary(
                StateIcon.MOVING,
                "Pioneer",
                "moving",
                problem,
                activity,
                actTime,
                battery,
                LinkMeter.MOST_BARS,
                false,
                false);
    }

    @Test
    void theShorterTheCardTheMoreImportantIsWhatItShows() {
        assertThat(summary("", "", "").line()).isEqualTo("moving");
        assertThat(summary("", "", "").shortest()).isEqualTo("Pioneer");
        assertThat(summary("", "Wander", "00:07").line()).isEqualTo("Wander  00:07");
        assertThat(summary("connection lost", "Wander", "00:07").shortest()).isEqualTo("connection lost");
    }

    @Test
    void theDescriptionHasEverythingOnce() {
        assertThat(summary("", "Wander", "00:07").description())
                .isEqualTo("Pioneer, moving, Wander  00:07, battery 80 %");
    }
}
