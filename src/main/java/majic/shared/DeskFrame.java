package majic.shared;

import java.util.Optional;
import java.util.regex.Pattern;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.shared.message.RobotState.Movement;
import org.jspecify.annotations.Nullable;

/**
 * The frame of the poses of a shared robot. This program uses the frame of the robot's desk, so that the pose is the
 * same at all desks, until its user places the robot elsewhere. Thread-safe.
 */
final class DeskFrame {
    private static final Pattern POSE = Pattern.compile("(?i)\\b(x|y|heading|pose)\\b");

    private final MajicBot bot;

    /** Where this class has placed the robot last; null before. */
    private volatile @Nullable Pose adopted;

    /** Of the odometry of the robot at its desk, as reported last; null before. */
    private volatile @Nullable Pose origin;

    DeskFrame(MajicBot bot) {
        this.bot = bot;
    }

    /** Takes the frame over from the first state of a connection, unless the user has placed the robot elsewhere. */
    void connected(Movement reported) {
        if (reported.placed() && isAdopted()) {
            adopt(reported.pose());
        }
    }

    /** Takes the frame over from a state if the robot was not placed before, or its desk has placed it anew. */
    void reported(Movement reported) {
        boolean anew = !reported.origin().equals(origin) && isAdopted();
        origin = reported.origin();
        if (reported.placed() && (bot.placedAt().isEmpty() || anew)) {
            adopt(reported.pose());
        }
    }

    /**
     * Takes over the frame of the desk.
     *
     * @param pose the robot's present pose at its desk
     */
    void adopt(Pose pose) {
        adopted = pose;
        bot.place(pose);
    }

    /** Returns a pose in the frame of this program as it is in that of the desk. */
    Pose atDesk(Pose here) {
        Pose there = origin;
        return isAdopted() || there == null ? here : there.plus(here.seenFrom(bot.odometryOrigin()));
    }

    /** Returns whether a condition in MAJIC Script means the same at the desk as here. */
    boolean hasMeaningOf(String condition) {
        return isAdopted() || !POSE.matcher(condition).find();
    }

    /** Returns whether the robot is in the frame of the desk. */
    boolean isAdopted() {
        return bot.placedAt().equals(Optional.ofNullable(adopted));
    }
}
