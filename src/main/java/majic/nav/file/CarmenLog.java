package majic.nav.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleConsumer;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;

/**
 * Logs of odometry and laser scans in the format of CARMEN (Montemerlo, Roy, Thrun 2003; its logger's manual), plain or
 * compressed by gzip: {@code ODOM}, {@code FLASER}, {@code ROBOTLASER1}. Comments and all other lines are skipped, also
 * {@code PARAM} and {@code RLASER}. Metres and radians are converted to mm and degrees; a range of 0 is nothing
 * measured.
 *
 * <p>A line has at most 200,000 characters, a log {@value #MOST_LINES} lines.
 */
public final class CarmenLog {
    /** The most lines of a log; two weeks of odometry at 20 Hz. */
    public static final int MOST_LINES = 20_000_000;

    /** What a SICK LMS 200 reports if there is no echo; a greater distance is none either. */
    private static final double SICK_REACH_M = 81.83;

    /** The noise of a SICK LMS 200 at up to 8 m by its data sheet: 15 mm. */
    private static final double NOISE_MM = 15;

    /** The greatest distance of a place, m: beyond it, a coordinate is wrong. */
    private static final double FAR_M = 1e6;

    private static final double LATEST_S = 1e11;
    private static final double MM = 1000;

    /** A sensor farther from the robot's centre is none: the pose is a corrected one, as in some published logs. */
    private static final double MOST_OFFSET_MM = 1000;

    private static final int HALF_TURN = 180;

    /** How far beams that are written as one scanner may be from its place, and from its angles. */
    private static final double APART_MM = 1;

    private static final double UNEVEN_DEG = 0.1;

    private CarmenLog() {}

    /** What is read from a log, in the order of its lines. The times may step back by a second. */
    public interface Listener {
        /** Called for each line of odometry: time in s, pose in the frame of the odometry. */
        void odometry(double timeS, Pose pose);

        /** Called for each scan. */
        void scan(RangeScan scan);
    }

    /**
     * Reads a log. Blocks; the listener is called on this thread.
     *
     * @param file plain or compressed by gzip
     * @param progress called with the share that has been read, 0 to 1, for each line
     * @throws IOException if the file cannot be read, or a line is damaged: one sentence with the number of the line;
     *     the listener has got what is in front of it
     */
    public static void read(Path file, Listener listener, DoubleConsumer progress) throws IOException {
        try (NumberedLines lines = NumberedLines.open(file, MOST_LINES)) {
            Reader reader = new Reader(lines, listener);
            for (String line = lines.next(); line != null; line = lines.next()) {
                reader.read(line);
                progress.accept(lines.progress());
            }
        }
    }

    /** Reads lines one after the other. */
    private static final class Reader {
        private final NumberedLines lines;
        private final Listener listener;
        private final Map<String, RangeSensor> sensors = new HashMap<>();
        private String[] fields = {};
        private int next;

        Reader(NumberedLines lines, Listener listener) {
            this.lines = lines;
            this.listener = listener;
        }

        void read(String line) throws IOException {
            int end = line.indexOf(' ');
            String word = end < 0 ? line : line.substring(0, end);
            if (!word.equals("ODOM") && !word.equals("FLASER") && !word.equals("ROBOTLASER1")) {
                return;
            }
            fields = line.trim().split("\\s+");
            next = 1;
            switch (word) {
                case "ODOM" -> odometry();
                case "FLASER" -> frontLaser();
                default -> robotLaser();
            }
        }

        private void odometry() throws IOException {
            Pose pose = pose();
            skip(3);
            listener.odometry(time(), pose);
        }

        private void frontLaser() throws IOException {
            int count = count("the number of ranges", 1);
            double stepDeg = (double) HALF_TURN / (count % 2 == 0 || count == 1 ? count : count - 1);
            float[] ranges = ranges(count);
            Pose laser = pose();
            Pose robot = pose();
            double time = time();
            RangeSensor sensor = sensors.computeIfAbsent(
                    "FLASER " + count, key -> laser(mount(robot, laser), count, -90, stepDeg, SICK_REACH_M));
            listener.scan(new RangeScan(sensor, time, robot, ranges));
        }

        private void robotLaser() throws IOException {
            skip(1);
            double start = number("the first angle (rad)", -2 * Math.PI, 2 * Math.PI);
            skip(1);
            double step = number("the step of the angle (rad)", -Math.PI, Math.PI);
            double reach = number("the greatest range (m)", 0.01, FAR_M);
            skip(2);
            int count = count("the number of ranges", 1);
            float[] ranges = ranges(count);
            skip(count("the number of remissions", 0));
            Pose laser = pose();
            Pose robot = pose();
            skip(5);
            double time = time();
            RangeSensor sensor = sensors.computeIfAbsent(
                    "ROBOTLASER1 " + count + " " + start + " " + step + " " + reach,
                    key -> laser(mount(robot, laser), count, Math.toDegrees(start), Math.toDegrees(step), reach));
            listener.scan(new RangeScan(sensor, time, robot, ranges));
        }

