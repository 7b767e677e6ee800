package majic.panel;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;

/**
 * Places the drawing of a robot as large as it can be, with lights, a map and readings beside or below it, and above all
 * a banner while it says something. In little room the readings go first, then the map; the lights stay.
 */
public final class Instruments implements LayoutManager {
    private static final int LEAST_DRAWING = 110;
    private static final int LEAST_MAP = 80;
    private static final int GOOD_MAP = 130;
    private static final int LEAST_ROWS = 3;

    /** What the drawing may lose of its size for the lights to stand two by two, or for readings beside it. */
    private static final double LOSS = 0.8;

    /** The share of a tall panel that the drawing takes. */
    private static final double UPPER = 0.6;

    private final Banner banner;
    private final Component drawing;
    private final LightsPanel lights;
    private final Component map;
    private final NumbersPanel numbers;

    /**
     * A layout of these children; all have the same parent.
     *
     * @param banner across the top, while it says something
     * @param drawing best square
     * @param lights none is left out
     * @param map any shape will do
     * @param numbers as many of them as fit
     */
    public Instruments(Banner banner, Component drawing, LightsPanel lights, Component map, NumbersPanel numbers) {
        this.banner = banner;
        this.drawing = drawing;
        this.lights = lights;
        this.map = map;
        this.numbers = numbers;
    }

    @Override
    public void layoutContainer(Container parent) {
        int gap = gap();
        Rectangle room = new Rectangle(gap, gap, parent.getWidth() - 2 * gap, parent.getHeight() - 2 * gap);
        if (banner.isVisible()) {
            int height = banner.heightIn(room.width);
            banner.setBounds(room.x, room.y, room.width, height);
            room = new Rectangle(room.x, room.y + height + gap, room.width, Math.max(0, room.height - height - gap));
        }
        if (room.height > room.width) {
            layOutAbove(room);
        } else {
            layOutBeside(room);
        }
    }

    /** Half a row. */
    private int gap() {
        return numbers.gap() / 2;
    }

    private void layOutBeside(Rectangle room) {
        int columns = side(room, 2) >= LOSS * side(room, 1) ? 2 : 1;
        int side = side(room, columns);
        drawing.setBounds(room.x, room.y, side, room.height);
        int left = side + gap();
        Rectangle column = new Rectangle(room.x + left, room.y, Math.max(0, room.width - left), room.height);
        placeLights(column, columns);
        int used = lights.heightOf(columns) + gap();
        placeMapAbove(new Rectangle(column.x, column.y + used, column.width, Math.max(0, column.height - used)));
    }

    /** The side of a square drawing beside the lights; a little smaller if that makes room for readings below them. */
    private int side(Rectangle room, int columns) {
        int side = sideBeside(room, lights.widthOf(columns));
        int withReadings = sideBeside(room, Math.max(lights.widthOf(columns), numbers.getMinimumSize().width));
        return withReadings >= LOSS * side ? withReadings : side;
    }

    private int sideBeside(Rectangle room, int width) {
        return Math.max(0, Math.min(room.height, room.width - width - gap()));
    }

    private void placeLights(Rectangle column, int columns) {
        lights.arrange(columns);
        lights.setBounds(column.x, column.y, column.width, lights.heightOf(columns));
    }

    /** The map above the readings; every reading if the map is still good, else a few of them or none. */
    private void placeMapAbove(Rectangle rest) {
        int spare = rest.height - GOOD_MAP - gap();
        int rows = Math.min(spare, numbers.heightIn(rest.width));
        boolean few = rows < LEAST_ROWS * numbers.gap() || rest.width < numbers.getMinimumSize().width;
        int height = few ? rest.height : rest.height - rows - gap();
        place(map, new Rectangle(rest.x, rest.y, rest.width, height), height >= LEAST_MAP);
        place(numbers, new Rectangle(rest.x, rest.y + height + gap(), rest.width, rows), !few);
    }

    /** Below the drawing the lights and the readings at the left, the map at the right. */
    private void layOutAbove(Rectangle room) {
        int height = Math.min(room.width, (int) (UPPER * room.height));
        drawing.setBounds(room.x, room.y, room.width, height);
        int half = widthBelow(room.width - gap());
        int top = room.y + height + gap();
        Rectangle left = new Rectangle(room.x, top, half, room.y + room.height - top);
        placeLights(left, 1);
        int used = lights.heightOf(1) + gap();
        boolean fits = half >= numbers.getMinimumSize().width && left.height - used >= LEAST_ROWS * numbers.gap();
        place(numbers, new Rectangle(left.x, top + used, half, left.height - used), fits);
        int rest = room.width - half - gap();
        place(map, new Rectangle(left.x + half + gap(), top, rest, left.height), rest >= LEAST_MAP);
    }

    /** Half of the room, but what lights and readings need as long as the map is still good. */
    private int widthBelow(int width) {
        int half = Math.max(lights.widthOf(1), width / 2);
        int needed = numbers.getMinimumSize().width;
        return width - needed >= GOOD_MAP ? Math.max(half, needed) : half;
    }

    private static void place(Component child, Rectangle bounds, boolean fits) {
        child.setVisible(fits);
        child.setBounds(fits ? bounds : new Rectangle());
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        int height = Math.max(LEAST_DRAWING, lights.heightOf(1)) + (banner.isVisible() ? 2 * numbers.gap() : 0);
        return new Dimension(lights.widthOf(1) + LEAST_DRAWING + 3 * gap(), height + 2 * gap());
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
