package majic.gui.map;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.lab.LabAccess.Wall;
import majic.nav.grid.NavigationMap.Place;
import majic.panel.map.MapContent;
import majic.panel.map.MapView;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** The floor of the team map, as in the last scene. Must be used on the event dispatch thread. */
final class TeamFloor implements MapContent {
    private static final Texts TEXTS = Texts.of(TeamFloor.class);
    /** Extent that an empty map shows. */
    private static final Rectangle2D EMPTY = new Rectangle2D.Double(-1500, -1000, 3000, 2000);

    private static final double MARGIN_MM = 200;

    /** Radius in mm shown around robots with an unknown environment. */
    private static final double FREE_MM = 600;

    /** How far from its centre a place can be clicked. */
    private static final double PLACE_PX = 8;

    private MapScene scene = MapScene.EMPTY;
    private Set<Integer> selected = Set.of();
    private MapScene.@Nullable Robot preview;
    private @Nullable Place placePreview;
    private @Nullable Pose target;
    private @Nullable List<Waypoint> waypoints;
    private boolean placeable;

    void show(MapScene newScene) {
        scene = newScene;
    }

    /** Marks these robots as selected, and no others. */
    void mark(Collection<Integer> numbers) {
        selected = Set.copyOf(numbers);
    }

    /** Makes the tips say how a robot is placed. */
    void allowPlacing() {
        placeable = true;
    }

    /** Draws a robot where it is being dragged to; null ends that. */
    void preview(MapScene.@Nullable Robot robot) {
        preview = robot;
    }

    /** Draws a place where it is being dragged to; null ends that. */
    void previewPlace(@Nullable Place place) {
        placePreview = place;
    }

    /** Draws an arrow where robots are to drive to; null ends that. */
    void previewTarget(@Nullable Pose place) {
        target = place;
    }

    /** Draws waypoints, and how further ones are added; null ends that. */
    void previewWaypoints(@Nullable List<Waypoint> drawn) {
        waypoints = drawn;
    }

    /** Returns the robots as {@code 1 Pioneer, 2 Copter at 3.0 m}, or the keys that draw waypoints. */
    String description() {
        List<Waypoint> drawn = waypoints;
        return drawn == null
                ? scene.robots().stream().map(TeamFloor::name).collect(Collectors.joining(", "))
                : TEXTS.get("waypoints.count", drawn.size()) + "; " + String.join("; ", WaypointPainter.keys());
    }

    private static String name(MapScene.Robot robot) {
        String name = robot.number() + " " + robot.label();
        return robot.isInAir() ? TEXTS.get("robot.inAir", name, robot.metres()) : name;
    }

    /** Returns the selected robots; the only one if none is selected. */
    List<MapScene.Robot> chosen() {
        List<MapScene.Robot> chosen = scene.robots().stream()
                .filter(robot -> selected.contains(robot.number()))
                .toList();
        return chosen.isEmpty() && scene.robots().size() == 1 ? scene.robots() : chosen;
    }

    boolean hasPicture() {
        return scene.map() != null;
    }

    /** Returns the place that is drawn at a pixel. */
    Optional<Place> placeAt(Point2D pixel, MapView view) {
        MapPicture map = scene.map();
        return map == null
                ? Optional.empty()
                : map.places().stream()
                        .filter(place ->
                                view.pixel(place.pose().xMm(), place.pose().yMm())
                                                .distance(pixel)
                                        <= PLACE_PX)
                        .findFirst();
    }

    /** Returns the robot that is drawn at a pixel; of several a selected one if there is one. */
    Optional<MapScene.Robot> topRobotAt(Point2D pixel, MapView view) {
        return robotsUnder(pixel, view)
                .min(Comparator.comparing((MapScene.Robot robot) -> !selected.contains(robot.number())));
    }

    /** Returns the numbers of the robots that are drawn at a pixel. */
    List<Integer> robotsAt(Point2D pixel, MapView view) {
        return robotsUnder(pixel, view).map(MapScene.Robot::number).toList();
    }

    private Stream<MapScene.Robot> robotsUnder(Point2D pixel, MapView view) {
        return scene.robots().stream().filter(robot -> new RobotGlyph(robot, view).covers(pixel));
    }

