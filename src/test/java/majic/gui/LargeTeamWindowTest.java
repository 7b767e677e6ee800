package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.stream.Stream;
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
    void theCardsAreInRowsWithoutCoveringEachOtherAndScroll() {
        Container strip = window.find("teamStrip", Container.class);
        Component[] cards = strip.getComponents();
        assertThat(cards).hasSize(ROBOTS);
        for (Component card : cards) {
            assertThat(new Rectangle(strip.getSize()).contains(card.getBounds()))
                    .as(card.getName())
                    .isTrue();
            assertThat(card.getHeight()).as(card.getName()).isGreaterThanOrEqualTo(18);
            assertThat(Stream.of(cards).filter(other -> other.getBounds().intersects(card.getBounds())))
                    .containsExactly(card);
        }
        assertThat(isVisible("card1")).isTrue();
        assertThat(isVisible("card200")).isFalse();
    }

    @Test
    void altAndThreeDigitsSelectARobotAndScrollToItsCard() {
        window.pressWithAltAsOf(10_000, KeyEvent.VK_1);
        window.pressWithAltAsOf(10_900, KeyEvent.VK_7);
        window.pressWithAltAsOf(11_800, KeyEvent.VK_3);

        window.await("robot 173 to be selected", () -> window.isShowing("bot173"));
        window.await("its card to show", () -> isVisible("card173"));
        assertThat(window.isShowing("bot1")).isFalse();
    }

    @Test
    void aDigitAfterAPauseBeginsANewNumber() {
        window.pressWithAltAsOf(10_000, KeyEvent.VK_1);
        window.pressWithAltAsOf(11_001, KeyEvent.VK_7);

        window.await("robot 7 to be selected", () -> window.isShowing("bot7"));
    }

    @Test
    void theDownKeyGoesToTheCardBelow() {
        Container strip = window.find("teamStrip", Container.class);
        long columns = Stream.of(strip.getComponents())
                .filter(card -> card.getY() == 0)
                .count();
        window.focus("card1");

        window.press(KeyEvent.VK_DOWN);

        window.await("the robot below to be selected", () -> window.isShowing("bot" + (1 + columns)));
    }

    @Test
    void aSelectionOfAllIsNamedByARange() {
        window.focus("card1");

        window.pressWithCtrl(KeyEvent.VK_A);

        window.await("the notice", () -> window.text("panelNotice").contains("1–200"));
    }

    @Test
    void aRobotThatLosesItsConnectionIsMarkedOnItsCard() {
        String before = description("card150");

        window.type.made.get(149).loseLink();

        window.await("the mark", () -> !description("card150").equals(before));
        assertThat(description("card150")).contains("lost");
    }

    private String description(String card) {
        return window.find(card, Component.class).getAccessibleContext().getAccessibleName();
    }

    private boolean isVisible(String card) {
        JComponent strip = window.find("teamStrip", JComponent.class);
        Rectangle bounds = window.find(card, Component.class).getBounds();
        return strip.getVisibleRect().intersects(bounds);
    }
}
