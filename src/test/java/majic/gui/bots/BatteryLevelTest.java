package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import java.util.List;
import java.util.OptionalInt;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;

class BatteryLevelTest {
    private static MajicBot reporting(String parameter, double amount, Unit unit) {
        MajicBot bot = mock();
        when(bot.parameters()).thenReturn(List.of(Parameter.number(parameter, unit, "the battery")));
        when(bot.get(parameter)).thenReturn(Value.of(amount, unit));
        return bot;
    }

    @Test
    void theChargeIsShownInPercent() {
        assertThat(SummaryReadings.of(reporting("battery", 80.4, Unit.PERCENT)).battery())
                .isEqualTo(new BatteryLevel("battery", OptionalInt.of(80), "80 %"));
    }

    @Test
    void theVoltageIsShownAndPlottedIfTheChargeIsNotReported() {
        assertThat(SummaryReadings.of(reporting("voltage", 12.34, Unit.V)).battery())
                .isEqualTo(new BatteryLevel("voltage", OptionalInt.empty(), "12.3 V"));
    }
}
