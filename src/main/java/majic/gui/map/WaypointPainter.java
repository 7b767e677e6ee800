package majic.gui.map;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.UIManager;
import majic.gui.kit.LineArt;
import majic.gui.kit.Palette;
import majic.panel.DrawingColors;
import majic.panel.map.MapView;
import majic.text.Texts;

/** Draws waypoints while they are added: a line with a number at each, the place of the next one, and the keys. */
final class WaypointPainter {
    private static final Texts TEXTS = Texts.of(WaypointPainter.class);
    private static final Stroke LINE = new BasicStroke(2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    private static final double RADIUS_PX = 10;
    private static final double CROSS_PX = 7;
    private static final int INSET = 12;
    private static final int MARGIN = 4;
    private static final String BETWEEN = " · ";
    private static final FontRenderContext ON_SCREEN = new FontRenderContext(null, true, true);

    private final Graphics2D g;
    private final MapView view;
    private final FontMetrics metrics;

    /** Creates the painter; the pen has the font of labels. */
    WaypointPainter(Graphics2D g, MapView view) {
        this.g = g;
        this.view = view;
        this.metrics = g.getFontMetrics();
    }

    void paint(List<Waypoint> waypoints) {
        g.setStroke(LINE);
        g.setColor(Palette.link());
        Path2D line = new Path2D.Double();
        for (Waypoint waypoint : waypoints) {
            Point2D at = pixel(waypoint);
            if (line.getCurrentPoint() == null) {
                line.moveTo(at.getX(), at.getY());
            } else {
                line.lineTo(at.getX(), at.getY());
            }
        }
        g.draw(line);
        waypoints.stream()
                .filter(waypoint -> waypoint.at().withHeading())
                .forEach(waypoint -> g.draw(MapPainter.arrow(waypoint.at().pose(), view)));
        for (int index = 0; index < waypoints.size(); index++) {
            paintNumber(pixel(waypoints.get(index)), "" + (index + 1));
        }
        paintCross();
        paintKeys();
    }

    private Point2D pixel(Waypoint waypoint) {
        return view.pixel(waypoint.at().pose().xMm(), waypoint.at().pose().yMm());
    }

    private void paintNumber(Point2D at, String number) {
        double radius = Math.max(UIScale.scale((float) RADIUS_PX), metrics.stringWidth(number) / 2.0 + MARGIN);
        Shape disc = new LineArt().circle(at.getX(), at.getY(), radius).shape();
        g.setColor(Palette.paper());
        g.fill(disc);
        g.setColor(Palette.link());
        g.draw(disc);
        g.setColor(Palette.text());
        g.drawString(number, (float) (at.getX() - metrics.stringWidth(number) / 2.0), (float)
                (at.getY() + (metrics.getAscent() - metrics.getDescent()) / 2.0));
    }

    /** Marks the place of the waypoint that a key adds. */
    private void paintCross() {
        double x = view.width() / 2.0;
        double y = view.height() / 2.0;
        g.setColor(Palette.text());
        g.draw(new LineArt()
                .line(x - CROSS_PX, y, x + CROSS_PX, y)
                .line(x, y - CROSS_PX, x, y + CROSS_PX)
                .shape());
    }

    /** Draws what mouse and keys do above the scale. */
    private void paintKeys() {
        int height = keysHeightPx(view.width());
        double top = view.height() - UIScale.scale(MapPainter.FOOT_PX) - height;
        g.setColor(DrawingColors.translucent(Palette.paper(), 0.85));
        g.fill(new Rectangle2D.Double(0, top, view.width(), height));
        g.setColor(Palette.text());
        double y = top + MARGIN + metrics.getAscent();
        for (String line : lines(view.width())) {
            g.drawString(line, INSET, (float) y);
            y += lineHeightPx();
        }
    }

    /** Returns the height of what {@link #paint} writes above the scale of a map of a width. */
    static int keysHeightPx(int widthPx) {
        return lines(widthPx).size() * lineHeightPx() + 2 * MARGIN;
    }

    private static Font font() {
        return UIManager.getFont("Label.font");
    }

    private static int lineHeightPx() {
        return (int) Math.ceil(font().getLineMetrics(BETWEEN, ON_SCREEN).getHeight());
    }

    /** Distributes the keys on as many lines as the width needs. */
    private static List<String> lines(int widthPx) {
        List<String> lines = new ArrayList<>();
        for (String key : keys()) {
            String between = BETWEEN;
            for (String part : fits(key, widthPx) ? List.of(key) : List.of(key.split(" "))) {
                append(lines, between, part, widthPx);
                between = " ";
            }
        }
        return lines;
    }

    private static void append(List<String> lines, String between, String part, int widthPx) {
        int last = lines.size() - 1;
        if (!lines.isEmpty() && fits(lines.get(last) + between + part, widthPx)) {
            lines.set(last, lines.get(last) + between + part);
        } else {
            lines.add(part);
        }
    }

    private static boolean fits(String line, int widthPx) {
        return font().getStringBounds(line, ON_SCREEN).getWidth() <= widthPx - 2 * INSET;
    }

    /** Returns what mouse and keys do while waypoints are drawn. */
    static List<String> keys() {
        return Stream.of(
                        "waypoints.add",
                        "waypoints.heading",
                        "waypoints.remove",
                        "waypoints.finish",
                        "waypoints.giveUp")
                .map(TEXTS::get)
                .toList();
    }
}
