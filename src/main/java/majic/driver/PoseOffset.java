package majic.driver;

import java.util.Optional;
import majic.bot.BotState;
import majic.bot.Pose;
import org.jspecify.annotations.Nullable;

/**
 * The offset between the pose by a robot's own odometry and the pose that users see. Placing the robot changes the
 * offset and never the odometry, so that a motion in progress is not disturbed. Thread-safe.
 */
final class PoseOffset {
    private BotState own = BotState.UNKNOWN;
    private Pose origin = Pose.START;
    private @Nullable Pose start;
    private boolean reconnected;

    /**
     * Takes a state whose pose is by the odometry.
     *
     * @return the state that users see
     */
    synchronized BotState reported(BotState state) {
        if (reconnected && start != null) {
            origin = origin.plus(own.pose()).originOf(state.pose());
        }
        reconnected = false;
        own = state;
        return shown();
    }

    /**
     * Shows the present place of the robot as another one from now on.
     *
     * @return the state that users see
     */
    synchronized BotState place(Pose place) {
        start = place;
        origin = place.originOf(own.pose());
        return shown();
    }

    /** The place at which the robot was put last; empty if it was never placed. */
    synchronized Optional<Pose> start() {
        return Optional.ofNullable(start);
    }

    /** Keeps a placed robot where it is, although the odometry may start again with its next report. */
    synchronized void reconnecting() {
        reconnected = true;
    }

    private BotState shown() {
        return start == null
                ? own
                : new BotState(
                        origin.plus(own.pose()),
                        own.speedMmPerSec(),
                        own.turnRateDegPerSec(),
                        own.moving(),
                        own.atNanos());
    }
}
