package majic.panel;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.stream.Stream;

/**
 * The shape of a status light.
 *
 * @param kind the kind of light
 */
record StatusLightIcon(StatusLight.Kind kind) implements ScaledIcon {
    private static final int SIZE = 12;
    private static final List<StatusLightIcon> ALL =
            Stream.of(StatusLight.Kind.values()).map(StatusLightIcon::new).toList();
    private static final Color YELLOW = new Color(0xF0A732);

    /** Returns the same icon for the same kind, since a label paints itself for another one. */
    static StatusLightIcon of(StatusLight.Kind kind) {
        return ALL.get(kind.ordinal());
    }

    @Override
    public void paint(Component on, Graphics2D pen) {
        switch (kind) {
            case QUIET -> ring(pen);
            case GOOD -> fill(pen, DrawingColors.current().good(), new Ellipse2D.Double(1, 1, 10, 10));
            case WARNING -> warning(pen);
            case ALARM -> alarm(pen);
        }
    }

    private static void ring(Graphics2D pen) {
        pen.setColor(DrawingColors.current().shape());
        pen.setStroke(DrawingColors.stroke(1.6));
        pen.draw(new Ellipse2D.Double(2, 2, 8, 8));
    }

    private static void warning(Graphics2D pen) {
        Path2D triangle = new Path2D.Double();
        triangle.moveTo(6, 0.5);
        triangle.lineTo(12, 11.5);
        triangle.lineTo(0, 11.5);
        triangle.closePath();
        fill(pen, YELLOW, triangle);
        pen.setColor(Color.BLACK);
        pen.setStroke(DrawingColors.stroke(0.8));
        pen.draw(triangle);
        pen.setStroke(DrawingColors.stroke(1.4));
        pen.draw(new Line2D.Double(6, 4.5, 6, 7.5));
        pen.draw(new Line2D.Double(6, 9.6, 6, 9.7));
    }

    private static void alarm(Graphics2D pen) {
        Path2D octagon = new Path2D.Double();
        for (int corner = 0; corner < 8; corner++) {
            double angle = Math.PI / 8 + corner * Math.PI / 4;
            double x = 6 + 6.2 * Math.cos(angle);
            double y = 6 + 6.2 * Math.sin(angle);
            if (corner == 0) {
                octagon.moveTo(x, y);
            } else {
                octagon.lineTo(x, y);
            }
        }
        octagon.closePath();
        DrawingColors colors = DrawingColors.current();
        pen.setColor(colors.alarm());
        pen.fill(octagon);
        pen.setColor(colors.paper());
        pen.setStroke(DrawingColors.stroke(1.7));
        pen.draw(new Line2D.Double(3.8, 3.8, 8.2, 8.2));
        pen.draw(new Line2D.Double(3.8, 8.2, 8.2, 3.8));
    }

    private static void fill(Graphics2D pen, Color color, Shape shape) {
        pen.setColor(color);
        pen.fill(shape);
    }

    @Override
    public int width() {
        return SIZE;
    }
}
