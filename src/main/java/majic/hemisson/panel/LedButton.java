package majic.hemisson.panel;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import javax.swing.JButton;
import majic.panel.DrawingColors;
import majic.text.Texts;

/**
 * An LED or the buzzer on the drawing in its last confirmed state; with a dotted ring while the robot has not yet
 * confirmed a click. For the event dispatch thread.
 */
public final class LedButton extends JButton {
    private static final long serialVersionUID = 1;
    private static final double HALO = 1.7;
    private static final Texts TEXTS = Texts.of(LedButton.class);

    private final LedOrBuzzer part;
    private double radiusPx = 6;
    private boolean on;
    private boolean waiting;
    private boolean faded;

    LedButton(LedOrBuzzer part) {
        this.part = part;
        setName(part.parameter());
        setOpaque(false);
        setContentAreaFilled(false);
        setBorderPainted(false);
        setFocusPainted(false);
        setRolloverEnabled(true);
        setRequestFocusEnabled(false);
        getAccessibleContext().setAccessibleName(part.words());
        setToolTipText("");
    }

    LedOrBuzzer part() {
        return part;
    }

    public boolean isOn() {
        return on;
    }

    /** How large it is drawn. */
    void scale(double pixels) {
        radiusPx = pixels;
    }

    void show(boolean believedOn, boolean stillWaiting, boolean connected) {
        on = believedOn;
        waiting = stillWaiting;
        faded = !connected;
        getAccessibleContext().setAccessibleDescription(on ? "on" : "off");
        repaint();
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        return waiting
                ? TEXTS.get(on ? "led.waiting.on" : "led.waiting.off", part.words(), part.parameter())
                : TEXTS.get(on ? "led.on" : "led.off", part.words(), part.parameter());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(20, 20);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        pen.translate(getWidth() / 2.0, getHeight() / 2.0);
        DrawingColors colors = faded ? DrawingColors.current().faded() : DrawingColors.current();
        if (getModel().isRollover() || isFocusOwner() || waiting) {
            paintRing(pen, colors);
        }
        if (part == LedOrBuzzer.BUZZER) {
            paintBuzzer(pen, colors);
        } else {
            paintLed(pen, colors);
        }
        pen.dispose();
    }

    private void paintRing(Graphics2D pen, DrawingColors colors) {
        pen.setColor(colors.accent());
        float[] dots = {2, 2};
        pen.setStroke(waiting ? new java.awt.BasicStroke(1.4f, 0, 0, 1, dots, 0) : DrawingColors.stroke(1.4));
        pen.draw(circle(HALO * radiusPx));
    }

    private void paintLed(Graphics2D pen, DrawingColors colors) {
        if (on) {
            pen.setColor(colors.wash(0.3));
            pen.fill(circle(HALO * radiusPx));
        }
        pen.setColor(on ? colors.accent() : colors.paper());
        pen.fill(circle(radiusPx));
        pen.setColor(colors.grey(0.8));
        pen.setStroke(DrawingColors.stroke(1.3));
        pen.draw(circle(radiusPx));
    }

    private void paintBuzzer(Graphics2D pen, DrawingColors colors) {
        double unit = radiusPx / 5;
        Path2D horn = new Path2D.Double();
        horn.moveTo(-6 * unit, -2 * unit);
        horn.lineTo(-3 * unit, -2 * unit);
        horn.lineTo(0, -5 * unit);
        horn.lineTo(0, 5 * unit);
        horn.lineTo(-3 * unit, 2 * unit);
        horn.lineTo(-6 * unit, 2 * unit);
        horn.closePath();
        pen.setColor(on ? colors.accent() : colors.paper());
        pen.fill(horn);
        pen.setColor(on ? colors.accent() : colors.grey(0.8));
        pen.setStroke(DrawingColors.stroke(1.3));
        pen.draw(horn);
        for (double wave = 3 * unit; on && wave <= 6 * unit; wave += 3 * unit) {
            pen.draw(new Arc2D.Double(-wave, -wave, 2 * wave, 2 * wave, -45, 90, Arc2D.OPEN));
        }
    }

    private static Ellipse2D circle(double radius) {
        return new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius);
    }
}
