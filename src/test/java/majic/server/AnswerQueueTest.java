package majic.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class AnswerQueueTest {
    private final AnswerQueue answers = new AnswerQueue(3, 100);
    private final NarrowWire wire = new NarrowWire();

    /** Takes a limited number of bytes. */
    private static final class NarrowWire implements Wire {
        private final StringBuilder sent = new StringBuilder();
        private int room;

        @Override
        public int read(ByteBuffer target) {
            return 0;
        }

        @Override
        public void write(ByteBuffer source) {
            byte[] bytes = new byte[Math.min(room, source.remaining())];
            source.get(bytes);
            room -= bytes.length;
            sent.append(new String(bytes, StandardCharsets.US_ASCII));
        }

        @Override
        public void endOutput() {}

        @Override
        public boolean isOpen() {
            return true;
        }

        @Override
        public void close() {}
    }

    @Test
    void answersAreSentInTheirOrderInWhateverPortionsTheConnectionTakes() throws IOException {
        answers.add("one");
        answers.add("two");
        while (!answers.isEmpty()) {
            wire.room = 3;
            answers.send(wire);
        }
        assertThat(wire.sent).hasToString("one\ntwo\n");
    }

    @Test
    void moreLinesThanTheLimitAreLeftOutAndReported() throws IOException {
        for (int line = 1; line <= 4; line++) {
            answers.add("line " + line);
        }
        assertThat(answers.hasOverflowed()).isTrue();
        wire.room = 100;
        answers.send(wire);
        assertThat(wire.sent).hasToString("line 1\nline 2\nline 3\n");
    }

    @Test
    void longLinesReachTheLimitEarlier() {
        answers.add("x".repeat(60));
        assertThat(answers.hasOverflowed()).isFalse();
        answers.add("x".repeat(60));
        assertThat(answers.hasOverflowed()).isTrue();
    }

    @Test
    void theReasonReplacesWhatWaitsButNotTheRestOfABegunLine() throws IOException {
        answers.add("begun");
        wire.room = 2;
        answers.send(wire);
        answers.add("waits");
        answers.replaceBy("the reason");
        wire.room = 100;
        answers.send(wire);
        assertThat(wire.sent).hasToString("begun\nthe reason\n");
    }

    @Test
    void controlCharactersAreWrittenOut() throws IOException {
        answers.add("a\u001b[2J\nb");
        wire.room = 100;
        answers.send(wire);
        assertThat(wire.sent).hasToString("a\\u001b[2J\\nb\n");
    }
}
