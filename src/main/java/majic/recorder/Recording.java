package majic.recorder;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiPredicate;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.RangeSensor;
import majic.lab.LabAccess;
import majic.recorder.RecordingFormat.Kind;

/** One file of a recording in memory. Immutable once it is read. */
public final class Recording implements RecordedHistory {
    private final RecordingHead head;
    private final RecordedRoom room;
    private final List<RobotTracks> robots;
    private final Map<String, Track> truths;
    private final List<Mark> marks;
    private final List<RecordedLine> lines;
    private final double endS;

    private Recording(RecordingHead head, Collector content) {
        this.head = head;
        this.room = new RecordedRoom(content.walls, new LabAccess.Furnishing(content.tapes, content.lamps));
        this.robots = List.copyOf(content.robots);
        this.truths = Collections.unmodifiableMap(content.truths);
        this.marks = List.copyOf(content.marks);
        this.lines = List.copyOf(content.lines);
        this.endS = Math.max(head.beginS(), content.endS);
    }

    /**
     * The room in which robots were recorded. Immutable.
     *
     * @param walls none without a simulated lab
     * @param furnishing none without a simulated lab
     */
    public record RecordedRoom(List<LabAccess.Wall> walls, LabAccess.Furnishing furnishing) {
        /** Copies the list. */
        public RecordedRoom {
            walls = List.copyOf(walls);
        }
    }

    /**
     * Reads a whole file. Blocks.
     *
     * @param file a file of a recording; its end may be missing
     * @return its content
     * @throws IOException if it cannot be read, or is no recording; the message says why
     */
    public static Recording read(Path file) throws IOException {
        return read(file, (robot, parameter) -> true);
    }

    /** Reads a file without the changes of other parameters than those wanted, and then also without pictures. */
    static Recording read(Path file, BiPredicate<Integer, String> wanted) throws IOException {
        Collector content = new Collector(wanted);
        RecordingHead head = RecordingReader.read(file, content);
        return new Recording(head, content);
    }

    /**
     * Returns what the file says about itself.
     *
     * @return when it began
     */
    public RecordingHead head() {
        return head;
    }

    /**
     * Returns the room.
     *
     * @return empty without a simulated lab
     */
    public RecordedRoom room() {
        return room;
    }

    /**
     * Returns what was recorded of each robot.
     *
     * @return in the order in which they joined
     */
    public List<RobotTracks> tracks() {
        return robots;
    }

    /**
     * Returns the true poses of the robots in the simulated lab at a time.
     *
     * @param seconds time of the recording
     * @return by the name in the lab; empty without a lab
     */
    public Map<String, Pose> truePoses(double seconds) {
        Map<String, Pose> poses = new TreeMap<>();
        truths.forEach((name, track) ->
                Optional.ofNullable(track.at(seconds)).ifPresent(text -> poses.put(name, RecordingFormat.pose(text))));
        return poses;
    }

    /**
     * Returns the lines of the session.
     *
     * @return in their order
     */
    public List<RecordedLine> lines() {
        return lines;
    }

    /**
     * Returns the time of its first line.
     *
     * @return seconds since the beginning of the recording
     */
    public double beginS() {
        return head.beginS();
    }

    @Override
    public double endS() {
        return endS;
    }

    @Override
    public List<RecordedRobot> robots() {
        return robots.stream().map(RobotTracks::robot).toList();
    }

    @Override
    public List<Parameter> parameters(int robot) {
        Map<String, Parameter> all = new LinkedHashMap<>();
        robots.stream()
                .filter(tracks -> tracks.robot().number() == robot)
                .forEach(tracks -> tracks.parameters().forEach(parameter -> all.put(parameter.name(), parameter)));
        return List.copyOf(all.values());
    }

    @Override
    public Series series(int robot, String parameter, double fromS) {
        return Series.join(robots.stream()
                .filter(tracks -> tracks.robot().number() == robot)
                .map(tracks -> tracks.series(parameter, fromS))
                .toList());
    }

    @Override
    public List<Mark> marks(double fromS) {
        return marks.stream().filter(mark -> mark.seconds() >= fromS).toList();
    }

    /** Collects the lines of a file. */
    private static final class Collector implements RecordingSink {
        private final BiPredicate<Integer, String> wanted;
        private final boolean all;
        private final List<LabAccess.Wall> walls = new ArrayList<>();
        private final List<LabAccess.Tape> tapes = new ArrayList<>();
        private final List<LabAccess.Lamp> lamps = new ArrayList<>();
        private final List<RobotTracks> robots = new ArrayList<>();
        private final Map<Integer, RobotTracks> present = new LinkedHashMap<>();
        private final Map<String, RangeSensor> sensors = new HashMap<>();
        private final Map<String, Track> truths = new TreeMap<>();
        private final List<Mark> marks = new ArrayList<>();
        private final List<RecordedLine> lines = new ArrayList<>();
        private double endS;

        Collector(BiPredicate<Integer, String> wanted) {
            this.wanted = wanted;
            this.all = wanted.test(0, "");
        }

        @Override
        public void time(double seconds) {
            endS = seconds;
        }

        @Override
        public void room(Kind kind, double[] mm) {
            switch (kind) {
                case WALL -> walls.add(new LabAccess.Wall(mm[0], mm[1], mm[2], mm[3]));
                case TAPE -> tapes.add(new LabAccess.Tape(mm[0], mm[1], mm[2], mm[3]));
                default -> lamps.add(new LabAccess.Lamp(mm[0], mm[1]));
            }
        }

        @Override
        public void robot(RecordedRobot robot) {
            if (present.containsKey(robot.number())) {
                return;
            }
            RobotTracks tracks = new RobotTracks(robot);
            robots.add(tracks);
            present.put(robot.number(), tracks);
        }

        @Override
        public void parameter(int robot, Parameter parameter, boolean about) {
            RobotTracks tracks = present.get(robot);
            if (tracks != null) {
                tracks.describe(parameter, about);
            }
        }

        @Override
        public void change(Kind kind, int robot, String name, String text) {
            if (kind == Kind.TRUTH) {
                RecordingFormat.pose(text);
                truths.computeIfAbsent(name, key -> new Track()).add(endS, text);
            } else if (kind == Kind.STATUS && name.equals(RecordingFormat.WAY)) {
                RecordingFormat.way(text);
            }
            RobotTracks tracks = present.get(robot);
            if (tracks != null && (all || kind == Kind.VALUE && wanted.test(robot, name.toLowerCase(Locale.ROOT)))) {
                tracks.add(kind, name, endS, text);
            }
        }

        @Override
        public void picture(int robot, String jpeg) {
            RobotTracks tracks = present.get(robot);
            if (tracks != null && all) {
                tracks.addPicture(endS, jpeg);
            }
        }

        @Override
        public void sensor(int robot, String[] columns) {
            if (all) {
                RangeSensor sensor = ScanText.sensor(columns);
                sensors.put(robot + " " + sensor.name(), sensor);
            }
        }

        @Override
        public void scan(int robot, String[] columns) {
            RobotTracks tracks = present.get(robot);
            RangeSensor sensor = sensors.get(robot + " " + columns[3]);
            if (tracks != null && sensor != null) {
                tracks.addScan(ScanText.scan(columns, sensor));
            }
        }

        @Override
        public void event(Mark mark) {
            marks.add(mark);
            RobotTracks tracks = present.get(mark.robot());
            if (mark.kind() == Mark.Kind.REMOVED && tracks != null) {
                tracks.removed(mark.seconds());
                present.remove(mark.robot());
            }
        }

        @Override
        public void line(RecordedLine line) {
            lines.add(line);
        }
    }
}
