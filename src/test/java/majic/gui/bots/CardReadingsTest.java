package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Value;
import org.junit.jupiter.api.Test;

class CardReadingsTest {
    @Test
    void theStopButtonOnTheRobotIsRead() {
        MajicBot bot = mock();
        when(bot.parameters()).thenReturn(List.of(Parameter.yesNo("stopButton", "whether it is pressed")));
        when(bot.get("stopButton")).thenReturn(Value.yesNo(true));

        assertThat(CardReadings.of(bot).stopPressed()).isTrue();
    }

    @Test
    void aRobotWithoutAStopButtonIsNotStoppedByIt() {
        MajicBot bot = mock();
        when(bot.parameters()).thenReturn(List.of());

        assertThat(CardReadings.of(bot)).isEqualTo(CardReadings.NONE);
    }

    @Test
    void aPressedButtonIsAProblemAsLongAsThereIsNoGraverOne() {
        assertThat(RobotSummary.problem(false, false, "", true)).contains("STOP pressed");
        assertThat(RobotSummary.problem(true, false, "", true)).contains("stop not confirmed");
        assertThat(RobotSummary.problem(false, true, "", true)).contains("connection lost");
        assertThat(RobotSummary.problem(false, false, "", false)).isEmpty();
    }
}
