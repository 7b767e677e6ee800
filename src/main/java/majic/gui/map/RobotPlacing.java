package majic.gui.map;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.gui.kit.CommandChannel;
import majic.panel.map.Trail;
import majic.team.Member;
import majic.team.Team;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Sets where a robot is: with Shift, dragging a robot on the map moves its picture; with Shift and Ctrl, the robot
 * looks to the mouse. On release the pose is set by a command: a robot of the simulated lab is put down there, any
 * other one does not move and reports the new pose. While a robot moves or is owned, placing is refused. Must be used
 * on the event dispatch thread.
 */
final class RobotPlacing extends MouseAdapter {
    private static final Texts TEXTS = Texts.of(RobotPlacing.class);
    /** How far the mouse must move before a press is a drag, in pixels. */
    private static final int DRAG_PX = 4;

    private final TeamMap map;
    private final Team team;
    private final CommandChannel channel;
    private final Consumer<Member> placed;
    private @Nullable Drag drag;

    /** A robot that is being dragged, and where. */
    private record Drag(Member member, MapScene.Robot robot, Point pressed) {}

    /**
     * Creates the mouse listener; it must also be added for mouse motions.
     *
     * @param placed receives a robot for which a command was submitted
     */
    RobotPlacing(TeamMap map, Team team, CommandChannel channel, Consumer<Member> placed) {
        this.map = map;
        this.team = team;
        this.channel = channel;
        this.placed = placed;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        drag = null;
        if (SwingUtilities.isLeftMouseButton(event) && event.isShiftDown()) {
            map.topRobotAt(event.getPoint()).ifPresent(robot -> begin(robot, event.getPoint()));
        }
    }

    private void begin(MapScene.Robot robot, Point pressed) {
        try {
            Member member = team.member(robot.number());
            Optional<String> reason = refusal(member);
            reason.ifPresent(channel::showError);
            if (reason.isEmpty()) {
                drag = new Drag(member, robot, pressed);
            }
        } catch (BotException e) {
            channel.showError(String.valueOf(e.getMessage()));
        }
    }

    /** Returns why a robot cannot be placed now; empty if it can. */
    private static Optional<String> refusal(Member member) {
        if (!member.bot().isConnected()) {
            return Optional.of(TEXTS.get("placing.lost", member.number()));
        }
        if (member.owner() != null) {
            return Optional.of(TEXTS.get("placing.used", member.number()));
        }
        if (!member.isIdle() || member.bot().state().moving()) {
            return Optional.of(TEXTS.get("placing.moves", member.number()));
        }
        return Optional.empty();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (drag != null) {
            map.preview(moved(drag.robot, pose(drag, event)));
        }
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        Drag ended = drag;
        drag = null;
        map.preview(null);
        if (ended != null && map.contains(event.getPoint()) && event.getPoint().distance(ended.pressed) > DRAG_PX) {
            refusal(ended.member).ifPresentOrElse(channel::showError, () -> place(ended, pose(ended, event)));
        }
    }

    private Pose pose(Drag dragged, MouseEvent event) {
        Pose from = standing(dragged.robot);
        Point2D start = map.view().place(dragged.pressed.x, dragged.pressed.y);
        Point2D mouse = map.view().place(event.getX(), event.getY());
        if (event.isControlDown() || event.isMetaDown()) {
            double heading = Math.toDegrees(Math.atan2(mouse.getY() - from.yMm(), mouse.getX() - from.xMm()));
            return new Pose(from.xMm(), from.yMm(), heading);
        }
        return new Pose(
                from.xMm() + mouse.getX() - start.getX(), from.yMm() + mouse.getY() - start.getY(), from.headingDeg());
    }

    /** Returns where a robot is as far as is known: in the lab its true pose. */
    private static Pose standing(MapScene.Robot robot) {
        return robot.truth() == null ? robot.reported() : robot.truth();
    }

    private void place(Drag ended, Pose pose) {
        int number = ended.member.number();
        channel.submit(String.join(
                " ",
                ended.robot.truth() == null ? number + " set pose" : "lab place " + number,
                "" + Math.round(pose.xMm()),
                "" + Math.round(pose.yMm()),
                "" + Math.round(pose.headingDeg())));
        placed.accept(ended.member);
    }

    /** Returns the picture of a robot at another pose. */
    private static MapScene.Robot moved(MapScene.Robot robot, Pose pose) {
        return new MapScene.Robot(
                robot.number(),
                robot.label(),
                robot.bodyMm(),
                robot.origin(),
                pose,
                Uncertainty.UNKNOWN,
                robot.truth() == null ? null : pose,
                new Trail(),
                robot.connected(),
                false,
                MapScene.PlannedWay.NONE);
    }
}
