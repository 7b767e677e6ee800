package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The known answers of the Hemisson sheet, sections 10 and 14. */
class QuestionTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"12 | 12 | D,9,9", "-12 | 3 | D,-9,3", "5 | -5 | D,5,-5", "0 | 0 | D,0,0"})
    void wheelValuesAreClampedToOneDigit(int left, int right, String command) {
        assertThat(Question.wheels(new MotorValues(left, right)).text()).isEqualTo(command);
    }

    @Test
    void aCommandEndsWithCarriageReturnAlone() {
        assertThat(Question.bytes(Question.STOP.text())).containsExactly('D', ',', '0', ',', '0', '\r');
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"e,05,-5 | 5 | -5", "e,-9,09 | -9 | 9", "e,10,-10 | 10 | -10", "e,3,-3 | 3 | -3"})
    void speedsAreReadAsSignedNumbers(String line, int left, int right) {
        Reply reply = Reply.of(line);

        assertThat(Question.SPEEDS.isAnsweredBy(reply)).isTrue();
        assertThat(reply.numbers()).containsExactly(left, right);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"d", "d,3,-3"})
    void bothDialectsConfirmTheWheels(String line) {
        assertThat(Question.STOP.isAnsweredBy(Reply.of(line))).isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "n,004,004,004,004,004,004,060",
                "n,004,004,004,004,0x4,004,060,060",
                "n,004,004,004,004,004,004,060,0600",
                "o,004,004,004,004,004,004,060,060"
            })
    void aDamagedReadingIsNoAnswer(String line) {
        assertThat(Question.PROXIMITY.isAnsweredBy(Reply.of(line))).isFalse();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"Unknown Command ?!", "<E01: unknown command>"})
    void bothDialectsRefuse(String line) {
        assertThat(Reply.of(line).kind()).isEqualTo(Reply.Kind.REFUSED);
    }

    @Test
    void aLineThatBeginsWithHemiOsIsAGreeting() {
        assertThat(Reply.of("HemiOS V1.23 Beta , K-Team").kind()).isEqualTo(Reply.Kind.GREETING);
    }

    @Test
    void allFourLedsAreSentTogether() {
        assertThat(Question.leds(Leds.OFF.withPgm(true).withRight(true)).text()).isEqualTo("L,0,1,0,1");
    }
}
