package majic.recorder;

import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.Value;
import majic.recorder.RecordingFormat.Kind;

/** What was recorded of one robot. Filled by the thread that reads the file, then read by any. */
public final class RobotTracks {
    /** The name of an item of a list: {@code sonar[3]}. */
    private static final Pattern ITEM = Pattern.compile("(.+)\\[(\\d{1,3})]");

    private final RecordedRobot robot;
    private final Map<String, Parameter> parameters = new LinkedHashMap<>();
    private final Map<String, Boolean> estimates = new TreeMap<>();
    private final Map<String, Track> values = new HashMap<>();
    private final Map<String, Track> status = new HashMap<>();
    private final Map<String, Track> reports = new HashMap<>();
    private final Track pictures = new Track();
    private final Track changes = new Track();
    private final List<RangeScan> scans = new ArrayList<>();
    private double removedS = Double.POSITIVE_INFINITY;

    RobotTracks(RecordedRobot robot) {
        this.robot = robot;
    }

    void describe(Parameter parameter, boolean about) {
        parameters.put(key(parameter.name()), parameter);
        estimates.put(key(parameter.name()), about);
    }

    void add(Kind kind, String name, double seconds, String text) {
        Map<String, Track> tracks = kind == Kind.VALUE ? values : kind == Kind.STATUS ? status : reports;
        String key = kind == Kind.VALUE ? key(name) : name;
        tracks.computeIfAbsent(key, missing -> new Track()).add(seconds, text);
        if (changes.size() == 0 || changes.seconds(changes.size() - 1) < seconds) {
            changes.add(seconds, 0);
        }
    }

    void addPicture(double seconds, String jpeg) {
        pictures.add(seconds, jpeg);
    }

    void addScan(RangeScan scan) {
        scans.add(scan);
    }

    void removed(double seconds) {
        removedS = seconds;
    }

    private static String key(String name) {
        return name.toLowerCase(Locale.ROOT);
    }

    /**
     * Returns which robot it was.
     *
     * @return its number, type and place
     */
    public RecordedRobot robot() {
        return robot;
    }

    /**
     * Returns whether the robot was in the team at a time.
     *
     * @param seconds time of the recording
     * @return true from its line in the file until it was removed
     */
    public boolean isPresent(double seconds) {
        return seconds >= robot.addedS() && seconds < removedS;
    }

    /**
     * Returns its parameters.
     *
     * @return those of which values were recorded, in the order of its table
     */
    public List<Parameter> parameters() {
        return List.copyOf(parameters.values());
    }

    /**
     * Returns the value of a parameter at a time.
     *
     * @param parameter one of {@link #parameters()}
     * @param seconds time of the recording
     * @return unknown before the first one
     */
    public Value value(Parameter parameter, double seconds) {
        Track track = values.get(key(parameter.name()));
        String text = track == null ? null : track.at(seconds);
        return text == null
                ? Value.unknown("not recorded yet")
                : ValueText.value(text, parameter, estimates.getOrDefault(key(parameter.name()), false));
    }

    /**
     * Returns the number in a parameter at a time.
     *
     * @param parameter its name
     * @param seconds time of the recording
     * @return empty if there was none
     */
    public Optional<Double> number(String parameter, double seconds) {
        Track track = values.get(key(parameter));
        double number = track == null ? Double.NaN : track.numberAt(seconds);
        return Double.isFinite(number) ? Optional.of(number) : Optional.empty();
    }

    /**
     * Returns the pose in the robot's own frame at a time. While there is no reading, as after the loss of the
     * connection, the last one counts.
     *
     * @param seconds time of the recording
     * @return the pose at which the robot was added before the first reading
     */
    public Pose pose(double seconds) {
        return new Pose(last("x", seconds), last("y", seconds), last("heading", seconds));
    }

    private double last(String parameter, double seconds) {
        Track track = values.get(key(parameter));
        double number = track == null ? Double.NaN : track.lastNumberAt(seconds);
        return Double.isNaN(number) ? 0 : number;
    }

