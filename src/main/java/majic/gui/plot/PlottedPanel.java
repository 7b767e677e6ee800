package majic.gui.plot;

import java.awt.LayoutManager;
import java.awt.datatransfer.Transferable;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.JPanel;
import majic.bot.Parameter;
import majic.gui.kit.EventThread;
import majic.gui.plot.data.Quantity;
import majic.panel.PlotHost;
import org.jspecify.annotations.Nullable;

/** A panel of one robot, live or recorded, whose figures open plots. Must be used on the event dispatch thread. */
public class PlottedPanel extends JPanel implements PlotHost {
    private static final long serialVersionUID = 1L;

    private final transient Plots plots;
    private final int robot;
    private final transient Supplier<List<Parameter>> parameters;

    /**
     * Creates an empty panel.
     *
     * @param layout places the components; null for none
     * @param plots shows the curves
     * @param robot the robot's number
     * @param parameters returns the robot's present parameters
     */
    public PlottedPanel(@Nullable LayoutManager layout, Plots plots, int robot, Supplier<List<Parameter>> parameters) {
        super(layout);
        this.plots = plots;
        this.robot = robot;
        this.parameters = parameters;
    }

    @Override
    public final boolean canPlot(String parameter) {
        return parameters.get().stream()
                .anyMatch(known -> known.name().equalsIgnoreCase(parameter) && Quantity.isPlottable(known));
    }

    @Override
    public final void plot(List<String> names, boolean add) {
        EventThread.piece(() -> plots.plot(robot, names, add));
    }

    @Override
    public final Transferable dragged(List<String> names) {
        return plots.dragged(robot, names);
    }
}
