package majic.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JMenu;
import javax.swing.JPopupMenu;
import majic.bot.Pose;
import majic.gui.TestWindow;
import majic.nav.file.MapFiles;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Waypoints that are drawn on the map of the team, on which a robot is placed and a place has a name. */
class WaypointsWindowTest {
    private static final String MAP = "teamMap";
    private static final Pose DESK = new Pose(1000, 500, 90);
    private static final Pose ROBOT = new Pose(0, 0, 90);

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @TempDir
    private Path folder;

    @BeforeEach
    void beginToDraw() throws IOException {
        Path file = folder.resolve("office.yaml");
        OccupancyGrid grid = OccupancyGrid.of(new Pose(-1000, -1000, 0), 50, 80, 60, (column, row) -> 0.1);
        MapFiles.write(file, NavigationMap.of(grid).with(new NavigationMap.Place("desk", DESK, true)));
        window.parser.parseText("map open \"" + file + '"');
        window.await("the map", () -> map().placeAt(pixel(DESK)).isPresent());
        window.add("//one").place(ROBOT);
        window.await(
                "the robot on the map", () -> map().topRobotAt(pixel(ROBOT)).isPresent());
        draw();
    }

    private void draw() {
        assertThat(isOffered()).isTrue();
        window.run(window.entry("Draw Waypoints")::doClick);
        window.await("the map to have the focus", map()::isFocusOwner);
    }

    private TeamMap map() {
        return window.find(MAP, TeamMap.class);
    }

    private Point pixel(Pose at) {
        Point2D pixel = map().view().pixel(at.xMm(), at.yMm());
        return new Point((int) Math.round(pixel.getX()), (int) Math.round(pixel.getY()));
    }

    private void click(double xMm, double yMm) {
        window.clickAt(MAP, pixel(new Pose(xMm, yMm, 0)));
    }

    private void drag(Pose from, Pose to) {
        window.run(() -> {
            send(MouseEvent.MOUSE_PRESSED, pixel(from));
            send(MouseEvent.MOUSE_DRAGGED, pixel(to));
            send(MouseEvent.MOUSE_RELEASED, pixel(to));
        });
    }

    private void send(int id, Point at) {
        send(id, at, 1);
    }

    private void send(int id, Point at, int clicks) {
        map().dispatchEvent(new MouseEvent(
                map(), id, 0, InputEvent.BUTTON1_DOWN_MASK, at.x, at.y, clicks, false, MouseEvent.BUTTON1));
    }

    /** Waits for the editor, and returns the lines in it. */
    private List<String> script() {
        return window.awaitShowing("script", RSyntaxTextArea.class)
                .getText()
                .lines()
                .toList();
    }

    private String hint() {
        return String.valueOf(map().getAccessibleContext().getAccessibleDescription());
    }

    /** Returns the coordinates behind a command of one robot. */
    private static Pose place(String line) {
        String[] words = line.split(" ");
        assertThat(words[1]).isEqualTo("goto");
        return new Pose(
                Double.parseDouble(words[2]),
                Double.parseDouble(words[3]),
                words.length > 4 ? Double.parseDouble(words[4]) : 0);
    }

    @Test
    void clicksBecomeAScriptOfTheSelectedRobotInTheEditor() {
        click(500, 1000);
        click(1000, 500);
        click(2000, -500);
        window.press(KeyEvent.VK_ENTER);

        List<String> script = script();
        assertThat(script)
                .hasSize(4)
                .startsWith("# Goes to 3 places of the map.")
                .contains("1 goto desk");
        assertThat(place(script.get(1)).distanceMm(new Pose(500, 1000, 0))).isLessThan(20);
        assertThat(place(script.get(3)).distanceMm(new Pose(2000, -500, 0))).isLessThan(20);
        assertThat(map().hasToClose()).isFalse();
    }

    @Test
    void aDragIsAWaypointWithAHeadingAndTheMapStays() {
        Pose there = new Pose(500, 1000, 0);
        Point before = pixel(there);
        drag(there, new Pose(500, 1500, 0));
        assertThat(pixel(there)).isEqualTo(before);
        window.press(KeyEvent.VK_ENTER);

        Pose target = place(script().get(1));
        assertThat(target.distanceMm(there)).isLessThan(20);
        assertThat(target.headingDeg()).isBetween(88.0, 92.0);
    }

