package majic.shared;

import majic.shared.message.RobotState.Holder;
import org.jspecify.annotations.Nullable;

/**
 * Which program may move a shared robot, as its desk has reported it last. Immutable.
 *
 * @param holder that program; null if the robot is free
 * @param here whether it is this program
 */
record RobotHolder(@Nullable Holder holder, boolean here) {
    /** Returns whether another program holds the robot, so that this one may not move it. */
    boolean isElsewhere() {
        return holder != null && !here;
    }

    /** Returns the user and desk, and what the program runs if that is known; empty if the robot is free. */
    String title() {
        if (holder == null) {
            return "";
        }
        return holder.work().isEmpty() ? holder.toString() : holder + " (" + holder.work() + ")";
    }

    /** Returns the value of the parameter {@code holder}. */
    @Override
    public String toString() {
        if (holder == null) {
            return "nobody";
        }
        return here ? "this program" : title();
    }
}
