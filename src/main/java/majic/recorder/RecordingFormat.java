package majic.recorder;

import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.Unit;
import majic.lab.LabAccess;
import majic.log.Line;
import majic.text.VisibleText;

/**
 * The lines of a recording: columns between tabs, first the time in seconds, empty if it is that of the line before,
 * then the kind of line. {@code docs/recordings.md} describes them.
 */
final class RecordingFormat {
    /** The first word of a file. */
    static final String NAME = "majic-recording";

    /** Is raised when readers of the version before could not read the file. */
    static final String VERSION = "1";

    /** The status of a robot that has the way on which it drives to a place. */
    static final String WAY = "way";

    /** The status of a robot that leaves the ground, so that its altitude is shown on the map. */
    static final String AIRCRAFT = "aircraft";

    private static final String TAB = "\t";

    /** About four months. */
    private static final double LONGEST_S = 1e7;

    private static final int ROBOT_COLUMNS = 12;
    private static final int PARAMETER_COLUMNS = 10;

    /** The kinds of lines. */
    enum Kind {
        /** A wall of the room: two ends. */
        WALL,
        /** A piece of tape on the floor: two ends. */
        TAPE,
        /** A lamp above the floor. */
        LAMP,
        /** A robot joins the recording. */
        ROBOT,
        /** A parameter of which values follow. */
        PARAMETER,
        /** A parameter of a robot has changed. */
        VALUE,
        /** What the team keeps of a robot has changed: connection, owner, running command. */
        STATUS,
        /** What a robot's panel shows beyond the parameters has changed; its driver defines names and texts. */
        REPORT,
        /** The true pose of a robot in the simulated lab has changed. */
        TRUTH,
        /** A laser scanner of which scans follow. */
        SENSOR,
        /** What a laser scanner has measured. */
        SCAN,
        /** A picture of a robot's camera. */
        PICTURE,
        /** Something happened to a robot or the team. */
        EVENT,
        /** A line of the session. */
        LINE,
        /** Lines are missing here, because the disk was too slow. */
        MISSING;

        /** The word in the file. */
        String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    private RecordingFormat() {}

    static String wall(LabAccess.Wall wall) {
        return places(Kind.WALL, wall.x1(), wall.y1(), wall.x2(), wall.y2());
    }

    static String tape(LabAccess.Tape tape) {
        return places(Kind.TAPE, tape.x1(), tape.y1(), tape.x2(), tape.y2());
    }

    static String lamp(LabAccess.Lamp lamp) {
        return places(Kind.LAMP, lamp.x(), lamp.y());
    }

    private static String places(Kind kind, double... mm) {
        return columns(kind, DoubleStream.of(mm).mapToObj(ValueText::of).collect(Collectors.joining(TAB)));
    }

    static String robot(RecordedRobot robot) {
        Pose origin = robot.origin();
        return columns(
                Kind.ROBOT,
                String.valueOf(robot.number()),
                robot.type(),
                VisibleText.of(robot.label()),
                VisibleText.of(robot.make()),
                ValueText.of(robot.bodyMm()),
                robot.estimates() ? "about" : "",
                ValueText.of(origin.xMm()),
                ValueText.of(origin.yMm()),
                ValueText.of(origin.headingDeg()),
                robot.inLab());
    }

    static RecordedRobot robot(String[] columns, double seconds) {
        require(columns, ROBOT_COLUMNS);
        return new RecordedRobot(
                robotNumber(columns[2]),
                columns[3],
                columns[4],
                columns[5],
                number(columns[6]),
                !columns[7].isEmpty(),
                new Pose(number(columns[8]), number(columns[9]), number(columns[10])),
                columns[11],
                seconds);
    }

    static String parameter(int robot, Parameter parameter, boolean about) {
        return columns(
                Kind.PARAMETER,
                String.valueOf(robot),
                parameter.name(),
                parameter.kind().name().toLowerCase(Locale.ROOT),
                parameter.unit().symbol(),
                about ? "about" : "",
                String.valueOf(parameter.range().min()),
                String.valueOf(parameter.range().max()),
                VisibleText.of(parameter.help()));
    }