        private static RangeSensor laser(Pose mount, int count, double firstDeg, double stepDeg, double reachM) {
            return RangeSensor.laser(mount, count, firstDeg, stepDeg, reachM * MM, NOISE_MM);
        }

        private static Pose mount(Pose robot, Pose laser) {
            Pose mount = laser.seenFrom(robot);
            return mount.distanceMm(Pose.START) <= MOST_OFFSET_MM ? mount : Pose.START;
        }

        private float[] ranges(int count) throws IOException {
            float[] ranges = new float[count];
            for (int index = 0; index < count; index++) {
                double range = number("range " + (index + 1) + " (m)", 0, FAR_M) * MM;
                ranges[index] = range == 0 ? Float.NaN : (float) range;
            }
            return ranges;
        }

        private Pose pose() throws IOException {
            double x = number("x (m)", -FAR_M, FAR_M) * MM;
            double y = number("y (m)", -FAR_M, FAR_M) * MM;
            return new Pose(x, y, Math.toDegrees(number("theta (rad)", -FAR_M, FAR_M)));
        }

        private double time() throws IOException {
            return number("the time (s)", 0, LATEST_S);
        }

        private int count(String what, int least) throws IOException {
            return (int) number(what, least, RangeSensor.MOST_BEAMS);
        }

        private void skip(int number) {
            next += number;
        }

        private double number(String what, double least, double most) throws IOException {
            if (next >= fields.length) {
                throw lines.wrong("the line ends in front of " + what + "; a whole " + fields[0] + " has "
                        + (fields[0].equals("ODOM")
                                ? "x y theta tv rv accel time"
                                : "ranges, two poses and the time behind their number"));
            }
            return lines.number(fields[next++], what, least, most);
        }
    }

    /**
     * Returns the line of an odometry.
     *
     * @param timeS s
     * @param pose in the frame of the odometry
     * @return without an end of line
     */
    public static String line(double timeS, Pose pose) {
        return String.format(Locale.ROOT, "ODOM %s 0 0 0 %.6f majic %.6f", text(pose), timeS, timeS);
    }

    /**
     * Returns the line of a scan, a {@code ROBOTLASER1}; no echo is written as the reach, nothing measured as 0.
     *
     * @param scan of a sensor whose beams are equally far apart, as those of {@link RangeSensor#laser}
     * @return without an end of line
     * @throws IllegalArgumentException if they are not, or do not begin at one place
     */
    public static String line(RangeScan scan) {
        List<Beam> beams = scan.sensor().beams();
        Pose mount = beams.get(0).mount();
        double first = Math.toRadians(mount.headingDeg());
        double step = Math.toRadians(stepDeg(scan.sensor()));
        double reach = beams.get(0).reachMm() / MM;
        StringBuilder line = new StringBuilder(String.format(
                Locale.ROOT,
                "ROBOTLASER1 0 %.8f %.8f %.8f %.3f 0.015 0 %d",
                first,
                step * (beams.size() - 1),
                step,
                reach,
                scan.size()));
        for (int beam = 0; beam < scan.size(); beam++) {
            float mm = scan.rangeMm(beam);
            double range = Float.isNaN(mm) ? 0 : Math.min(reach, mm / MM);
            line.append(String.format(Locale.ROOT, " %.3f", range));
        }
        Pose laser = scan.odometry().plus(new Pose(mount.xMm(), mount.yMm(), 0));
        return line.append(String.format(
                        Locale.ROOT,
                        " 0 %s %s 0 0 0 0 0 %.6f majic %.6f",
                        text(laser),
                        text(scan.odometry()),
                        scan.timeS(),
                        scan.timeS()))
                .toString();
    }

    private static double stepDeg(RangeSensor sensor) {
        List<Beam> beams = sensor.beams();
        Pose first = beams.get(0).mount();
        Pose last = beams.get(beams.size() - 1).mount();
        if (beams.size() == 1) {
            return 0;
        }
        double about = Pose.normalised(beams.get(1).mount().headingDeg() - first.headingDeg());
        double whole = about * (beams.size() - 1);
        double exact = (whole + Pose.normalised(last.headingDeg() - first.headingDeg() - whole)) / (beams.size() - 1);
        for (int index = 0; index < beams.size(); index++) {
            Pose mount = beams.get(index).mount();
            double wrong = Pose.normalised(mount.headingDeg() - first.headingDeg() - index * exact);
            if (mount.distanceMm(first) > APART_MM || Math.abs(wrong) > UNEVEN_DEG) {
                throw new IllegalArgumentException("the beams of the " + sensor.name()
                        + " are not equally far apart at one place, as a CARMEN log needs them");
            }
        }
        return exact;
    }

    private static String text(Pose pose) {
        return String.format(
                Locale.ROOT, "%.6f %.6f %.6f", pose.xMm() / MM, pose.yMm() / MM, Math.toRadians(pose.headingDeg()));
    }
}
