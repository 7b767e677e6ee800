package majic.aibo.body;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import majic.aibo.urbi.PendingRequests;
import majic.aibo.urbi.UrbiDecoder;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiRequest;
import majic.aibo.urbi.UrbiValue;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Unit;

/**
 * Whatever bytes come from a dog: kept ones in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ReceivingFuzzTest {
    private static final String GOOD_LINE = "\n[00000007:good] 7.000000\n";
    private static final UrbiMessage GOOD = new UrbiMessage(7, "good", new UrbiMessage.Result(new UrbiValue.Num(7)));

    @FuzzTest
    void theSameMessagesComeHoweverTheBytesAreCut(byte[] wire) {
        List<String> whole = decode(new UrbiDecoder(), wire, wire.length + 1);
        int chunkSize = wire.length == 0 ? 1 : 1 + (wire[wire.length - 1] & 0x3F);

        assertThat(decode(new UrbiDecoder(), wire, chunkSize)).isEqualTo(whole);
        assertThat(decode(new UrbiDecoder(), wire, 1)).isEqualTo(whole);
    }

    /** A binary that the noise announces swallows what fits into it and ends within a line; the next one is read. */
    @FuzzTest
    void aGoodMessageIsFoundAfterAnyNoise(byte[] noise) {
        UrbiDecoder decoder = new UrbiDecoder();
        decoder.feed(noise, noise.length);
        byte[] good = GOOD_LINE.repeat(3).getBytes(StandardCharsets.ISO_8859_1);

        List<UrbiMessage> found = new ArrayList<>(decoder.feed(good, good.length));
        while (decoder.isInBinary()) {
            List<UrbiMessage> freed = decoder.giveUpCutBinary();
            found.addAll(freed);
        }
        found.addAll(decoder.feed(good, good.length));

        assertThat(found).last().isEqualTo(GOOD);
    }

    @FuzzTest
    void noMessageUpsetsTheDriver(byte[] wire) {
        SensorReadings senses = new SensorReadings();
        for (UrbiMessage message : new UrbiDecoder().feed(wire, wire.length)) {
            UrbiRequest ask = new UrbiRequest(message.tag(), UrbiRequest.Expects.VALUE);
            PendingRequests pending = new PendingRequests();
            pending.add(ask);
            pending.answer(message, UrbiVersion.of(String.valueOf(message.body()), UrbiVersion.V1_0));
            if (message.body() instanceof UrbiMessage.Result result) {
                assertThat(ask.value()).isSameAs(result.value());
                senses.put(Sensor.NEAR, result.value(), message.timeMs());
                assertThat(senses.number(Sensor.NEAR).orElse(0.0)).isFinite();
                assertThat(senses.value(Sensor.NEAR, 10, Unit.MM)).isNotNull();
            }
        }
    }

    /** As text, for binaries are equal only if they are the same. */
    private static List<String> decode(UrbiDecoder decoder, byte[] wire, int chunkSize) {
        List<String> messages = new ArrayList<>();
        for (int at = 0; at < wire.length; at += chunkSize) {
            byte[] chunk = Arrays.copyOfRange(wire, at, Math.min(wire.length, at + chunkSize));
            decoder.feed(chunk, chunk.length).forEach(message -> messages.add(text(message)));
        }
        return messages;
    }

    private static String text(UrbiMessage message) {
        return String.valueOf(message).replaceAll("bytes=\\[B@[0-9a-f]+", "bytes");
    }
}
