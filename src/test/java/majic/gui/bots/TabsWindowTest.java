package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.accessibility.AccessibleState;
import javax.swing.JTabbedPane;
import majic.gui.TestWindow;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the tabbed panes of the robots. */
class TabsWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private JTabbedPane mainPane;

    @BeforeEach
    void addThree() {
        window.run(() -> window.frame.setSize(1280, 800));
        List.of("one", "two", "three").forEach(window::add);
        mainPane = window.find("mainPane", JTabbedPane.class);
    }

    private <T> T read(Supplier<T> value) {
        List<T> result = new ArrayList<>();
        window.run(() -> result.add(value.get()));
        return result.get(0);
    }

    private int selected() {
        return read(mainPane::getSelectedIndex);
    }

    @Test
    void eachRobotHasATabWithThePaneOfItsOwn() {
        for (int index = 0; index < 3; index++) {
            int tab = index;
            assertThat(read(() -> mainPane.getComponentAt(tab).getName())).isEqualTo("bot" + (tab + 1));
            assertThat(read(() -> mainPane.getTabComponentAt(tab).getName())).isEqualTo("tab" + (tab + 1));
        }
        window.team.remove(2);
        window.await("its tab to go", () -> window.tabs().equals(List.of("1", "3")));
    }

    @Test
    void aSelectedTabOfThePaneIsASelectedRobot() {
        window.run(() -> mainPane.setSelectedIndex(1));
        window.command("move 50");
        window.awaitMessage("2 move 50");
        assertThat(window.isShowing("bot2")).isTrue();
    }

    @Test
    void theSelectedTabIsThatOfTheFirstSelectedRobot() {
        window.click("tabName3");
        window.clickWithCtrl("tabName2");
        assertThat(selected()).isEqualTo(1);
        window.clickWithCtrl("tabName2");
        assertThat(selected()).isEqualTo(2);
        window.clickWithCtrl("tabName3");
        assertThat(selected()).isEqualTo(-1);
    }

    @Test
    void ctrlPageUpAndDownGoThroughTheTabsFromAnyPartOfTheWindow() {
        window.focus("commandLine");
        window.pressWithCtrl(KeyEvent.VK_PAGE_DOWN);
        assertThat(selected()).isEqualTo(1);
        window.pressWithCtrl(KeyEvent.VK_PAGE_UP);
        window.pressWithCtrl(KeyEvent.VK_PAGE_UP);
        assertThat(selected()).isEqualTo(2);
        window.focus("drivePad");
        window.pressWithCtrl(KeyEvent.VK_PAGE_DOWN);
        assertThat(selected()).isEqualTo(0);
    }

    @Test
    void aScreenReaderFindsPageTabsWithTheirStatesAndSelectsThem() {
        AccessibleContext list = read(mainPane::getAccessibleContext);
        assertThat(list.getAccessibleRole()).isEqualTo(AccessibleRole.PAGE_TAB_LIST);
        List<AccessibleContext> tabs = read(() -> IntStream.range(0, 3)
                .mapToObj(list::getAccessibleChild)
                .map(Accessible::getAccessibleContext)
                .toList());
        assertThat(tabs).allMatch(tab -> tab.getAccessibleRole() == AccessibleRole.PAGE_TAB);
        assertThat(tabs.get(1).getAccessibleName()).startsWith("Robot 2 Toy, stationary");
        assertThat(selectedAmong(tabs)).containsExactly(0);

        assertThat(read(() -> tabs.get(1).getAccessibleAction().doAccessibleAction(0)))
                .isTrue();
        assertThat(selectedAmong(tabs)).containsExactly(1);
        assertThat(window.isShowing("bot2")).isTrue();

        window.run(() -> list.getAccessibleSelection().addAccessibleSelection(2));
        assertThat(selectedAmong(tabs)).containsExactly(1, 2);
        assertThat(list.getAccessibleSelection().getAccessibleSelectionCount()).isEqualTo(2);
    }

    private List<Integer> selectedAmong(List<AccessibleContext> tabs) {
        return read(() -> IntStream.range(0, tabs.size())
                .filter(tab -> tabs.get(tab).getAccessibleStateSet().contains(AccessibleState.SELECTED))
                .boxed()
                .toList());
    }

    @Test
    void theTabsCanBePaintedAsSoonAsTheirLookHasChanged() {
        BufferedImage picture = new BufferedImage(800, 600, BufferedImage.TYPE_INT_RGB);
        window.run(() -> {
            mainPane.updateUI();
            mainPane.paint(picture.getGraphics());
        });
        Rectangle tab = read(() -> mainPane.getBoundsAt(mainPane.getSelectedIndex()));
        Color edge = read(RobotTab::selectedEdge);
        assertThat(new Color(picture.getRGB(tab.x + tab.width + 2, tab.y))).isEqualTo(edge);
    }

    @Test
    void theRightEdgeOfTheTabsCanBeDraggedAndItsPlaceIsKept() {
        Component grip = window.find("tabGrip", Component.class);
        int before = read(() -> mainPane.getBoundsAt(0).width);
        window.run(() -> grip.dispatchEvent(
                new MouseEvent(grip, MouseEvent.MOUSE_DRAGGED, 0, MouseEvent.BUTTON1_DOWN_MASK, 104, 5, 1, false)));

        window.await("wider tabs", () -> read(() -> mainPane.getBoundsAt(0).width) == before + 100);
        window.await(
                "the setting",
                () -> window.settings.get("window.place").orElse("").endsWith(" " + (before + 100)));
    }

    @Test
    void theWidthOfTheTabsIsThatOfTheLastTime() {
        try (TestWindow again = TestWindow.openWith("window.place", "10 10 1200 700 normal 400 450 350")) {
            again.add("one");
            JTabbedPane pane = again.find("mainPane", JTabbedPane.class);
            again.await("the kept width", () -> again.tabPlaces().get(0).width == 350);
            assertThat(pane.isShowing()).isTrue();
        }
    }

    @Test
    void theNameHasItsPlaceWhileTheSignsOfTheConnectionComeAndGo() {
        Component name = window.find("tabName2", Component.class);
        Rectangle before = read(() -> name.getBounds());
        window.type.made.get(1).loseLink();
        window.await("the loss", () -> window.text("tabLine2").startsWith("connection lost"));
        Rectangle after = read(() -> name.getBounds());
        assertThat(after).isEqualTo(before);
    }
}
