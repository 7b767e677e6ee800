package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

class StripLayoutTest {
    private static final int HEIGHT = 450;

    private final JLabel font = new JLabel();

    private StripLayout.Grid grid(int cards) {
        return StripLayout.grid(cards, new Dimension(248, HEIGHT), font);
    }

    @Test
    void fewCardsAreFullInOneColumn() {
        assertThat(grid(3).columns()).isEqualTo(1);
        assertThat(grid(3).size()).isEqualTo(CardSize.FULL);
    }

    @Test
    void moreCardsShowLess() {
        assertThat(grid(9).size()).isEqualTo(CardSize.MEDIUM);
        assertThat(grid(15).size()).isEqualTo(CardSize.COMPACT);
        assertThat(grid(15).columns()).isEqualTo(1);
    }

    @Test
    void cardsThatDoNotFitInOneColumnAreNarrow() {
        assertThat(grid(30).size()).isEqualTo(CardSize.NARROW);
        assertThat(grid(30).columns()).isEqualTo(2);
    }

    @Test
    void withVeryLittleRoomTheCardsAreLowerThanTheyShouldBe() {
        StripLayout.Grid grid = StripLayout.grid(20, new Dimension(248, 90), font);
        assertThat(grid.columns()).isEqualTo(3);
        assertThat(7 * grid.height()).isLessThanOrEqualTo(90);
    }

    @Test
    void ofALargeTeamNumbersAndStatesAreInRows() {
        StripLayout.Grid grid = grid(200);

        assertThat(grid.size()).isEqualTo(CardSize.BADGE);
        assertThat(grid.isInRows()).isTrue();
        assertThat(grid.columns()).isGreaterThanOrEqualTo(5);
        assertThat(grid.height()).isGreaterThanOrEqualTo(18);
    }

    @Test
    void noGridIsHigherThanTheRoom() {
        for (int cards = 1; cards <= 40; cards++) {
            StripLayout.Grid grid = grid(cards);
            int rows = (cards + grid.columns() - 1) / grid.columns();
            assertThat(rows * grid.height()).as(cards + " cards").isLessThanOrEqualTo(HEIGHT);
        }
    }
}
