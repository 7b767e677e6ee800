package majic.gui.plot;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.DoubleSupplier;
import majic.recorder.Mark;
import majic.recorder.RecordedHistory;
import majic.recorder.RecordedRobot;
import majic.recorder.Series;

/** Reads what was recorded of the running session before a plot was opened, on a thread of its own. */
final class Past {
    private static final Logger LOG = System.getLogger(Past.class.getName());

    /** About the time between two reports of a robot. */
    private static final double PERIOD_S = 0.1;

    private final ExecutorService thread = Executors.newSingleThreadExecutor(Past::thread);
    private final RecordedHistory history;
    private final DoubleSupplier now;

    /**
     * Creates a reader.
     *
     * @param now the present time of the plots, seconds
     */
    Past(RecordedHistory history, DoubleSupplier now) {
        this.history = history;
        this.now = now;
    }

    private static Thread thread(Runnable body) {
        Thread thread = new Thread(body, "plot history");
        thread.setDaemon(true);
        return thread;
    }

    /** Adds the recorded readings and marks in the background. */
    void read(Quantity quantity, Samples samples, MarkRecord marks) {
        thread.execute(() -> {
            try {
                double offset = now.getAsDouble() - history.endS();
                if (quantity.index() == Quantity.WHOLE) {
                    samples.addPast(points(quantity).moved(offset));
                }
                marks.replace(marks(offset), history.endS() + offset);
            } catch (IOException e) {
                LOG.log(Level.WARNING, "what was recorded before a plot was opened cannot be read", e);
            }
        });
    }

    private Points points(Quantity quantity) throws IOException {
        double added = history.robots().stream()
                .filter(robot -> robot.number() == quantity.robot())
                .mapToDouble(RecordedRobot::addedS)
                .max()
                .orElse(0);
        Series series = history.series(quantity.robot(), quantity.parameter(), added);
        return Points.ofChanges(series.seconds(), series.values(), PERIOD_S);
    }

    private List<PlotMark> marks(double offset) throws IOException {
        return history.marks(0).stream()
                .filter(Past::isShown)
                .map(mark -> new PlotMark(
                        mark.seconds() + offset, mark.robot(), mark.text(), mark.kind() != Mark.Kind.BEGUN))
                .toList();
    }

    private static boolean isShown(Mark mark) {
        return switch (mark.kind()) {
            case BEGUN, ENDED, STOP, LOST, REGAINED -> true;
            case ADDED, REMOVED, UNCONFIRMED, RELEASED, OWNER -> false;
        };
    }
}
