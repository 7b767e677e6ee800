package majic.gui.map;

import com.formdev.flatlaf.util.UIScale;
import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import javax.swing.UIManager;
import majic.bot.Pose;
import majic.gui.kit.LineArt;
import majic.gui.kit.Palette;
import majic.lab.LabAccess.Lamp;
import majic.lab.LabAccess.Tape;
import majic.lab.LabAccess.Wall;
import majic.nav.grid.NavigationMap;
import majic.panel.DrawingColors;
import majic.panel.map.MapView;
import majic.text.Texts;

/**
 * Draws a scene: map with forbidden lines, tape, walls, lamps, ways, robots and labels, in that order; then a legend.
 */
public final class MapPainter {
    private static final Texts TEXTS = Texts.of(MapPainter.class);
    /** Height in pixels of the space for scale and legend below the room. */
    public static final int FOOT_PX = 24;

    private static final Stroke THIN = new BasicStroke(1);
    private static final Stroke WALL = new BasicStroke(2.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    private static final double TAPE_MM = 19;
    private static final double LEAST_TAPE_PX = 1.5;
    private static final double LAMP_PX = 4;
    private static final double PLACE_PX = 4;
    private static final double ARROW_PX = 40;
    private static final Color SHINE = new Color(0xFFC107);
    private static final int INSET = 12;
    private static final int MARGIN = 4;

    /** Maximum length in pixels of the scale at the other end of that space. */
    private static final int SCALE_PX = 115;

    private static final double BYSTANDER_MM = 120;

    private final Graphics2D g;
    private final MapView view;
    private final LabelRoom room = new LabelRoom();

    MapPainter(Graphics2D g, MapView view) {
        this.g = g;
        this.view = view;
    }

    /**
     * Draws a scene.
     *
     * @param selected the numbers of the robots to mark as selected
     */
    void paint(MapScene scene, Set<Integer> selected) {
        g.setFont(UIManager.getFont("Label.font"));
        MapPicture map = scene.map();
        if (map != null) {
            map.paint(g, view);
            map.forbidden().forEach(this::paintForbidden);
        }
        scene.furnishing().tapes().forEach(this::paintTape);
        scene.walls().forEach(this::paintWall);
        scene.furnishing().lamps().forEach(this::paintLamp);
        List<RobotGlyph> robots = scene.robots().stream()
                .map(robot -> new RobotGlyph(robot, view))
                .toList();
        robots.forEach(robot -> robot.paintTrail(g));
        robots.forEach(robot -> robot.paintWay(g));
        robots.forEach(robot -> robot.paintUncertainty(g));
        robots.forEach(robot -> robot.paintBody(g));
        robots.forEach(robot -> robot.paintTruth(g));
        paintNumbers(robots, selected);
        scene.bystanders().forEach(this::paintBystander);
        if (map != null) {
            map.places().forEach(this::paintPlace);
        }
        robots.stream().filter(robot -> selected.contains(robot.number())).forEach(robot -> robot.paintSelection(g));
    }

    /**
     * Draws the numbers that cover no other number, first those of robots that need attention or are selected, and then
     * heights, and which robots wait.
     */
    private void paintNumbers(List<RobotGlyph> robots, Set<Integer> selected) {
        robots.stream()
                .sorted(Comparator.comparing((RobotGlyph robot) -> !robot.isAlarming())
                        .thenComparing(robot -> !selected.contains(robot.number())))
                .forEach(robot -> robot.paintNumber(g, room));
        robots.forEach(robot -> robot.paintHeight(g, room));
        robots.forEach(robot -> robot.paintWaits(g, room));
    }

    /** Draws a robot where it is being dragged to, with its pose beside it. */
    void paintPreview(MapScene.Robot robot, String place) {
        g.setComposite(AlphaComposite.SrcOver.derive(0.7f));
        RobotGlyph glyph = new RobotGlyph(robot, view);
        glyph.paintBody(g);
        glyph.paintNumber(g, new LabelRoom());
        g.setComposite(AlphaComposite.SrcOver);
        glyph.paintTruth(g);
        glyph.paintSelection(g);
        paintBeside(robot.reported(), robot.bodyMm() * view.pxPerMm(), place);
    }

    /** Draws an arrow where a robot is to drive to, with the place beside it. */
    void paintTarget(Pose target, String place) {
        g.setStroke(WALL);
        g.setColor(Palette.link());
        g.draw(arrow(target, view));
        paintBeside(target, ARROW_PX, place);
    }

    /** Returns an arrow from a place to where a robot is to look there. */
    static Shape arrow(Pose target, MapView view) {
        Point2D at = view.pixel(target.xMm(), target.yMm());
        AffineTransform turned = AffineTransform.getTranslateInstance(at.getX(), at.getY());
        turned.rotate(-Math.toRadians(target.headingDeg()));
        return turned.createTransformedShape(new LineArt()
                .line(0, 0, ARROW_PX, 0)
                .line(ARROW_PX * 0.7, -ARROW_PX * 0.2, ARROW_PX, 0, ARROW_PX * 0.7, ARROW_PX * 0.2)
                .circle(0, 0, PLACE_PX)
                .shape());
    }

    /** Draws a text beside a place, on a margin of the floor's colour so that it is readable over walls and robots. */
    private void paintBeside(Pose place, double radiusPx, String text) {
        Point2D at = view.pixel(place.xMm(), place.yMm());
        double aside = radiusPx + INSET;
        FontMetrics metrics = g.getFontMetrics();
        int width = metrics.stringWidth(text);
        boolean fits = at.getX() + aside + width <= view.width();
        double x = fits ? at.getX() + aside : at.getX() - aside - width;
        double top = at.getY() - metrics.getAscent();
        int height = metrics.getAscent() + metrics.getDescent();
        g.setColor(DrawingColors.translucent(Palette.paper(), 0.75));
        g.fill(new RoundRectangle2D.Double(x - MARGIN, top, width + 2 * MARGIN, height, MARGIN, MARGIN));
        g.setColor(Palette.text());
        g.drawString(text, (float) x, (float) at.getY());
    }

    private void paintWall(Wall wall) {
        g.setStroke(WALL);
        g.setColor(Palette.mixed(0.65));
        g.draw(line(wall.x1(), wall.y1(), wall.x2(), wall.y2()));
    }

    private void paintForbidden(NavigationMap.ForbiddenLine forbidden) {
        g.setStroke(THIN);
        g.setColor(Palette.forbidden());
        g.draw(line(forbidden.fromXmm(), forbidden.fromYmm(), forbidden.toXmm(), forbidden.toYmm()));
    }

    private void paintTape(Tape tape) {
        double width = Math.max(LEAST_TAPE_PX, TAPE_MM * view.pxPerMm());
        g.setStroke(new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.setColor(Palette.shape());
        g.draw(line(tape.x1(), tape.y1(), tape.x2(), tape.y2()));
    }

    private Line2D line(double x1, double y1, double x2, double y2) {
        return new Line2D.Double(view.pixel(x1, y1), view.pixel(x2, y2));
    }

    /** Draws a lamp in the same size at every scale, because no robot can run into it. */
    private void paintLamp(Lamp lamp) {
        Point2D at = view.pixel(lamp.x(), lamp.y());
        double x = at.getX();
        double y = at.getY();
        Ellipse2D bulb = new Ellipse2D.Double(x - LAMP_PX, y - LAMP_PX, 2 * LAMP_PX, 2 * LAMP_PX);
        g.setColor(SHINE);
        g.fill(bulb);
        g.setStroke(THIN);
        g.setColor(Palette.mixed(0.65));
        g.draw(bulb);
        for (int ray = 0; ray < 8; ray++) {
            double right = LAMP_PX * Math.cos(ray * Math.PI / 4);
            double down = LAMP_PX * Math.sin(ray * Math.PI / 4);
            g.draw(new Line2D.Double(x + 1.5 * right, y + 1.5 * down, x + 2.1 * right, y + 2.1 * down));
        }
    }

    private void paintBystander(MapScene.Bystander bystander) {
        Point2D at = view.pixel(bystander.truth().xMm(), bystander.truth().yMm());
        double x = at.getX();
        double y = at.getY();
        double radius = BYSTANDER_MM * view.pxPerMm();
        g.setStroke(THIN);
        g.setColor(Palette.faint());
        g.draw(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
        FontMetrics metrics = g.getFontMetrics();
        Rectangle2D label = new Rectangle2D.Double(
                x + radius + 3,
                y - metrics.getAscent(),
                metrics.stringWidth(bystander.name()),
                metrics.getAscent() + metrics.getDescent());
        if (room.take(label)) {
            g.drawString(bystander.name(), (float) label.getX(), (float) y);
        }
    }

    /** Draws a place as a square with its name. */
    void paintPlace(NavigationMap.Place place) {
        Point2D at = view.pixel(place.pose().xMm(), place.pose().yMm());
        g.setStroke(THIN);
        g.setColor(Palette.link());
        g.draw(new Rectangle2D.Double(at.getX() - PLACE_PX, at.getY() - PLACE_PX, 2 * PLACE_PX, 2 * PLACE_PX));
        FontMetrics metrics = g.getFontMetrics();
        Rectangle2D label = new Rectangle2D.Double(
                at.getX() + PLACE_PX + MARGIN,
                at.getY() - metrics.getAscent() / 2.0,
                metrics.stringWidth(place.name()),
                metrics.getAscent());
        if (room.take(label)) {
            g.drawString(place.name(), (float) label.getX(), (float) (label.getMaxY() - metrics.getDescent() / 2.0));
        }
    }

    /** Draws the legend. */
    void paintKey(MapScene scene) {
        String key = keys(scene).stream().filter(this::fits).findFirst().orElse("");
        int textWidth = g.getFontMetrics().stringWidth(key);
        g.setColor(Palette.faint());
        g.drawString(key, view.width() - INSET - textWidth, view.height() - INSET + 3);
    }

    /** Returns the texts of the legend, the shorter forms last. */
    private static List<String> keys(MapScene scene) {
        if (!scene.walls().isEmpty() && scene.startsAreGuessed()) {
            return List.of(TEXTS.get("legend.room.unknown"), TEXTS.get("legend.unknown"));
        }
        if (!scene.walls().isEmpty()) {
            return List.of(TEXTS.get("legend.room.long"), TEXTS.get("legend.room"), TEXTS.get("legend.room.short"));
        }
        return scene.startsAreGuessed() ? List.of(TEXTS.get("legend.free"), TEXTS.get("legend.free.short")) : List.of();
    }

    private boolean fits(String key) {
        return g.getFontMetrics().stringWidth(key) <= view.width() - UIScale.scale(SCALE_PX) - INSET;
    }
}
