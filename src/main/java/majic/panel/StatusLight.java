package majic.panel;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import javax.swing.JLabel;

/**
 * Shows one condition of a robot as a word and a shape; colour only adds to them. A disabled light shows an old
 * condition: grey words and a ring. Must be used on the event dispatch thread.
 */
public final class StatusLight extends JLabel {
    private static final long serialVersionUID = 1;

    /** The severity of a condition, and its shape. */
    public enum Kind implements ScaledIcon {
        /** Nothing to report: a ring. */
        QUIET,
        /** In working order: a disc. */
        GOOD,
        /** Needs attention: a triangle. */
        WARNING,
        /** Prevents motion: an octagon with a cross. */
        ALARM;

        private static final int SIZE = 12;
        private static final Color YELLOW = new Color(0xF0A732);

        @Override
        public void paint(Component on, Graphics2D pen) {
            switch (this) {
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

    /**
     * Creates a light of kind {@link Kind#QUIET}.
     *
     * @param name of the condition, for tests and screen readers
     * @param tip what the condition means
     */
    public StatusLight(String name, String tip) {
        setName(name);
        setToolTipText(tip);
        setIconTextGap(5);
        show(Kind.QUIET, name);
    }

    /**
     * Shows the condition.
     *
     * @param kind its shape
     * @param words its words, short
     */
    public void show(Kind kind, String words) {
        setIcon(kind);
        setDisabledIcon(Kind.QUIET);
        setText(words);
        getAccessibleContext().setAccessibleDescription(getToolTipText());
    }

    /**
     * Returns the severity shown last.
     *
     * @return the kind given last
     */
    public Kind kind() {
        return (Kind) getIcon();
    }
}
