package majic.ros.graph;

import java.util.List;

/**
 * What is known about a model of robot before it is connected. Immutable.
 *
 * @param name for users
 * @param radiusMm of a circle around its turning centre that contains it, mm
 * @param speedMmPerSec its highest speed, mm/s
 * @param turnDegPerSec its highest turn rate, deg/s
 * @param accelerationMmPerSec2 the change of speed that it can follow, mm/s²
 * @param accelerationDegPerSec2 the change of turn rate that it can follow, deg/s²
 * @param slowestMmPerSec the lowest speed that has an effect, mm/s
 * @param slowestDegPerSec the lowest turn rate that has an effect, deg/s
 * @param timeoutS after so many seconds without a command it stops by itself; infinite if it drives on, NaN if that is
 *     not known
 * @param commands the topics of its velocity commands relative to its namespace, the best one first; empty for any
 * @param odometry the topics of its odometry relative to its namespace, the best one first; empty for any
 * @param note a sentence for the user when it is connected; empty for none
 */
public record KnownRobot(
        String name,
        double radiusMm,
        double speedMmPerSec,
        double turnDegPerSec,
        double accelerationMmPerSec2,
        double accelerationDegPerSec2,
        double slowestMmPerSec,
        double slowestDegPerSec,
        double timeoutS,
        List<String> commands,
        List<String> odometry,
        String note) {

    /**
     * Returns what the robot does when commands end.
     *
     * @return as {@code stops after 0.5 s}
     */
    public String afterCommands() {
        if (Double.isNaN(timeoutS)) {
            return "unknown";
        }
        return Double.isInfinite(timeoutS) ? "drives on" : "stops after " + timeoutS + " s";
    }
}
