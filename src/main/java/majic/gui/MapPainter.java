package majic.gui;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.List;
import majic.bot.LabAccess.Lamp;
import majic.bot.LabAccess.Tape;
import majic.bot.LabAccess.Wall;
import majic.panel.Lengths;

/** Draws a scene: grid, tape, walls, lamps, robots, scale and key, in that order. */
final class MapPainter {
    /** What scale and key need below the room. */
    static final int FOOT_PX = 24;

    private static final Stroke THIN = new BasicStroke(1);
    private static final Stroke WALL = new BasicStroke(2.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    private static final double TAPE_MM = 19;
    private static final double LEAST_TAPE_PX = 1.5;
    private static final double LAMP_PX = 4;
    private static final Color SHINE = new Color(0xFFC107);
    private static final int INSET = 12;
    private static final double BYSTANDER_MM = 120;

    private final Graphics2D g;
    private final MapView view;
    private final int width;
    private final int height;

    MapPainter(Graphics2D g, MapView view, int width, int height) {
        this.g = g;
        this.view = view;
        this.width = width;
        this.height = height;
    }

    void paint(MapScene scene) {
        paintGrid();
        scene.furnishing().tapes().forEach(this::paintTape);
        scene.walls().forEach(this::paintWall);
        scene.furnishing().lamps().forEach(this::paintLamp);
        scene.bystanders().forEach(this::paintBystander);
        List<RobotGlyph> robots = scene.robots().stream()
                .map(robot -> new RobotGlyph(robot, view))
                .toList();
        robots.forEach(robot -> robot.paintTrail(g));
        robots.forEach(robot -> robot.paintBody(g));
        robots.forEach(robot -> robot.paintTruth(g));
        paintScale();
        paintKey(scene);
    }

    private void paintGrid() {
        g.setStroke(THIN);
        g.setColor(Palette.mixed(0.14));
        double step = scaleMm();
        MapScene.Point corner = view.place(new Point(0, height));
        for (double x = Math.floor(corner.xMm() / step) * step; view.x(x) <= width; x += step) {
            g.draw(new Line2D.Double(view.x(x), 0, view.x(x), height));
        }
        for (double y = Math.floor(corner.yMm() / step) * step; view.y(y) >= 0; y += step) {
            g.draw(new Line2D.Double(0, view.y(y), width, view.y(y)));
        }
    }

    private void paintWall(Wall wall) {
        g.setStroke(WALL);
        g.setColor(Palette.mixed(0.65));
        g.draw(new Line2D.Double(view.x(wall.x1()), view.y(wall.y1()), view.x(wall.x2()), view.y(wall.y2())));
    }

    private void paintTape(Tape tape) {
        double width = Math.max(LEAST_TAPE_PX, TAPE_MM * view.pixelsPerMm());
        g.setStroke(new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.setColor(Palette.mixed(0.4));
        g.draw(new Line2D.Double(view.x(tape.x1()), view.y(tape.y1()), view.x(tape.x2()), view.y(tape.y2())));
    }

    /** As large in every scale, for nobody bumps into it. */
    private void paintLamp(Lamp lamp) {
        double x = view.x(lamp.x());
        double y = view.y(lamp.y());
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
        double x = view.x(bystander.truth().xMm());
        double y = view.y(bystander.truth().yMm());
        double radius = BYSTANDER_MM * view.pixelsPerMm();
        g.setStroke(THIN);
        g.setColor(Palette.mixed(0.5));
        g.draw(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
        g.drawString(bystander.name(), (float) (x + radius + 3), (float) y);
    }

    /** A bar as long as one square of the grid. */
    private void paintScale() {
        double length = scaleMm() * view.pixelsPerMm();
        double y = height - INSET;
        g.setStroke(new BasicStroke(2));
        g.setColor(Palette.mixed(0.8));
        g.draw(new Line2D.Double(INSET, y, INSET + length, y));
        g.draw(new Line2D.Double(INSET, y - 4, INSET, y + 4));
        g.draw(new Line2D.Double(INSET + length, y - 4, INSET + length, y + 4));
        g.drawString(Lengths.text(scaleMm()), INSET + 4, (float) y - 7);
    }

    private void paintKey(MapScene scene) {
        String key = scene.walls().isEmpty()
                ? scene.startsAreGuessed() ? "starting places unknown: drawn side by side" : ""
                : "filled: where a robot believes it is · dashed: where it is";
        int textWidth = g.getFontMetrics().stringWidth(key);
        g.setColor(Palette.mixed(0.6));
        g.drawString(key, width - INSET - textWidth, height - INSET + 3);
    }

    private double scaleMm() {
        return Lengths.round(90 / view.pixelsPerMm());
    }
}
