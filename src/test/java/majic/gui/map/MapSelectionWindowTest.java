package majic.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import majic.bot.Pose;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests that robots are selected by a click on the map. Without a lab they are drawn one metre apart, downwards. */
class MapSelectionWindowTest {
    private static final int APART_MM = 1000;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final ToyBot one = window.add("one");

    private void addTwoMore() {
        window.add("two");
        window.add("three");
        awaitMap("1 Toy, 2 Toy, 3 Toy");
    }

    private void awaitMap(String robots) {
        window.await(
                "the robots on the map",
                () -> robots.equals(map().getAccessibleContext().getAccessibleDescription()));
    }

    @Test
    void aClickOnARobotSelectsIt() {
        addTwoMore();
        window.clickAt("teamMap", pixel(-APART_MM));
        window.await("the selection", () -> window.isShowing("bot2"));
        assertThat(window.isShowing("bot1")).isFalse();
    }

    @Test
    void aClickOnTheFloorChangesNothing() {
        addTwoMore();
        window.clickAt("teamMap", pixel(-APART_MM / 2));
        assertThat(window.isShowing("bot1")).isTrue();
    }

    @Test
    void whereRobotsOverlapTheNextClickSelectsTheNextOne() {
        addTwoMore();
        one.at(new Pose(0, -APART_MM, 0), false);
        window.await("robot 1 beside robot 2", () -> tip(-APART_MM).contains("1 Toy"));
        window.clickAt("teamMap", pixel(-APART_MM));
        window.await("the other", () -> window.isShowing("bot2"));
        window.clickAt("teamMap", pixel(-APART_MM));
        window.await("the first again", () -> window.isShowing("bot1"));
    }

    @Test
    void aRightClickOnARobotOpensItsMenu() {
        addTwoMore();
        window.menuAt("teamMap", pixel(-APART_MM));
        JPopupMenu menu = window.awaitShowing("robotMenu", JPopupMenu.class);
        assertThat(((JMenuItem) menu.getComponent(0)).getText()).isEqualTo("Stop 2");
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(window.team.isLatched()).isFalse();
    }

    private TeamMap map() {
        return window.find("teamMap", TeamMap.class);
    }

    private String tip(int yMm) {
        Point at = pixel(yMm);
        return String.valueOf(window.tipAt("teamMap", at));
    }

    private Point pixel(int yMm) {
        Point2D at = map().view().pixel(0, yMm);
        return new Point((int) Math.round(at.getX()), (int) Math.round(at.getY()));
    }
}
