package majic.aibo.urbi;

import java.util.List;

/** Builds the URBI commands that several parts of the driver send. */
public final class UrbiCommands {
    /** Ends the walks of all clients: these tags are the stick's own, inside of its gaits (URBI sheet 15, 19). */
    public static final String STOP_GAITS = "stop walk, stop turn,";

    private UrbiCommands() {}

    /** Returns commands that start in the same cycle and end when all have ended (URBI sheet 3). */
    public static String together(List<String> commands) {
        return commands.size() == 1 ? commands.get(0) : "{ " + String.join(" & ", commands) + " }";
    }

    /**
     * Returns a command to a group of devices such that it ends once, under its own tag. Without the braces a 1.0
     * kernel reports an end for each member, some or all of them under the tag {@code __system__} (URBI sheet 21).
     */
    public static String toGroup(String command) {
        return "{ " + command + " }";
    }

    /** Returns an assignment of a number. */
    public static String assign(String variable, double amount) {
        return variable + " = " + UrbiVersion.number(amount);
    }
}
