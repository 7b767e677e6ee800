package majic.gui;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import majic.bot.Pose;

/** Where a robot has been, for a while. Used on one thread. */
final class Trail {
    private static final int LONGEST = 600;
    private static final double STEP_MM = 20;

    private final Deque<MapScene.Point> points = new ArrayDeque<>();
    private List<MapScene.Point> copy = List.of();

    /** Takes in where the robot is now; small steps are left out. */
    List<MapScene.Point> with(Pose now) {
        MapScene.Point last = points.peekLast();
        if (last == null || Math.hypot(now.xMm() - last.xMm(), now.yMm() - last.yMm()) >= STEP_MM) {
            points.add(new MapScene.Point(now.xMm(), now.yMm()));
            if (points.size() > LONGEST) {
                points.remove();
            }
            copy = List.copyOf(points);
        }
        return copy;
    }
}
