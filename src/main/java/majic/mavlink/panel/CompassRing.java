package majic.mavlink.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import javax.swing.UIManager;
import majic.panel.DrawingColors;
import majic.panel.Horizon;
import majic.text.Texts;

/**
 * An artificial horizon inside a compass, which turns so that the heading is at the top, where it is shown as a figure.
 * For the event dispatch thread.
 */
final class CompassRing extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(CompassRing.class);
    private static final int DIAMETER = 124;
    private static final int TICK_DEG = 30;
    private static final int QUARTER_DEG = 90;
    private static final int FULL_DEG = 360;

    /** Copters and rovers tilt little. */
    private static final double HALF_VIEW_DEG = 30;

    private static final List<String> QUARTERS = List.of("north", "east", "south", "west");

    private final Horizon horizon = new Horizon(DIAMETER, HALF_VIEW_DEG);
    private int headingDeg = -1;

    CompassRing() {
        super(null);
        setName("compass");
        setOpaque(false);
        setPreferredSize(new Dimension(UIScale.scale(DIAMETER), UIScale.scale(DIAMETER)));
        add(horizon);
        describe();
    }

    /** Shows an attitude; grey if it is an old one. */
    void show(Optional<VehicleScene.Attitude> attitude, boolean current) {
        boolean isNew = current && attitude.map(VehicleScene.Attitude::current).orElse(true);
        horizon.setEnabled(isNew);
        horizon.show(attitude.map(now -> new Horizon.Tilt(now.pitchDeg(), now.rollDeg()))
                .orElse(null));
        int degrees = attitude.map(now -> Math.floorMod(Math.round(now.compassDeg()), FULL_DEG))
                .orElse(-1);
        if (degrees != headingDeg || isNew != isEnabled()) {
            headingDeg = degrees;
            setEnabled(isNew);
            describe();
            repaint();
        }
    }

    private void describe() {
        String words = headingDeg < 0 ? TEXTS.get("compass.none") : TEXTS.get("compass", headingDeg);
        setToolTipText(words);
        getAccessibleContext().setAccessibleName(words);
    }

    private String figure() {
        return headingDeg < 0 ? "–" : headingDeg + "°";
    }

    @Override
    public void doLayout() {
        int inset = ringWidth() + UIScale.scale(1);
        int side = Math.min(getWidth(), getHeight()) - 2 * inset;
        horizon.setBounds((getWidth() - side) / 2, (getHeight() - side) / 2, side, side);
    }

    private int ringWidth() {
        return getFontMetrics(UIManager.getFont("Label.font")).getHeight();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        DrawingColors colors =
                isEnabled() ? DrawingColors.current() : DrawingColors.current().faded();
        double radius = Math.min(getWidth(), getHeight()) / 2.0 - 1;
        pen.translate(getWidth() / 2.0, getHeight() / 2.0);
        pen.setColor(colors.grey(0.08));
        pen.fill(new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius));
        if (headingDeg >= 0) {
            paintRose(pen, colors, radius);
        }
        pen.dispose();
    }

    /** Draws the figure above the horizon, which would cover it otherwise. */
    @Override
    protected void paintChildren(Graphics graphics) {
        super.paintChildren(graphics);
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        pen.translate(getWidth() / 2.0, getHeight() / 2.0);
        paintFigure(pen, Math.min(getWidth(), getHeight()) / 2.0 - 1);
        pen.dispose();
    }

    private void paintRose(Graphics2D pen, DrawingColors colors, double radius) {
        FontMetrics metrics = pen.getFontMetrics();
        double middle = radius - ringWidth() / 2.0;
        for (int degrees = 0; degrees < FULL_DEG; degrees += TICK_DEG) {
            Graphics2D turned = (Graphics2D) pen.create();
            turned.rotate(Math.toRadians(degrees - headingDeg));
            if (degrees % QUARTER_DEG == 0) {
                String letter = TEXTS.get(QUARTERS.get(degrees / QUARTER_DEG));
                turned.setColor(degrees == 0 ? colors.alarm() : colors.line());
                turned.drawString(letter, -metrics.stringWidth(letter) / 2f, (float)
                        (-middle + (metrics.getAscent() - metrics.getDescent()) / 2.0));
            } else {
                turned.setColor(colors.grey(0.6));
                turned.setStroke(DrawingColors.stroke(1.3));
                turned.draw(new Line2D.Double(0, -middle - UIScale.scale(3f), 0, -middle + UIScale.scale(3f)));
            }
            turned.dispose();
        }
    }

    private void paintFigure(Graphics2D pen, double radius) {
        FontMetrics metrics = pen.getFontMetrics();
        double width = metrics.stringWidth("888°") + UIScale.scale(6f);
        double height = metrics.getHeight();
        DrawingColors colors = DrawingColors.current();
        RoundRectangle2D box = new RoundRectangle2D.Double(-width / 2, -radius, width, height, 5, 5);
        pen.setColor(colors.paper());
        pen.fill(box);
        pen.setColor(colors.grey(0.6));
        pen.setStroke(DrawingColors.stroke(1));
        pen.draw(box);
        Path2D pointer = new Path2D.Double();
        float size = UIScale.scale(4f);
        pointer.moveTo(-size, -radius + height);
        pointer.lineTo(size, -radius + height);
        pointer.lineTo(0, -radius + height + size);
        pointer.closePath();
        pen.fill(pointer);
        pen.setColor(isEnabled() ? colors.line() : UIManager.getColor("Label.disabledForeground"));
        pen.drawString(figure(), -metrics.stringWidth(figure()) / 2f, (float) (-radius + metrics.getAscent()));
    }
}
