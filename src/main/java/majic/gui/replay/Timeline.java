package majic.gui.replay;

import com.formdev.flatlaf.ui.FlatSliderUI;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.function.DoubleConsumer;
import javax.swing.JComponent;
import javax.swing.JSlider;
import javax.swing.plaf.basic.BasicSliderUI;
import majic.gui.kit.Palette;
import majic.panel.DrawingColors;
import majic.recorder.Mark;
import majic.text.Texts;

/**
 * The time slider of a replay, in tenths of a second, with marks above its track: a line where a command began, a
 * square for STOP, a triangle for a lost connection or a stop that was not confirmed, a ring for other events.
 */
final class Timeline extends JSlider {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(Timeline.class);
    private static final int STEPS_PER_S = 10;
    private static final int MARKS_PX = 16;
    private static final int NEAR_PX = 4;

    private final double beginS;
    private final transient List<Mark> marks;
    private boolean following;

    /**
     * Creates a slider over a span of time.
     *
     * @param chosen receives the time that the user has chosen, seconds
     */
    Timeline(double beginS, double endS, List<Mark> marks, DoubleConsumer chosen) {
        super(0, Math.max(1, (int) Math.ceil((endS - beginS) * STEPS_PER_S)), 0);
        this.beginS = beginS;
        this.marks = marks.stream().filter(mark -> sign(mark) != Sign.NONE).toList();
        setName("timeline");
        getAccessibleContext().setAccessibleName(TEXTS.get("timeline"));
        setToolTipText("");
        setExtent(0);
        setUI(new MarkedTrack(this));
        addChangeListener(event -> {
            if (!following) {
                chosen.accept(beginS + (double) getValue() / STEPS_PER_S);
            }
        });
    }

    /** Keeps the marks in another look and feel. */
    @Override
    public void updateUI() {
        setUI(new MarkedTrack(this));
    }

    /** Follows the position, unless it is being dragged. */
    void follow(double seconds) {
        if (!getValueIsAdjusting()) {
            following = true;
            setValue((int) Math.round((seconds - beginS) * STEPS_PER_S));
            following = false;
        }
    }

    /** Returns the texts of the events at the mouse, otherwise the time. */
    @Override
    public String getToolTipText(MouseEvent event) {
        BasicSliderUI track = (BasicSliderUI) getUI();
        int from = track.valueForXPosition(event.getX() - NEAR_PX);
        int to = track.valueForXPosition(event.getX() + NEAR_PX);
        String events = marks.stream()
                .filter(mark -> value(mark) >= from && value(mark) <= to)
                .map(mark -> ReplayTimes.clock(mark.seconds()) + "  " + words(mark))
                .reduce((one, other) -> one + " \u00b7 " + other)
                .orElse("");
        double seconds = beginS + (double) track.valueForXPosition(event.getX()) / STEPS_PER_S;
        return events.isEmpty() ? ReplayTimes.clock(seconds) : events;
    }

    private static String words(Mark mark) {
        return switch (mark.kind()) {
            case STOP -> TEXTS.get("mark.stop", mark.text());
            case LOST -> TEXTS.get("mark.lost", mark.robot(), mark.text());
            case UNCONFIRMED -> TEXTS.get("mark.unconfirmed", mark.robot(), mark.text());
            case ADDED -> TEXTS.get("mark.added", mark.robot());
            case REMOVED -> TEXTS.get("mark.removed", mark.robot());
            case REGAINED -> TEXTS.get("mark.regained", mark.robot());
            default -> mark.text();
        };
    }

    private int value(Mark mark) {
        return (int) Math.round((mark.seconds() - beginS) * STEPS_PER_S);
    }

    /** How an event is drawn. */
    private enum Sign {
        NONE,
        LINE,
        SQUARE,
        TRIANGLE,
        RING
    }

    private static Sign sign(Mark mark) {
        return switch (mark.kind()) {
            case BEGUN -> Sign.LINE;
            case STOP -> Sign.SQUARE;
            case LOST, UNCONFIRMED -> Sign.TRIANGLE;
            case ADDED, REMOVED, REGAINED, RELEASED -> Sign.RING;
            case ENDED, OWNER -> Sign.NONE;
        };
    }

    /** A track with the marks above it. */
    private static final class MarkedTrack extends FlatSliderUI {
        private final Timeline timeline;

        MarkedTrack(Timeline timeline) {
            this.timeline = timeline;
        }

        @Override
        public Dimension getPreferredSize(JComponent component) {
            Dimension size = super.getPreferredSize(component);
            return new Dimension(size.width, size.height + UIScale.scale(MARKS_PX));
        }

        @Override
        protected void calculateTrackRect() {
            super.calculateTrackRect();
            trackRect.y += UIScale.scale(MARKS_PX) / 2;
        }

        @Override
        public void paintTrack(Graphics graphics) {
            super.paintTrack(graphics);
            List<Mark> all = timeline.marks;
            if (all == null) {
                return;
            }
            Graphics2D pen = (Graphics2D) graphics.create();
            DrawingColors.prepare(pen);
            double y = trackRect.getCenterY() - UIScale.scale(MARKS_PX);
            all.forEach(mark -> paintScaled(pen, mark, xPositionForValue(timeline.value(mark)), y));
            pen.dispose();
        }

        /** Paints a mark around a point, 8 pixels wide at the normal font size. */
        private static void paintScaled(Graphics2D pen, Mark mark, double x, double y) {
            Graphics2D scaled = (Graphics2D) pen.create();
            scaled.translate(x, y);
            scaled.scale(UIScale.getUserScaleFactor(), UIScale.getUserScaleFactor());
            scaled.setStroke(DrawingColors.stroke(1.4));
            paint(scaled, sign(mark));
            scaled.dispose();
        }

        private static void paint(Graphics2D pen, Sign sign) {
            switch (sign) {
                case LINE -> {
                    pen.setColor(Palette.command());
                    pen.draw(new Line2D.Double(0, -4, 0, 5));
                }
                case SQUARE -> {
                    pen.setColor(Palette.error());
                    pen.fill(new Rectangle2D.Double(-4, -4, 8, 8));
                }
                case TRIANGLE -> {
                    pen.setColor(Palette.error());
                    pen.fill(triangle());
                }
                case RING -> {
                    pen.setColor(Palette.mixed(0.75));
                    pen.draw(new Ellipse2D.Double(-3, -3, 6, 6));
                }
                case NONE -> {}
            }
        }

        private static Path2D triangle() {
            Path2D shape = new Path2D.Double();
            shape.moveTo(-5, -4);
            shape.lineTo(5, -4);
            shape.lineTo(0, 5);
            shape.closePath();
            return shape;
        }
    }
}
