package majic.panel;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;

/** Gives readings the room they claim, beside or below a drawing, which gets the rest. */
public final class NumbersBeside implements LayoutManager {
    private final Component drawing;
    private final NumbersPanel numbers;

    /**
     * A layout of two children.
     *
     * @param drawing any size will do for it
     * @param numbers what is known in figures
     */
    public NumbersBeside(Component drawing, NumbersPanel numbers) {
        this.drawing = drawing;
        this.numbers = numbers;
    }

    @Override
    public void layoutContainer(Container parent) {
        int gap = numbers.gap() / 2;
        Rectangle room = new Rectangle(gap, gap, parent.getWidth() - 2 * gap, parent.getHeight() - 2 * gap);
        Rectangle claimed = numbers.claim(room);
        numbers.setBounds(claimed);
        boolean atFoot = claimed.y > room.y;
        int width = atFoot ? room.width : room.width - claimed.width - 2 * gap;
        int height = atFoot ? room.height - claimed.height - 2 * gap : room.height;
        drawing.setBounds(gap, gap, Math.max(0, width), Math.max(0, height));
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        Dimension least = numbers.getMinimumSize();
        int gaps = numbers.gap();
        return new Dimension(least.width + gaps, least.height + gaps);
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        return minimumLayoutSize(parent);
    }

    @Override
    public void addLayoutComponent(String name, Component component) {
        // both children are known already
    }

    @Override
    public void removeLayoutComponent(Component component) {
        // both stay
    }
}
