package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import org.junit.jupiter.api.Test;

class ClearOfStopTest {
    private static final Rectangle SCREEN = new Rectangle(0, 0, 1280, 800);
    private static final Rectangle STOP = new Rectangle(1100, 60, 170, 50);

    @Test
    void aWindowBesideStopStaysWhereItIs() {
        Rectangle beside = new Rectangle(0, 0, 1000, 700);
        assertThat(ClearOfStop.clear(beside, 500, STOP, SCREEN)).isEqualTo(beside);
    }

    @Test
    void aWindowOverStopIsMovedBelowItAndMadeLowerWhereTheScreenEnds() {
        Rectangle placed = ClearOfStop.clear(new Rectangle(40, 10, 1200, 780), 520, STOP, SCREEN);
        assertThat(placed).isEqualTo(new Rectangle(40, 118, 1200, 682));
    }

    @Test
    void withoutRoomBelowAWindowIsPlacedToTheLeft() {
        Rectangle placed = ClearOfStop.clear(new Rectangle(40, 10, 1200, 780), 700, STOP, SCREEN);
        assertThat(placed).isEqualTo(new Rectangle(0, 10, 1092, 780));
    }
}
