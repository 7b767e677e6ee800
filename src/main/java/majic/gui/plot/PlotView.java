package majic.gui.plot;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.image.BufferedImage;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.Timer;
import majic.gui.kit.EventThread;
import majic.panel.VisibilityWatch;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Shows the chart of a plot, with a cursor. The chart is painted on another thread, at most ten times a second, and
 * only while the view is visible and something in it may have changed; this thread only copies the picture. Must be
 * used on the event dispatch thread.
 */
final class PlotView extends JComponent {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(PlotView.class);
    private static final Logger LOG = System.getLogger(PlotView.class.getName());
    private static final int PERIOD_MS = 100;

    private final transient PlotModel model;
    private final transient ChartCursor cursor;
    private final Timer timer = new Timer(PERIOD_MS, tick -> tick());
    private transient @Nullable PaintedChart chart;
    private transient @Nullable BufferedImage spare;
    private boolean painting;
    private boolean changed = true;

    PlotView(PlotModel model) {
        this.model = model;
        this.cursor = new ChartCursor(this, model);
        setName("chart");
        setOpaque(true);
        setFocusable(true);
        setPreferredSize(UIScale.scale(new Dimension(640, 360)));
        setMinimumSize(new Dimension(200, 120));
        model.addListener(this::modelChanged);
        new VisibilityWatch(this, this::visibilityChanged);
        new ChartKeys(this, model, cursor).install();
        cursor.install();
    }

    private void modelChanged() {
        changed = true;
        tick();
    }

    private void visibilityChanged(boolean visible) {
        if (visible) {
            changed = true;
            timer.start();
            tick();
        } else {
            timer.stop();
        }
    }

    /** Has the chart painted with the colours of the present look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        changed = true;
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        changed |= width != getWidth() || height != getHeight();
        super.setBounds(x, y, width, height);
    }

    /** Returns the chart that is shown; null before the first is painted. */
    @Nullable
    PaintedChart chart() {
        return chart;
    }

    private void tick() {
        boolean mayDiffer = changed
                || !model.isPaused() && model.time().to() >= model.source().now() - 1;
        if (timer.isRunning() && mayDiffer && !painting && getWidth() > 0 && getHeight() > 0) {
            changed = false;
            painting = true;
            ChartJob job = ChartJob.of(model, getWidth(), getHeight(), scale(), false);
            BufferedImage image = image(job);
            PaintThread.run(() -> paint(job, image));
        }
    }

    private double scale() {
        GraphicsConfiguration screen = getGraphicsConfiguration();
        return screen == null ? 1 : screen.getDefaultTransform().getScaleX();
    }

    private BufferedImage image(ChartJob job) {
        BufferedImage last = spare;
        spare = null;
        return last != null && job.fits(last) ? last : job.newImage();
    }

    private void paint(ChartJob job, BufferedImage image) {
        try {
            PaintedChart painted = ChartPainter.paint(job, image);
            EventThread.later(() -> show(painted));
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "a plot could not be painted", e);
            EventThread.later(() -> painting = false);
        }
    }

    private void show(PaintedChart painted) {
        PaintedChart before = chart;
        spare = before == null ? null : before.image();
        chart = painted;
        painting = false;
        cursor.chartChanged();
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        PaintedChart shown = chart;
        pen.setColor(ChartLook.current().paper());
        pen.fillRect(0, 0, getWidth(), getHeight());
        if (shown != null) {
            pen.drawImage(shown.image(), 0, 0, shown.job().width(), shown.job().height(), null);
            cursor.paint(pen, shown);
        }
        pen.dispose();
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                private static final long serialVersionUID = 1L;

                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.CANVAS;
                }
            };
            accessibleContext.setAccessibleName(TEXTS.get("chart"));
        }
        return accessibleContext;
    }
}
