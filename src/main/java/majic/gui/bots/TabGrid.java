package majic.gui.bots;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;

/**
 * The places of the tabs in one or more columns: the richest tabs for which there is room. Their places depend on their
 * number and the room alone, so that no tab moves when a robot is selected or its state changes. Immutable.
 *
 * @param tabs how many tabs there are, at least 1
 * @param columns their number
 * @param size what the tabs show
 * @param width of a tab in pixels
 * @param height of a tab in pixels
 */
record TabGrid(int tabs, int columns, TabSize size, int width, int height) {
    /** Pixels between the tabs, through which the selected one is joined to its pane. */
    static final int GAP = 4;

    private static final int MOST_COLUMNS = 3;

    /** As many robots always have tabs with buttons, however low. */
    private static final int ALWAYS_WITH_BUTTONS = 20;

    /**
     * Chooses the places for some tabs.
     *
     * @param tabs how many, at least 1
     * @param room width and height for all in pixels
     * @param component has the font of the tabs
     */
    static TabGrid of(int tabs, Dimension room, Component component) {
        for (TabSize size : List.of(TabSize.FULL, TabSize.MEDIUM, TabSize.SMALL, TabSize.NARROW)) {
            Optional<TabGrid> whole = whole(tabs, size, room, component);
            if (whole.isPresent()) {
                return whole.get();
            }
        }
        return tabs > ALWAYS_WITH_BUTTONS ? badges(tabs, room, component) : lowered(tabs, room, component);
    }

    /** Returns the grid in which each tab has the room that it needs; empty if there is none. */
    private static Optional<TabGrid> whole(int tabs, TabSize size, Dimension room, Component component) {
        int natural = size.height(component);
        int rows = (room.height + GAP) / (natural + GAP);
        if (rows == 0) {
            return Optional.empty();
        }
        int columns = ceil(tabs, rows);
        int width = share(room.width, columns);
        if (columns > MOST_COLUMNS || width < size.width()) {
            return Optional.empty();
        }
        int most = natural + TabSize.NARROW.height(component) / 2;
        int height = Math.min(share(room.height, ceil(tabs, columns)), most);
        return Optional.of(new TabGrid(tabs, columns, size, width, height));
    }

    /** Returns a grid of lower tabs than they should be; it scrolls where they would be too low to be read. */
    private static TabGrid lowered(int tabs, Dimension room, Component component) {
        int natural = TabSize.NARROW.height(component);
        int columns = Math.max(1, Math.min(MOST_COLUMNS, (room.width + GAP) / (TabSize.NARROW.width() + GAP)));
        int height = Math.max(natural * 2 / 3, Math.min(natural, share(room.height, ceil(tabs, columns))));
        return new TabGrid(tabs, columns, TabSize.NARROW, share(room.width, columns), height);
    }

    private static TabGrid badges(int tabs, Dimension room, Component component) {
        int columns = Math.max(1, (room.width + GAP) / (TabSize.BADGE.width() + GAP));
        return new TabGrid(tabs, columns, TabSize.BADGE, share(room.width, columns), TabSize.BADGE.height(component));
    }

    private static int share(int room, int parts) {
        return (room - (parts - 1) * GAP) / parts;
    }

    private static int ceil(int number, int divisor) {
        return (number + divisor - 1) / divisor;
    }

    private int rows() {
        return ceil(tabs, columns);
    }

    /** Returns whether neighbours are beside each other, and not below each other. */
    private boolean isInRows() {
        return size == TabSize.BADGE;
    }

    /** Returns the height of all tabs in pixels. */
    int heightOfAll() {
        return rows() * (height + GAP) - GAP;
    }

    /** Returns the place of a tab. */
    Rectangle place(int tab) {
        int row = isInRows() ? tab / columns : tab % rows();
        return new Rectangle(column(tab) * (width + GAP), row * (height + GAP), width, height);
    }

    private int column(int tab) {
        return isInRows() ? tab % columns : tab / rows();
    }

    /** Returns whether a tab is in the last column, beside the panes. */
    boolean isBesidePanes(int tab) {
        return column(tab) == columns - 1;
    }

    /** Returns by how many tabs the one below a tab is further. */
    int toTabBelow() {
        return isInRows() ? columns : 1;
    }

    /** Returns by how many tabs the one beside a tab is further; the next one if there is only one column. */
    int toTabBeside() {
        return isInRows() || columns == 1 ? 1 : rows();
    }
}
