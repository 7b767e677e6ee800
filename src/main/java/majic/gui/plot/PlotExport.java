package majic.gui.plot;

import java.awt.image.BufferedImage;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.imageio.ImageIO;
import majic.file.WholeFile;
import majic.gui.plot.data.Points;
import majic.gui.plot.data.Quantity;
import majic.gui.plot.data.Span;
import majic.text.IoReason;
import majic.text.Texts;

/** Writes files of plots. Every method blocks, and returns why it failed; empty if it did not. */
final class PlotExport {
    private static final Texts TEXTS = Texts.of(PlotExport.class);
    private static final String HEADER = "time_s,robot,parameter,value,unit";

    private PlotExport() {}

    /**
     * Writes all readings of a span of time as comma-separated values, one curve after the other; a reading without a
     * value has an empty field.
     */
    static Optional<String> csv(List<Curve> curves, Span time, Path file) {
        return replace(file, out -> {
            BufferedWriter rows = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
            rows.write(HEADER);
            rows.newLine();
            for (Curve curve : curves) {
                write(curve, time, rows);
            }
            rows.flush();
        });
    }

    private static void write(Curve curve, Span time, BufferedWriter out) throws IOException {
        Points points = curve.points().within(time);
        Quantity quantity = curve.quantity();
        for (int index = 0; index < points.size(); index++) {
            double value = points.values()[index];
            out.write(String.format(
                    Locale.ROOT,
                    "%.3f,%d,%s,%s,%s",
                    points.times()[index],
                    quantity.robot(),
                    quantity.name(),
                    Double.isNaN(value) ? "" : String.valueOf(value),
                    quantity.unit().symbol()));
            out.newLine();
        }
    }

    /** Paints a chart into a PNG file. */
    static Optional<String> png(ChartJob job, Path file) {
        BufferedImage image = ChartPainter.paint(job, job.newImage()).image();
        return replace(file, out -> ImageIO.write(image, "png", out));
    }

    private static Optional<String> replace(Path file, WholeFile.Content content) {
        try {
            WholeFile.replace(file, content);
            return Optional.empty();
        } catch (IOException e) {
            return Optional.of(TEXTS.get("notWritten", file, IoReason.of(e)));
        }
    }
}
