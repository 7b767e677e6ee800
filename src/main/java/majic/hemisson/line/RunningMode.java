package majic.hemisson.line;

import java.util.List;
import java.util.Map;

/** What the robot does by itself, as selected by its four switches when it is switched on (Hemisson sheet 7). */
public final class RunningMode {
    /** The mode that executes commands and nothing else. */
    static final String REMOTE_CONTROL = "remote control";

    private static final Map<List<Integer>, String> BY_SWITCHES = Map.of(
            List.of(1, 1, 1, 1), REMOTE_CONTROL,
            List.of(1, 1, 1, 0), "obstacle avoidance",
            List.of(1, 1, 0, 1), "line following",
            List.of(1, 0, 1, 1), "dance",
            List.of(0, 1, 1, 1), "BotStudio program");

    private RunningMode() {}

    /** The name in the robot's manual; half a sentence for switches that select no mode. */
    public static String of(List<Integer> switches) {
        return BY_SWITCHES.getOrDefault(switches, "none that is known");
    }
}
