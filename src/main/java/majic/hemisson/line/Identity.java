package majic.hemisson.line;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Who answered at connecting. Immutable.
 *
 * @param version the firmware's name: {@code HemiOS_v_1.50}
 * @param switches the four switches as the robot lists them, 0 or 1; empty if it did not say
 * @param tellsSpeeds whether it can be asked for its speeds, as HemiOS 1.40 and later can
 */
public record Identity(String version, List<Integer> switches, boolean tellsSpeeds) {
    private static final List<Integer> REMOTE_CONTROL = List.of(1, 1, 1, 1);

    /** The modes in which the factory firmware reads every command, remote control first (sheet 7). */
    private static final List<List<Integer>> LISTENING_MODES =
            List.of(REMOTE_CONTROL, List.of(1, 1, 1, 0), List.of(1, 1, 0, 1), List.of(1, 0, 1, 1), List.of(0, 1, 1, 1));

    /** What a person can do about another mode than remote control. */
    public static final String REMEDY = "put all four to the side that reads 1 and switch it off and on";

    public static final Identity NOBODY = new Identity("", List.of(), false);

    public Identity {
        switches = List.copyOf(switches);
    }

    /** Whether the switches select the mode in which the robot does what it is told, and nothing else (sheet 7). */
    public boolean isRemoteControlled() {
        return switches.isEmpty() || switches.equals(REMOTE_CONTROL);
    }

    /** Whether it takes every command, whatever else it does; in other modes a long one may deafen it (sheet 7). */
    public boolean listens() {
        return switches.isEmpty() || LISTENING_MODES.contains(switches);
    }

    /** Whether its running mode sets its wheels, whatever they were told. A firmware built by others may have no modes. */
    public boolean setsItsOwnSpeeds() {
        return listens() && !isRemoteControlled();
    }

    /** Whether its running mode may move it, and it cannot be asked whether it does. */
    public boolean mayMoveUntold() {
        return !tellsSpeeds && !isRemoteControlled();
    }

    /** The same robot after a restart, in the mode that its switches select now. */
    public Identity restarted(List<Integer> newSwitches) {
        return new Identity(version, newSwitches, tellsSpeeds);
    }

    /** What is to be said of its mode; null if nothing is wrong with it. */
    public @Nullable String warning() {
        return isRemoteControlled()
                ? null
                : "its switches read " + switches + ", so it does not run in remote control mode and may do "
                        + "as it likes; " + REMEDY;
    }

    /** Whether it speaks the dialect of the robots that RoadNarrows sold (sheet 10). */
    boolean isRoadNarrows() {
        return version.contains("-RN");
    }
}
