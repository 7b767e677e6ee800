package majic.gui.command;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import majic.gui.kit.Palette;

/** Underlines the wrong word of a line with a zigzag. Must be used on the event dispatch thread. */
final class WrongWord {
    private static final double STEP = 2;

    private final JTextComponent field;
    private int from;
    private int to;

    WrongWord(JTextComponent field) {
        this.field = field;
    }

    /** Sets the wrong word; an empty range underlines nothing. */
    void set(int start, int end) {
        from = start;
        to = end;
        field.repaint();
    }

    void paint(Graphics graphics) {
        if (from >= to || to > field.getDocument().getLength()) {
            return;
        }
        Graphics2D pen = (Graphics2D) graphics.create();
        try {
            Rectangle2D first = field.modelToView2D(from);
            Rectangle2D last = field.modelToView2D(to);
            pen.clip(field.getVisibleRect());
            pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            pen.setColor(Palette.error());
            pen.draw(zigzag(first.getX(), last.getX(), first.getMaxY() - 1));
        } catch (BadLocationException e) {
            throw new IllegalStateException("the word is in the line", e);
        } finally {
            pen.dispose();
        }
    }

    private static Path2D zigzag(double left, double right, double bottom) {
        Path2D path = new Path2D.Double();
        path.moveTo(left, bottom);
        boolean up = true;
        for (double x = left + STEP; x < right; x += STEP) {
            path.lineTo(x, up ? bottom - STEP : bottom);
            up = !up;
        }
        return path;
    }
}
