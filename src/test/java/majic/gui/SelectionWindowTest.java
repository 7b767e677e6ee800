package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.util.List;
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
        assertThat(selected()).containsExactly("card1");
        assertThat(window.isShowing("bot1")).isTrue();
        assertThat(window.isShowing("bot2")).isFalse();
    }

    @Test
    void aClickOnACardSelectsItsRobotAlone() {
        window.click("card2");
        assertThat(selected()).containsExactly("card2");
        assertThat(window.isShowing("bot1")).isFalse();
        assertThat(window.isShowing("bot2")).isTrue();
    }

    @Test
    void aClickWithCtrlShowsTwoPanelsSideBySide() {
        window.clickWithCtrl("card3");
        assertThat(selected()).containsExactly("card1", "card3");
        assertThat(window.isShowing("bot1") && window.isShowing("bot3")).isTrue();
        window.clickWithCtrl("card1");
        assertThat(selected()).containsExactly("card3");
    }

    @Test
    void twoPanelsTakeWidthFromTheMapWhichHasItAgainAfterwards() {
        window.run(() -> window.frame.setSize(1280, 800));
        int before = width("teamMap");
        window.clickWithCtrl("card3");
        window.await("room for two", () -> width("robotPanels") > 700);
        assertThat(width("teamMap")).isLessThan(before);
        window.click("card3");
        window.await("the map as before", () -> width("teamMap") == before);
    }

    private int width(String component) {
        return window.find(component, Component.class).getWidth();
    }

    @Test
    void withThreeSelectedTheFirstIsShownWithAHint() {
        window.clickWithCtrl("card2");
        window.clickWithCtrl("card3");
        assertThat(window.isShowing("bot1")).isTrue();
        assertThat(window.isShowing("bot2")).isFalse();
        assertThat(window.text("panelNotice")).startsWith("Selected: 1, 2, 3.");
    }

    @Test
    void aLineWithoutRobotsIsForTheSelectedOnesAndIsShownWithTheirNumbers() {
        window.clickWithCtrl("card2");
        window.command("move 50");
        window.awaitMessage("1,2 move 50");
        window.await("both to move", () -> one.told.contains("move 50") && two.told.contains("move 50"));
    }

    @Test
    void altAndADigitSelectsTheRobotOfThatNumber() {
        window.focus("commandLine");
        window.pressWithAlt(KeyEvent.VK_2);
        assertThat(selected()).containsExactly("card2");
        assertThat(window.text("commandLine")).isEmpty();
    }

    @Test
    void tabGoesToTheCardOfTheRobotThatAltAndADigitSelected() {
        window.focus("commandLine");
        window.pressWithAlt(KeyEvent.VK_2);
        assertThat(window.cards())
                .filteredOn(
                        number -> window.find("card" + number, Component.class).isFocusable())
                .containsExactly("2");
    }

    @Test
    void onACardTheArrowKeysSelectTheNeighbourAndSpaceAddsOrRemovesARobot() {
        window.focus("card1");
        window.press(KeyEvent.VK_DOWN);
        assertThat(selected()).containsExactly("card2");
        window.pressWithCtrl(KeyEvent.VK_DOWN);
        window.press(KeyEvent.VK_SPACE);
        assertThat(selected()).containsExactly("card2", "card3");
        window.press(KeyEvent.VK_SPACE);
        assertThat(selected()).containsExactly("card2");
    }

    @Test
    void afterTheSelectedRobotIsRemovedNoOtherOneIsSelected() {
        window.team.remove(1);
        window.await("the card to go", () -> window.cards().equals(List.of("2", "3")));
        assertThat(selected()).isEmpty();
        assertThat(window.text("panelNotice")).startsWith("No robot is selected");
        window.command("move 50");
        window.awaitMessage("which robot?");
    }

    @Test
    void thePadDrivesAllSelectedRobots() {
        window.clickWithCtrl("card2");
        window.holdMouse("drive AHEAD");
        window.await("both", () -> one.told.contains("drive 200 0") && two.told.contains("drive 200 0"));
        window.letGoMouse();
        window.await("both to be stationary", () -> isHalted(one) && isHalted(two));
    }

    @Test
    void thePadDrivesTheSelectedRobotsThatCanBeDriven() {
        two.loseLink();
        window.clickWithCtrl("card2");
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
    void aCardStopsItsRobotAlone() {
        window.click("cardStop2");
        window.await("the stop", () -> two.told.contains("halt"));
        assertThat(one.told).isEmpty();
        assertThat(window.team.isLatched()).isFalse();
    }

    @Test
    void aCardReconnectsItsRobot() {
        two.loseLink();
        window.await("the button", () -> window.isShowing("cardReconnect2"));
        assertThat(window.text("cardLine2")).isEqualTo("connection lost");
        window.click("cardReconnect2");
        window.await("the connection", two::isConnected);
        window.await("the button to go", () -> !window.isShowing("cardReconnect2"));
    }

    @Test
    void aRobotThatDoesNotConfirmItsStopIsMarkedOnItsCard() {
        two.confirmStops(false);
        window.click("cardStop2");
        window.await("the mark", () -> window.text("cardLine2").equals("stop not confirmed"));
    }

    private static boolean isHalted(ToyBot bot) {
        return bot.told.get(bot.told.size() - 1).equals("halt");
    }

    private List<String> selected() {
        return window.cards().stream()
                .map(number -> "card" + number)
                .filter(card -> window.find(card, Component.class)
                        .getAccessibleContext()
                        .getAccessibleName()
                        .endsWith(", selected"))
                .toList();
    }
}
