package majic.recorder;

import java.io.IOException;
import java.util.List;
import majic.bot.Parameter;

/**
 * What was recorded so far, of the running session or in a file. All times are seconds since the beginning of the
 * recording. Thread-safe. Every method may read files: call it in the background, never on the event dispatch thread.
 */
public interface RecordedHistory {
    /**
     * Returns the recorded robots.
     *
     * @return in the order in which they were added; a number that was used again occurs again
     * @throws IOException if a file cannot be read
     */
    List<RecordedRobot> robots() throws IOException;

    /**
     * Returns the parameters of which values were recorded.
     *
     * @param robot a robot's number
     * @return in the order of the robot's table, each with its name, unit, range and explanation; all read-only
     * @throws IOException if a file cannot be read
     */
    List<Parameter> parameters(int robot) throws IOException;

    /**
     * Returns the recorded values of a parameter as numbers.
     *
     * @param robot a robot's number
     * @param parameter its name, whatever the case; {@code sonar[3]} for one value of a list
     * @param fromS the first time of interest; the value in force at that time is the first one returned
     * @return empty if nothing was recorded of it
     * @throws IOException if a file cannot be read
     */
    Series series(int robot, String parameter, double fromS) throws IOException;

    /**
     * Returns the events to be marked on a time axis.
     *
     * @param fromS the first time of interest
     * @return in the order of their times
     * @throws IOException if a file cannot be read
     */
    List<Mark> marks(double fromS) throws IOException;

    /**
     * Returns the time up to which there is something.
     *
     * @return seconds; of the running session the present time
     * @throws IOException if a file cannot be read
     */
    double endS() throws IOException;
}
