package majic.recorder;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.recorder.RecordingFormat.Kind;
import majic.text.VisibleText;

/** The form of laser scanners and their scans in a recording: numbers between spaces, ranges in whole millimetres. */
final class ScanText {
    /** Farther than a robot gets. */
    private static final double FAR_MM = 1e9;

    private static final int BEAM_NUMBERS = 7;
    private static final int SENSOR_COLUMNS = 5;
    private static final int SCAN_COLUMNS = 7;
    private static final String BETWEEN = " ";
    private static final String NO_ECHO = "clear";
    private static final String NOTHING_MEASURED = "?";

    private ScanText() {}

    static String sensor(int robot, RangeSensor sensor) {
        return RecordingFormat.change(
                Kind.SENSOR,
                robot,
                VisibleText.of(sensor.name()),
                sensor.beams().stream().map(ScanText::beam).collect(Collectors.joining(BETWEEN)));
    }

    private static String beam(Beam beam) {
        return String.join(
                BETWEEN,
                pose(beam.mount()),
                ValueText.fine(beam.openingDeg()),
                ValueText.fine(beam.leastMm()),
                ValueText.fine(beam.reachMm()),
                ValueText.fine(beam.noiseMm()));
    }

    private static String pose(Pose pose) {
        return String.join(
                BETWEEN, ValueText.fine(pose.xMm()), ValueText.fine(pose.yMm()), ValueText.fine(pose.headingDeg()));
    }

    static RangeSensor sensor(String[] columns) {
        RecordingFormat.require(columns, SENSOR_COLUMNS);
        String[] numbers = columns[4].split(BETWEEN);
        if (numbers.length % BEAM_NUMBERS != 0) {
            throw new IllegalArgumentException(
                    "a sensor has " + numbers.length + " numbers and needs " + BEAM_NUMBERS + " for each beam");
        }
        List<Beam> beams = new ArrayList<>();
        for (int at = 0; at < numbers.length; at += BEAM_NUMBERS) {
            beams.add(new Beam(
                    new Pose(number(numbers[at]), number(numbers[at + 1]), number(numbers[at + 2])),
                    number(numbers[at + 3]),
                    number(numbers[at + 4]),
                    number(numbers[at + 5]),
                    number(numbers[at + 6])));
        }
        return new RangeSensor(columns[3], beams);
    }

    private static double number(String text) {
        return RecordingFormat.number(text);
    }

    /**
     * The line of a scan.
     *
     * @param measuredS the time of the recording at which it was measured
     */
    static String scan(int robot, RangeScan scan, double measuredS) {
        StringBuilder ranges = new StringBuilder();
        for (int beam = 0; beam < scan.size(); beam++) {
            ranges.append(beam == 0 ? "" : BETWEEN).append(range(scan.rangeMm(beam)));
        }
        return RecordingFormat.change(
                Kind.SCAN,
                robot,
                VisibleText.of(scan.sensor().name()),
                ValueText.time(measuredS) + "\t" + pose(scan.odometry()) + "\t" + ranges);
    }

    private static String range(float mm) {
        return Float.isNaN(mm) ? NOTHING_MEASURED : Float.isInfinite(mm) ? NO_ECHO : String.valueOf(Math.round(mm));
    }

    static RangeScan scan(String[] columns, RangeSensor sensor) {
        RecordingFormat.require(columns, SCAN_COLUMNS);
        String[] texts = columns[6].split(BETWEEN);
        float[] ranges = new float[texts.length];
        for (int beam = 0; beam < texts.length; beam++) {
            ranges[beam] = switch (texts[beam]) {
                case NO_ECHO -> Float.POSITIVE_INFINITY;
                case NOTHING_MEASURED -> Float.NaN;
                default -> (float) number(texts[beam]);
            };
        }
        Pose odometry = RecordingFormat.pose(columns[5]);
        if (odometry.distanceMm(Pose.START) > FAR_MM) {
            throw new IllegalArgumentException("\"" + columns[5] + "\" is too far away");
        }
        return new RangeScan(sensor, RecordingFormat.time(columns[4]), odometry, ranges);
    }
}
