package majic.recorder;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.recorder.RecordingFormat.Kind;

/**
 * The laser scans of one robot in a recording, as long as it was connected: their odometry has one origin. Immutable.
 *
 * @param file the file of the recording with which reading begins; the files that continue it are read too
 * @param robot which robot
 * @param index of these scans among all of the recording, from 0
 * @param count the number of scans
 */
public record RecordedScans(Path file, RecordedRobot robot, int index, int count) {
    private static final int MOST_SENSORS = 100;

    /**
     * Finds the scans in a recording: those of each robot, and of each of its connections. Blocks.
     *
     * @param file a file of a recording; its end may be missing
     * @return in the order of their first scans; empty if the recording has none
     * @throws IOException if a file cannot be read or is damaged: one sentence with its name
     */
    public static List<RecordedScans> in(Path file) throws IOException {
        Sink sink = new Sink(-1, scan -> {});
        readParts(file, sink);
        List<RecordedScans> all = new ArrayList<>();
        for (Run run : sink.runs) {
            all.add(new RecordedScans(file, run.robot, all.size(), run.count));
        }
        return all;
    }

    /**
     * Reads the scans. Blocks; the taker is called on this thread.
     *
     * @param taker receives each scan; its time is in seconds since the recording began
     * @throws IOException as {@link #in}; the taker has got what is in front of the damage
     */
    public void read(Consumer<RangeScan> taker) throws IOException {
        readParts(file, new Sink(index, taker));
    }

    private static void readParts(Path file, RecordingSink sink) throws IOException {
        Optional<Path> next = Optional.of(file);
        while (next.isPresent()) {
            Path part = next.get();
            next = AdjacentParts.of(part, readPart(part, sink)).next();
        }
    }

    private static RecordingHead readPart(Path part, RecordingSink sink) throws IOException {
        try {
            return RecordingReader.read(part, sink);
        } catch (FileSystemException e) {
            throw e;
        } catch (IOException e) {
            throw new IOException(part.getFileName() + " cannot be read: " + e.getMessage(), e);
        }
    }

    /** The scans of a connection so far. */
    private static final class Run {
        private final RecordedRobot robot;
        private final int index;
        private int count;

        Run(RecordedRobot robot, int index) {
            this.robot = robot;
            this.index = index;
        }
    }

    /** Counts the scans of each connection, and passes on those of one. */
    private static final class Sink implements RecordingSink {
        private final int wanted;
        private final Consumer<RangeScan> taker;
        private final List<Run> runs = new ArrayList<>();
        private final Map<Integer, Run> present = new HashMap<>();
        private final Map<Integer, RecordedRobot> robots = new HashMap<>();
        private final Map<Integer, String> connections = new HashMap<>();
        private final Map<String, RangeSensor> sensors = new HashMap<>();

        Sink(int wanted, Consumer<RangeScan> taker) {
            this.wanted = wanted;
            this.taker = taker;
        }

        @Override
        public void robot(RecordedRobot robot) {
            robots.put(robot.number(), robot);
        }

        /** Each file repeats how a robot is connected, which ends no connection. */
        @Override
        public void change(Kind kind, int robot, String name, String text) {
            if (kind == Kind.STATUS && name.equals("connection") && !text.equals(connections.put(robot, text))) {
                present.remove(robot);
            }
        }

        @Override
        public void event(Mark mark) {
            switch (mark.kind()) {
                case ADDED, REMOVED, LOST, REGAINED -> present.remove(mark.robot());
                default -> {}
            }
        }

        @Override
        public void sensor(int robot, String[] columns) {
            RangeSensor sensor = ScanText.sensor(columns);
            sensors.put(key(robot, sensor.name()), sensor);
            if (sensors.size() > MOST_SENSORS) {
                throw new IllegalArgumentException("there are more than " + MOST_SENSORS + " sensors");
            }
        }

        @Override
        public void scan(int robot, String[] columns) {
            RecordedRobot known = robots.get(robot);
            RangeSensor sensor = sensors.get(key(robot, columns[3]));
            if (known == null || sensor == null) {
                throw new IllegalArgumentException("there is no sensor of this scan in front of it");
            }
            RangeScan scan = ScanText.scan(columns, sensor);
            Run run = present.computeIfAbsent(robot, key -> begin(known));
            run.count++;
            if (run.index == wanted) {
                taker.accept(scan);
            }
        }

        private Run begin(RecordedRobot robot) {
            Run run = new Run(robot, runs.size());
            runs.add(run);
            return run;
        }

        private static String key(int robot, String sensor) {
            return robot + " " + sensor;
        }
    }
}