    /**
     * Returns what the team knew of the robot at a time.
     *
     * @param name {@code connection}, {@code owner}, {@code placed}, {@code aircraft}, {@code stop} or {@code way}
     * @param seconds time of the recording
     * @return the text; empty if there was none
     */
    public String status(String name, double seconds) {
        Track track = status.get(name);
        String text = track == null ? null : track.at(seconds);
        return text == null ? "" : text;
    }

    /**
     * Returns where the robot's own frame lay on the map at a time.
     *
     * @param seconds time of the recording
     * @return the frame of the map once a user has placed the robot, until then where it was added
     */
    public Pose origin(double seconds) {
        return isPlaced(seconds) ? Pose.START : robot.origin();
    }

    /**
     * Returns whether a user has placed the robot on the map.
     *
     * @param seconds time of the recording
     * @return true from the first time on
     */
    public boolean isPlaced(double seconds) {
        return !status("placed", seconds).isEmpty();
    }

    /**
     * Returns how high an aircraft was at a time.
     *
     * @param seconds time of the recording
     * @return mm above where it took off; empty for a robot on the ground, and while its height was not known
     */
    public Optional<Double> heightMm(double seconds) {
        return status(RecordingFormat.AIRCRAFT, seconds).isEmpty() ? Optional.empty() : number("altitude", seconds);
    }

    /**
     * Returns the way on which the robot drove to a place at a time.
     *
     * @param seconds time of the recording
     * @return the corners that were still ahead, in the robot's own frame, the place last; empty if it did not
     */
    public List<Pose> way(double seconds) {
        return RecordingFormat.way(status(RecordingFormat.WAY, seconds));
    }

    /**
     * Returns what the robot's panel showed beyond the parameters.
     *
     * @param seconds time of the recording
     * @return by the names that its driver has defined
     */
    public Map<String, String> reports(double seconds) {
        Map<String, String> texts = new TreeMap<>();
        reports.forEach(
                (name, track) -> Optional.ofNullable(track.at(seconds)).ifPresent(text -> texts.put(name, text)));
        return texts;
    }

    /**
     * Returns the times at which something of the robot changed.
     *
     * @param fromS excluded
     * @param toS included
     * @return ascending
     */
    public double[] changes(double fromS, double toS) {
        return changes.times(fromS, toS);
    }

    /**
     * Returns when something of the robot had changed last.
     *
     * @param seconds time of the recording
     * @return not after that time
     */
    public double lastChangeS(double seconds) {
        int index = changes.indexAt(seconds);
        return index < 0 ? seconds : changes.seconds(index);
    }

    /**
     * Returns what the laser scanners of the robot have measured.
     *
     * @return in the order of their times, which are those of the recording, seconds
     */
    public List<RangeScan> scans() {
        return Collections.unmodifiableList(scans);
    }

    /**
     * Returns the last picture of the camera before a time.
     *
     * @param seconds time of the recording
     * @return when it came; empty if there was none, or if it is damaged
     */
    public Optional<Picture> picture(double seconds) {
        int index = pictures.indexAt(seconds);
        return index < 0
                ? Optional.empty()
                : jpeg(pictures.text(index)).map(jpeg -> new Picture(pictures.seconds(index), jpeg));
    }

    private static Optional<byte[]> jpeg(String text) {
        try {
            return Optional.of(Base64.getDecoder().decode(text));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /**
     * A picture of the camera.
     *
     * @param seconds when it came
     * @param jpeg a JPEG file; not to be changed
     */
    public record Picture(double seconds, byte[] jpeg) {}

    Series series(String parameter, double fromS) {
        Track whole = values.get(key(parameter));
        if (whole != null) {
            return whole.series(fromS);
        }
        Matcher item = ITEM.matcher(parameter);
        Track list = item.matches() ? values.get(key(item.group(1))) : null;
        return list == null ? Series.EMPTY : list.series(fromS, Integer.parseInt(item.group(2)));
    }

    /** The parameter of which a series is read: that of the list for an item of a list. */
    static String parameterOf(String series) {
        Matcher item = ITEM.matcher(series);
        return key(item.matches() ? item.group(1) : series);
    }
}
