package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Value;
import org.junit.jupiter.api.Test;

class SummaryReadingsTest {
    @Test
    void theStopButtonOnTheRobotIsRead() {
        MajicBot bot = mock();
        when(bot.parameters()).thenReturn(List.of(Parameter.yesNo("stopButton", "whether it is pressed")));
        when(bot.get("stopButton")).thenReturn(Value.yesNo(true));

        assertThat(SummaryReadings.of(bot).stopPressed()).isTrue();
    }

    @Test
    void aRobotWithoutAStopButtonIsNotStoppedByIt() {
        MajicBot bot = mock();
        when(bot.parameters()).thenReturn(List.of());

        assertThat(SummaryReadings.of(bot)).isEqualTo(SummaryReadings.NONE);
    }

    @Test
    void aPressedButtonIsAProblemAsLongAsThereIsNoGraverOne() {
        assertThat(RobotSummary.problem(false, false, "", true)).contains(List.of("STOP pressed", "pressed", "!"));
        assertThat(RobotSummary.problem(true, false, "", true))
                .contains(List.of("stop not confirmed", "unconfirmed", ""));
        assertThat(RobotSummary.problem(false, true, "", true)).contains(List.of("connection lost", "lost", ""));
        assertThat(RobotSummary.problem(false, false, "", false)).isEmpty();
    }
}
