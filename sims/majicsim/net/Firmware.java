package majicsim.net;

/** A simulated robot as its lines use it. Every call holds the lab's lock, so a firmware needs no locks of its own. */
public interface Firmware {
    /**
     * Reports a new client.
     *
     * @param line its line, open
     */
    default void connected(Line line) {}

    /**
     * Reports received bytes, in pieces of any size.
     *
     * @param line where from
     * @param bytes at least one; the firmware may keep the array
     */
    void received(Line line, byte[] bytes);

    /**
     * A line has ended, from either end. Called once for every line that was connected; nothing can be sent to it any
     * more.
     *
     * @param line the line, closed
     */
    default void disconnected(Line line) {}

    /**
     * Reports that lab time has advanced; the world has just been stepped.
     *
     * @param seconds the lab's fixed step
     */
    void step(double seconds);

    /**
     * For how long nothing will change but the time, unless the firmware is used. Asked after a step.
     *
     * @return lab time after which the next step must be taken, ns; 0 for each step of the lab
     */
    default long restNanos() {
        return 0;
    }

    /**
     * Lets lab time pass in which the firmware rests, in place of steps.
     *
     * @param nanos lab time, so short that nothing is due at its end
     */
    default void rest(long nanos) {
        step(nanos / 1e9);
    }
}
