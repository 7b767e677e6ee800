package majic.gui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseEvent;
import java.util.Locale;
import javax.swing.JPanel;
import javax.swing.UIManager;
import majic.bot.Pose;
import org.jspecify.annotations.Nullable;

/**
 * The bird's-eye view of the team: every robot with its number, heading and trail, and with a lab the room and where
 * the robots really are. Shows everything by itself until somebody zooms or drags; a double click goes back to that.
 */
final class TeamMap extends JPanel {
    private static final long serialVersionUID = 1L;

    private transient MapScene scene = MapScene.EMPTY;
    private transient @Nullable MapView chosen;

    TeamMap() {
        setName("teamMap");
        setOpaque(true);
        setPreferredSize(new Dimension(640, 420));
        setMinimumSize(new Dimension(240, 160));
        setToolTipText("");
        getAccessibleContext().setAccessibleName("Team map");
        MapMouse mouse = new MapMouse(this);
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
    }

    /** Shows another moment. */
    void show(MapScene newScene) {
        scene = newScene;
        repaint();
    }

    MapScene scene() {
        return scene;
    }

    /** How the floor lies on this component now. */
    MapView view() {
        MapView view = chosen;
        return view != null ? view : MapView.fitting(Extent.of(scene), getWidth(), getHeight() - MapPainter.FOOT_PX);
    }

    /** Shows the floor as somebody chose; null to show everything again. */
    void choose(@Nullable MapView view) {
        chosen = view;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        Color floor = UIManager.getColor("TextArea.background");
        g.setColor(floor);
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(UIManager.getFont("Label.font"));
        new MapPainter(g, view(), getWidth(), getHeight()).paint(scene);
        g.dispose();
    }

    @Override
    public @Nullable String getToolTipText(MouseEvent event) {
        MapView view = view();
        return scene.robots().stream()
                .filter(robot -> new RobotGlyph(robot, view).covers(event.getX(), event.getY()))
                .map(TeamMap::describe)
                .findFirst()
                .orElse(null);
    }

    private static String describe(MapScene.Robot robot) {
        Pose at = robot.believed();
        return String.format(
                Locale.ROOT,
                "%d %s: x %.0f mm, y %.0f mm, heading %.0f° on the map",
                robot.number(),
                robot.label(),
                at.xMm(),
                at.yMm(),
                at.headingDeg());
    }
}
