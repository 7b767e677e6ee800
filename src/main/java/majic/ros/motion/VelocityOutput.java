package majic.ros.motion;

import majic.bot.LinkLost;

/**
 * The velocity topic of a base. Both methods queue a message and return at once, on any thread; calls are not made at the
 * same time.
 */
public interface VelocityOutput {
    /**
     * Publishes a velocity.
     *
     * @param mmPerSec finite, ahead positive
     * @param degPerSec finite, counterclockwise positive
     * @throws LinkLost if the connection has ended
     */
    void publish(double mmPerSec, double degPerSec);

    /**
     * Publishes a zero velocity ahead of everything that has not been sent yet; velocities among that are dropped.
     *
     * @throws LinkLost if the connection has ended
     */
    void publishStop();
}
