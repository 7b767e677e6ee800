package majic.pioneer.parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import majic.pioneer.state.Gripper;

/** Actions of gripper and lift, with the argument of the command (ARCOS sheet 11.5). */
enum GripperAction {
    /** Paddles apart. */
    OPEN(1, Gripper::open),
    /** Paddles together, or on an object between them. */
    CLOSE(2, Gripper::closed),
    /** Lift all the way up. */
    UP(4, Gripper::liftUp),
    /** Lift all the way down. */
    DOWN(5, Gripper::liftDown),
    /** Closed and up, for driving. */
    STORE(7, gripper -> gripper.closed() && gripper.liftUp()),
    /** Open and down, for gripping. */
    DEPLOY(8, gripper -> gripper.open() && gripper.liftDown()),
    /** Stop both. */
    STOP(15, gripper -> true);

    private final int argument;
    private final Predicate<Gripper> end;

    GripperAction(int argument, Predicate<Gripper> end) {
        this.argument = argument;
        this.end = end;
    }

    static GripperAction of(String word) {
        return valueOf(word.toUpperCase(Locale.ROOT));
    }

    static List<String> words() {
        return Arrays.stream(values()).map(GripperAction::word).toList();
    }

    String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    int argument() {
        return argument;
    }

    /** Whether the action is done and nothing moves any more. */
    boolean isDone(Gripper gripper) {
        return end.test(gripper) && !gripper.moving() && !gripper.liftMoving();
    }
}
