package majicsim.pioneer.motion;

/**
 * Whether the motors push without getting anywhere (ARCOS sheet 7.5): set when the robot meets something, kept while the
 * command that pushed is in force, cleared once it has come away or is commanded to stop. Shown in at least one SIP. After each
 * push the motors have no power for a pause, then they try again.
 */
public final class Stall {
    /** Less than this, in mm or degrees, is settling against the obstacle, not coming away. */
    private static final double AWAY = 2;

    private boolean stalled;
    private boolean unreported;
    private double cameAway;
    private double pauseSeconds;

    /** Met something; the motors are to rest for so long. */
    void pushed(double newPauseSeconds) {
        stalled = true;
        unreported = true;
        cameAway = 0;
        pauseSeconds = newPauseSeconds;
    }

    /** Covered this way, or this angle, freely. */
    void moved(double amount) {
        cameAway += Math.abs(amount);
        if (cameAway > AWAY) {
            stalled = false;
        }
    }

    /** Neither moves nor is commanded to. */
    void rests() {
        stalled = false;
    }

    void step(double seconds) {
        pauseSeconds = Math.max(0, pauseSeconds - seconds);
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
