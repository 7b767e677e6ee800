package majic.gui.plot.data;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleSupplier;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.recorder.RecordedRobot;
import majic.recorder.Recording;
import majic.recorder.RobotTracks;
import majic.text.Texts;

/** Provides a recording to plots, up to the present position of its replay. Thread-safe. */
public final class RecordedSource implements PlotSource {
    private static final Texts TEXTS = Texts.of(RecordedSource.class);
    private static final Logger LOG = System.getLogger(RecordedSource.class.getName());

    private final Recording recording;
    private final DoubleSupplier position;

    /**
     * Creates a source.
     *
     * @param position the position of the replay, seconds since the beginning of the recording
     */
    public RecordedSource(Recording recording, DoubleSupplier position) {
        this.recording = recording;
        this.position = position;
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
        try {
            samples.addPast(Past.points(recording, quantity, 0));
        } catch (IOException e) {
            LOG.log(Level.WARNING, "a recording that is in memory cannot be read", e);
        }
        return () -> {};
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
        try {
            return Past.marks(recording, 0).stream()
                    .filter(mark -> mark.seconds() >= from && mark.seconds() <= to)
                    .toList();
        } catch (IOException e) {
            return List.of();
        }
    }
}
