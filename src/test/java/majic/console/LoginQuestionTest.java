package majic.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Tests when the terminal asks for the password of a broker, and what the answers are used for. */
class LoginQuestionTest implements LoginQuestion.Prompts {
    private static final String ROBOT = "mqtts://broker/lab/desk2/1";
    private static final String LINE = "add " + ROBOT;

    private final Deque<String> answers = new ArrayDeque<>();
    private final List<String> asked = new ArrayList<>();
    private final List<String> used = new ArrayList<>();
    private final LoginQuestion question = new LoginQuestion(this);

    @Override
    public @Nullable String text(String prompt) {
        asked.add(prompt);
        return answers.poll();
    }

    @Override
    public char @Nullable [] secret(String prompt) {
        String answer = text(prompt);
        return answer == null ? null : answer.toCharArray();
    }

    @Override
    public boolean isStop(String answer) {
        return answer.toLowerCase(Locale.ROOT).endsWith("stop");
    }

    @Override
    public void use(String address, String user, char[] password) {
        used.add(address + " " + user + " " + new String(password));
    }

    @Test
    void nothingIsAskedWithoutARefusal() {
        assertThat(question.ask()).isEmpty();
        assertThat(asked).isEmpty();
    }

    @Test
    void theLinesAreRepeatedWithWhatIsTyped() {
        assertThat(question.note(ROBOT, LINE)).get().asString().contains("press Enter on an empty line");
        assertThat(question.note(ROBOT, LINE + " as 4")).isEmpty();
        answers.addAll(List.of(" anna ", "secret"));

        assertThat(question.ask()).isEqualTo(LINE + "\n" + LINE + " as 4");
        assertThat(used).containsExactly(ROBOT + " anna secret");
        assertThat(asked).containsExactly("User at the broker of " + ROBOT + ": ", "Password: ");
        assertThat(question.ask()).isEmpty();
    }

    @Test
    void anEmptyUserEndsTheQuestion() {
        question.note(ROBOT, LINE);
        answers.add("");

        assertThat(question.ask()).isEmpty();
        assertThat(asked).hasSize(1);
        assertThat(used).isEmpty();
    }

    @Test
    void aStopThatIsTypedAsAnAnswerIsAStop() {
        question.note(ROBOT, LINE);
        answers.add("all stop");
        assertThat(question.ask()).isEqualTo("all stop");

        question.note(ROBOT, LINE);
        answers.addAll(List.of("anna", "STOP"));
        assertThat(question.ask()).isEqualTo("STOP");
        assertThat(used).isEmpty();
    }

    @Test
    void theEndOfTheInputEndsTheQuestion() {
        question.note(ROBOT, LINE);

        assertThat(question.ask()).isEmpty();
        assertThat(used).isEmpty();
    }
}
