package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Rectangle;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JTabbedPane;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the window with as many robots as a team can have. */
class FullTeamWindowTest {
    private static final int ROBOTS = 20;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void addAll() {
        window.run(() -> window.frame.setSize(1280, 800));
        IntStream.rangeClosed(1, ROBOTS).forEach(number -> window.add("number " + number));
    }

    @Test
    void allTabsAreWholeWithTheirStopButtonsWhichNoAlarmMoves() {
        assertTabsAreWhole();
        List<Rectangle> before = window.tabPlaces();
        window.type.made.get(4).confirmStops(false);
        window.click("tabStop5");
        window.await("the alarm", () -> window.isShowing("stopAlarm"));
        window.run(window.frame::validate);
        assertTabsAreWhole();
        assertThat(window.tabPlaces()).isEqualTo(before);
        window.run(() -> window.find("mainPane", JTabbedPane.class).setSelectedIndex(15));
        window.run(window.frame::validate);
        assertThat(window.tabPlaces()).as("columns never swap places").isEqualTo(before);
    }

    /** So much of it shows "Hemisson" in full in the usual font. */
    @Test
    void theNameHasHalfOfANarrowTabBesideTheSignsOfConnectionAndBattery() {
        Component name = window.find("tabName3", Component.class);
        assertThat(name.getWidth()).isGreaterThan(name.getParent().getWidth() / 2);
        assertThat(window.isShowing("tabLine3")).isTrue();
    }

    private void assertTabsAreWhole() {
        JTabbedPane strip = window.find("mainPane", JTabbedPane.class);
        List<Component> tabs = IntStream.range(0, strip.getTabCount())
                .mapToObj(strip::getTabComponentAt)
                .toList();
        assertThat(tabs).hasSize(ROBOTS);
        Rectangle inside = new Rectangle(strip.getSize());
        for (Component tab : tabs) {
            Component stop = window.find("tabStop" + tab.getName().substring("tab".length()), Component.class);
            assertThat(inside.contains(tab.getBounds())).as(tab.getName()).isTrue();
            assertThat(new Rectangle(tab.getSize()).contains(stop.getBounds()))
                    .as(stop.getName())
                    .isTrue();
            assertThat(stop.getHeight()).as(stop.getName()).isGreaterThanOrEqualTo(16);
            assertThat(tabs.stream().filter(other -> other.getBounds().intersects(tab.getBounds())))
                    .containsExactly(tab);
        }
    }
}
