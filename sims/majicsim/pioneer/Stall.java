package majicsim.pioneer;

/**
 * Whether the motors push without getting anywhere (ARCOS sheet 7.5): set when the robot meets something, kept while the
 * command that pushed is in force, cleared once it has come away or is asked to rest. Shown in at least one SIP.
 */
final class Stall {
    /** Less than this, in mm or degrees, is settling against the obstacle, not coming away. */
    private static final double AWAY = 2;

    private boolean stalled;
    private boolean untold;
    private double cameAway;

    void pushed() {
        stalled = true;
        untold = true;
        cameAway = 0;
    }

    /** Covered this way, or this angle, freely. */
    void moved(double amount) {
        cameAway += Math.abs(amount);
        if (cameAway > AWAY) {
            stalled = false;
        }
    }

    /** Neither moves nor wants to. */
    void rests() {
        stalled = false;
    }

    /** For the SIP: whether it is stalled, or was since this was last asked. */
    boolean report() {
        boolean report = stalled || untold;
        untold = false;
        return report;
    }
}
