package majicsim.pioneer.motion;

/**
 * Whether the motors push against an obstacle (ARCOS sheet 7.5): set when the robot meets one, kept while the same
 * command is in force, cleared after the robot has moved away or was commanded to stop. Shown in at least one SIP.
 * After each push the motors have no power for a pause, then they try again.
 */
public final class Stall {
    /** Less motion than this, in mm or degrees, does not count as moving away. */
    private static final double AWAY = 2;

    private boolean stalled;
    private boolean unreported;
    private double cameAway;
    private double pauseSeconds;

    /** Reports an obstacle; the motors rest for this time. */
    void pushed(double newPauseSeconds) {
        stalled = true;
        unreported = true;
        cameAway = 0;
        pauseSeconds = newPauseSeconds;
    }

    /** Reports free motion over this distance or angle. */
    void moved(double amount) {
        cameAway += Math.abs(amount);
        if (cameAway > AWAY) {
            stalled = false;
        }
    }

    /** Reports a step with neither motion nor a motion command. */
    void rests() {
        stalled = false;
    }

    void step(double seconds) {
        if (pauseSeconds > 0) {
            pauseSeconds = Math.max(0, pauseSeconds - seconds);
        }
    }

    /** Whether the motors have no power because of a stall a moment ago. */
    boolean isPausing() {
        return pauseSeconds > 0;
    }

    /** For the SIP: whether it is stalled, or was since the last call. */
    public boolean report() {
        boolean report = stalled || unreported;
        unreported = false;
        return report;
    }
}
