package majic.gui.plot;

import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.Optional;
import javax.swing.TransferHandler;

/** Adds the curves of readings that are dropped on a plot, if they are from the plot's source. */
final class ReadingDrop extends TransferHandler {
    private static final long serialVersionUID = 1L;

    private final transient PlotModel model;

    ReadingDrop(PlotModel model) {
        this.model = model;
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return readings(support).isPresent();
    }

    @Override
    public boolean importData(TransferSupport support) {
        Optional<DraggedReadings> readings = readings(support);
        readings.ifPresent(dropped -> model.add(dropped.quantities()));
        return readings.isPresent();
    }

    private Optional<DraggedReadings> readings(TransferSupport support) {
        if (!support.isDataFlavorSupported(DraggedReadings.FLAVOR)) {
            return Optional.empty();
        }
        try {
            DraggedReadings readings =
                    (DraggedReadings) support.getTransferable().getTransferData(DraggedReadings.FLAVOR);
            return Optional.of(readings).filter(dragged -> dragged.source() == model.source());
        } catch (UnsupportedFlavorException | IOException e) {
            return Optional.empty();
        }
    }
}
