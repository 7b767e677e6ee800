package majicsim.aibo.urbi;

/**
 * The server's reset (URBI sheet, section 9 and appendix A): everything is stopped and removed, then the stick's
 * scripts run again.
 */
final class Restart {
    private static final String TAG = "reset";

    /** The time that the stick's scripts took to load in the recording. */
    private static final double RELOAD_MS = 2400;

    private final Kernel kernel;
    private boolean requested;
    private double reloadAtMs = Double.POSITIVE_INFINITY;

    Restart(Kernel kernel) {
        this.kernel = kernel;
    }

    void request() {
        requested = true;
    }

    /** To be called at the start of each cycle. */
    void step() {
        if (requested) {
            requested = false;
            reloadAtMs = kernel.nowMs() + RELOAD_MS;
            kernel.forget();
            announceToAll("Reset completed.");
        } else if (kernel.nowMs() >= reloadAtMs) {
            reloadAtMs = Double.POSITIVE_INFINITY;
            announceToAll("Reloading");
            kernel.reload();
        }
    }

    private void announceToAll(String text) {
        kernel.connections().forEach(each -> each.send(TAG, "*** " + text));
    }
}
