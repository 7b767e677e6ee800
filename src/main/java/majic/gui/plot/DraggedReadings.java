package majic.gui.plot;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.util.List;
import majic.gui.plot.data.PlotSource;
import majic.gui.plot.data.Quantity;

/**
 * Readings of a robot that can be dragged onto a plot of the same source. Immutable.
 *
 * @param source provides them
 * @param robot the robot's number
 * @param parameters names of its parameters
 */
record DraggedReadings(PlotSource source, int robot, List<String> parameters) implements Transferable {
    static final DataFlavor FLAVOR = flavor();

    private static DataFlavor flavor() {
        try {
            return new DataFlavor(DataFlavor.javaJVMLocalObjectMimeType + ";class=" + DraggedReadings.class.getName());
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns what can be plotted of them now. */
    List<Quantity> quantities() {
        return parameters.stream()
                .flatMap(parameter -> source.quantities(robot, parameter).stream())
                .toList();
    }

    @Override
    public DataFlavor[] getTransferDataFlavors() {
        return new DataFlavor[] {FLAVOR};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
        return FLAVOR.equals(flavor);
    }

    @Override
    public Object getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
        if (!isDataFlavorSupported(flavor)) {
            throw new UnsupportedFlavorException(flavor);
        }
        return this;
    }
}
