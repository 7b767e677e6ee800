package majic.soak;

import java.util.regex.Pattern;

/** How a command to one robot ended, as the session log words it. */
enum Outcome {
    DONE,
    STOPPED,
    LOST,
    FAILED,
    NOT_RUN,
    NOT_STOPPED,
    REFUSED;

    private static final Pattern LOSS = Pattern.compile("connect|link|answer|report");

    /** Returns the outcome of a line of the log that begins with the command's text. */
    static Outcome of(String kind, String how) {
        return switch (kind) {
            case "error" -> REFUSED;
            case "alarm" -> NOT_STOPPED;
            case "failure" -> LOSS.matcher(how).find() ? LOST : FAILED;
            default -> how.startsWith("not run") ? NOT_RUN : how.startsWith("stopped") ? STOPPED : DONE;
        };
    }
}
