package majic.hemisson.readings;

import static org.assertj.core.api.Assertions.assertThat;

import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;
import org.junit.jupiter.api.Test;

class PolledAnswersTest {
    private static final int MANY = 300;

    private final PolledAnswers senses = new PolledAnswers();

    @Test
    void whatIsAnsweredAgainAndAgainIsNeverEvictedByRawAnswers() {
        for (int register = 0; register < MANY; register++) {
            senses.take(Question.PROXIMITY, Reply.of("n,004,004,004,004,004,004,060,080"), register);
            senses.take(raw(register), Reply.of("r,255"), register);

            assertThat(senses.knows(Question.PROXIMITY)).isTrue();
        }
        assertThat(senses.knows(raw(MANY - 1))).isTrue();
        assertThat(senses.knows(raw(0))).isFalse();
    }

    private static Question raw(int register) {
        return Question.ask("R,C0," + register + ",01", "r,\\d{3}", 1);
    }
}
