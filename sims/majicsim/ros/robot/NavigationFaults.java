package majicsim.ros.robot;

/** The faults of the navigation. Guarded by the lab's lock. */
final class NavigationFaults {
    private boolean isRejecting;

    /** Rejects every goal from now on, or no longer. */
    void reject(boolean rejects) {
        isRejecting = rejects;
    }

    boolean isRejecting() {
        return isRejecting;
    }
}
