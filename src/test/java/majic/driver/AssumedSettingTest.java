package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Value;
import org.junit.jupiter.api.Test;

class AssumedSettingTest {
    private static final Value ON = Value.onOff(true);
    private static final Value OFF = Value.onOff(false);

    private final Object session = new Object();
    private final AssumedSetting setting = new AssumedSetting();

    @Test
    void isUnknownBeforeAValueWasSent() {
        assertThat(setting.in(session)).isInstanceOf(Value.Unknown.class);
    }

    @Test
    void keepsTheLastValueSent() {
        setting.sent(session, ON);
        setting.sent(session, OFF);

        assertThat(setting.in(session)).isEqualTo(OFF);
    }

    @Test
    void isUnknownInTheNextSession() {
        setting.sent(session, ON);

        assertThat(setting.in(new Object())).isInstanceOf(Value.Unknown.class);
    }

    @Test
    void hasItsInitialValueAgainInTheNextSession() {
        setting.sent(session, ON);

        assertThat(setting.in(session, () -> OFF)).isEqualTo(ON);
        assertThat(setting.in(new Object(), () -> OFF)).isEqualTo(OFF);
    }
}
