package majic.gui.replay;

import java.awt.BorderLayout;
import java.awt.datatransfer.Transferable;
import java.util.List;
import javax.swing.JPanel;
import majic.gui.plot.Plots;
import majic.gui.plot.data.Quantity;
import majic.panel.PlotHost;

/** Contains the panel of a recorded robot, whose figures open plots of the recording. */
final class PlottedPanel extends JPanel implements PlotHost {
    private static final long serialVersionUID = 1L;

    private final transient ReplayRobot robot;
    private final transient Plots plots;

    PlottedPanel(ReplayRobot robot, Plots plots) {
        super(new BorderLayout());
        this.robot = robot;
        this.plots = plots;
    }

    @Override
    public boolean canPlot(String parameter) {
        return robot.tracks().parameters().stream()
                .anyMatch(known -> known.name().equalsIgnoreCase(parameter) && Quantity.isPlottable(known));
    }

    @Override
    public void plot(List<String> parameters, boolean add) {
        plots.plot(robot.robot().number(), parameters, add);
    }

    @Override
    public Transferable dragged(List<String> parameters) {
        return plots.dragged(robot.robot().number(), parameters);
    }
}
