package majic.panel.map;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import majic.panel.DrawingColors;
import majic.panel.ScaledIcon;

/**
 * The symbol on a map's button, drawn in the colour of text.
 *
 * @param action the button's action
 * @param size pixels
 */
record MapIcon(MapAction action, int size) implements ScaledIcon {
    /** Size of the grid in which the symbols are designed. */
    private static final double GRID = 14;

    @Override
    public void paint(Component on, Graphics2D pen) {
        pen.scale(size / GRID, size / GRID);
        pen.setColor(DrawingColors.current().grey(0.85));
        pen.setStroke(DrawingColors.stroke(1.5));
        switch (action) {
            case ZOOM_IN -> plus(pen);
            case ZOOM_OUT -> line(pen, 2, 7, 12, 7);
            case FIT -> corners(pen);
            case FOLLOW -> target(pen);
            case AHEAD_UP -> pointer(pen);
            case CLEAR -> bin(pen);
            case LEFT, RIGHT, UP, DOWN -> {}
        }
    }

    private static void line(Graphics2D pen, double x1, double y1, double x2, double y2) {
        pen.draw(new Line2D.Double(x1, y1, x2, y2));
    }

    private static void plus(Graphics2D pen) {
        line(pen, 2, 7, 12, 7);
        line(pen, 7, 2, 7, 12);
    }

    private static void corners(Graphics2D pen) {
        for (int quarter = 0; quarter < 4; quarter++) {
            line(pen, 1.5, 1.5, 5, 1.5);
            line(pen, 1.5, 1.5, 1.5, 5);
            pen.rotate(Math.PI / 2, GRID / 2, GRID / 2);
        }
    }

    private static void target(Graphics2D pen) {
        pen.draw(new Ellipse2D.Double(3, 3, 8, 8));
        pen.fill(new Ellipse2D.Double(5.5, 5.5, 3, 3));
        for (int quarter = 0; quarter < 4; quarter++) {
            line(pen, 7, 0.5, 7, 3);
            pen.rotate(Math.PI / 2, GRID / 2, GRID / 2);
        }
    }

    private static void pointer(Graphics2D pen) {
        Path2D pointer = new Path2D.Double();
        pointer.moveTo(7, 1);
        pointer.lineTo(12, 12.5);
        pointer.lineTo(7, 9.5);
        pointer.lineTo(2, 12.5);
        pointer.closePath();
        pen.draw(pointer);
    }

    private static void bin(Graphics2D pen) {
        line(pen, 1.5, 3.5, 12.5, 3.5);
        line(pen, 5, 1.5, 9, 1.5);
        pen.draw(new Rectangle2D.Double(3, 3.5, 8, 9));
        line(pen, 5.7, 6, 5.7, 10);
        line(pen, 8.3, 6, 8.3, 10);
    }

    @Override
    public int width() {
        return size;
    }
}
