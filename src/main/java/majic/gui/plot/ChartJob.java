package majic.gui.plot;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import majic.gui.plot.data.PlotMark;
import majic.gui.plot.data.Span;
import org.jspecify.annotations.Nullable;

/**
 * What is to be painted, so that another thread can do it. Immutable except for the samples of the curves.
 *
 * @param width in pixels of the user interface
 * @param height in pixels of the user interface
 * @param scale pixels of the picture for one of these
 * @param time the time shown
 * @param zoom the magnified part; null if the axes fit the readings
 * @param curves what is shown
 * @param marks the marks in this time of the robots shown
 * @param look colours and font
 * @param legend whether the picture contains the names of the curves
 */
record ChartJob(
        int width,
        int height,
        double scale,
        Span time,
        PlotModel.@Nullable Zoom zoom,
        List<Curve> curves,
        List<PlotMark> marks,
        ChartLook look,
        boolean legend) {

    /** Describes the present state of a plot; on the event dispatch thread. */
    static ChartJob of(PlotModel model, int width, int height, double scale, boolean legend) {
        Span time = model.time();
        return new ChartJob(
                width,
                height,
                scale,
                time,
                model.zoom(),
                model.curves(),
                marks(model, time),
                ChartLook.current(),
                legend);
    }

    BufferedImage newImage() {
        return new BufferedImage(pixels(width), pixels(height), BufferedImage.TYPE_INT_RGB);
    }

    /** Returns whether an image has the size of the picture. */
    boolean fits(BufferedImage image) {
        return image.getWidth() == pixels(width) && image.getHeight() == pixels(height);
    }

    private int pixels(int length) {
        return Math.max(1, (int) Math.ceil(length * scale));
    }

    private static List<PlotMark> marks(PlotModel model, Span time) {
        Set<Integer> robots =
                model.curves().stream().map(curve -> curve.quantity().robot()).collect(Collectors.toSet());
        return model.source().marks(time.from(), time.to()).stream()
                .filter(mark -> mark.robot() == 0 || robots.contains(mark.robot()))
                .toList();
    }
}
