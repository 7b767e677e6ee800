package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JButton;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NarrowWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void shrink() {
        window.resize(700, 540);
        window.await(
                "a narrow window",
                () -> window.find("messageArea", Component.class).getWidth() < 700);
    }

    @Test
    void everyButtonHasItsTextIfThereIsRoomBesideReleaseAndStopIsFullyVisible() {
        assertThat(isWhole("stop")).isTrue();
        window.resize(860, 540);
        window.await("words", () -> button("Save Session").getText() != null);
        assertThat(window.text("Save Session")).isEqualTo("Save Session");
        assertThat(button("Save Session").getWidth())
                .isGreaterThanOrEqualTo(button("Save Session").getPreferredSize().width);
        assertThat(isWhole("stop")).isTrue();
    }

    @Test
    void stopMovesNoButtonHoweverNarrowTheWindowIs() {
        window.add("one");
        for (int width = 700; width <= 1000; width += 20) {
            window.resize(width, 540);
            window.run(window.frame::validate);
            Rectangle before = button("Kill Majic").getBounds();
            window.push("stop");
            window.await("release", () -> window.isShowing("release"));
            window.run(window.frame::validate);
            assertThat(button("Kill Majic").getBounds()).as(width + " px").isEqualTo(before);
            assertThat(isWhole("stop") && isWhole("release")).as(width + " px").isTrue();
            window.push("release");
            window.await("the button to go", () -> !window.isShowing("release"));
        }
    }

    @Test
    void theTabsHaveTheSpaceOfAMapThatWouldBeTooNarrow() {
        window.add("one");
        Component map = window.find("teamMap", Component.class);
        window.await("no map", () -> !map.isVisible());
        assertThat(window.find("mainPane", Component.class).getWidth())
                .isEqualTo(map.getParent().getWidth());

        window.resize(1280, 800);
        window.await("the map", map::isVisible);
    }

    @Test
    void theLeastSizeOfTheWindowIsNeverLargerThanTheScreen() {
        assertThat(MajicFrame.leastSize(new Rectangle(640, 400))).isEqualTo(new Dimension(640, 400));
        assertThat(MajicFrame.leastSize(new Rectangle(1920, 1080))).isEqualTo(new Dimension(700, 520));
    }

    @Test
    void onTheSmallestScreenStopAndReleaseAreWholeAndTheTabsOfTwentyRobotsAreReached() {
        window.addAll(20);
        window.run(() -> window.frame.setMinimumSize(null));
        window.resize(640, 400);
        window.click("stop");
        window.await("release", () -> window.isShowing("release"));
        window.run(window.frame::validate);
        assertThat(isWhole("stop") && isWhole("release")).isTrue();
        Rectangle pane = new Rectangle(window.find("mainPane", Component.class).getSize());
        assertThat(window.tabPlaces().stream().allMatch(pane::contains) || window.isShowing("tabScroll"))
                .isTrue();
        assertThat(window.isShowing("tabStop20")).isTrue();
        assertThat(window.isShowing("commandLine")).isTrue();
    }

    private JButton button(String name) {
        return window.find(name, JButton.class);
    }

    private boolean isWhole(String name) {
        JButton button = button(name);
        Rectangle bounds =
                SwingUtilities.convertRectangle(button.getParent(), button.getBounds(), window.frame.getContentPane());
        return new Rectangle(window.frame.getContentPane().getSize()).contains(bounds)
                && button.getWidth() >= button.getPreferredSize().width;
    }

    @ParameterizedTest
    @ValueSource(strings = {"Add Bot", "Kill Bot", "Load Act", "Save Session", "Save Log"})
    void theEntryOfAnActionThatAsksFirstEndsWithAnEllipsisAndItsButtonDoesNot(String name) {
        window.resize(900, 540);
        window.await("words", () -> button(name).getText() != null);
        assertThat(window.entry(name + "…").getText()).isEqualTo(name + "…");
        assertThat(window.text(name)).isEqualTo(name);
    }
}
