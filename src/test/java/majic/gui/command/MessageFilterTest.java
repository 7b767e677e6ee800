package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.LocalTime;
import java.util.Set;
import majic.log.Line;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MessageFilterTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "2 move 500: done | true",
                "2: motors are on | true",
                "1,2 move 500 | true",
                "1-4 get x | true",
                "2.move(500) | true",
                "Bot 2 is dead | true",
                "1 move 500: done | false",
                "12: motors are on | false",
                "3,4 stop | false",
                "Bot 1 is dead | false",
                "STOP is latched | true",
                "all stop | true",
                "2000000000 lines | true"
            })
    void messagesOfOtherRobotsAreHidden(String text, boolean shown) {
        MessageFilter filter = MessageFilter.EVERYTHING.forRobot(2);
        assertThat(filter.accepts(message(Line.Kind.ANSWER, text))).isEqualTo(shown);
    }

    @Test
    void aKindCanBeHidden() {
        MessageFilter filter = MessageFilter.EVERYTHING.with(MessageFilter.Group.ANSWERS, false);
        assertThat(filter.accepts(message(Line.Kind.ANSWER, "1 move 5: done"))).isFalse();
        assertThat(filter.accepts(message(Line.Kind.COMMAND, "1 move 5"))).isTrue();
    }

    @Test
    void anAlarmIsAlwaysShown() {
        MessageFilter nothing = new MessageFilter(1, Set.of());
        assertThat(nothing.accepts(message(Line.Kind.ALARM, "2: connection lost")))
                .isTrue();
        assertThat(nothing.accepts(message(Line.Kind.ERROR, "1: wrong"))).isFalse();
    }

    private static Message message(Line.Kind kind, String text) {
        return new Message(LocalTime.NOON, new Line(kind, text));
    }
}