    @Test
    void aDoubleClickAddsTheLastWaypoint() {
        click(500, 1000);
        window.doubleClickAt(MAP, pixel(DESK));

        assertThat(script()).hasSize(3).endsWith("1 goto desk");
    }

    @Test
    void theMapStaysAsItIsAfterADoubleClick() {
        window.push("map zoom_in");
        Point before = pixel(ROBOT);
        window.doubleClickAt(MAP, pixel(DESK));

        assertThat(script()).hasSize(2);
        assertThat(pixel(ROBOT)).isEqualTo(before);
    }

    @Test
    void aSlowClickDuringWhichTheMouseMovesIsOneWaypoint() {
        click(500, 1000);
        Point desk = pixel(DESK);
        window.run(() -> {
            send(MouseEvent.MOUSE_PRESSED, desk);
            send(MouseEvent.MOUSE_DRAGGED, new Point(desk.x + 1, desk.y), 0);
            send(MouseEvent.MOUSE_RELEASED, new Point(desk.x + 1, desk.y), 0);
        });

        assertThat(hint()).startsWith("waypoints: 2;");
        assertThat(map().hasToClose()).isTrue();
    }

    @Test
    void backspaceRemovesTheLastWaypoint() {
        click(500, 1000);
        click(1000, 500);
        click(2000, -500);
        window.press(KeyEvent.VK_BACK_SPACE);
        window.press(KeyEvent.VK_ENTER);

        assertThat(script()).hasSize(3).endsWith("1 goto desk");
    }

    @Test
    void theFirstEscGivesUpAndTheNextOneStops() {
        click(500, 1000);
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(map().hasToClose()).isFalse();
        assertThat(window.team.isLatched()).isFalse();
        assertThat(window.isShowing("script")).isFalse();

        window.press(KeyEvent.VK_ESCAPE);
        assertThat(window.team.isLatched()).isTrue();
    }

    @Test
    void f12StopsWhileWaypointsAreDrawn() {
        window.press(KeyEvent.VK_F12);

        window.await("the stop", window.team::isLatched);
        assertThat(map().hasToClose()).isTrue();
    }

    @Test
    void keysAloneAddWhatIsInTheMiddle() {
        Pose middle = map().view().pose(new Point(map().getWidth() / 2, map().getHeight() / 2));
        window.press(KeyEvent.VK_SPACE);
        window.press(KeyEvent.VK_RIGHT);
        window.press(KeyEvent.VK_SPACE);
        window.press(KeyEvent.VK_ENTER);

        assertThat(place(script().get(1)).distanceMm(middle)).isLessThan(2);
        assertThat(place(script().get(2)).xMm()).isGreaterThan(middle.xMm());
    }

    @Test
    void withoutAWaypointThereIsNoScript() {
        window.press(KeyEvent.VK_ENTER);

        window.awaitMessage("There is no waypoint yet; click on the map to add one, or press Esc to give up.");
        assertThat(map().hasToClose()).isTrue();
    }

    @Test
    void screenReadersGetTheKeysAndTheNumberOfWaypoints() {
        click(500, 1000);

        assertThat(hint()).startsWith("waypoints: 1; Click").contains("Backspace", "Enter", "Esc");
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(hint()).isEqualTo("1 Toy");
    }

    @Test
    void theTipHasTheCoordinatesAlone() {
        assertThat(window.tipAt(MAP, pixel(ROBOT))).matches("x [-−]?\\d mm, y [-−]?\\d mm");
    }

    @Test
    void clicksSelectRobotsAgainAfterwards() {
        window.add("//two").place(new Pose(2000, 0, 180));
        window.await(
                "the other robot",
                () -> map().topRobotAt(pixel(new Pose(2000, 0, 0))).isPresent());
        click(2000, 0);
        assertThat(window.isShowing("bot1")).isTrue();
        window.press(KeyEvent.VK_ESCAPE);
        click(2000, 0);

        window.await("the selection", () -> window.isShowing("bot2"));
    }

    @Test
    void theEntryNeedsASelectedRobot() {
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(isOffered()).isTrue();

        window.team.remove(1);
        window.await("no robot", () -> !isOffered());
    }

    private boolean isOffered() {
        JMenu menu = (JMenu) ((JPopupMenu) window.entry("Draw Waypoints").getParent()).getInvoker();
        window.run(() -> menu.setSelected(true));
        boolean offered = window.entry("Draw Waypoints").isEnabled();
        window.run(() -> menu.setSelected(false));
        return offered;
    }
}
