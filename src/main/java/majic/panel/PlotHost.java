package majic.panel;

import java.awt.datatransfer.Transferable;
import java.util.List;

/**
 * Plots readings of one robot. Implemented by a container of the robot's panel, where {@link PlotLink} finds it. Must
 * be used on the event dispatch thread.
 */
public interface PlotHost {
    /**
     * Returns whether a reading can be plotted.
     *
     * @param parameter name of the robot's parameter
     * @return true if the robot has this parameter and its values are numbers or switches
     */
    boolean canPlot(String parameter);

    /**
     * Shows live curves of readings.
     *
     * @param parameters names of the robot's parameters, at least one
     * @param add whether the curves are added to the plot that was used last, rather than shown in a new one
     */
    void plot(List<String> parameters, boolean add);

    /**
     * Returns readings for dragging them onto a plot, which then shows their curves too.
     *
     * @param parameters names of the robot's parameters, at least one
     * @return what the plots accept
     */
    Transferable dragged(List<String> parameters);
}
