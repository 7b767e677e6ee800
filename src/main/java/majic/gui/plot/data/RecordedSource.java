package majic.gui.plot.data;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.DoubleSupplier;
import java.util.stream.Stream;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.recorder.RecordedRobot;
import majic.recorder.Recording;
import majic.recorder.RobotTracks;
import majic.text.Texts;

/**
 * Provides a part of a recording to plots, up to the present position of its replay, and further parts after it.
 * Thread-safe.
 */
public final class RecordedSource implements PlotSource {
    private static final Texts TEXTS = Texts.of(RecordedSource.class);
    private static final Logger LOG = System.getLogger(RecordedSource.class.getName());

    private final List<RecordedFeed> feeds = new CopyOnWriteArrayList<>();
    private final DoubleSupplier position;
    private volatile Recording recording;
    private volatile List<PlotMark> marks;

    /**
     * Creates a source.
     *
     * @param recording the first part
     * @param position the position of the replay, seconds since the beginning of the recording
     */
    public RecordedSource(Recording recording, DoubleSupplier position) {
        this.recording = recording;
        this.position = position;
        this.marks = marks(recording);
    }

    /** Adds the readings of another part to all curves. Takes some time. */
    public void show(Recording part) {
        recording = part;
        feeds.forEach(feed -> feed.add(part));
        marks = Stream.concat(
                        marks.stream().filter(mark -> mark.seconds() < part.beginS() || mark.seconds() > part.endS()),
                        marks(part).stream())
                .sorted(Comparator.comparingDouble(PlotMark::seconds))
                .toList();
    }

    private static List<PlotMark> marks(Recording part) {
        try {
            return Past.marks(part, 0);
        } catch (IOException e) {
            LOG.log(Level.WARNING, "a recording that is in memory cannot be read", e);
            return List.of();
        }
    }

    @Override
    public List<Robot> robots() {
        Map<Integer, Robot> robots = new TreeMap<>();
        for (RecordedRobot robot : recording.robots()) {
            List<Parameter> parameters = recording.parameters(robot.number()).stream()
                    .filter(Quantity::isPlottable)
                    .toList();
            robots.put(robot.number(), new Robot(robot.number(), robot.label(), parameters));
        }
        return List.copyOf(robots.values());
    }

    @Override
    public List<Quantity> quantities(int robot, String parameter) {
        return recording.parameters(robot).stream()
                .filter(known -> known.name().equalsIgnoreCase(parameter) && Quantity.isPlottable(known))
                .findFirst()
                .map(known -> Quantity.of(robot, known, present(robot, known)))
                .orElse(List.of());
    }

    private Value present(int robot, Parameter parameter) {
        return recording.tracks().stream()
                .filter(tracks -> tracks.robot().number() == robot && tracks.isPresent(now()))
                .findFirst()
                .map((RobotTracks tracks) -> tracks.value(parameter, now()))
                .orElse(Value.unknown(TEXTS.get("notInTeam")));
    }

    @Override
    public Feed feed(Quantity quantity, Samples samples) {
        RecordedFeed feed = new RecordedFeed(quantity, samples);
        feeds.add(feed);
        feed.add(recording);
        return () -> feeds.remove(feed);
    }

    @Override
    public double now() {
        return position.getAsDouble();
    }

    @Override
    public boolean isReplay() {
        return true;
    }

    @Override
    public List<PlotMark> marks(double from, double to) {
        return marks.stream()
                .filter(mark -> mark.seconds() >= from && mark.seconds() <= to)
                .toList();
    }

    /** A curve and what it shows. */
    private record RecordedFeed(Quantity quantity, Samples samples) {
        /** Returns the time up to which there is something of the robot: changes alone are recorded. */
        private double end(Recording part) {
            return part.tracks().stream()
                    .filter(tracks -> tracks.robot().number() == quantity.robot())
                    .mapToDouble(
                            tracks -> tracks.isPresent(part.endS()) ? part.endS() : tracks.lastChangeS(part.endS()))
                    .max()
                    .orElse(Double.NEGATIVE_INFINITY);
        }

        void add(Recording part) {
            try {
                Points points = Past.points(part, quantity, 0).heldUntil(end(part));
                samples.addPast(points);
                samples.addLater(points);
            } catch (IOException e) {
                LOG.log(Level.WARNING, "a recording that is in memory cannot be read", e);
            }
        }
    }
}
