package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import majic.hemisson.modules.Modules;
import majic.hemisson.readings.Clearance;
import majic.hemisson.readings.Proximity;

/**
 * Whatever bytes come from a robot: found and kept ones in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ReceivingFuzzTest {
    private static final String GOOD = "n,004,004,004,004,004,004,060,060";
    private static final List<Question> QUESTIONS = List.of(
            Question.VERSION,
            Question.SWITCHES,
            Question.SPEEDS,
            Question.PROXIMITY,
            Question.LIGHT,
            Question.REMOTE,
            Question.MODULES,
            Question.wheels(new MotorValues(3, 3)),
            Question.ask("R,C0,10,03", "r(,\\d{3}){3}", 1.2));

    @FuzzTest
    void theSameLinesComeHoweverTheBytesAreCut(byte[] wire) {
        List<String> whole = decode(wire, wire.length + 1);
        int chunkSize = wire.length == 0 ? 1 : 1 + (wire[wire.length - 1] & 0x3F);

        assertThat(decode(wire, chunkSize)).isEqualTo(whole);
        assertThat(decode(wire, 1)).isEqualTo(whole);
        assertThat(whole).allMatch(line -> line.length() <= ReplyDecoder.LONGEST && !line.contains("\n"));
    }

    @FuzzTest
    void aGoodLineIsFoundAfterAnyNoise(byte[] noise) {
        ReplyDecoder decoder = new ReplyDecoder();
        decoder.feed(noise, noise.length);
        byte[] good = ("\r\n" + GOOD + "\r\n").getBytes(StandardCharsets.ISO_8859_1);

        assertThat(decoder.feed(good, good.length)).endsWith(GOOD);
    }

    @FuzzTest
    void noReplyBreaksTheDriver(byte[] wire) {
        for (String line : decode(wire, 512)) {
            Reply reply = Reply.of(line);
            QUESTIONS.stream()
                    .filter(question -> question.isAnsweredBy(reply))
                    .forEach(question -> use(question, reply));
        }
    }

    private static void use(Question question, Reply reply) {
        if (question == Question.PROXIMITY) {
            Proximity seen = new Proximity(reply.numbers()).next(reply.numbers());
            assertThat(Clearance.front(seen).orElse(0)).isNotNegative();
        } else if (question == Question.MODULES) {
            assertThat(Modules.of(reply).names()).isNotEmpty();
        } else if (question != Question.VERSION && question.purpose() == Question.Purpose.ASK) {
            assertThat(reply.numbers()).isNotEmpty();
        }
    }

    /** The most that may be sent to a moving robot that sends noise: stops, and questions that take no time. */
    @FuzzTest
    void noAnswersMakeARobotMoveOrHoldUpItsStop(byte[] wire) {
        ManualClock clock = new ManualClock();
        RecordingLink link = new RecordingLink();
        Conversation conversation = new Conversation(link, clock, LineTimes.CABLE, new RecordedEvents());
        conversation.setDeafenable(false);
        conversation.ask(Question.PROXIMITY);
        conversation.stop();
        for (String line : decode(wire, 512)) {
            conversation.bytesReceived();
            conversation.received(Reply.of(line));
            clock.pass(0.05);
            conversation.tick();
        }
        clock.pass(2);
        conversation.tick();
        clock.pass(0.2);
        conversation.tick();

        assertThat(link.commands())
                .allMatch(command -> List.of("N", "D,0,0", "E").contains(command));
        assertThat(link.commands()).containsAnyOf("D,0,0", "E");
    }

    private static List<String> decode(byte[] wire, int chunkSize) {
        ReplyDecoder decoder = new ReplyDecoder();
        List<String> lines = new ArrayList<>();
        for (int at = 0; at < wire.length; at += chunkSize) {
            byte[] chunk = Arrays.copyOfRange(wire, at, Math.min(wire.length, at + chunkSize));
            lines.addAll(decoder.feed(chunk, chunk.length));
        }
        return lines;
    }
}
