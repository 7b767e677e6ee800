package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.accessibility.AccessibleState;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests what selects robots, and what the selection is used for. */
class SelectionWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private ToyBot one;
    private ToyBot two;

    @BeforeEach
    void addThree() {
        one = window.add("one");
        two = window.add("two");
        window.add("three");
    }

    @Test
    void theFirstRobotOfATeamIsSelected() {
        assertThat(selected()).containsExactly("tab1");
        assertThat(window.isShowing("bot1")).isTrue();
        assertThat(window.isShowing("bot2")).isFalse();
    }

    @Test
    void aClickOnATabSelectsItsRobotAlone() {
        window.click("tab2");
        assertThat(selected()).containsExactly("tab2");
        assertThat(window.isShowing("bot1")).isFalse();
        assertThat(window.isShowing("bot2")).isTrue();
    }

    @Test
    void theTabsStayWhereTheyAreWhenASecondRobotIsCompared() {
        for (int width : List.of(1600, 1280, 1000, 800)) {
            window.run(() -> window.frame.setSize(width, 700));
            Map<String, Point> before = places();
            window.clickWithCtrl("tab2");
            assertThat(window.isShowing("bot1") && window.isShowing("bot2")).isTrue();
            assertThat(places()).as("at a width of " + width).isEqualTo(before);
            assertThat(Math.min(width("bot1"), width("bot2")))
                    .as("panes at a width of " + width)
                    .isGreaterThan(150);
            window.clickWithCtrl("tab2");
            assertThat(window.isShowing("bot2")).isFalse();
            assertThat(places()).isEqualTo(before);
        }
    }

    private Map<String, Point> places() {
        Map<String, Point> places = new TreeMap<>();
        window.run(() -> {
            window.frame.validate();
            Stream.of("tab1", "tab2", "tab3", "tabGrip", "drivePad")
                    .forEach(name ->
                            places.put(name, window.find(name, Component.class).getLocationOnScreen()));
        });
        return places;
    }

    @Test
    void aClickWithCtrlShowsTwoPanelsSideBySide() {
        window.clickWithCtrl("tab3");
        assertThat(selected()).containsExactly("tab1", "tab3");
        assertThat(window.isShowing("bot1") && window.isShowing("bot3")).isTrue();
        window.clickWithCtrl("tab1");
        assertThat(selected()).containsExactly("tab3");
    }

    @Test
    void twoPanelsTakeWidthFromTheMapWhichHasItAgainAfterwards() {
        window.run(() -> window.frame.setSize(1280, 800));
        int before = width("teamMap");
        window.clickWithCtrl("tab3");
        window.await("room for two", () -> width("mainPane") > 900);
        assertThat(width("teamMap")).isLessThan(before);
        window.click("tabName3");
        window.await("the map as before", () -> width("teamMap") == before);
    }

    private int width(String component) {
        return window.find(component, Component.class).getWidth();
    }

    @Test
    void withThreeSelectedTheFirstIsShownWithAHint() {
        window.clickWithCtrl("tab2");
        window.clickWithCtrl("tab3");
        assertThat(window.isShowing("bot1")).isTrue();
        assertThat(window.isShowing("bot2")).isFalse();
        assertThat(window.text("panelNotice")).startsWith("Selected: 1, 2, 3.");
    }

    @Test
    void aLineWithoutRobotsIsForTheSelectedOnesAndIsShownWithTheirNumbers() {
        window.clickWithCtrl("tab2");
        window.command("move 50");
        window.awaitMessage("1,2 move 50");
        window.await("both to move", () -> one.told.contains("move 50") && two.told.contains("move 50"));
    }

    @Test
    void altAndADigitSelectsTheRobotOfThatNumber() {
        window.focus("commandLine");
        window.pressWithAlt(KeyEvent.VK_2);
        assertThat(selected()).containsExactly("tab2");
        assertThat(window.text("commandLine")).isEmpty();
    }

    @Test
    void tabGoesToTheTabOfTheRobotThatAltAndADigitSelected() {
        window.focus("commandLine");
        window.pressWithAlt(KeyEvent.VK_2);
        assertThat(window.tabs())
                .filteredOn(
                        number -> window.find("tab" + number, Component.class).isFocusable())
                .containsExactly("2");
    }

    @Test
    void onATabTheArrowKeysSelectTheNeighbourAndSpaceAddsOrRemovesARobot() {
        window.focus("tab1");
        window.press(KeyEvent.VK_DOWN);
        assertThat(selected()).containsExactly("tab2");
        window.pressWithCtrl(KeyEvent.VK_DOWN);
        window.press(KeyEvent.VK_SPACE);
        assertThat(selected()).containsExactly("tab2", "tab3");
        window.press(KeyEvent.VK_SPACE);
        assertThat(selected()).containsExactly("tab2");
    }

    @Test
    void afterTheSelectedRobotIsRemovedNoOtherOneIsSelected() {
        window.team.remove(1);
        window.await("the tab to go", () -> window.tabs().equals(List.of("2", "3")));
        assertThat(selected()).isEmpty();
        assertThat(window.text("panelNotice")).startsWith("No robot is selected");
        window.command("move 50");
        window.awaitMessage("which robot?");
    }

    @Test
    void thePadDrivesAllSelectedRobots() {
        window.clickWithCtrl("tab2");
        window.holdMouse("drive AHEAD");
        window.await("both", () -> one.told.contains("drive 200 0") && two.told.contains("drive 200 0"));
        window.letGoMouse();
        window.await("both to be stationary", () -> isHalted(one) && isHalted(two));
    }

    @Test
    void thePadDrivesTheSelectedRobotsThatCanBeDriven() {
        two.loseLink();
        window.clickWithCtrl("tab2");
        window.await("the hint", () -> window.text("driveHint").startsWith("Click here to drive 1 "));
        window.holdMouse("drive AHEAD");
        window.await("the first", () -> one.told.contains("drive 200 0"));
        window.letGoMouse();
        window.await("it to be stationary", () -> isHalted(one));
    }

    @Test
    void aHeldArrowDoesNotDriveARobotThatIsSelectedMeanwhile() {
        window.holdMouse("drive AHEAD");
        window.await("the first", () -> one.told.contains("drive 200 0"));
        window.pressWithAlt(KeyEvent.VK_2);
        window.await("it to be stationary", () -> isHalted(one));
        window.await("the first to be free", () -> window.team.member(1).owner() == null);
        assertThat(two.told).isEmpty();
        window.letGoMouse();
        window.holdMouse("drive AHEAD");
        window.await("the second", () -> two.told.contains("drive 200 0"));
        window.letGoMouse();
        window.await("it to be stationary", () -> isHalted(two));
    }

    @Test
    void aTabStopsItsRobotAlone() {
        window.click("tabStop2");
        window.await("the stop", () -> two.told.contains("halt"));
        assertThat(one.told).isEmpty();
        assertThat(window.team.isLatched()).isFalse();
    }

    @Test
    void aTabReconnectsItsRobot() {
        two.loseLink();
        window.await("the button", () -> window.isShowing("tabReconnect2"));
        assertThat(window.text("tabLine2")).isEqualTo("connection lost");
        window.click("tabReconnect2");
        window.await("the connection", two::isConnected);
        window.await("the button to go", () -> !window.isShowing("tabReconnect2"));
    }

    @Test
    void aRobotThatDoesNotConfirmItsStopIsMarkedOnItsTab() {
        two.confirmStops(false);
        window.click("tabStop2");
        window.await("the mark", () -> window.text("tabLine2").equals("stop not confirmed"));
    }

    private static boolean isHalted(ToyBot bot) {
        return bot.told.get(bot.told.size() - 1).equals("halt");
    }

    private List<String> selected() {
        return window.tabs().stream()
                .map(number -> "tab" + number)
                .filter(tab -> window.find(tab, Component.class)
                        .getAccessibleContext()
                        .getAccessibleStateSet()
                        .contains(AccessibleState.SELECTED))
                .toList();
    }
}
