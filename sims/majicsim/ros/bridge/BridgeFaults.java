package majicsim.ros.bridge;

/** The faults of one bridge. Each lasts until it is ended. Guarded by the lab's lock. */
public final class BridgeFaults {
    private boolean isWithoutPongs;
    private boolean isWithoutServices;
    private boolean isHanging;
    private int malformedMessages;

    /** No faults yet. */
    public BridgeFaults() {}

    /**
     * Leaves pings unanswered, as a computer that hangs.
     *
     * @param without true from now on, false to end it
     */
    public void suppressPongs(boolean without) {
        isWithoutPongs = without;
    }

    /**
     * Leaves calls of services unanswered.
     *
     * @param without true from now on, false to end it
     */
    public void suppressServices(boolean without) {
        isWithoutServices = without;
    }

    void hang(boolean hangs) {
        isHanging = hangs;
    }

    boolean isHanging() {
        return isHanging;
    }

    /**
     * Cuts off the second half of the next messages to clients, so that they are no JSON.
     *
     * @param count how many
     */
    public void malform(int count) {
        malformedMessages = count;
    }

    boolean isWithoutPongs() {
        return isWithoutPongs;
    }

    boolean isWithoutServices() {
        return isWithoutServices;
    }

    /** Whether the message that is sent now is to be cut; counts it. */
    boolean takeMalformed() {
        if (malformedMessages == 0) {
            return false;
        }
        malformedMessages--;
        return true;
    }
}
