package majic.figures.nav;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Pose;

/**
 * Drives a robot through way points by its true pose: it turns towards the next one, and drives while it looks there.
 */
final class OfficeTour {
    private static final double SPEED_MM_PER_S = 400;
    private static final double REACHED_MM = 250;
    private static final double AHEAD_DEG = 25;
    private static final double MOST_DEG_PER_S = 40;
    private static final double DEG_PER_S_PER_DEG = 1.5;

    private final MajicBot robot;
    private final Deque<Pose> left;

    OfficeTour(MajicBot robot, List<Pose> way) {
        this.robot = robot;
        this.left = new ArrayDeque<>(way);
    }

    /**
     * Drives on.
     *
     * @param at the true pose
     * @return whether way points are left
     */
    boolean step(Pose at) {
        while (!left.isEmpty() && left.element().distanceMm(at) < REACHED_MM) {
            left.remove();
        }
        if (left.isEmpty()) {
            robot.drive(0, 0);
            return false;
        }
        Pose goal = left.element().seenFrom(at);
        double angle = Math.toDegrees(Math.atan2(goal.yMm(), goal.xMm()));
        double rate = Math.max(-MOST_DEG_PER_S, Math.min(MOST_DEG_PER_S, DEG_PER_S_PER_DEG * angle));
        robot.drive(Math.abs(angle) < AHEAD_DEG ? SPEED_MM_PER_S : 0, rate);
        return true;
    }
}
