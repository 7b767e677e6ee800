package majic.gui.bots;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.util.List;
import javax.swing.JViewport;

/**
 * Places the cards of all robots in the room there is: in one column, each as large as possible; in more columns where
 * one has no room for all. The cards of a large team show numbers and states only, in rows that may be higher than the
 * room together.
 */
final class StripLayout implements LayoutManager {
    private static final int WIDTH = 268;
    private static final int LEAST_WIDTH = 96;
    private static final int BADGE_WIDTH = 45;
    private static final int GAP = 3;
    private static final int MOST_COLUMNS = 3;

    /** As many robots always have cards with buttons, however low. */
    private static final int ALWAYS_WITH_BUTTONS = 20;

    /**
     * Places in a grid.
     *
     * @param columns their number
     * @param size what the cards show
     * @param height of a card in pixels
     */
    record Grid(int columns, CardSize size, int height) {
        /** Returns whether neighbours are beside each other, and not below each other. */
        boolean isInRows() {
            return size == CardSize.BADGE;
        }

        private int rows(int cards) {
            return (cards + columns - 1) / columns;
        }

        /** Returns the height of all cards in pixels. */
        int heightOf(int cards) {
            return rows(cards) * (height + GAP) - GAP;
        }
    }

    /**
     * Chooses the places for some cards.
     *
     * @param cards how many, at least 1
     * @param room width and height for all in pixels
     * @param component has the font of the cards
     */
    static Grid grid(int cards, Dimension room, Component component) {
        for (CardSize size : List.of(CardSize.FULL, CardSize.MEDIUM, CardSize.COMPACT)) {
            int height = share(cards, 1, room.height);
            if (size.height(component) <= height) {
                return new Grid(1, size, size.height(component) + slack(size, height, component));
            }
        }
        int natural = CardSize.NARROW.height(component);
        int columns = 2;
        while (columns < MOST_COLUMNS && share(cards, columns, room.height) < natural) {
            columns++;
        }
        int height = share(cards, columns, room.height);
        if (cards > ALWAYS_WITH_BUTTONS && height < natural * 2 / 3) {
            return badges(room.width, component);
        }
        return new Grid(columns, CardSize.NARROW, Math.min(height, natural * 3 / 2));
    }

    private static Grid badges(int width, Component component) {
        int columns = Math.max(1, (width + GAP) / (UIScale.scale(BADGE_WIDTH) + GAP));
        return new Grid(columns, CardSize.BADGE, CardSize.BADGE.height(component));
    }

    private static int share(int cards, int columns, int height) {
        int rows = (cards + columns - 1) / columns;
        return (height - (rows - 1) * GAP) / rows;
    }

    /** Returns by how much a card is higher than it must be: at most half a line. */
    private static int slack(CardSize size, int height, Component component) {
        return Math.min(height - size.height(component), CardSize.COMPACT.height(component) / 2);
    }

    /** Returns the grid for the visible part of a strip, which has a card at least. */
    static Grid gridOf(Container strip) {
        Dimension room = strip.getParent() instanceof JViewport port ? port.getExtentSize() : strip.getSize();
        return grid(strip.getComponentCount(), room, strip);
    }

    @Override
    public void layoutContainer(Container strip) {
        RobotCard[] cards = cards(strip);
        if (cards.length == 0) {
            return;
        }
        Grid grid = gridOf(strip);
        int rows = grid.rows(cards.length);
        int width = (strip.getWidth() - (grid.columns() - 1) * GAP) / grid.columns();
        for (int index = 0; index < cards.length; index++) {
            int column = grid.isInRows() ? index % grid.columns() : index / rows;
            int row = grid.isInRows() ? index / grid.columns() : index % rows;
            cards[index].show(grid.size());
            cards[index].setBounds(column * (width + GAP), row * (grid.height() + GAP), width, grid.height());
        }
    }

    private static RobotCard[] cards(Container strip) {
        RobotCard[] cards = new RobotCard[strip.getComponentCount()];
        for (int index = 0; index < cards.length; index++) {
            cards[index] = (RobotCard) strip.getComponent(index);
        }
        return cards;
    }

    @Override
    public Dimension preferredLayoutSize(Container strip) {
        int cards = Math.max(1, strip.getComponentCount());
        Grid grid = cards > ALWAYS_WITH_BUTTONS
                ? gridOf(strip)
                : new Grid(1, CardSize.COMPACT, CardSize.COMPACT.height(strip));
        return new Dimension(UIScale.scale(WIDTH), grid.heightOf(cards));
    }

    @Override
    public Dimension minimumLayoutSize(Container strip) {
        return new Dimension(UIScale.scale(LEAST_WIDTH), 0);
    }

    @Override
    public void addLayoutComponent(String name, Component component) {}

    @Override
    public void removeLayoutComponent(Component component) {}
}
