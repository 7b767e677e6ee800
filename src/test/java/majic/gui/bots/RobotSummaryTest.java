package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalInt;
import majic.gui.kit.StateIcon;
import org.junit.jupiter.api.Test;

class RobotSummaryTest {
    private static RobotSummary summary(List<String> problem, String activity, String actTime) {
        return summary(problem, activity, actTime, 80);
    }

    private static RobotSummary summary(List<String> problem, String activity, String actTime, int percent) {
        BatteryLevel battery = new BatteryLevel("battery", OptionalInt.of(percent), percent + " %");
        return new RobotSummary(
                StateIcon.MOVING,
                "MobileRobots Pioneer",
                List.of("Pioneer"),
                "moving",
                problem,
                activity,
                actTime,
                battery,
                OptionalInt.of(LinkMeter.MOST_BARS),
                false,
                false);
    }

    @Test
    void theShorterTheTabTheMoreImportantIsWhatItShows() {
        assertThat(summary(List.of(), "", "").line()).containsExactly("moving");
        assertThat(summary(List.of(), "", "").onlyLine()).containsExactly("Pioneer");
        assertThat(summary(List.of(), "Wander", "00:07").line()).containsExactly("Wander  00:07");
        List<String> lost = List.of("connection lost", "lost", "");
        assertThat(summary(lost, "Wander", "00:07").conditionLine()).containsExactly("connection lost", "lost", "");
        assertThat(summary(lost, "Wander", "00:07").onlyLine()).containsExactly("connection lost", "lost", "");
    }

    @Test
    void theTabWithOneLineAloneNamesALowCharge() {
        assertThat(summary(List.of(), "Wander", "00:07", 9).onlyLine()).containsExactly("battery 9 %", "9 %");
        assertThat(summary(List.of(), "Wander", "00:07", 9).line()).containsExactly("Wander  00:07");
    }

    @Test
    void theDescriptionHasEverythingOnce() {
        assertThat(summary(List.of(), "Wander", "00:07").description())
                .isEqualTo("Pioneer, moving, Wander  00:07, battery 80 %");
    }
}
