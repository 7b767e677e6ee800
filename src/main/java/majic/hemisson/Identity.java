package majic.hemisson;

import java.util.List;

/**
 * Who answered at connecting. Immutable.
 *
 * @param version the firmware's name: {@code HemiOS_v_1.50}
 * @param switches the four switches as the robot lists them, 0 or 1; empty if it did not say
 * @param tellsSpeeds whether it can be asked for its speeds, as HemiOS 1.40 and later can
 */
record Identity(String version, List<Integer> switches, boolean tellsSpeeds) {
    private static final List<Integer> REMOTE_CONTROL = List.of(1, 1, 1, 1);

    static final Identity NOBODY = new Identity("", List.of(), false);

    Identity {
        switches = List.copyOf(switches);
    }

    /** Whether the switches select the mode in which the robot does what it is told, and nothing else (sheet 7). */
    boolean isRemoteControlled() {
        return switches.isEmpty() || switches.equals(REMOTE_CONTROL);
    }

    /** Whether it speaks the dialect of the robots that RoadNarrows sold (sheet 10). */
    boolean isRoadNarrows() {
        return version.contains("-RN");
    }
}
