package majic.driver;

import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Value;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** What {@link MotionGate} and {@link Motion} use of the robot that they move. */
interface MovingRobot {
    String name();

    TimeSource time();

    /** Raised after each new reading, revocation and change of the connection. */
    Signal changes();

    boolean isConnected();

    /** Throws a {@link BotException} unless the robot is connected. */
    void requireConnected();

    /** Returns the number of readings taken so far. */
    long readings();

    /** Counts a reading of another robot that a guard reads as well, and wakes the motion. */
    void lookAgain();

    void notice(String message);

    void lost(LinkLost cause);

    void driveAt(double mmPerSec, double degPerSec);

    /** Drives for a time, and returns how the speeds were adjusted; null if they were not. */
    @Nullable
    Value driveFor(double mmPerSec, double degPerSec, double seconds, Motion motion);

    void halt();

    void haltAhead();

    void confirmHalt();

    /** Returns the distance of the last drive; null if unknown. */
    @Nullable
    Value driven();
}
