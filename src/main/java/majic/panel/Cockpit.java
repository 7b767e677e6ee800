package majic.panel;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;

/**
 * Places a view of a robot with what its camera sees, controls and readings, beside the view or, where there is more
 * height than width, below it. In little room the readings go first, then the picture gets smaller; controls stay.
 */
public final class Cockpit implements LayoutManager {
    private static final int LEAST_VIEW = 130;
    private static final int LEAST_PICTURE = 60;
    private static final int LEAST_ROWS = 3;

    /** Of the width beside the view. */
    private static final double COLUMN = 0.38;

    /** More height than this for the width, and the view stands on top. */
    private static final double TALL = 1.15;

    private final Component view;
    private final Component picture;
    private final Component controls;
    private final NumbersPanel numbers;

    /**
     * A layout of these children; all have the same parent.
     *
     * @param view gets all the room that the others leave
     * @param picture keeps the shape of its preferred size
     * @param controls with the height they prefer and at least the width
     * @param numbers as many of them as fit
     */
    public Cockpit(Component view, Component picture, Component controls, NumbersPanel numbers) {
        this.view = view;
        this.picture = picture;
        this.controls = controls;
        this.numbers = numbers;
    }

    @Override
    public void layoutContainer(Container parent) {
        int gap = gap();
        Rectangle room = new Rectangle(gap, gap, parent.getWidth() - 2 * gap, parent.getHeight() - 2 * gap);
        if (room.height > TALL * room.width && room.width >= 2 * leastColumn() + gap) {
            layOutAbove(room);
        } else {
            layOutBeside(room);
        }
    }

    private int gap() {
        return numbers.gap() / 2;
    }

    private int leastColumn() {
        return controls.getMinimumSize().width;
    }

    private int pictureHeight(int width) {
        Dimension shape = picture.getPreferredSize();
        return width * shape.height / shape.width;
    }

    private void layOutBeside(Rectangle room) {
        int least = leastColumn();
        int width = Math.max(least, Math.min((int) (COLUMN * room.width), room.width - room.height));
        int controlsHeight = controls.getPreferredSize().height;
        int left = room.height - controlsHeight - gap();
        int pictureHeight = Math.min(pictureHeight(width), Math.max(LEAST_PICTURE, left));
        int x = room.x + room.width - width;
        view.setBounds(room.x, room.y, Math.max(0, room.width - width - gap()), room.height);
        picture.setBounds(x, room.y, width, pictureHeight);
        controls.setBounds(x, room.y + pictureHeight + gap(), width, controlsHeight);
        int used = pictureHeight + controlsHeight + 2 * gap();
        placeNumbers(new Rectangle(x, room.y + used, width, room.height - used));
    }

    private void layOutAbove(Rectangle room) {
        int half = (room.width - gap()) / 2;
        int controlsHeight = controls.getPreferredSize().height;
        int strip = Math.max(controlsHeight, pictureHeight(half));
        int spare = room.height - strip - gap() - room.width;
        int rows = spare < (LEAST_ROWS + 1) * numbers.gap() ? 0 : Math.min(spare, numbers.heightIn(room.width) + gap());
        int y = room.y + room.height - rows - strip;
        view.setBounds(room.x, room.y, room.width, y - gap() - room.y);
        picture.setBounds(room.x, y, half, strip);
        controls.setBounds(room.x + room.width - half, y, half, controlsHeight);
        placeNumbers(new Rectangle(room.x, y + strip + gap(), room.width, rows - gap()));
    }

    private void placeNumbers(Rectangle rest) {
        boolean fits = rest.width >= numbers.getMinimumSize().width && rest.height >= LEAST_ROWS * numbers.gap();
        numbers.setVisible(fits);
        numbers.setBounds(fits ? rest : new Rectangle());
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        int height = controls.getPreferredSize().height + LEAST_PICTURE + 3 * gap();
        return new Dimension(leastColumn() + LEAST_VIEW + 3 * gap(), height);
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
