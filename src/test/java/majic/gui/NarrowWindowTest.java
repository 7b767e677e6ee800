package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Rectangle;
import javax.swing.JButton;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("jdk")
class NarrowWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void shrink() {
        window.run(() -> window.frame.setSize(700, 540));
        window.await(
                "a narrow window",
                () -> window.find("messageArea", Component.class).getWidth() < 700);
    }

    @Test
    void everyButtonHasItsTextAndStopIsFullyVisible() {
        assertThat(window.text("Save Session")).isEqualTo("Save Session");
        assertThat(button("Save Session").getWidth())
                .isGreaterThanOrEqualTo(button("Save Session").getPreferredSize().width);
        assertThat(isWhole("stop")).isTrue();
    }

    @Test
    void releaseIsWorthMoreThanTheWordsOnButtons() {
        window.add("one");
        window.click("stop");
        window.await("pictures alone", () -> button("Save Session").getText() == null);
        assertThat(isWhole("stop")).isTrue();
        assertThat(isWhole("release")).isTrue();

        window.click("release");
        window.await("words", () -> "Save Session".equals(button("Save Session").getText()));
    }

    @Test
    void theTabsHaveTheSpaceOfAMapThatWouldBeTooNarrow() {
        window.add("one");
        Component map = window.find("teamMap", Component.class);
        window.await("no map", () -> !map.isVisible());
        assertThat(window.find("mainPane", Component.class).getWidth())
                .isEqualTo(map.getParent().getWidth());

        window.run(() -> window.frame.setSize(1280, 800));
        window.await("the map", map::isVisible);
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
        assertThat(window.entry(name + "…").getText()).isEqualTo(name + "…");
        assertThat(window.text(name)).isEqualTo(name);
    }
}
