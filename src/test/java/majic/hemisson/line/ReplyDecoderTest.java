package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReplyDecoderTest {
    private static final String SESSION = "HemiOS V1.50 , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30\r\n"
            + "E-Mail : info@hemisson.com\r\n\r\nD\u00e9marrage en mode Interne\r\nb,HemiOS_v_1.50\r\n"
            + "n,004,004,004,004,004,004,060,060\r\nUnknown Command ?!\r\n";

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 64, 1000})
    void theLinesDoNotDependOnThePacketsOfTheBytes(int chunkSize) {
        assertThat(decode(SESSION, chunkSize))
                .containsExactly(
                        "HemiOS V1.50 , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30",
                        "E-Mail : info@hemisson.com",
                        "",
                        "D\u00e9marrage en mode Interne",
                        "b,HemiOS_v_1.50",
                        "n,004,004,004,004,004,004,060,060",
                        "Unknown Command ?!");
    }

    @Test
    void aPartialLineIsKept() {
        assertThat(decode("b,Hemi", 100)).isEmpty();
    }

    @Test
    void aTooLongLineIsDroppedAndTheNextIsFound() {
        assertThat(decode("x".repeat(ReplyDecoder.LONGEST + 1) + "\r\nd\r\n", 50))
                .containsExactly("d");
    }

    @Test
    void everyByteMayOccurInALine() {
        assertThat(decode("&\u0000\u0003\u00ff\rz\r\n", 1)).containsExactly("&\u0000\u0003\u00ff\rz");
    }

    private static List<String> decode(String text, int chunkSize) {
        byte[] wire = text.getBytes(StandardCharsets.ISO_8859_1);
        ReplyDecoder decoder = new ReplyDecoder();
        List<String> lines = new ArrayList<>();
        for (int at = 0; at < wire.length; at += chunkSize) {
            byte[] chunk = Arrays.copyOfRange(wire, at, Math.min(wire.length, at + chunkSize));
            lines.addAll(decoder.feed(chunk, chunk.length));
        }
        return lines;
    }
}
