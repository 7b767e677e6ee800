package majic.team;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotControl;
import majic.time.TimeSource;

/**
 * Records what a {@link ManualControl} sends to its robot, as commands that repeat it: consecutive equal drives become
 * one command with a time. Times are never rounded up, and a drive that expired counts until its expiry. Used by one
 * thread.
 */
final class ManualLog {
    /** The longest time that a timed drive accepts, seconds. */
    private static final double LONGEST_DRIVE_S = 60;

    /** Shorter drives moved nothing, seconds. */
    private static final double SHORTEST_DRIVE_S = 0.01;

    private final TimeSource time;
    private final List<ManualCommand> commands = new ArrayList<>();
    private double mmPerSec;
    private double degPerSec;
    private long beganNanos;
    private long renewedNanos;
    private boolean driving;

    /**
     * Creates an empty log.
     *
     * @param time the clock of the team
     */
    ManualLog(TimeSource time) {
        this.time = time;
    }

    /** Adds a drive that was just sent; mm/s and deg/s. */
    void drove(double ahead, double left) {
        long now = time.nanos();
        boolean goesOn = driving && ahead == mmPerSec && left == degPerSec && now <= expiryNanos();
        if (!goesOn) {
            endDrive(now);
            driving = ahead != 0 || left != 0;
            mmPerSec = ahead;
            degPerSec = left;
            beganNanos = now;
        }
        renewedNanos = now;
    }

    /** Adds a parameter that was just set, in its own unit. */
    void set(String parameter, double number, boolean isInMs) {
        long now = time.nanos();
        endDrive(now);
        commands.add(new ManualCommand(now, "set " + parameter + " " + decimal(number) + (isInMs ? "ms" : "")));
    }

    /** Ends the drive under way, if there is one, and returns everything so far, oldest first. */
    List<ManualCommand> end() {
        endDrive(time.nanos());
        return List.copyOf(commands);
    }

    private void endDrive(long now) {
        if (driving) {
            driving = false;
            addDrive((Math.min(now, expiryNanos()) - beganNanos) / 1e9);
        }
    }

    private long expiryNanos() {
        return renewedNanos + (long) (BotControl.DRIVE_LEASE_S * 1e9);
    }

    private void addDrive(double seconds) {
        long at = beganNanos;
        for (double left = seconds; left >= SHORTEST_DRIVE_S; left -= LONGEST_DRIVE_S) {
            String duration = decimal(Math.min(left, LONGEST_DRIVE_S));
            commands.add(new ManualCommand(
                    at, "drive " + decimal(mmPerSec) + " " + decimal(degPerSec) + " for " + duration + "s"));
            at += (long) (LONGEST_DRIVE_S * 1e9);
        }
    }

    /** Rounds towards zero, so that nothing becomes faster or longer. */
    private static String decimal(double number) {
        BigDecimal cut = BigDecimal.valueOf(number).setScale(3, RoundingMode.DOWN);
        return cut.signum() == 0 ? "0" : cut.stripTrailingZeros().toPlainString();
    }
}
