package majic.ros.navigation;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.driver.Motion;
import majic.ros.bridge.ActionGoal;
import majic.ros.readings.RosClient;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * Pursues one goal at a time. A stop has to call {@link #cancel}, after it has sent its zero velocity: until the goal
 * is cancelled the robot's own navigation sends velocities as well. Thread-safe.
 */
public final class Navigation {
    private static final Logger LOG = System.getLogger(Navigation.class.getName());

    /** Servers answer at once; one that rejects a goal never does. */
    private static final double ANSWER_S = 5;

    /** Across a large building at a walking pace. */
    private static final double LONGEST_S = 1800;

    private static final double DOCK_S = 180;

    private final Signal changes;
    private volatile @Nullable Goal running;
    private volatile boolean unfinished;
    private volatile @Nullable Connected connected;

    /** The robot of the newest connection. */
    private record Connected(RosClient connection, NavigationServers servers) {
        /** Cancels the goals of all programs; waits for nothing. */
        void cancelAll() {
            servers.moveBase().ifPresent(server -> MoveBaseGoal.cancelAll(connection, server));
            Stream.of(servers.navigateToPose(), servers.dock(), servers.undock())
                    .flatMap(Optional::stream)
                    .forEach(action ->
                            connection.request(action + "/_action/cancel_goal", JsonNodeFactory.instance.objectNode()));
        }
    }

    /**
     * Creates an idle navigation.
     *
     * @param changes the signal that all threads waiting for the robot wait on
     */
    public Navigation(Signal changes) {
        this.changes = changes;
    }

    /**
     * A place to drive to.
     *
     * @param frame in which it is given, as {@code odom} or {@code map}
     * @param pose in mm and degrees
     */
    public record Target(String frame, Pose pose) {
        ObjectNode message() {
            ObjectNode message = JsonNodeFactory.instance.objectNode();
            message.putObject("header").put("frame_id", frame);
            ObjectNode place = message.putObject("pose");
            place.putObject("position")
                    .put("x", pose.xMm() / 1000)
                    .put("y", pose.yMm() / 1000)
                    .put("z", 0.0);
            double half = Math.toRadians(pose.headingDeg()) / 2;
            place.putObject("orientation")
                    .put("x", 0.0)
                    .put("y", 0.0)
                    .put("z", Math.sin(half))
                    .put("w", Math.cos(half));
            return message;
        }
    }

    /**
     * Drives to a place, and returns when the robot reports its arrival, or the guard has ended it.
     *
     * @param servers of the robot; at least one of move_base and Nav2
     * @param target where
     * @param motion for sending and waiting; a stop and the guard cancel the goal
     * @throws MotionFailed if the robot does not take the goal or gives it up; it is cancelled then
     * @throws LinkLost if the connection is lost; the robot may go on
     */
    public void drive(RosClient connection, NavigationServers servers, Target target, Motion motion) {
        if (servers.moveBase().isPresent()) {
            pursue(
                    new MoveBaseGoal(connection, servers.moveBase().get(), target.message(), changes),
                    motion,
                    new Limits(ANSWER_S, LONGEST_S));
            return;
        }
        String action = servers.navigateToPose()
                .orElseThrow(() -> new BotException("there is neither move_base nor Nav2 on this robot"));
        ObjectNode arguments = JsonNodeFactory.instance.objectNode();
        arguments.set("pose", target.message());
        pursue(
                action(connection, new ActionGoal(action, "nav2_msgs/action/NavigateToPose", arguments)),
                motion,
                new Limits(ANSWER_S, LONGEST_S));
    }

    /**
     * Runs an action without arguments, such as docking, until its end.
     *
     * @param action its absolute name
     * @param type as {@code irobot_create_msgs/action/Dock}
     * @param motion as in {@link #drive}
     * @throws MotionFailed if the robot gives it up, or takes longer than three minutes
     */
    public void perform(RosClient connection, String action, String type, Motion motion) {
        ActionGoal goal = new ActionGoal(action, type, JsonNodeFactory.instance.objectNode());
        pursue(action(connection, goal), motion, new Limits(DOCK_S, DOCK_S));
    }

    private Goal action(RosClient connection, ActionGoal goal) {
        return new ActionGoalRun(connection.openGoal(), goal, changes);
    }

    /** How long to wait for the first report and for the end, s. */
    private record Limits(double answerS, double endS) {}

    private void pursue(Goal goal, Motion motion, Limits limits) {
        running = goal;
        try (goal) {
            motion.send(goal::send);
            if (!motion.await(goal::isAnswered, limits.answerS()) && !motion.guardReached()) {
                throw new MotionFailed("the navigation of the robot did not take the goal within "
                        + Math.round(limits.answerS()) + " s; it may be starting, without a map, or blocked");
            }
            if (!motion.await(() -> goal.result().isPresent(), limits.endS()) && !motion.guardReached()) {
                throw new MotionFailed("the goal was not reached within " + Math.round(limits.endS()) + " s");
            }
            if (!motion.guardReached()) {
                check(goal);
            }
        } catch (LinkLost e) {
            unfinished = true;
            throw e;
        } finally {
            if (goal.result().isEmpty()) {
                attemptCancel(goal);
            }
            running = null;
        }
    }

    private static void check(Goal goal) {
        Goal.Result result = goal.result().orElse(Goal.Result.FAILED);
        String reason = goal.reason().isBlank() || goal.reason().equals("0") ? "" : ": " + goal.reason();
        switch (result) {
            case SUCCEEDED -> {}
            case CANCELLED -> throw new MotionFailed("the goal was cancelled on the robot" + reason);
            case FAILED -> throw new MotionFailed("the robot gave the goal up" + reason);
        }
    }

    /**
     * Cancels all goals that the robot pursues, those of other programs too: they would move it on after the stop.
     * Waits for nothing and throws nothing.
     */
    public void cancel() {
        Goal goal = running;
        Connected robot = connected;
        if (goal != null) {
            attemptCancel(goal);
        } else if (robot != null) {
            try {
                robot.cancelAll();
            } catch (LinkLost e) {
                LOG.log(Level.DEBUG, "the goals of other programs could not be cancelled", e);
            }
        }
    }

    private void attemptCancel(Goal goal) {
        try {
            goal.cancel();
        } catch (LinkLost e) {
            unfinished = true;
            LOG.log(Level.DEBUG, "the goal could not be cancelled", e);
        }
    }

    /**
     * Uses a new connection from now on, and cancels what the robot may still pursue since the last one was lost: the
     * loss cancels no goal (rosbridge sheet 6). Sends nothing after a connection that ended without a goal.
     *
     * @param servers of the robot
     * @throws LinkLost if the connection has ended
     */
    public void begin(RosClient connection, NavigationServers servers) {
        Connected robot = new Connected(connection, servers);
        connected = robot;
        if (unfinished) {
            robot.cancelAll();
            unfinished = false;
        }
    }

    /**
     * Returns how far the goal still is.
     *
     * @return mm; empty without a goal, or if the robot does not report it
     */
    public OptionalDouble leftMm() {
        return Optional.ofNullable(running).map(Goal::leftMm).orElse(OptionalDouble.empty());
    }

    /**
     * Returns whether a goal is being pursued.
     *
     * @return true from its sending to its end
     */
    public boolean isPursuing() {
        return running != null;
    }
}
