package majic.aibo.urbi;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** How commands are written for the two generations of servers (URBI sheet 1). */
public enum UrbiVersion {
    /** 1.0 and before: a tag names the command whose values it marks. */
    V1_0("%s: %s"),
    /** 1.5: values are sent into a channel of that name. */
    V1_5("%s << %s");

    private final String labelled;

    UrbiVersion(String labelled) {
        this.labelled = labelled;
    }

    /** Returns the version that a banner line names, or the given one if it names none. */
    public static UrbiVersion of(String bannerLine, UrbiVersion otherwise) {
        if (bannerLine.contains("URBI Kernel version 1.5")) {
            return V1_5;
        }
        return bannerLine.contains("URBI Kernel version") ? V1_0 : otherwise;
    }

    /** Returns a command that makes the server send a value under a tag. Without the separator. */
    public String labelled(String tag, String expression) {
        return String.format(labelled, tag, expression);
    }

    /** A number as every URBI reads it: plain decimals, since {@code 1e3} is a syntax error (URBI sheet 5). */
    public static String number(double amount) {
        BigDecimal rounded =
                BigDecimal.valueOf(amount).setScale(4, RoundingMode.HALF_UP).stripTrailingZeros();
        return rounded.signum() == 0 ? "0" : rounded.toPlainString();
    }
}
