package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

class TabGridTest {
    private static final Dimension ROOM = new Dimension(284, 450);

    private final JLabel font = new JLabel();

    private TabGrid grid(int tabs) {
        return TabGrid.of(tabs, ROOM, font);
    }

    @Test
    void fewTabsAreFullInOneColumn() {
        assertThat(grid(3).columns()).isEqualTo(1);
        assertThat(grid(3).size()).isEqualTo(TabSize.FULL);
    }

    @Test
    void moreTabsShowLess() {
        assertThat(grid(9).size()).isEqualTo(TabSize.MEDIUM);
        assertThat(grid(20).size()).isEqualTo(TabSize.SMALL);
        assertThat(grid(20).columns()).isEqualTo(2);
    }

    @Test
    void aWiderColumnShowsMore() {
        TabGrid wide = TabGrid.of(20, new Dimension(3 * 230, 450), font);
        assertThat(wide.size()).isEqualTo(TabSize.MEDIUM);
        assertThat(wide.columns()).isEqualTo(3);
    }

    @Test
    void tabsThatDoNotFitInTwoLinesHaveOne() {
        assertThat(grid(30).size()).isEqualTo(TabSize.NARROW);
    }

    @Test
    void withVeryLittleRoomTheTabsAreLowerThanTheyShouldBeAndScroll() {
        TabGrid grid = TabGrid.of(20, new Dimension(284, 90), font);
        assertThat(grid.columns()).isEqualTo(3);
        assertThat(grid.height()).isBetween(16, TabSize.NARROW.height(font));
    }

    @Test
    void ofALargeTeamNumbersAndStatesAreInRows() {
        TabGrid grid = grid(200);

        assertThat(grid.size()).isEqualTo(TabSize.BADGE);
        assertThat(grid.toTabBelow()).isEqualTo(grid.columns()).isGreaterThanOrEqualTo(5);
        assertThat(grid.height()).isGreaterThanOrEqualTo(18);
    }

    @Test
    void eachTabHasAPlaceOfItsOwnInTheRoom() {
        Rectangle room = new Rectangle(ROOM);
        for (int tabs = 1; tabs <= 40; tabs++) {
            TabGrid grid = grid(tabs);
            List<Rectangle> places =
                    IntStream.range(0, tabs).mapToObj(grid::place).toList();
            assertThat(places).as(tabs + " tabs").allMatch(room::contains);
            assertThat(places)
                    .allMatch(place -> places.stream().filter(place::intersects).count() == 1);
        }
    }
}
