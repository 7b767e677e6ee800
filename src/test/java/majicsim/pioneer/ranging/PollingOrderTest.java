package majicsim.pioneer.ranging;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import majicsim.pioneer.Rig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** POLLING, SONARCYCLE and the arrays of SONAR (ARCOS sheet 6.1). */
class PollingOrderTest {
    private static final int POLLING = 3;
    private static final int SONAR = 28;
    private static final int SONARCYCLE = 48;

    private final Rig rig = Rig.open();

    @Test
    void discsFireInTheOrderGivenAndOthersNotAtAll() {
        rig.command(SONARCYCLE, 100).text(POLLING, (byte) 8, (byte) 1, (byte) 4);
        assertThat(discs(6)).containsExactly(7, 0, 3, 7, 0, 3);
    }

    @Test
    void eachArrayTakesItsOwnTurn() {
        rig.command(SONARCYCLE, 100).text(POLLING, (byte) 1, (byte) 9, (byte) 10);
        assertThat(discs(3)).containsExactly(0, 8, 0, 9, 0, 8);
    }

    @Test
    void withoutDiscsItIsTheUsualOrderAgain() {
        rig.text(POLLING, (byte) 1).text(POLLING).pulse(0.4).line.take();
        assertThat(discs(4)).contains(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    }

    @Test
    void numbersOfNoDiscAreLeftOut() {
        assertThat(PollingOrder.of(new byte[] {0, 33, -1, 5}).discs()).containsExactly(4);
        assertThat(PollingOrder.of(new byte[] {0, 33})).isEqualTo(PollingOrder.USUAL);
    }

    @ParameterizedTest
    @CsvSource({"0, 0x00", "2, 0x1C", "4, 0x1A", "1, 0x1E", "10, 0x1E"})
    void higherBitsOfSonarChooseTheArray(int argument, String flags) {
        assertThat(rig.command(SONAR, argument).nextSip().flags()).isEqualTo(Integer.decode(flags));
    }

    private List<Integer> discs(int sips) {
        List<Integer> discs = new ArrayList<>();
        for (int i = 0; i < sips; i++) {
            discs.addAll(rig.nextSip().sonar().keySet());
        }
        return discs;
    }
}
