package majic.gui.plot.data;

import java.util.List;
import majic.bot.Parameter;

/** Provides the readings of robots to plots. Thread-safe; no method blocks. */
public interface PlotSource {
    /**
     * A robot whose parameters can be plotted.
     *
     * @param number its number
     * @param label its name and type, for users
     * @param parameters those that can be plotted
     */
    record Robot(int number, String label, List<Parameter> parameters) {}

    /** Returns the robots, in the order of their numbers. */
    List<Robot> robots();

    /** Returns the name that a robot has now; empty if it has none. */
    default String nameOf(int robot) {
        return "";
    }

    /**
     * Returns what a parameter consists of.
     *
     * @param robot the robot's number
     * @param parameter name of a parameter
     * @return one quantity, or one for each value of a list; none if there is no such robot or parameter now
     */
    List<Quantity> quantities(int robot, String parameter);

    /**
     * Adds the readings of a quantity to samples, past ones if they are known and then new ones as they come, until the
     * feed is closed. The robot is asked for nothing that it reports by itself.
     *
     * @param quantity one that {@link #quantities} returned
     * @param samples receives the readings, on any thread
     */
    Feed feed(Quantity quantity, Samples samples);

    /** Returns the present time, seconds. */
    double now();

    /** Returns whether the readings come from a recording, so that plots are marked as those of a replay. */
    default boolean isReplay() {
        return false;
    }

    /** Returns the marks within a span of time, oldest first. */
    List<PlotMark> marks(double from, double to);

    /** Adds readings to the samples of a curve until it is closed. */
    interface Feed extends AutoCloseable {
        @Override
        void close();
    }
}
