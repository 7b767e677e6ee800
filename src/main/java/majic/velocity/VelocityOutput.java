package majic.velocity;

import majic.bot.LinkLost;

/** The velocity topic of a base. Calls come from any thread, one at a time. */
@FunctionalInterface
public interface VelocityOutput {
    /**
     * Publishes a velocity; takes no longer than the write deadline of the link.
     *
     * @param mmPerSec finite, ahead positive
     * @param degPerSec finite, counterclockwise positive
     * @throws LinkLost if the connection has ended
     */
    void publish(double mmPerSec, double degPerSec);
}
