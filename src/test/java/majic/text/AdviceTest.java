package majic.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class AdviceTest {
    @Test
    void followsAStatementInTheSameSentence() {
        assertThat(Advice.joined("the other end reset it", "\"add 10.0.0.5\" connects it again"))
                .isEqualTo("the other end reset it; \"add 10.0.0.5\" connects it again");
    }

    @Test
    void hasNoSemicolonBehindAQuestion() {
        assertThat(Advice.joined("there is no act WandrDog; did you mean WanderDog?", "\"acts\" lists all"))
                .isEqualTo("there is no act WandrDog; did you mean WanderDog? \"acts\" lists all");
    }

    @Test
    void asksOneQuestionOnly() {
        assertThat(Advice.joined("there is no computer named dog; is the name right?", "is the dog on?"))
                .isEqualTo("there is no computer named dog; is the name right?");
    }
}