    @Override
    public void paint(Graphics2D pen, MapView view) {
        MapPainter painter = new MapPainter(pen, view);
        painter.paint(scene, selected);
        if (waypoints == null) {
            painter.paintKey(scene);
        } else {
            new WaypointPainter(pen, view).paint(waypoints);
        }
        if (preview != null) {
            painter.paintPreview(preview, place(preview.reported()));
        }
        if (placePreview != null) {
            painter.paintPlace(placePreview);
        }
        if (target != null) {
            painter.paintTarget(target, place(target));
        }
    }

    @Override
    public Rectangle2D extent() {
        Rectangle2D room = null;
        for (Wall wall : scene.walls()) {
            room = joined(room, around(wall.x1(), wall.y1(), 0));
            room = joined(room, around(wall.x2(), wall.y2(), 0));
        }
        Rectangle2D all = room == null ? null : grown(room, MARGIN_MM);
        MapPicture map = scene.map();
        if (map != null) {
            all = joined(all, grown(map.extent(), MARGIN_MM));
        }
        double margin = room == null ? FREE_MM : MARGIN_MM;
        for (MapScene.Robot robot : scene.robots()) {
            Pose at = robot.reported();
            Rectangle2D way = new Rectangle2D.Double(at.xMm(), at.yMm(), 0, 0);
            robot.trail().extend(way);
            robot.way().corners().forEach(corner -> way.add(corner.xMm(), corner.yMm()));
            all = joined(all, grown(way, margin));
            // Outside of the room a selected robot needs space for its frame.
            double beside = room != null && room.contains(at.xMm(), at.yMm()) ? MARGIN_MM : FREE_MM;
            all = joined(all, around(at.xMm(), at.yMm(), robot.bodyMm() + beside));
        }
        return all == null ? EMPTY : all;
    }

    private static Rectangle2D around(double xMm, double yMm, double radiusMm) {
        return grown(new Rectangle2D.Double(xMm, yMm, 0, 0), radiusMm);
    }

    private static Rectangle2D grown(Rectangle2D floor, double mm) {
        return new Rectangle2D.Double(
                floor.getX() - mm, floor.getY() - mm, floor.getWidth() + 2 * mm, floor.getHeight() + 2 * mm);
    }

    private static Rectangle2D joined(@Nullable Rectangle2D one, Rectangle2D other) {
        return one == null ? other : one.createUnion(other);
    }

    @Override
    public int footPx(int widthPx) {
        int keys = waypoints == null ? 0 : WaypointPainter.keysHeightPx(widthPx);
        return UIScale.scale(MapPainter.FOOT_PX) + keys;
    }

    /** Clears the trails shown so far; robots and room stay. */
    @Override
    public void clear() {
        scene.robots().forEach(robot -> robot.trail().clear());
    }

    @Override
    public String tip(double xMm, double yMm, MapView view) {
        if (waypoints != null) {
            return TEXTS.get("waypoints.here", Math.round(xMm), Math.round(yMm));
        }
        Point2D mouse = view.pixel(xMm, yMm);
        boolean alone = robotsAt(mouse, view).size() == 1;
        List<String> robots = robotsUnder(mouse, view)
                .map(robot -> describe(alone && placeable ? placeableKey(robot) : "robot", robot))
                .toList();
        return robots.isEmpty() ? MapContent.super.tip(xMm, yMm, view) : String.join("\n", robots);
    }

    private static String placeableKey(MapScene.Robot robot) {
        return robot.truth() == null ? "robot.placeable" : "robot.inLab";
    }

    private static String describe(String key, MapScene.Robot robot) {
        Pose at = robot.reported();
        String place = TEXTS.get(
                key,
                robot.number(),
                robot.label(),
                Math.round(at.xMm()),
                Math.round(at.yMm()),
                Math.round(at.headingDeg()));
        String high = robot.isInAir() ? "\n" + TEXTS.get("robot.height", robot.metres()) : "";
        String why = robot.way().waits();
        return place + high + (why.isEmpty() ? "" : "\n" + TEXTS.get("robot.waits", why));
    }

    private static String place(Pose at) {
        return TEXTS.get("place", Math.round(at.xMm()), Math.round(at.yMm()), Math.round(at.headingDeg()));
    }
}
