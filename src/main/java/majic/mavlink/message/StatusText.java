package majic.mavlink.message;

import java.util.Locale;

/**
 * A whole text of an autopilot. Immutable.
 *
 * @param severity 0 emergency to 7 debug (MAVLink sheet 6)
 * @param text not blank
 * @param atNanos when its last piece arrived, on the driver's clock
 */
public record StatusText(int severity, String text, long atNanos) {
    private static final int ERROR = 3;
    private static final int WARNING = 4;

    /** Whether it reports an error, or worse. */
    public boolean isError() {
        return severity <= ERROR;
    }

    /** Whether it reports a warning, or worse. */
    public boolean isWarning() {
        return severity <= WARNING;
    }

    /** Whether it announces a failsafe, as {@code Battery Failsafe}; not one that ended or that prevents arming. */
    public boolean isFailsafe() {
        String lower = text.toLowerCase(Locale.ROOT);
        return isWarning() && lower.contains("failsafe") && !lower.contains("clear") && !lower.contains("arm:");
    }
}
