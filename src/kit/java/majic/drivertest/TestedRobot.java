package majic.drivertest;

import majic.bot.MajicBot;
import majic.bot.Pose;

/**
 * A driver and the robot that it drives, for one test of {@link DriverConformance}. The robot moves as a real one
 * would, and its clock is that of the driver. Used by the thread of the test.
 */
public interface TestedRobot extends AutoCloseable {
    /**
     * Returns the driver.
     *
     * @return the same object at each call; not connected at first
     */
    MajicBot bot();

    /**
     * Returns where the robot really is, in whatever frame, and not where the driver assumes it to be.
     *
     * @return mm and degrees, counterclockwise positive
     */
    Pose truePose();

    /** Ends all connections from the robot's end. The robot can be connected again afterwards. */
    void cut();

    /**
     * Sends nothing more until it is closed, though all connections stay open, as a robot does that was switched off or
     * is out of reach.
     */
    void fallSilent();

    /** Puts something immovable in front of the robot. */
    void block();

    /** Takes away what {@link #block} has put there. The robot may be at another place afterwards. */
    void unblock();

    /** Closes the driver, if the test has not done so, then the robot and its clock. */
    @Override
    void close();
}
