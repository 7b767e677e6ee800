package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import majic.environment.Settings;
import majic.log.Line;
import org.junit.jupiter.api.Test;

class AlarmSoundTest {
    private final Settings settings = Settings.inMemory();
    private final AtomicInteger played = new AtomicInteger();
    private final AlarmSound sound = new AlarmSound(settings, played::incrementAndGet);

    @Test
    void anAlarmIsHeardButNoOtherLine() {
        sound.line(new Line(Line.Kind.ERROR, "1 move 5: failed"));
        assertThat(played).hasValue(0);
        sound.line(new Line(Line.Kind.ALARM, "1: connection lost"));
        assertThat(played).hasValue(1);
    }

    @Test
    void alarmsThatFollowEachOtherAreHeardOnce() {
        for (int robot = 1; robot <= 20; robot++) {
            sound.line(new Line(Line.Kind.ALARM, robot + ": connection lost"));
        }
        assertThat(played).hasValue(1);
    }

    @Test
    void theSoundStaysOffOnceItWasSwitchedOff() {
        settings.put("window.alarmSound", "off");
        AlarmSound next = new AlarmSound(settings, played::incrementAndGet);
        next.line(new Line(Line.Kind.ALARM, "1: connection lost"));
        assertThat(next.isOn()).isFalse();
        assertThat(played).hasValue(0);
    }
}
