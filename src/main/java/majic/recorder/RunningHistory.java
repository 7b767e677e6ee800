package majic.recorder;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiPredicate;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import majic.bot.Parameter;

/** What was recorded so far in the running session; reads its files at each call, and keeps nothing. */
final class RunningHistory implements RecordedHistory {
    private final Supplier<List<Path>> files;
    private final DoubleSupplier now;

    /**
     * @param files the files, the oldest first, complete up to the call
     * @param now the time of the recording, seconds
     */
    RunningHistory(Supplier<List<Path>> files, DoubleSupplier now) {
        this.files = files;
        this.now = now;
    }

    private List<Recording> read(BiPredicate<Integer, String> wanted) throws IOException {
        List<Recording> parts = new ArrayList<>();
        for (Path file : files.get()) {
            try {
                parts.add(Recording.read(file, wanted));
            } catch (NoSuchFileException e) {
                // It was deleted meanwhile, being the oldest.
            }
        }
        return parts;
    }

    private List<Recording> readWithoutValues() throws IOException {
        return read((robot, parameter) -> false);
    }

    @Override
    public List<RecordedRobot> robots() throws IOException {
        Map<String, RecordedRobot> robots = new LinkedHashMap<>();
        for (Recording part : readWithoutValues()) {
            part.robots().forEach(robot -> robots.putIfAbsent(robot.number() + " " + robot.origin(), robot));
        }
        return List.copyOf(robots.values());
    }

    @Override
    public List<Parameter> parameters(int robot) throws IOException {
        Map<String, Parameter> parameters = new LinkedHashMap<>();
        for (Recording part : readWithoutValues()) {
            part.parameters(robot).forEach(parameter -> parameters.put(parameter.name(), parameter));
        }
        return List.copyOf(parameters.values());
    }

    @Override
    public Series series(int robot, String parameter, double fromS) throws IOException {
        String wanted = RobotTracks.parameterOf(parameter);
        List<Series> series = new ArrayList<>();
        for (Recording part : read((number, name) -> number == robot && name.equals(wanted))) {
            series.add(part.series(robot, parameter, fromS));
        }
        return Series.join(series);
    }

    @Override
    public List<Mark> marks(double fromS) throws IOException {
        List<Mark> marks = new ArrayList<>();
        for (Recording part : readWithoutValues()) {
            marks.addAll(part.marks(fromS));
        }
        return marks;
    }

    @Override
    public double endS() {
        return now.getAsDouble();
    }
}
