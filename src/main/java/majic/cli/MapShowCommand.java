package majic.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.file.CarmenLog;
import majic.nav.file.MapFiles;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.NavigationMap.Place;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import majic.program.Version;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code majic map show}: shows what is in the file of a map or in a log. */
@Command(
        name = "show",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Checks the file of a map or a log and shows what is in it.")
final class MapShowCommand implements Callable<Integer> {
    private static final double MM = 1000;

    @Spec
    private @Nullable CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "a map (.yaml, .map) or a CARMEN log (.clf, .log, also with .gz)")
    private Path file = Path.of("");

    @Override
    public Integer call() throws IOException {
        PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        if (name.matches(".*\\.(clf|log)(\\.gz)?")) {
            out.println(log());
        } else {
            show(MapFiles.read(file), out);
        }
        out.flush();
        return 0;
    }

    private void show(NavigationMap map, PrintWriter out) {
        OccupancyGrid grid = map.grid();
        out.println(size(grid));
        out.println("lower left corner at " + text(grid.origin()));
        map.home().ifPresent(home -> out.println("home at " + text(home)));
        for (Place place : map.places()) {
            Pose pose = place.pose();
            out.println("place " + VisibleText.of(place.name()) + " at "
                    + (place.withHeading() ? text(pose) : text(pose).replaceFirst(", [^,]*$", "")));
        }
        if (!map.forbidden().isEmpty()) {
            out.println(map.forbidden().size() + " forbidden lines");
        }
    }

    private static String text(Pose pose) {
        return String.format(Locale.ROOT, "%.0f mm, %.0f mm, %.1f deg", pose.xMm(), pose.yMm(), pose.headingDeg());
    }

    /** One line with the size and what is known. */
    static String size(OccupancyGrid grid) {
        double area = grid.cellMm() * grid.cellMm() / MM / MM;
        return String.format(
                Locale.ROOT,
                "%.1f m by %.1f m, %d by %d cells of %.0f mm; free %.0f m², occupied %d cells",
                grid.width() * grid.cellMm() / MM,
                grid.height() * grid.cellMm() / MM,
                grid.width(),
                grid.height(),
                grid.cellMm(),
                grid.count(State.FREE) * area,
                grid.count(State.OCCUPIED));
    }

    private String log() throws IOException {
        Counting counting = new Counting();
        CarmenLog.read(file, counting, share -> {});
        return counting.odometry + " lines of odometry, " + counting.scans + " scans, " + Math.round(counting.seconds())
                + " s";
    }

    private static final class Counting implements CarmenLog.Listener {
        private int odometry;
        private int scans;
        private double firstS = Double.POSITIVE_INFINITY;
        private double lastS = Double.NEGATIVE_INFINITY;

        @Override
        public void odometry(double timeS, Pose pose) {
            odometry++;
            seen(timeS);
        }

        @Override
        public void scan(RangeScan scan) {
            scans++;
            seen(scan.timeS());
        }

        private void seen(double timeS) {
            firstS = Math.min(firstS, timeS);
            lastS = Math.max(lastS, timeS);
        }

        double seconds() {
            return Math.max(0, lastS - firstS);
        }
    }
}
