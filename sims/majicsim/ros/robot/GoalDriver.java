package majicsim.ros.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.function.BooleanSupplier;
import majicsim.ros.graph.Topic;
import majicsim.ros.options.RosOptions;
import org.jspecify.annotations.Nullable;

/**
 * Drives straight to a goal: turns towards it, drives, turns as the goal demands. It avoids nothing, and gives up when
 * the robot is blocked. Like real navigation it publishes velocities on the topic that other nodes use too, and nothing
 * arbitrates.
 */
final class GoalDriver {
    private static final long PERIOD_NANOS = 48_000_000;
    private static final int MOST_BLOCKED = 60;
    private static final double NEAR_M = 0.02;
    private static final double ALIGNED_RAD = 0.03;
    private static final double TURN_FIRST_RAD = 0.3;
    private static final double GAIN_PER_SEC = 1.5;
    private static final double SLOWEST_TURN = 0.1;
    private static final double FASTEST_TURN = 1.5;
    private static final double SLOWEST = 0.03;
    private static final double FASTEST = 0.18;

    private final Topic commands;
    private final boolean isStamped;
    private final WheelOdometry odometry;
    private final BooleanSupplier isBlocked;
    private @Nullable Task task;
    private long dueNanos;

    GoalDriver(Topic commands, RosOptions options, WheelOdometry odometry, BooleanSupplier isBlocked) {
        this.commands = commands;
        this.isStamped = options.isStamped();
        this.odometry = odometry;
        this.isBlocked = isBlocked;
    }

    /** Drives to a goal instead of the present one, if there is any, which ends as replaced. */
    void start(Goal goal, Listener listener) {
        end(Outcome.REPLACED);
        task = new Task(goal, listener);
        if (!goal.isValid()) {
            end(Outcome.FAILED);
        }
    }

    void cancel() {
        end(Outcome.CANCELED);
    }

    boolean isActive() {
        return task != null;
    }

    WheelOdometry odometry() {
        return odometry;
    }

    /** The distance to the goal, m; 0 without one. */
    double remaining() {
        return task == null ? 0 : Math.hypot(task.goal.x() - odometry.x(), task.goal.y() - odometry.y());
    }

    void step(long nowNanos) {
        if (task != null && nowNanos >= dueNanos) {
            dueNanos = nowNanos + PERIOD_NANOS;
            drive(task);
        }
    }

    private void drive(Task present) {
        present.blocked = isBlocked.getAsBoolean() ? present.blocked + 1 : 0;
        double distance = remaining();
        if (present.blocked > MOST_BLOCKED) {
            end(Outcome.FAILED);
        } else if (distance > NEAR_M && !present.isThere) {
            driveTowards(present.goal, distance);
        } else {
            present.isThere = true;
            turn(present.goal);
        }
    }

    private void driveTowards(Goal goal, double distance) {
        double bearing = error(Math.atan2(goal.y() - odometry.y(), goal.x() - odometry.x()));
        double turning = limited(GAIN_PER_SEC * bearing, 0, FASTEST_TURN);
        if (Math.abs(bearing) > TURN_FIRST_RAD) {
            publish(0, turning);
        } else {
            publish(limited(distance, SLOWEST, FASTEST), turning);
        }
    }

    private void turn(Goal goal) {
        double error = error(goal.yaw());
        if (Math.abs(error) > ALIGNED_RAD) {
            publish(0, limited(GAIN_PER_SEC * error, SLOWEST_TURN, FASTEST_TURN));
        } else {
            end(Outcome.REACHED);
        }
    }

    private double error(double yaw) {
        return Math.IEEEremainder(yaw - odometry.yaw(), 2 * Math.PI);
    }

    private static double limited(double value, double least, double most) {
        return Math.copySign(Math.max(least, Math.min(most, Math.abs(value))), value);
    }

    private void end(Outcome outcome) {
        Task ended = task;
        if (ended != null) {
            task = null;
            publish(0, 0);
            ended.listener.ended(outcome);
        }
    }

    private void publish(double metresPerSec, double radPerSec) {
        ObjectNode twist = Messages.twist(metresPerSec, radPerSec);
        commands.publish(isStamped ? Messages.empty().set("twist", twist) : twist);
    }

    /** How a task ended. */
    enum Outcome {
        REACHED,
        FAILED,
        CANCELED,
        REPLACED
    }

    /** Receives the end of a task, once. */
    interface Listener {
        void ended(Outcome outcome);
    }

    private static final class Task {
        private final Goal goal;
        private final Listener listener;
        private int blocked;
        private boolean isThere;

        Task(Goal goal, Listener listener) {
            this.goal = goal;
            this.listener = listener;
        }
    }
}
