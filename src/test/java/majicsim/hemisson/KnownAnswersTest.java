package majicsim.hemisson;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Section 14 of the Hemisson sheet and its transcripts, over a real socket and a real pseudo-terminal. */
@Timeout(value = 20, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class KnownAnswersTest {
    private static final String GREETING = "HemiOS V1.50 , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30\r\n"
            + "E-Mail : info@hemisson.com\r\n\r\n";
    private static final String UNKNOWN = "Unknown Command ?!\r\n";

    /** In the table, ␍ and ␊ are the characters themselves, and two lines of the reply are separated by both. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "B␍ | b,HemiOS_v_1.50␍␊",
                "BB␍B,1␍Bxyz␍ | b,HemiOS_v_1.50␍␊b,HemiOS_v_1.50␍␊b,HemiOS_v_1.50␍␊",
                "I␍ | i,1,1,1,1␍␊",
                "N␍ | n,004,004,004,004,004,004,060,060␍␊",
                "O␍ | o,220,220,220,220,220,220,220,220␍␊",
                "P,0␍P,2␍M,1␍ | p,004,004,004␍␊p,060,060␍␊m,220,220,220␍␊",
                "D,5,-5␍E␍ | d␍␊e,05,-5␍␊",
                "D,9,9␍E␍D,-9,-9␍E␍ | d␍␊e,09,09␍␊d␍␊e,-9,-9␍␊",
                "D,12,12␍E␍ | d␍␊e,01,-4␍␊",
                "D,10,3␍E␍ | d␍␊e,01,-4␍␊",
                "D,-12,12␍E␍ | d␍␊e,-1,-4␍␊",
                "D,+5,5␍E␍ | d␍␊e,-5,-4␍␊",
                "D, 5,5␍E␍ | d␍␊e,-16,-4␍␊",
                "D,5;7␍E␍Dx5y7␍E␍ | d␍␊e,05,07␍␊d␍␊e,05,07␍␊",
                "D,5,-␍E␍ | d␍␊e,05,35␍␊",
                "D,3,4␍D,5␍E␍ | d␍␊d␍␊e,05,04␍␊",
                "D␍E␍ | d␍␊e,-48,-48␍␊",
                "T␍J␍ | t,000␍␊j␍␊",
                "H,1␍H,0␍L,1,0,1,0␍ | h␍␊h␍␊l␍␊",
                "R,C0,00,01␍W,C0,00,01␍ | r,255␍␊w␍␊",
                "b␍n␍ B␍K␍␍\u00fe␍ | ?????? ",
                "B␍␊B␍␊ | b,HemiOS_v_1.50␍␊?",
                "B␊␍B␊␍ | b,HemiOS_v_1.50␍␊b,HemiOS_v_1.50␍␊",
                "P,3␍M,9␍T␍ | t,000␍␊",
                "1,0␍2,0,1␍1,0␍ | 1,0␍␊2␍␊1,1␍␊",
                "1,9␍2,7,1␍ | 1,?2␍␊?",
                "!␍!␍ | !\u0001␍␊!\u0000␍␊",
                "D,3,-3␍&␍ | d␍␊&\u0003\u00fd\u0004\u0004\u0004\u0004\u0004\u0004<<ÜÜÜÜÜÜÜÜ\u000f\u0000\u00012␍␊",
                "*\u0003\u00fd\u0005␍E␍ | *␍␊e,03,-3␍␊",
                "FE ␍B ␊␍I ␊␍D,4,4 ␊␍ | ?b,HemiOS_v_1.50␍␊i,1,1,1,1␍␊d␍␊",
            })
    void answersAsTheRealFirmwareDid(String sent, String received) throws IOException {
        String expected = control(received).replace("?", UNKNOWN);
        try (Bench bench = new Bench(HemissonOptions.standard());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.send(control(sent));
            wire.expect(expected);
        }
        try (Bench bench = new Bench(HemissonOptions.standard())) {
            assumeTrue(bench.pty.isPresent(), "no pseudo-terminals here");
            try (Wire wire = Wire.device(bench.pty.get().address())) {
                wire.send(control(sent));
                wire.expect(expected);
            }
        }
    }

    @Test
    void aResetIsAnsweredThenGreetedAndStopsTheMotors() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.exchange("D,5,5", "d");
            wire.exchange("Z", "z");
            bench.steps(2);
            wire.expect(GREETING);
            wire.exchange("E", "e,00,00");
        }
    }

    @Test
    void modulesAnswerOnTheBusAndTheUltrasonicOneSeesTheBoxAt274Centimetres() throws IOException {
        HemissonOptions withModules =
                HemissonOptions.standard().withModules(Set.of(ModuleKind.CAMERA, ModuleKind.ULTRASONIC));
        try (Bench bench = new Bench(withModules);
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.exchange("J", "j,c0,e0");
            wire.exchange("W,C0,21,0A", "w");
            wire.exchange("R,C0,21,01", "r,010");
            wire.exchange("W,C0,21,0a", "w");
            wire.exchange("R,C0,21,01", "r,042");
            wire.exchange("Y,C0,20,02,41,42", "y");
            wire.exchange("R,C0,20,03", "r,002,065,066");
            wire.exchange("W,E0,00,51", "w");
            bench.steps(17);
            wire.exchange("R,E0,02,02", "r,001,018");
        }
    }

    private static String control(String text) {
        return text.replace('␍', '\r').replace('␊', '\n');
    }
}