    static Parameter parameter(String[] columns) {
        require(columns, PARAMETER_COLUMNS);
        return new Parameter(
                columns[3],
                constant(Parameter.Kind.class, columns[4]),
                unit(columns[5]),
                new Range(number(columns[7]), number(columns[8])),
                false,
                List.of(),
                true,
                false,
                false,
                List.of(),
                columns[9]);
    }

    private static Unit unit(String symbol) {
        for (Unit unit : Unit.values()) {
            if (unit.symbol().equals(symbol)) {
                return unit;
            }
        }
        throw new IllegalArgumentException("no unit: " + symbol);
    }

    static boolean isAbout(String[] columns) {
        return !columns[6].isEmpty();
    }

    static String change(Kind kind, int robot, String name, String text) {
        return columns(kind, String.valueOf(robot), name, text);
    }

    static String pose(Pose pose) {
        return ValueText.of(pose.xMm()) + " " + ValueText.of(pose.yMm()) + " " + ValueText.of(pose.headingDeg());
    }

    static Pose pose(String text) {
        String[] numbers = text.split(" ");
        require(numbers, 3);
        return new Pose(number(numbers[0]), number(numbers[1]), number(numbers[2]));
    }

    /** The corners of a way, in whole millimetres. */
    static String way(List<Pose> corners) {
        return corners.stream()
                .map(corner -> Math.round(corner.xMm()) + " " + Math.round(corner.yMm()))
                .collect(Collectors.joining(" "));
    }

    /** The corners of a way, each with heading 0. */
    static List<Pose> way(String text) {
        String[] numbers = text.isEmpty() ? new String[0] : text.split(" ");
        if (numbers.length % 2 != 0) {
            throw new IllegalArgumentException(
                    "a way has " + numbers.length + " numbers and needs two for each corner");
        }
        return IntStream.range(0, numbers.length / 2)
                .mapToObj(corner -> new Pose(number(numbers[2 * corner]), number(numbers[2 * corner + 1]), 0))
                .toList();
    }

    static String picture(int robot, byte[] jpeg) {
        return columns(Kind.PICTURE, String.valueOf(robot), Base64.getEncoder().encodeToString(jpeg));
    }

    static String event(int robot, Mark.Kind kind, String text) {
        return columns(Kind.EVENT, String.valueOf(robot), kind.name().toLowerCase(Locale.ROOT), VisibleText.of(text));
    }

    static Mark event(String[] columns, double seconds) {
        require(columns, 5);
        return new Mark(seconds, constant(Mark.Kind.class, columns[3]), robotNumber(columns[2]), columns[4]);
    }

    static String line(Line line) {
        return columns(Kind.LINE, line.kind().name().toLowerCase(Locale.ROOT), line.text());
    }

    static RecordedLine line(String[] columns, double seconds) {
        require(columns, 4);
        return new RecordedLine(seconds, constant(Line.Kind.class, columns[2]), columns[3]);
    }

    static String missing(long lines) {
        return columns(Kind.MISSING, String.valueOf(lines));
    }

    private static String columns(Kind kind, String... columns) {
        return TAB + kind.word() + TAB + String.join(TAB, columns) + "\n";
    }

    /** The columns of a line; trailing empty ones are kept. */
    static String[] split(String line) {
        return line.split(TAB, -1);
    }

    static double number(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("\"" + text + "\" is not a number", e);
        }
    }

    /** A time of the recording, in seconds. */
    static double time(String text) {
        double seconds = number(text);
        if (!(Math.abs(seconds) <= LONGEST_S)) {
            throw new IllegalArgumentException("\"" + text + "\" is not a time");
        }
        return seconds;
    }

    static int robotNumber(String text) {
        try {
            return Integer.parseInt(text);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("\"" + text + "\" is not the number of a robot", e);
        }
    }

    private static <E extends Enum<E>> E constant(Class<E> type, String word) {
        return Arrays.stream(type.getEnumConstants())
                .filter(one -> one.name().toLowerCase(Locale.ROOT).equals(word))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("\"" + word + "\" is not a known kind"));
    }

    /** Refuses a line that is too short. */
    static void require(String[] columns, int count) {
        if (columns.length < count) {
            throw new IllegalArgumentException("it has " + columns.length + " columns and needs " + count);
        }
    }
}
