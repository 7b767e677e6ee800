package majic.aibo.panel;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import majic.aibo.body.BodyPoint;
import majic.panel.DrawingColors;

/** The parts of the dog as one view shows them, painted from the farthest to the nearest, in mm. */
final class PartsDrawing {
    private static final double OUTLINE_MM = 5;
    private static final double LED_MM = 5;

    /** More than a pixel, in which smooth edges end. */
    private static final int EDGE_MM = 8;

    /** How far an LED shines around its place. */
    static final double LED_REACH_MM = LedDrawing.GLOW * LED_MM;

    /** What faces away is a little darker. */
    private static final double SHADE = 0.0012;

    private final Projection view;
    private final DrawingColors colors;
    private final boolean live;
    private final LedDrawing leds;
    private final List<Part> parts = new ArrayList<>();

    private record Part(double depth, Consumer<Graphics2D> paint) {}

    /** No parts yet; LEDs shine only while the dog is connected. */
    PartsDrawing(Projection view, DrawingColors colors, boolean live) {
        this.view = view;
        this.colors = colors;
        this.live = live;
        this.leds = new LedDrawing(colors, LED_MM, colors.grey(0.8));
    }

    /** A round-ended part of this thickness. */
    void bone(BodyPoint from, BodyPoint to, double widthMm, double grey) {
        boneBehind(0, from, to, widthMm, grey);
    }

    /** The same, painted as if it were farther away. */
    void boneBehind(double furtherMm, BodyPoint from, BodyPoint to, double widthMm, double grey) {
        double depth = (view.depth(from) + view.depth(to)) / 2;
        double shaded = grey + SHADE * Math.max(0, Math.min(120, depth + 40));
        Color color = colors.grey(Math.min(0.75, shaded));
        parts.add(new Part(depth + furtherMm, pen -> capsule(pen, from, to, widthMm, color)));
    }

    /** A part of a colour of its own. */
    void part(BodyPoint from, BodyPoint to, double widthMm, Color color) {
        double depth = (view.depth(from) + view.depth(to)) / 2;
        parts.add(new Part(depth, pen -> capsule(pen, from, to, widthMm, color)));
    }

    /** A touch sensor; stands out while it is pressed. */
    void pad(BodyPoint from, BodyPoint to, double widthMm, boolean pressed) {
        double depth = (view.depth(from) + view.depth(to)) / 2;
        Color color = pressed ? colors.accent() : colors.paper();
        parts.add(new Part(depth, pen -> capsule(pen, from, to, pressed ? 1.35 * widthMm : widthMm, color)));
    }

    void led(BodyPoint at, Color light, Optional<Double> amount) {
        Optional<Double> shown = live ? amount : Optional.empty();
        parts.add(new Part(view.depth(at) - 1, pen -> leds.paint(pen, view.across(at), view.up(at), light, shown)));
    }

    void paint(Graphics2D pen) {
        parts.sort(Comparator.comparingDouble(Part::depth).reversed());
        parts.forEach(part -> part.paint().accept(pen));
    }

    private void capsule(Graphics2D pen, BodyPoint from, BodyPoint to, double widthMm, Color color) {
        Line2D line = new Line2D.Double(view.across(from), view.up(from), view.across(to), view.up(to));
        if (!reachesClip(pen, line, widthMm)) {
            return;
        }
        pen.setColor(colors.grey(0.8));
        pen.setStroke(DrawingColors.stroke(widthMm));
        pen.draw(line);
        pen.setColor(color);
        pen.setStroke(DrawingColors.stroke(widthMm - OUTLINE_MM));
        pen.draw(line);
    }

    /** Most of the dog is outside the clip when only the LEDs of its back are painted anew. */
    private static boolean reachesClip(Graphics2D pen, Line2D line, double widthMm) {
        Rectangle area = line.getBounds();
        int reach = (int) Math.ceil(widthMm / 2) + EDGE_MM;
        area.grow(reach, reach);
        return pen.hitClip(area.x, area.y, area.width, area.height);
    }
}
