package majic.hemisson.readings;

import static org.assertj.core.api.Assertions.assertThat;

import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;

class PolledAnswersTest {
    private static final int MANY = 300;

    private final PolledAnswers polled = new PolledAnswers(TimeSource.system());

    @Test
    void aPolledAnswerIsNeverEvictedByRawAnswers() {
        for (int register = 0; register < MANY; register++) {
            polled.answered(Question.PROXIMITY, Reply.of("n,004,004,004,004,004,004,060,080"), 0);
            polled.answered(raw(register), Reply.of("r,255"), 0);

            assertThat(polled.hasAnswered(Question.PROXIMITY)).isTrue();
        }
        assertThat(polled.hasAnswered(raw(MANY - 1))).isTrue();
        assertThat(polled.hasAnswered(raw(0))).isFalse();
    }

    private static Question raw(int register) {
        return Question.ask("R,C0," + register + ",01", "r,\\d{3}", 1);
    }
}
