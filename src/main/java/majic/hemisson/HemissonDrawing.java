package majic.hemisson;

import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JPanel;
import majic.panel.Ink;

/**
 * The robot from above, its front upward, as large as the room allows: its body, and around it the bars of its sensors.
 * For the event thread.
 */
final class HemissonDrawing extends JPanel {
    private static final long serialVersionUID = 1;

    /** From the middle to the figures beyond the bars, mm. */
    private static final double SHOWN_MM = 122;

    private transient HemissonView view;

    HemissonDrawing(HemissonView view) {
        this.view = view;
        setOpaque(false);
        getAccessibleContext().setAccessibleName("the Hemisson from above with its proximity readings");
        setToolTipText("Bars: infra-red proximity, 0 nothing to 255 near; bars inside look at the ground");
    }

    /** Shows another moment; on the event dispatch thread. */
    void show(HemissonView newView) {
        view = newView;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        Ink.prepare(pen);
        pen.translate(getWidth() / 2.0, getHeight() / 2.0);
        double pxPerMm = Math.min(getWidth(), getHeight()) / (2 * SHOWN_MM);
        Ink ink = view.connected() ? Ink.ofTheLook() : Ink.ofTheLook().faded();
        new BodyDrawing(view, ink, pxPerMm).paint(pen);
        new BarsDrawing(view.seen(), ink, pxPerMm).paint(pen);
        pen.dispose();
    }
}
