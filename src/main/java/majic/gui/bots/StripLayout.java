package majic.gui.bots;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.util.List;
import java.util.stream.Stream;

/**
 * Places the cards of all robots in the room there is: in one column, each as large as possible; in more columns where
 * one has no room for all.
 */
final class StripLayout implements LayoutManager {
    private static final int WIDTH = 248;
    private static final int LEAST_WIDTH = 96;
    private static final int GAP = 3;
    private static final int MOST_COLUMNS = 3;

    /**
     * Places in a grid.
     *
     * @param columns their number
     * @param size what the cards show
     * @param height of a card in pixels
     */
    record Grid(int columns, CardSize size, int height) {}

    /**
     * Chooses the places for some cards.
     *
     * @param cards how many, at least 1
     * @param height the height for all in pixels
     * @param component has the font of the cards
     */
    static Grid grid(int cards, int height, Component component) {
        for (CardSize size : List.of(CardSize.FULL, CardSize.MEDIUM, CardSize.COMPACT)) {
            int room = room(cards, 1, height);
            if (size.height(component) <= room) {
                return new Grid(1, size, size.height(component) + slack(size, room, component));
            }
        }
        int columns = 2;
        while (columns < MOST_COLUMNS && room(cards, columns, height) < CardSize.NARROW.height(component)) {
            columns++;
        }
        int room = room(cards, columns, height);
        return new Grid(columns, CardSize.NARROW, Math.min(room, CardSize.NARROW.height(component) * 3 / 2));
    }

    private static int room(int cards, int columns, int height) {
        int rows = (cards + columns - 1) / columns;
        return (height - (rows - 1) * GAP) / rows;
    }

    /** Returns by how much a card is higher than it must be: at most half a line. */
    private static int slack(CardSize size, int room, Component component) {
        return Math.min(room - size.height(component), CardSize.COMPACT.height(component) / 2);
    }

    @Override
    public void layoutContainer(Container strip) {
        RobotCard[] cards = cards(strip);
        if (cards.length == 0) {
            return;
        }
        Grid grid = grid(cards.length, strip.getHeight(), strip);
        int rows = (cards.length + grid.columns() - 1) / grid.columns();
        int width = (strip.getWidth() - (grid.columns() - 1) * GAP) / grid.columns();
        for (int index = 0; index < cards.length; index++) {
            int column = index / rows;
            int row = index % rows;
            cards[index].show(grid.size());
            cards[index].setBounds(column * (width + GAP), row * (grid.height() + GAP), width, grid.height());
        }
    }

    private static RobotCard[] cards(Container strip) {
        return Stream.of(strip.getComponents()).map(RobotCard.class::cast).toArray(RobotCard[]::new);
    }

    @Override
    public Dimension preferredLayoutSize(Container strip) {
        int rows = Math.max(1, strip.getComponentCount());
        return new Dimension(UIScale.scale(WIDTH), rows * (CardSize.COMPACT.height(strip) + GAP) - GAP);
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
