package majic.panel;

import java.awt.Rectangle;
import java.util.List;

/** Places side panes below a view: side by side, and below all of them the readings as far as there is space. */
final class SidePaneRow {
    private final List<SidePane> panes;
    private final ReadingsPanel<?> numbers;
    private final int gap;

    SidePaneRow(List<SidePane> panes, ReadingsPanel<?> numbers) {
        this.panes = panes;
        this.numbers = numbers;
        this.gap = numbers.gap() / 2;
    }

    /**
     * Returns the minimum height without the readings; larger than any available height if the width is too small for
     * the side panes.
     */
    int leastHeight(int width) {
        int each = widthOfEach(width);
        boolean fits = panes.stream().allMatch(pane -> pane.leastWidth() <= each);
        return fits
                ? panes.stream().mapToInt(pane -> pane.goodHeight(each)).max().orElse(0)
                : Short.MAX_VALUE;
    }

    private int widthOfEach(int width) {
        return (width - (panes.size() - 1) * 2 * gap) / panes.size();
    }

    /** Returns whether the readings are shown in an area. */
    boolean showsReadings(Rectangle room) {
        return rows(room) > 0;
    }

    private int rows(Rectangle room) {
        return numbers.heightWithin(room.width, spare(room) - gap);
    }

    /** Returns the height that a square view leaves over. */
    private int spare(Rectangle room) {
        return Math.max(0, room.height - leastHeight(room.width) - gap - room.width);
    }

    /**
     * Places the strip at the bottom of an area, as high as a square view permits; returns the height left for the
     * view.
     */
    int place(Rectangle room) {
        int each = widthOfEach(room.width);
        int height = leastHeight(room.width);
        int spare = spare(room);
        int rows = rows(room);
        if (panes.stream().anyMatch(SidePane::takesRest)) {
            height += rows == 0 ? spare : spare - rows - gap;
        }
        int y = room.y + room.height - height - (rows == 0 ? 0 : rows + gap);
        int x = room.x;
        for (SidePane pane : panes) {
            pane.place(x, y, each, pane.takesRest() ? height : Math.min(height, pane.goodHeight(each)));
            x += each + 2 * gap;
        }
        numbers.place(room.x, room.y + room.height - rows, room.width, rows);
        return y - gap - room.y;
    }
}
