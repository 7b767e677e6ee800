package majic.panel;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;

/**
 * Places a view with gauges, lights and readings beside or below it, whichever leaves the larger view. In little room the
 * readings go first; gauges and lights stay.
 */
public final class Dashboard implements LayoutManager {
    /** A view smaller than this is no use. */
    private static final int LEAST_VIEW = 110;

    /** How much larger the view must get for the lights to stand in a way that is less easily read. */
    private static final double WORTH_IT = 1.15;

    private static final int LEAST_ROWS = 3;

    private final Component view;
    private final Component gauges;
    private final LightsPanel lights;
    private final NumbersPanel numbers;

    /**
     * A layout of these children; all have the same parent.
     *
     * @param view gets all the room that the others leave
     * @param gauges with the height they prefer and at least the width
     * @param lights as many beside each other as there is room for
     * @param numbers as many of them as fit
     */
    public Dashboard(Component view, Component gauges, LightsPanel lights, NumbersPanel numbers) {
        this.view = view;
        this.gauges = gauges;
        this.lights = lights;
        this.numbers = numbers;
    }

    @Override
    public void layoutContainer(Container parent) {
        int gap = gap();
        Rectangle room = new Rectangle(gap, gap, parent.getWidth() - 2 * gap, parent.getHeight() - 2 * gap);
        int columns = 2;
        if (shorterBeside(room, 1) > WORTH_IT * shorterBeside(room, 2)) {
            columns = 1;
        }
        if (shorterAbove(room) > WORTH_IT * shorterBeside(room, columns)) {
            layOutAbove(room);
        } else {
            layOutBeside(room, columns);
        }
    }

    /** Half a row. */
    private int gap() {
        return numbers.gap() / 2;
    }

    private int gaugesHeight() {
        return gauges.getPreferredSize().height;
    }

    private int columnWidth(int columns) {
        return Math.max(gauges.getMinimumSize().width, lights.widthOf(columns));
    }

    private int columnHeight(int columns) {
        return gaugesHeight() + gap() + lights.heightOf(columns);
    }

    /** The shorter side of a view with a column beside it; 0 if the column does not fit. */
    private int shorterBeside(Rectangle room, int columns) {
        return columnHeight(columns) > room.height
                ? 0
                : Math.min(room.height, room.width - columnWidth(columns) - gap());
    }

    private void layOutBeside(Rectangle room, int columns) {
        int width = columnWidth(columns);
        int x = room.x + room.width - width;
        view.setBounds(room.x, room.y, Math.max(0, room.width - width - gap()), room.height);
        gauges.setBounds(x, room.y, width, gaugesHeight());
        lights.arrange(columns);
        lights.setBounds(x, room.y + gaugesHeight() + gap(), width, lights.heightOf(columns));
        int used = columnHeight(columns) + gap();
        placeNumbers(new Rectangle(x, room.y + used, width, room.height - used));
    }

    /** Gauges and lights side by side below the view, the lights as flat as the width allows. */
    private int columnsBelow(Rectangle room) {
        int width = (room.width - 2 * gap()) / 2;
        return width >= lights.widthOf(2) ? 2 : 1;
    }

    private int stripHeight(Rectangle room) {
        return Math.max(gaugesHeight(), lights.heightOf(columnsBelow(room)));
    }

    private int shorterAbove(Rectangle room) {
        boolean fits = (room.width - 2 * gap()) / 2 >= columnWidth(1);
        return fits ? Math.min(room.width, room.height - stripHeight(room) - gap()) : 0;
    }

    private void layOutAbove(Rectangle room) {
        int columns = columnsBelow(room);
        int strip = stripHeight(room);
        int spare = room.height - strip - gap() - room.width;
        int rows =
                spare - gap() < LEAST_ROWS * numbers.gap() ? 0 : Math.min(spare, numbers.heightIn(room.width) + gap());
        int y = room.y + room.height - rows - strip;
        int half = (room.width - 2 * gap()) / 2;
        view.setBounds(room.x, room.y, room.width, y - gap() - room.y);
        gauges.setBounds(room.x, y, half, gaugesHeight());
        lights.arrange(columns);
        lights.setBounds(room.x + room.width - half, y, half, lights.heightOf(columns));
        placeNumbers(new Rectangle(room.x, y + strip + gap(), room.width, rows - gap()));
    }

    private void placeNumbers(Rectangle rest) {
        boolean fits = rest.width >= numbers.getMinimumSize().width && rest.height >= LEAST_ROWS * numbers.gap();
        numbers.setVisible(fits);
        numbers.setBounds(fits ? rest : new Rectangle());
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(columnWidth(1) + LEAST_VIEW + 3 * gap(), columnHeight(2) + 2 * gap());
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        return minimumLayoutSize(parent);
    }

    @Override
    public void addLayoutComponent(String name, Component component) {
        // all children are known already
    }

    @Override
    public void removeLayoutComponent(Component component) {
        // all stay
    }
}
