package majic.hemisson.line;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The robot that answered at connecting. Immutable.
 *
 * @param version the name of the firmware: {@code HemiOS_v_1.50}
 * @param switches the four switches in the robot's order, 0 or 1; empty if it did not report them
 * @param tellsSpeeds whether it reports its speeds, as HemiOS 1.40 and later do
 */
public record Identity(String version, List<Integer> switches, boolean tellsSpeeds) {
    private static final List<Integer> REMOTE_CONTROL = List.of(1, 1, 1, 1);

    /** The modes in which the factory firmware reads every command, remote control first (sheet 7). */
    private static final List<List<Integer>> LISTENING_MODES =
            List.of(REMOTE_CONTROL, List.of(1, 1, 1, 0), List.of(1, 1, 0, 1), List.of(1, 0, 1, 1), List.of(0, 1, 1, 1));

    /** The remedy for another mode than remote control. */
    public static final String REMEDY = "put all four to the side that reads 1 and switch it off and on";

    public static final Identity NONE = new Identity("", List.of(), false);

    public Identity {
        switches = List.copyOf(switches);
    }

    /** Whether the switches select the mode that executes commands and nothing else, or are unknown (sheet 7). */
    public boolean isRemoteControlled() {
        return switches.isEmpty() || switches.equals(REMOTE_CONTROL);
    }

    /** Whether it reads every command, whatever else it does; in other modes a long one may deafen it (sheet 7). */
    public boolean listens() {
        return switches.isEmpty() || LISTENING_MODES.contains(switches);
    }

    /** Whether its running mode overrides the motor values that are sent. Other firmware may have no modes. */
    public boolean hasOwnSpeeds() {
        return listens() && !isRemoteControlled();
    }

    /** Whether its running mode may move it without reporting its speeds. */
    public boolean mayMoveUnreported() {
        return !tellsSpeeds && !isRemoteControlled();
    }

    /** The same robot after a restart, with the switches read then. */
    public Identity restarted(List<Integer> newSwitches) {
        return new Identity(version, newSwitches, tellsSpeeds);
    }

    /** A warning about its mode; null in remote control mode. */
    public @Nullable String warning() {
        return isRemoteControlled()
                ? null
                : "its switches read " + switches + ", so it does not run in remote control mode and may do "
                        + "as it likes; " + REMEDY;
    }

    /** Whether it has the dialect of the robots that RoadNarrows sold (sheet 10). */
    boolean isRoadNarrows() {
        return version.contains("-RN");
    }
}
