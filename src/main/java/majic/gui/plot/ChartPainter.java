package majic.gui.plot;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majic.gui.plot.data.Points;
import majic.gui.plot.data.Span;
import majic.text.NumberText;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Paints a chart by the library XChart. Usable on any thread; takes some ten milliseconds. */
final class ChartPainter {
    private static final BasicStroke GRID = new BasicStroke(1);
    private static final int PIXELS_A_COLUMN = 2;

    private ChartPainter() {}

    /**
     * Paints a picture.
     *
     * @param image is painted over; as large as the job says
     */
    static PaintedChart paint(ChartJob job, BufferedImage image) {
        Map<Curve, Points> points = points(job);
        List<ValueAxis> axes = ValueAxis.of(points, job.zoom());
        Graphics2D pen = image.createGraphics();
        pen.scale(job.scale(), job.scale());
        pen.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        pen.setColor(job.look().paper());
        pen.fillRect(0, 0, job.width(), job.height());
        LegendDrawing legend = new LegendDrawing(pen, job);
        int height = job.height() - TimeAxisDrawing.height(pen, job.look()) - legend.height();
        XYChart chart = new XYChart(job.width(), height);
        style(chart.getStyler(), job);
        chart.getStyler().setXAxisMin(job.time().from()).setXAxisMax(job.time().to());
        addAxes(chart, axes);
        points.forEach((curve, shown) -> addSeries(chart, curve, shown, axes, job.look()));
        if (points.isEmpty()) {
            addNothing(chart, job.time());
        }
        chart.paint(pen, job.width(), height);
        PaintedChart painted = new PaintedChart(image, job, plotArea(chart, job, axes), axes);
        TimeAxisDrawing.paint(pen, painted);
        MarksDrawing.paint(pen, painted);
        legend.paint();
        pen.dispose();
        return painted;
    }

    private static Map<Curve, Points> points(ChartJob job) {
        Map<Curve, Points> points = new LinkedHashMap<>();
        for (Curve curve : job.curves()) {
            int columns = Math.max(1, (int) (job.width() * job.scale() / PIXELS_A_COLUMN));
            points.put(
                    curve,
                    curve.points()
                            .around(job.time())
                            .thinned(job.time(), columns)
                            .withoutRepeats());
        }
        return points;
    }

    private static void style(XYStyler styler, ChartJob job) {
        ChartLook look = job.look();
        styler.setChartBackgroundColor(look.paper());
        styler.setPlotBackgroundColor(look.paper());
        styler.setPlotBorderColor(look.frame());
        styler.setPlotGridLinesColor(look.grid());
        styler.setPlotContentSize(1);
        styler.setPlotMargin(0);
        styler.setChartPadding(6);
        styler.setChartTitleVisible(false);
        styler.setChartFontColor(look.text());
        styler.setBaseFont(look.font());
        styler.setAxisTickLabelsFont(look.font());
        styler.setAxisTitleFont(look.font());
        styler.setLegendFont(look.font());
        styler.setAxisTickLabelsColor(look.text());
        styler.setAxisTickMarksColor(look.frame());
        styler.setXAxisTicksVisible(false);
        styler.setXAxisTickLabelsFormattingFunction(seconds -> "");
        styler.setYAxisTickLabelsFormattingFunction(ChartPainter::text);
        styler.setPlotGridVerticalLinesVisible(false);
        styler.setPlotGridLinesStroke(GRID);
        styler.setLegendVisible(false);
        styler.setYAxisTickMarkSpacingHint(3 * look.font().getSize());
        styler.setAntiAlias(true);
    }

    /** Formats a number of an axis; XChart's own formats take most of the time of a picture. */
    private static String text(double number) {
        double rounded = Math.rint(number * 1e6) / 1e6;
        String text = rounded == Math.rint(rounded) && Math.abs(rounded) < 1e9
                ? Long.toString((long) rounded)
                : Double.toString(rounded);
        return NumberText.of(text);
    }

    private static void addAxes(XYChart chart, List<ValueAxis> axes) {
        for (int group = 0; group < axes.size(); group++) {
            ValueAxis axis = axes.get(group);
            chart.setYAxisGroupTitle(group, axis.title());
            chart.getStyler().setYAxisMin(group, axis.range().from());
            chart.getStyler().setYAxisMax(group, axis.range().to());
            chart.getStyler()
                    .setYAxisGroupPosition(group, group == 0 ? Styler.YAxisPosition.Left : Styler.YAxisPosition.Right);
        }
    }

    private static void addSeries(XYChart chart, Curve curve, Points shown, List<ValueAxis> axes, ChartLook look) {
        Points points = shown.size() == 0 ? nothing(0) : shown;
        XYSeries series = chart.addSeries(curve.label(), points.times(), points.values());
        series.setLineColor(curve.style().color(look.dark()));
        series.setLineStyle(curve.style().stroke());
        series.setMarker(SeriesMarkers.NONE);
        if (curve.quantity().switched()) {
            series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Step);
        }
        for (int group = 0; group < axes.size(); group++) {
            if (axes.get(group).isOf(curve.quantity())) {
                series.setYAxisGroup(group);
            }
        }
    }

    private static Points nothing(double seconds) {
        return new Points(new double[] {seconds}, new double[] {Double.NaN});
    }

    /** Makes a chart without curves show its axes. */
    private static void addNothing(XYChart chart, Span time) {
        Points nothing = nothing(time.from());
        XYSeries series = chart.addSeries("nothing", nothing.times(), nothing.values());
        series.setMarker(SeriesMarkers.NONE);
        chart.getStyler().setYAxisMin(0.0);
        chart.getStyler().setYAxisMax(1.0);
    }

    private static Rectangle2D plotArea(XYChart chart, ChartJob job, List<ValueAxis> axes) {
        double left = chart.getScreenXFromChart(job.time().from());
        double right = chart.getScreenXFromChart(job.time().to());
        Span values = axes.isEmpty() ? new Span(0, 1) : axes.get(0).range();
        double top = chart.getScreenYFromChart(values.to());
        double bottom = chart.getScreenYFromChart(values.from());
        return new Rectangle2D.Double(left, top, right - left, bottom - top);
    }
}
