package majic.panel;

import java.awt.Rectangle;
import java.util.List;
import java.util.function.ToIntFunction;

/** Places side panes beside a view: one below the other, and under them the readings as far as there is space. */
final class SidePaneColumn {
    private final List<SidePane> panes;
    private final ReadingsPanel<?> numbers;
    private final int gap;

    SidePaneColumn(List<SidePane> panes, ReadingsPanel<?> numbers) {
        this.panes = panes;
        this.numbers = numbers;
        this.gap = numbers.gap() / 3;
    }

    int leastWidth() {
        return panes.stream().mapToInt(SidePane::leastWidth).max().orElse(0);
    }

    /** Returns the width at which the readings fit, while the side panes have no more than their minimum. */
    int widthForReadings() {
        return Math.max(leastWidth(), numbers.getMinimumSize().width);
    }

    /** Returns the width at which the readings that stand two in a row fit; 0 if there are none. */
    int widthForPairs() {
        return numbers.pairWidth() == 0 ? 0 : Math.max(widthForReadings(), numbers.pairWidth());
    }

    /** Returns whether the column has room for readings that stand two in a row. */
    boolean showsPairs(int width, int height) {
        int rest = height - sum(pane -> pane.goodHeight(width)) - gap;
        return width >= widthForPairs() && widthForPairs() > 0 && numbers.heightWithin(width, rest) > 0;
    }

    /** Returns whether the column has room for the important readings below the side panes. */
    boolean showsReadings(int width, int height) {
        int rest = height - sum(pane -> pane.goodHeight(width));
        return numbers.showsImportant(width, rest - gap + spareOfPanes(width));
    }

    /** Returns the width at which the column is lowest and wide enough for the readings. */
    int goodWidth() {
        return panes.stream().mapToInt(SidePane::goodWidth).reduce(widthForReadings(), Math::max);
    }

    int leastHeight(int width) {
        return sum(pane -> pane.leastHeight(width));
    }

    private int sum(ToIntFunction<SidePane> height) {
        return panes.stream().mapToInt(height).sum() + (panes.size() - 1) * gap;
    }

    void place(Rectangle room) {
        int rest = room.height - sum(pane -> pane.goodHeight(room.width));
        int rows = numbers.heightWithin(room.width, rest - gap + spareOfPanes(room.width));
        int spare = rows == 0 ? rest : rest - rows - gap;
        int y = room.y;
        for (SidePane pane : panes) {
            int height = height(pane, room.width, spare);
            pane.place(room.x, y, room.width, height);
            y += height + gap;
        }
        numbers.place(room.x, y, room.width, rows);
    }

    /** Returns by how much the panes are reduced for one more row of readings. */
    private int spareOfPanes(int width) {
        return Math.min(numbers.gap(), sum(pane -> pane.goodHeight(width)) - leastHeight(width));
    }

    /** Returns the preferred height, changed by the spare or missing height if the pane is flexible. */
    private static int height(SidePane pane, int width, int spare) {
        int good = pane.goodHeight(width);
        int least = pane.leastHeight(width);
        return spare < 0 || pane.takesRest() ? Math.max(least, good + spare) : good;
    }
}
