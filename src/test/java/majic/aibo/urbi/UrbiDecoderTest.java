package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import majic.aibo.urbi.UrbiMessage.Continued;
import majic.aibo.urbi.UrbiMessage.Failure;
import majic.aibo.urbi.UrbiMessage.Info;
import majic.aibo.urbi.UrbiMessage.Result;
import majic.aibo.urbi.UrbiValue.Binary;
import majic.aibo.urbi.UrbiValue.Items;
import majic.aibo.urbi.UrbiValue.Num;
import majic.aibo.urbi.UrbiValue.Other;
import majic.aibo.urbi.UrbiValue.Str;
import org.assertj.core.groups.Tuple;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UrbiDecoderTest {
    /** Excerpts of a real kernel's session: banner, values, flags, both shapes of errors, an echo of two lines. */
    private static final String SESSION = """
            [00076256:start] *** **********************************************************
            [00076256:start] ***
            [00076256:ident] *** ID: U94665654142880
            [00076288:power] *** Battery at 87 %
            [00076874:notag] 1.000000
            [00078012:t] *** begin
            [00079369:t] !!! Division by zero
            [00084526:error] !!! 39.4-6: syntax error, unexpected identifier, expecting end of command
            [00084296:t.sub] 13.000000
            [00102408:notag] "a\\"b"
            [00104666:notag] [1.000000,"a",[2.000000,3.000000]]
            [00104892:notag] []
            [00091412:notag] -inf
            [00087541:notag] !!! Unknown identifier: U94665654167728.unknownvar
            [00108530:notag] *** first
            second line of an echo
            [00108531:notag] 5.000000
            """;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 64, 4096})
    void findsTheSameMessagesHoweverTheBytesArrive(int chunkSize) {
        assertThat(decode(SESSION, chunkSize))
                .extracting(UrbiMessage::tag, UrbiMessage::body)
                .containsExactly(
                        of("start", new Info("*".repeat(58))),
                        of("start", new Info("")),
                        of("ident", new Info("ID: U94665654142880")),
                        of("power", new Info("Battery at 87 %")),
                        of("notag", new Result(new Num(1))),
                        of("t", new Info("begin")),
                        of("t", new Failure("Division by zero")),
                        of(
                                "error",
                                new Failure("39.4-6: syntax error, unexpected identifier, expecting end of command")),
                        of("t.sub", new Result(new Num(13))),
                        of("notag", new Result(new Str("a\"b"))),
                        of("notag", new Result(list(new Num(1), new Str("a"), list(new Num(2), new Num(3))))),
                        of("notag", new Result(list())),
                        of("notag", new Result(new Num(Double.NEGATIVE_INFINITY))),
                        of("notag", new Failure("Unknown identifier: U94665654167728.unknownvar")),
                        of("notag", new Info("first")),
                        of("notag", new Continued("second line of an echo")),
                        of("notag", new Result(new Num(5))));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 1000})
    void nothingSeparatesABinaryFromTheNextMessage(int chunkSize) {
        String wire =
                "[00012623:notag] BIN 5\nhello[00012623:cam] BIN 4 jpeg 208 160 160\nab\nc[00012623:notag] 7.000000\n";

        List<UrbiMessage> messages = decode(wire, chunkSize);

        assertThat(messages).hasSize(3);
        assertThat(binary(messages.get(0))).isEqualTo("hello");
        assertThat(binary(messages.get(1))).isEqualTo("ab\nc");
        assertThat(((Binary) value(messages.get(1))).words()).containsExactly("jpeg", "208", "160", "160");
        assertThat(value(messages.get(2))).isEqualTo(new Num(7));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 1000})
    void aListGoesOnBehindABinaryInIt(int chunkSize) {
        String wire = "[00013022:notag] [BIN 5\nhe]\"o,1.000000,[BIN 0\n]]\n[00013023:notag] 2.000000\n";

        List<UrbiMessage> messages = decode(wire, chunkSize);

        assertThat(messages).hasSize(2);
        List<UrbiValue> items = ((Items) value(messages.get(0))).items();
        assertThat(new String(((Binary) items.get(0)).bytes(), StandardCharsets.ISO_8859_1))
                .isEqualTo("he]\"o");
        assertThat(items.get(1)).isEqualTo(new Num(1));
        assertThat(items).hasSize(3);
    }

    @Test
    void aLineFeedInsideQuotesBelongsToTheString() {
        List<UrbiMessage> messages = decode("[00000001:a] \"one\ntwo\"\n[00000002:b] 3.000000\n", 1);

        assertThat(value(messages.get(0))).isEqualTo(new Str("one\ntwo"));
        assertThat(value(messages.get(1))).isEqualTo(new Num(3));
    }

    @Test
    void aSingleQuoteOrBracketInAnErrorOpensNothing() {
        List<UrbiMessage> messages = decode("[00000001:a] !!! cannot [ \"x\n[00000002:b] 3.000000\n", 1);

        assertThat(messages.get(0).body()).isEqualTo(new Failure("cannot [ \"x"));
        assertThat(messages).hasSize(2);
    }

    @Test
    void thePrefixOf15HasNoTag() {
        List<UrbiMessage> messages = decode("[00012345] 1.500000\n", 1);

        assertThat(messages).containsExactly(new UrbiMessage(12345, "notag", new Result(new Num(1.5))));
    }

    @Test
    void aLineWithoutEndIsDroppedAndTheNextOneRead() {
        String wire = "[00000001:a] \"" + "x".repeat(UrbiDecoder.MAX_TEXT) + "\n[00000002:b] 2.000000\n";

        assertThat(decode(wire, 1000)).containsExactly(new UrbiMessage(2, "b", new Result(new Num(2))));
    }

    @Test
    void aQuoteThatNeverClosesEndsAtTheNextLineWithAPrefix() {
        String wire = "[00000001:a] \"stan\n[00000002:b] 2.000000\n[00000003:c] \"stand\"\n";

        assertThat(decode(wire, 5))
                .extracting(UrbiMessage::body)
                .containsExactly(new Result(new Num(2)), new Result(new Str("stand")));
    }

    @Test
    void anImageCutInHalfIsGivenUpForTheMessagesBehindIt() {
        UrbiDecoder decoder = new UrbiDecoder();
        byte[] half = ("[00000001:cam] BIN 1000000 jpeg 208 160\n" + "x".repeat(500_000)
                        + "[00000002:b] 2.000000\n[00000003:c] 3.0")
                .getBytes(StandardCharsets.ISO_8859_1);
        assertThat(decoder.feed(half, half.length)).isEmpty();

        assertThat(decoder.giveUpCutBinary()).containsExactly(new UrbiMessage(2, "b", new Result(new Num(2))));
        assertThat(decoder.feed(new byte[] {'0', '\n'}, 2))
                .containsExactly(new UrbiMessage(3, "c", new Result(new Num(3))));
    }

    @Test
    void anImageThatIsOnlySlowIsNotGivenUp() {
        UrbiDecoder decoder = new UrbiDecoder();
        byte[] header = "[00000001:cam] BIN 4 jpeg 208 160\nab".getBytes(StandardCharsets.ISO_8859_1);
        decoder.feed(header, header.length);

        assertThat(decoder.giveUpCutBinary()).isEmpty();
        assertThat(binary(decoder.feed(new byte[] {'c', 'd'}, 2).get(0))).isEqualTo("abcd");
    }

    @Test
    void aBinaryOfAnImpossibleSizeIsDropped() {
        String wire = "[00000001:a] BIN 999999999\n[00000002:b] 2.000000\n";

        assertThat(decode(wire, 7)).containsExactly(new UrbiMessage(2, "b", new Result(new Num(2))));
    }

    @Test
    void whatIsNoValueIsKeptAsText() {
        assertThat(decode("[00000001:a] OBJ [x:1.000000,y:2.000000]\n", 1))
                .containsExactly(new UrbiMessage(1, "a", new Result(new Other("OBJ [x:1.000000,y:2.000000]"))));
        assertThat(decode("[00000001:a] [1.000000,\n[00000002:b] 2.000000\n", 1))
                .hasSize(2);
    }

    private static List<UrbiMessage> decode(String wire, int chunkSize) {
        UrbiDecoder decoder = new UrbiDecoder();
        List<UrbiMessage> messages = new ArrayList<>();
        byte[] bytes = wire.getBytes(StandardCharsets.ISO_8859_1);
        for (int at = 0; at < bytes.length; at += chunkSize) {
            byte[] chunk = Arrays.copyOfRange(bytes, at, Math.min(bytes.length, at + chunkSize));
            messages.addAll(decoder.feed(chunk, chunk.length));
        }
        return messages;
    }

    private static UrbiValue value(UrbiMessage message) {
        return ((Result) message.body()).value();
    }

    private static String binary(UrbiMessage message) {
        return new String(((Binary) value(message)).bytes(), StandardCharsets.ISO_8859_1);
    }

    private static UrbiValue list(UrbiValue... items) {
        return new Items(List.of(items));
    }

    private static Tuple of(Object... parts) {
        return Tuple.tuple(parts);
    }
}
