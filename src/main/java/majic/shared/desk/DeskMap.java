package majic.shared.desk;

import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.shared.message.RequestedAction;

/** What a desk does for the robots that it shares with its map; without one it refuses. */
public interface DeskMap {
    /**
     * Looks for a robot everywhere on the map. May block for some seconds.
     *
     * @param robot connected
     * @throws BotException if it cannot be looked for
     */
    default void localize(MajicBot robot) {
        throw new BotException("localize: there is no map");
    }

    /**
     * Drives a robot to a place and returns when it is stationary again.
     *
     * @param robot connected
     * @param control the permission to move that robot
     * @param place in the frame of the robot's poses
     * @param guard ends the motion early; made from {@link RequestedAction.GoTo#until()}
     * @return the place that it has reached
     * @throws BotException if the motion was stopped or failed
     */
    default MotionReport goTo(MajicBot robot, BotControl control, RequestedAction.GoTo place, Guard guard) {
        throw new BotException("goto: this desk sends no robots to places");
    }
}
