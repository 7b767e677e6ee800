package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JComponent;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the window with two hundred robots. */
class LargeTeamWindowTest {
    private static final int ROBOTS = 200;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void addAll() {
        window.run(() -> window.frame.setSize(1280, 800));
        window.addAll(ROBOTS);
    }

    @Test
    void theTabsAreInRowsWithoutCoveringEachOtherAndScroll() {
        List<Rectangle> tabs = window.tabPlaces();
        assertThat(tabs).hasSize(ROBOTS);
        for (Rectangle tab : tabs) {
            assertThat(tab.height).isGreaterThanOrEqualTo(18);
            assertThat(tabs.stream().filter(tab::intersects)).containsExactly(tab);
        }
        assertThat(isVisible("tab1")).isTrue();
        assertThat(isVisible("tab200")).isFalse();
    }

    @Test
    void altAndThreeDigitsSelectARobotAndScrollToItsTab() {
        window.pressWithAltAsOf(10_000, KeyEvent.VK_1);
        window.pressWithAltAsOf(10_900, KeyEvent.VK_7);
        window.pressWithAltAsOf(11_800, KeyEvent.VK_3);

        window.await("robot 173 to be selected", () -> window.isShowing("bot173"));
        window.await("its tab to show", () -> isVisible("tab173"));
        assertThat(window.isShowing("bot1")).isFalse();
    }

    @Test
    void aDigitAfterAPauseBeginsANewNumber() {
        window.pressWithAltAsOf(10_000, KeyEvent.VK_1);
        window.pressWithAltAsOf(11_001, KeyEvent.VK_7);

        window.await("robot 7 to be selected", () -> window.isShowing("bot7"));
    }

    @Test
    void theDownKeyGoesToTheTabBelow() {
        long columns = window.tabPlaces().stream().filter(tab -> tab.y == 0).count();
        window.focus("tab1");

        window.press(KeyEvent.VK_DOWN);

        window.await("the robot below to be selected", () -> window.isShowing("bot" + (1 + columns)));
    }

    @Test
    void aSelectionOfAllIsNamedByARange() {
        window.focus("tab1");

        window.pressWithCtrl(KeyEvent.VK_A);

        window.await("the notice", () -> window.text("panelNotice").contains("1–200"));
    }

    @Test
    void aRobotThatLosesItsConnectionIsMarkedOnItsTab() {
        String before = description("tab150");

        window.type.made.get(149).loseLink();

        window.await("the mark", () -> !description("tab150").equals(before));
        assertThat(description("tab150")).contains("lost");
    }

    private String description(String tab) {
        return window.find(tab, Component.class).getAccessibleContext().getAccessibleName();
    }

    private boolean isVisible(String tab) {
        return !window.find(tab, JComponent.class).getVisibleRect().isEmpty();
    }
}
