package majic.gui.map;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import majic.bot.Pose;
import majic.gui.kit.ClosesByEsc;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.RobotSelection;
import majic.nav.grid.NavigationMap.Place;
import majic.panel.map.ZoomableMap;
import majic.team.Member;
import majic.team.Team;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * The map of the team: every robot with its number, heading and trail, and with a lab the room and the robots' true
 * poses. Fits everything into view until the map is zoomed or dragged; a double click returns to that.
 */
public final class TeamMap extends ZoomableMap implements ClosesByEsc {
    private static final Texts TEXTS = Texts.of(TeamMap.class);
    private static final long serialVersionUID = 1L;

    private final transient TeamFloor floor;
    private transient @Nullable WaypointDrawing waypoints;

    public TeamMap() {
        this(new TeamFloor());
    }

    private TeamMap(TeamFloor floor) {
        super(floor);
        HelpTopic.set(this, "the-main-screen");
        this.floor = floor;
        setName("teamMap");
        setPreferredSize(new Dimension(640, 420));
        setMinimumSize(new Dimension(240, 160));
        getAccessibleContext().setAccessibleName(TEXTS.get("map"));
    }

    /**
     * Marks the selected robots, and lets a click select one.
     *
     * @param menu opens the context menu of a robot
     */
    public void select(Team team, RobotSelection selection, MapSelection.Menu menu) {
        addMouseListener(new MapSelection(this, team, selection, menu));
        selection.addListener(() -> {
            floor.mark(selection.numbers());
            repaint();
        });
    }

    /**
     * Lets a robot be dragged to its place with Shift.
     *
     * @param placed receives a robot that was placed
     */
    public void place(Team team, CommandChannel channel, Consumer<Member> placed) {
        RobotPlacing placing = new RobotPlacing(this, team, channel, placed);
        addMouseListener(placing);
        addMouseMotionListener(placing);
        floor.allowPlacing();
    }

    /**
     * Lets the selected robots be sent to places, and the places on the map be named, moved and removed by the mouse.
     *
     * @param propose receives a command in which the user replaces the word {@code NAME}
     */
    public void usePlaces(CommandChannel channel, Consumer<String> propose) {
        DriveMouse drive = new DriveMouse(this, channel);
        PlaceMouse places = new PlaceMouse(this, drive, channel, propose);
        for (MouseAdapter mouse : List.of(drive, places)) {
            addMouseListener(mouse);
            addMouseMotionListener(mouse);
        }
    }

    /**
     * Makes {@link #drawWaypoints} possible.
     *
     * @param openScript receives the script of waypoints that were drawn
     * @param showError receives why there is no script yet, as a sentence
     */
    public void useWaypoints(Consumer<String> openScript, Consumer<String> showError) {
        waypoints = new WaypointDrawing(this, floor, openScript, showError);
    }

    /**
     * Lets the user draw waypoints for the selected robots: until that ends, the buttons of the mouse and some keys
     * serve it alone.
     *
     * @throws IllegalStateException without {@link #useWaypoints}
     */
    public void drawWaypoints() {
        if (waypoints == null) {
            throw new IllegalStateException("this map shows no waypoints");
        }
        waypoints.begin();
        requestFocusInWindow();
    }

    private @Nullable WaypointDrawing drawing() {
        return waypoints != null && waypoints.isActive() ? waypoints : null;
    }

    /** Returns whether waypoints are drawn, which Esc gives up. */
    @Override
    public boolean hasToClose() {
        return drawing() != null;
    }

    @Override
    protected void processMouseEvent(MouseEvent event) {
        WaypointDrawing drawing = drawing();
        boolean crosses = event.getID() == MouseEvent.MOUSE_ENTERED || event.getID() == MouseEvent.MOUSE_EXITED;
        if (drawing == null || crosses) {
            super.processMouseEvent(event);
        } else {
            drawing.mouse(event);
        }
    }

    @Override
    protected void processMouseMotionEvent(MouseEvent event) {
        WaypointDrawing drawing = drawing();
        if (drawing == null || event.getID() == MouseEvent.MOUSE_MOVED) {
            super.processMouseMotionEvent(event);
        } else {
            drawing.mouse(event);
        }
    }

    /** Returns the selected robots; the only one if none is selected. */
    List<MapScene.Robot> chosen() {
        return floor.chosen();
    }

    /** Draws an arrow where robots are to drive to; null ends that. */
    void previewTarget(@Nullable Pose place) {
        floor.previewTarget(place);
        repaint();
    }

    /** Returns the place with a name at a pixel. */
    Optional<Place> placeAt(Point pixel) {
        return floor.placeAt(pixel, view());
    }

    /** Returns whether there is a map on which places can have names. */
    boolean hasPicture() {
        return floor.hasPicture();
    }

    /** Draws a place where it is being dragged to; null ends that. */
    void previewPlace(@Nullable Place place) {
        floor.previewPlace(place);
        repaint();
    }

    /** Returns the robot at a pixel; of several the selected one. */
    Optional<MapScene.Robot> topRobotAt(Point pixel) {
        return floor.topRobotAt(pixel, view());
    }

    /** Draws a robot where it is being dragged to; null ends that. */
    void preview(MapScene.@Nullable Robot robot) {
        floor.preview(robot);
        repaint();
    }

    /** Returns the numbers of the robots that are drawn at a pixel, in increasing order. */
    List<Integer> robotsAt(Point pixel) {
        return floor.robotsAt(pixel, view());
    }

    /** Shows another scene, and describes it for screen readers. */
    public void show(MapScene scene) {
        floor.show(scene);
        getAccessibleContext().setAccessibleDescription(floor.description());
        repaint();
    }
}
