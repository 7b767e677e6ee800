package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.LocalTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import majic.log.Line;
import majic.log.Line.Kind;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class MessageLogTest {
    private static final Line LATCH = new Line(Kind.NOTICE, "STOP is latched; \"release\" allows motion again");
    private static final Line RELEASE = new Line(Kind.NOTICE, "released: motion is allowed again");
    private static final Line REFUSAL = new Line(Kind.ALARM, "3 stop: failed: takes no more data");

    private final MessageLog log = new MessageLog();
    private final List<String> replaced = new ArrayList<>();
    private final Locale before = Locale.getDefault();

    @BeforeEach
    void inEnglish() {
        Locale.setDefault(Locale.ENGLISH);
    }

    @AfterEach
    void asBefore() {
        Locale.setDefault(before);
    }

    private void add(Line... lines) {
        log.add(
                Stream.of(lines).map(line -> new Message(LocalTime.NOON, line)).toList(),
                (old, present) -> replaced.add(
                        old.line().text() + " -> " + present.text(false).strip()));
    }

    private static Line done(int robot) {
        return new Line(Kind.ANSWER, robot + " stop: done");
    }

    private List<String> texts() {
        return log.all().stream()
                .map(message -> message.text(false).substring(2))
                .toList();
    }

    @Test
    void pressesOfStopAreOneLineWithACountAndConfirmationsAnotherOne() {
        for (int press = 0; press < 25; press++) {
            add(LATCH, done(1), done(2), done(4));
        }
        assertThat(texts()).containsExactly(LATCH.text() + " (25 times)", "1,2,4 stop: done");
    }

    @Test
    void aRobotThatDoesNotConfirmIsNamedOnceUntilItsAnswerChanges() {
        Line overdue = new Line(Kind.ALARM, "3: Toy has not confirmed its stop within 0.8 s; it may still move");
        add(LATCH, done(1), overdue, REFUSAL);
        add(LATCH, REFUSAL, done(1), overdue);
        add(LATCH, done(3), done(1));
        add(LATCH, done(1), done(3));
        assertThat(texts())
                .containsExactly(
                        LATCH.text() + " (4 times)", "1 stop: done", overdue.text(), REFUSAL.text(), "3 stop: done");
        add(LATCH, REFUSAL);
        assertThat(texts()).endsWith("3 stop: done", REFUSAL.text());
    }

    @Test
    void otherMessagesBetweenThePressesDoNotChangeThat() {
        add(LATCH, new Line(Kind.ANSWER, "1 move 5: stopped"), done(1));
        add(new Line(Kind.NOTICE, "1: the battery is low"), LATCH, done(1));
        assertThat(texts())
                .containsExactly(
                        LATCH.text() + " (2 times)", "1 move 5: stopped", "1 stop: done", "1: the battery is low");
    }

    @Test
    void aStopAfterAReleaseOrACommandHasLinesOfItsOwn() {
        add(LATCH, done(1), RELEASE, LATCH, done(1));
        add(new Line(Kind.COMMAND, "stop"), LATCH, done(1));
        assertThat(texts())
                .containsExactly(
                        LATCH.text(),
                        "1 stop: done",
                        RELEASE.text(),
                        LATCH.text(),
                        "1 stop: done",
                        "stop",
                        LATCH.text(),
                        "1 stop: done");
    }

    @Test
    void stopsOfOneRobotAreCountedWithoutALatch() {
        add(done(1), done(2));
        add(done(1));
        assertThat(texts()).containsExactly("1 stop: done (2 times)", "2 stop: done");
    }

    @Test
    void theChangesOfShownMessagesAreReported() {
        add(LATCH, done(1));
        add(LATCH, done(1), done(2));
        assertThat(replaced)
                .containsExactly(
                        LATCH.text() + " -> * " + LATCH.text() + " (2 times)", "1 stop: done -> 1,2 stop: done");
    }

    @Test
    void aMessageThatWasRemovedIsShownAgain() {
        add(LATCH, done(1));
        for (int line = 0; line < MessageLog.MOST_KEPT; line++) {
            add(new Line(Kind.NOTICE, "line " + line));
        }
        add(LATCH, done(1));
        assertThat(texts()).endsWith(LATCH.text(), "1 stop: done");
        add(LATCH, done(1));
        assertThat(texts()).endsWith(LATCH.text() + " (2 times)", "1 stop: done");
    }
}
