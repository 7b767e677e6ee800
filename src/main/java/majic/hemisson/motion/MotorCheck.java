package majic.hemisson.motion;

import java.util.stream.Collectors;
import majic.hemisson.line.Identity;
import majic.hemisson.line.MotorValues;
import majic.hemisson.line.Reply;
import majic.hemisson.line.RunningMode;
import org.jspecify.annotations.Nullable;

/** Compares the speeds that the robot reports with those sent last. Thread-safe. */
public final class MotorCheck {
    private volatile MotorValues confirmed = MotorValues.STILL;
    private volatile @Nullable String found;

    /** Records the values that the robot confirmed. */
    void confirmed(MotorValues wheels) {
        confirmed = wheels;
    }

    /** The last difference, as half a sentence; null if there is none. */
    public @Nullable String found() {
        return found;
    }

    /**
     * Compares them. The TV remote control and the running modes set speeds of their own (Hemisson sheet 7 and 8).
     *
     * @return the difference and its remedy; null if there is none
     */
    @Nullable
    String compare(Reply speeds, Identity identity) {
        String difference = difference(speeds, identity);
        found = difference;
        return difference;
    }

    private @Nullable String difference(Reply speeds, Identity identity) {
        if (speeds.kind() != Reply.Kind.ANSWER || MotorValues.of(speeds).equals(confirmed)) {
            return null;
        }
        String set = speeds.numbers().stream().map(String::valueOf).collect(Collectors.joining(" and "));
        if (identity.hasOwnSpeeds()) {
            return "it runs in the mode \"" + RunningMode.of(identity.switches()) + "\" (switches "
                    + identity.switches() + "), which sets its wheels to " + set + "; " + Identity.REMEDY;
        }
        return "its wheels were set to " + set + " by something else, a TV remote control"
                + (identity.switches().isEmpty() ? " or another running mode than remote control" : "");
    }
}
