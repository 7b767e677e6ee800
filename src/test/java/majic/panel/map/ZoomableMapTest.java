package majic.panel.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import javax.swing.AbstractButton;
import javax.swing.KeyStroke;
import majic.bot.Pose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ZoomableMapTest {
    private static final double NEAR = 0.1;

    private final Floor floor = new Floor();
    private final ZoomableMap map = new ZoomableMap(floor);

    @BeforeEach
    void size() {
        map.setSize(400, 300);
        map.doLayout();
    }

    @Test
    void theRobotStaysInTheMiddleUntilTheFloorIsDragged() {
        floor.pose = new Pose(5000, 1000, 0);
        assertThat(map.view().xMm()).isEqualTo(5000);

        mouse(MouseEvent.MOUSE_PRESSED, 200, 150, 1);
        mouse(MouseEvent.MOUSE_DRAGGED, 250, 150, 1);
        floor.pose = new Pose(9000, 0, 0);

        assertThat(map.view().xMm()).isCloseTo(4500, within(1e-6));
    }

    @Test
    void theWheelZoomsAndGoesOnFollowing() {
        map.dispatchEvent(new MouseWheelEvent(
                map, MouseEvent.MOUSE_WHEEL, 0, 0, 10, 10, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 1, -3));
        floor.pose = new Pose(700, 0, 0);

        assertThat(map.view().pxPerMm()).isGreaterThan(1.4 * NEAR);
        assertThat(map.view().xMm()).isEqualTo(700);
    }

    @Test
    void aDoubleClickShowsEverything() {
        mouse(MouseEvent.MOUSE_CLICKED, 100, 100, 2);
        assertThat(map.view().xMm()).isEqualTo(10_000);
        assertThat(map.view().pixel(0, 0).getY()).isCloseTo(300, within(1e-6));
        assertThat(map.view().pixel(0, 15_000).getY())
                .isCloseTo(map.getComponent(0).getHeight(), within(1e-6));
    }

    @Test
    void aPlaceJustBelowZeroIsShownAsZero() {
        assertThat(floor.tip(-0.3, -0.2, map.view())).startsWith("x 0 mm, y 0 mm");
    }

    @Test
    void keysDoWhatTheButtonsDo() {
        key("typed +");
        double nearer = map.view().pxPerMm();
        press("map zoom_out");

        assertThat(nearer).isGreaterThan(NEAR);
        assertThat(map.view().pxPerMm()).isCloseTo(NEAR, within(1e-9));
    }

    @Test
    void theMapTurnsWithTheRobotWhenAsked() {
        floor.pose = new Pose(0, 0, -30);
        key("typed u");
        assertThat(map.view().upDeg()).isEqualTo(-30);
        assertThat(button("map ahead_up").isSelected()).isTrue();

        key("typed u");
        assertThat(map.view().upDeg()).isEqualTo(MapView.Y_UP);
    }

    @Test
    void theButtonsShowTheModeOfTheView() {
        assertThat(button("map follow").isSelected()).isTrue();
        key("LEFT");
        assertThat(button("map follow").isSelected()).isFalse();
    }

    @Test
    void clearingIsLeftToTheContent() {
        press("map clear");
        assertThat(floor.cleared).isTrue();
    }

    @Test
    void everyButtonHasATip() {
        assertThat(buttons(map)).hasSize(6).allSatisfy(button -> {
            assertThat(button.getToolTipText()).isNotBlank();
            assertThat(button.getAccessibleContext().getAccessibleName()).isNotBlank();
            assertThat(button.isFocusable()).isTrue();
        });
    }

    @Test
    void aMapWithoutARobotToFollowShowsEverythingAndHasNothingThatNeedsOne() {
        MapContent team = floor;
        ZoomableMap map = new ZoomableMap(team);
        map.setSize(400, 300);

        assertThat(map.view()).isEqualTo(MapView.fitting(team.extent(), 400, 300));
        assertThat(buttons(map)).hasSize(4);
        assertThat(map.getInputMap().get(KeyStroke.getKeyStroke("typed f"))).isNull();
    }

    @Test
    void inLittleRoomTheButtonsGo() {
        map.setSize(100, 100);
        map.doLayout();
        assertThat(map.getComponent(0).isVisible()).isFalse();
    }

    private void mouse(int id, int x, int y, int clicks) {
        map.dispatchEvent(
                new MouseEvent(map, id, 0, InputEvent.BUTTON1_DOWN_MASK, x, y, clicks, false, MouseEvent.BUTTON1));
    }

    private void key(String stroke) {
        Object action = map.getInputMap().get(KeyStroke.getKeyStroke(stroke));
        map.getActionMap().get(action).actionPerformed(new ActionEvent(map, ActionEvent.ACTION_PERFORMED, stroke));
    }

    private void press(String name) {
        button(name).doClick(0);
    }

    private AbstractButton button(String name) {
        return Arrays.stream(buttons(map))
                .filter(button -> button.getName().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** Returns the buttons of a map; there is a gap between two of them. */
    private static AbstractButton[] buttons(ZoomableMap map) {
        MapTools tools = (MapTools) map.getComponent(0);
        return Arrays.stream(tools.getComponents())
                .filter(AbstractButton.class::isInstance)
                .map(AbstractButton.class::cast)
                .toArray(AbstractButton[]::new);
    }

    /** A floor of twenty metres by fifteen, its middle 10 m ahead. */
    private static final class Floor implements RobotContent {
        private Pose pose = Pose.START;
        private boolean cleared;

        @Override
        public void paint(Graphics2D pen, MapView view) {
            pen.drawLine(0, 0, 1, 1);
        }

        @Override
        public Pose pose() {
            return pose;
        }

        @Override
        public Rectangle2D extent() {
            return new Rectangle2D.Double(0, 0, 20_000, 15_000);
        }

        @Override
        public double nearPxPerMm(int sidePx) {
            return NEAR;
        }

        @Override
        public void clear() {
            cleared = true;
        }
    }
}
