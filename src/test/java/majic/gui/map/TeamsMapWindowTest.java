package majic.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JMenu;
import javax.swing.JPopupMenu;
import majic.bot.Pose;
import majic.gui.TestWindow;
import majic.gui.command.CommandLine;
import majic.nav.file.MapFiles;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A map of the team in the window, with a place that has a name. */
class TeamsMapWindowTest {
    private static final Pose DESK = new Pose(1000, 500, 90);
    private static final int CTRL = InputEvent.CTRL_DOWN_MASK | InputEvent.BUTTON1_DOWN_MASK;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void openAMap() throws IOException {
        file = folder.resolve("office.yaml");
        OccupancyGrid grid = OccupancyGrid.of(new Pose(-1000, -1000, 0), 50, 80, 60, (column, row) -> 0.1);
        MapFiles.write(file, NavigationMap.of(grid).with(new NavigationMap.Place("desk", DESK, true)));
        window.parser.parseText("map open \"" + file + '"');
        window.await("the map", () -> map().placeAt(pixel(DESK)).isPresent());
    }

    private TeamMap map() {
        return window.find("teamMap", TeamMap.class);
    }

    private Point pixel(Pose at) {
        Point2D pixel = map().view().pixel(at.xMm(), at.yMm());
        return new Point((int) Math.round(pixel.getX()), (int) Math.round(pixel.getY()));
    }

    private void send(int id, int modifiers, Point at, boolean menu) {
        map().dispatchEvent(new MouseEvent(
                map(), id, 0, modifiers, at.x, at.y, 1, menu, menu ? MouseEvent.BUTTON3 : MouseEvent.BUTTON1));
    }

    /** Adds a robot that is placed on the map, and waits until it is drawn there. */
    private void addAt(Pose at) {
        window.add("//" + at.xMm()).place(at);
        window.await("the robot on the map", () -> map().topRobotAt(pixel(at)).isPresent());
    }

    private void drag(int modifiers, Pose from, Pose to) {
        window.run(() -> {
            send(MouseEvent.MOUSE_PRESSED, modifiers, pixel(from), false);
            send(MouseEvent.MOUSE_DRAGGED, modifiers, pixel(to), false);
            send(MouseEvent.MOUSE_RELEASED, modifiers, pixel(to), false);
        });
    }

    /** Waits until a line is submitted, and returns the two numbers behind its beginning. */
    private Pose awaitPlace(String beginning, String end) {
        Pattern line = Pattern.compile("(?m)^.*" + beginning + " (-?\\d+) (-?\\d+)" + end + "$");
        window.await(
                "a line " + beginning,
                () -> line.matcher(window.text("messages")).find());
        Matcher found = line.matcher(window.text("messages"));
        assertThat(found.find()).isTrue();
        return new Pose(Double.parseDouble(found.group(1)), Double.parseDouble(found.group(2)), 0);
    }

    private void openMenuAt(Pose at) {
        window.run(() -> send(MouseEvent.MOUSE_PRESSED, InputEvent.BUTTON3_DOWN_MASK, pixel(at), true));
    }

    private Optional<NavigationMap.Place> place(String name) {
        return window.session.map().get().flatMap(known -> known.place(name));
    }

    @Test
    void shiftAndDragMovesAPlaceWithItsHeading() {
        Pose there = new Pose(2000, 1000, 90);
        drag(InputEvent.SHIFT_DOWN_MASK | InputEvent.BUTTON1_DOWN_MASK, DESK, there);

        window.await("the place there", () -> place("desk").orElseThrow().pose().distanceMm(there) < 20);
        assertThat(place("desk").orElseThrow().withHeading()).isTrue();
        assertThat(place("desk").orElseThrow().pose().headingDeg()).isEqualTo(90);
    }

    @Test
    void aRightClickOnTheFloorSendsTheSelectedRobotsThere() {
        Pose there = new Pose(500, 1000, 0);
        addAt(new Pose(0, 0, 90));
        addAt(new Pose(2000, 0, 180));
        window.clickWithCtrl("tab2");
        openMenuAt(there);
        window.click("driveHere");

        assertThat(awaitPlace("1,2 goto", "").distanceMm(there)).isLessThan(20);
    }

