package majic.gui.plot.data;

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
                samples.addPast(
                        points(history, quantity, added(quantity.robot())).moved(offset));
                marks.replace(marks(history, offset), history.endS() + offset);
            } catch (IOException e) {
                LOG.log(Level.WARNING, "what was recorded before a plot was opened cannot be read", e);
            }
        });
    }

    /** The time since which the robot with a number is in the team. */
    private double added(int number) throws IOException {
        return history.robots().stream()
                .filter(robot -> robot.number() == number)
                .mapToDouble(RecordedRobot::addedS)
                .max()
                .orElse(0);
    }

    /** The recorded readings of a quantity from a time on. */
    static Points points(RecordedHistory history, Quantity quantity, double fromS) throws IOException {
        Series series = history.series(quantity.robot(), quantity.name(), fromS);
        return Points.ofChanges(series.seconds(), series.values(), PERIOD_S);
    }

    /** The recorded marks, at times moved by an offset. */
    static List<PlotMark> marks(RecordedHistory history, double offset) throws IOException {
        return history.marks(0).stream()
                .filter(Past::isShown)
                .map(mark ->
                        new PlotMark(mark.seconds() + offset, mark.robot(), text(mark), mark.kind() != Mark.Kind.BEGUN))
                .toList();
    }

    private static String text(Mark mark) {
        return mark.kind() == Mark.Kind.STOP && mark.robot() == 0 ? MarkRecord.stopText() : mark.text();
    }

    private static boolean isShown(Mark mark) {
        return switch (mark.kind()) {
            case BEGUN, ENDED, STOP, LOST, REGAINED -> true;
            case ADDED, REMOVED, UNCONFIRMED, RELEASED, OWNER -> false;
        };
    }
}
