package majic.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import majic.bot.Pose;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import majic.gui.ToyLab;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class RobotPlacingWindowTest {
    private static final int SHIFT = InputEvent.SHIFT_DOWN_MASK;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final ToyBot bot = window.add("//one");

    private TeamMap map() {
        return window.find("teamMap", TeamMap.class);
    }

    /** Drags from the robot, which is at the origin, to a place on the floor. */
    private void drag(int modifiers, double xMm, double yMm) {
        window.await("the robot on the map", () -> map().topRobotAt(pixel(0, 0)).isPresent());
        drag(modifiers, Pose.START, xMm, yMm);
    }

    private void drag(int modifiers, Pose start, double xMm, double yMm) {
        window.run(() -> {
            Point from = pixel(start.xMm(), start.yMm());
            Point to = pixel(xMm, yMm);
            send(MouseEvent.MOUSE_PRESSED, modifiers, from);
            send(MouseEvent.MOUSE_DRAGGED, modifiers, to);
            send(MouseEvent.MOUSE_RELEASED, modifiers, to);
        });
    }

    private Point pixel(double xMm, double yMm) {
        Point2D pixel = map().view().pixel(xMm, yMm);
        return new Point((int) Math.round(pixel.getX()), (int) Math.round(pixel.getY()));
    }

    private void send(int id, int modifiers, Point at) {
        map().dispatchEvent(new MouseEvent(
                map(), id, 0, modifiers | InputEvent.BUTTON1_DOWN_MASK, at.x, at.y, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    void shiftAndDragSetsWhereTheRobotIsAndMovesNothing() {
        drag(SHIFT, 400, 200);
        window.await("the place", () -> bot.placedAt().isPresent());
        Pose place = bot.placedAt().orElseThrow();
        assertThat(place.distanceMm(new Pose(400, 200, 0))).isLessThan(20);
        assertThat(place.headingDeg()).isZero();
        assertThat(bot.told).isEmpty();
    }

    @Test
    void aRobotOfTheLabIsPutDownThere() {
        ToyLab lab = new ToyLab();
        ToyBot inLab = window.addFrom(lab);
        Pose before = ToyLab.FIRST_PLACE;
        window.await(
                "the robot of the lab on the map",
                () -> map().topRobotAt(pixel(before.xMm(), before.yMm()))
                        .filter(robot -> robot.truth() != null)
                        .isPresent());
        drag(SHIFT, new Pose(before.xMm(), before.yMm(), 0), 2000, 1500);
        window.await("the place", () -> inLab.placedAt().isPresent());
        Pose truth = lab.truePoses().get("toy");
        assertThat(truth.distanceMm(new Pose(2000, 1500, 90))).isLessThan(20);
        assertThat(truth.headingDeg()).isEqualTo(90);
        assertThat(inLab.placedAt()).contains(truth);
        assertThat(inLab.told).isEmpty();
    }

    @Test
    void withCtrlTheRobotLooksToTheMouse() {
        drag(SHIFT | InputEvent.CTRL_DOWN_MASK, 0, 300);
        window.await("the place", () -> bot.placedAt().isPresent());
        assertThat(bot.placedAt()).contains(new Pose(0, 0, 90));
    }

    @Test
    void withoutShiftTheMapIsMoved() {
        drag(0, 400, 200);
        assertThat(bot.placedAt()).isEmpty();
    }

    @Test
    void aRobotThatMovesIsNotPlaced() {
        bot.at(Pose.START, true);
        drag(SHIFT, 400, 200);
        window.awaitMessage("Robot 1 moves; drag it to its place when it is stationary.");
        assertThat(bot.placedAt()).isEmpty();
    }
}