    @Test
    void theHeadingIsThatOfTheDragWithCtrlAndTheMapStays() {
        Pose there = new Pose(500, 1000, 0);
        addAt(new Pose(0, 0, 90));
        Point before = pixel(there);
        drag(CTRL, there, new Pose(500, 1500, 0));

        assertThat(awaitPlace("1 goto", " (?:89|90|91)").distanceMm(there)).isLessThan(20);
        assertThat(pixel(there)).isEqualTo(before);
    }

    @Test
    void aRobotThatWasNotPlacedGetsThePlaceInItsOwnFrame() {
        Pose there = new Pose(500, 1000, 0);
        window.add("//one");
        window.add("//two");
        window.await(
                "the robots", () -> map().robotsAt(pixel(new Pose(0, -1000, 0))).contains(2));
        window.clickWithCtrl("tab2");
        openMenuAt(there);
        window.click("driveHere");

        assertThat(awaitPlace("1 goto", "").distanceMm(there)).isLessThan(20);
        assertThat(awaitPlace("2 goto", "").distanceMm(new Pose(500, 2000, 0))).isLessThan(20);
    }

    @Test
    void aRightClickOnAPlaceSendsTheRobotToIt() {
        addAt(new Pose(0, 0, 90));
        openMenuAt(DESK);
        window.click("driveToPlace");

        window.awaitMessage("1 goto desk");
    }

    @Test
    void withoutARobotNoneIsSent() {
        drag(CTRL, DESK, new Pose(500, 1500, 0));
        openMenuAt(DESK);

        assertThat(window.isShowing("renamePlace")).isTrue();
        assertThat(window.isShowing("driveToPlace")).isFalse();
    }

    @Test
    void theMenuSendsTheSelectedRobotsToAPlaceOrToCoordinates() {
        addAt(new Pose(0, 0, 90));
        JMenu places = (JMenu) window.entry("Drive the Selected Robots to");
        window.run(() -> places.setSelected(true));
        window.run(() -> places.getItem(places.getItemCount() - 1).doClick());
        assertThat(window.text("commandLine")).isEqualTo("1 goto ");
        assertThat(window.find("commandLine", CommandLine.class).getCaretPosition())
                .isEqualTo("1 goto ".length());

        window.run(() -> places.getItem(0).doClick());
        window.awaitMessage("1 goto desk");
    }

    @Test
    void aRightClickOnTheFloorOffersToNameThePlace() {
        openMenuAt(new Pose(0, 1000, 0));
        window.click("namePlace");

        CommandLine line = window.find("commandLine", CommandLine.class);
        assertThat(line.getText()).matches("map place NAME -?\\d+ 9\\d\\d|map place NAME -?\\d+ 10\\d\\d");
        assertThat(line.getSelectedText()).isEqualTo("NAME");
    }

    @Test
    void aRightClickOnAPlaceOffersToRenameAndRemoveIt() {
        openMenuAt(DESK);
        window.click("renamePlace");
        assertThat(window.text("commandLine")).isEqualTo("map place desk as NAME");

        openMenuAt(DESK);
        window.click("removePlace");
        window.await("no place", () -> place("desk").isEmpty());
    }

    @Test
    void theMenuOffersWhatMakesSense() {
        JMenu menu = (JMenu) ((JPopupMenu) window.entry("Close Map").getParent()).getInvoker();
        window.run(() -> menu.setSelected(true));
        assertThat(window.entry("End Building the Map").isEnabled()).isFalse();
        assertThat(window.entry("Save Map…").isEnabled()).isTrue();
        window.run(() -> menu.setSelected(false));

        window.run(window.entry("Close Map")::doClick);
        window.await("no map", () -> window.session.map().get().isEmpty());
        window.run(() -> menu.setSelected(true));
        assertThat(window.entry("Save Map…").isEnabled()).isFalse();
        window.run(() -> menu.setSelected(false));
    }
}
