package majic.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.file.WholeFile;
import majic.nav.file.CarmenLog;
import majic.nav.file.MapFiles;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.nav.mapping.Mapper;
import majic.nav.mapping.Trajectory;
import majic.program.Version;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code majic map build}: builds a map from a log or a recording of odometry and laser scans. */
@Command(
        name = "build",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        sortOptions = false,
        description = "Builds a map from a log or a recording of odometry and laser scans, without a window.")
final class MapBuildCommand implements Callable<Integer> {
    private static final double MM = 1000;
    private static final int SECONDS_PER_MINUTE = 60;
    private static final int PERCENT = 100;
    private static final int PROGRESS_STEP = 10;

    @Spec
    private @Nullable CommandSpec spec;

    @Parameters(paramLabel = "LOG", description = "a CARMEN log, plain or compressed by gzip, or a recording")
    private Path log = Path.of("");

    @Option(
            names = "--out",
            paramLabel = "NAME",
            description = "the map: NAME.yaml and NAME.pgm; the name of the log if it is left out")
    private @Nullable Path out;

    @Option(
            names = "--trajectory",
            paramLabel = "FILE",
            description = "also writes the corrected way: a line \"time x y theta\" (s, m, m, rad) for each odometry")
    private @Nullable Path trajectory;

    @Option(
            names = "--robot",
            paramLabel = "N",
            description = "the number of the robot, if a recording has scans of several")
    private @Nullable Integer robot;

    @Option(
            names = "--log",
            paramLabel = "FILE",
            description = "also writes what was read as a CARMEN log, compressed if FILE ends with .gz")
    private @Nullable Path carmenLog;

    @Override
    public Integer call() throws IOException {
        PrintWriter err = Objects.requireNonNull(spec).commandLine().getErr();
        ScanLog scans = ScanLog.of(log, robot, err::println);
        if (carmenLog != null) {
            scans.write(carmenLog);
        }
        Building building = new Building(err);
        scans.read(building, building::progress);
        building.mapper.finish();
        Path yaml = named();
        OccupancyGrid grid = building.mapper.grid();
        MapFiles.write(yaml, NavigationMap.of(grid));
        if (trajectory != null) {
            WholeFile.replace(trajectory, building.trajectory());
        }
        PrintWriter output = spec.commandLine().getOut();
        output.println(building.summary());
        output.println(yaml + ": " + MapShowCommand.size(grid));
        output.flush();
        return 0;
    }

    private Path named() {
        String name = String.valueOf((out == null ? log : out).getFileName());
        String base = name.replaceFirst("(?i)(\\.ya?ml|(\\.(clf|log|txt|majicrec))?(\\.gz)?)$", "");
        return (out == null ? log : out).resolveSibling(base + ".yaml");
    }

    /** What is made while the log is read. */
    private static final class Building implements CarmenLog.Listener {
        private final PrintWriter err;
        private final Mapper mapper = new Mapper();
        private final Trajectory way = new Trajectory(mapper);
        private @Nullable Pose last;
        private double distanceMm;
        private double firstS = Double.POSITIVE_INFINITY;
        private double lastS = Double.NEGATIVE_INFINITY;
        private int scans;
        private int shown;

        Building(PrintWriter err) {
            this.err = err;
        }

        @Override
        public void odometry(double timeS, Pose pose) {
            distanceMm += last == null ? 0 : last.distanceMm(pose);
            last = pose;
            firstS = Math.min(firstS, timeS);
            lastS = Math.max(lastS, timeS);
            way.add(timeS, pose);
        }

        @Override
        public void scan(RangeScan scan) {
            scans++;
            mapper.add(scan);
            odometry(scan.timeS(), scan.odometry());
        }

        void progress(double share) {
            int percent = (int) (share * PERCENT) / PROGRESS_STEP * PROGRESS_STEP;
            if (percent > shown) {
                shown = percent;
                err.println(percent + " %: " + scans + " scans, " + mapper.loops() + " loops");
                err.flush();
            }
        }

        String trajectory() {
            StringBuilder lines = new StringBuilder();
            for (Trajectory.TimedPose at : way.poses()) {
                lines.append(String.format(
                        Locale.ROOT,
                        "%.6f %.6f %.6f %.6f%n",
                        at.timeS(),
                        at.pose().xMm() / MM,
                        at.pose().yMm() / MM,
                        Math.toRadians(at.pose().headingDeg())));
            }
            return lines.toString();
        }

        String summary() {
            double seconds = Math.max(0, lastS - firstS);
            String kept = mapper.isFull() ? ", the map is full: later scans are left out" : "";
            return String.format(
                    Locale.ROOT,
                    "%d min %02d s, %.0f m, %d scans of which %d are in the map, %d loops%s",
                    (int) seconds / SECONDS_PER_MINUTE,
                    (int) seconds % SECONDS_PER_MINUTE,
                    distanceMm / MM,
                    scans,
                    mapper.scans(),
                    mapper.loops(),
                    kept);
        }
    }
}
