package majic.figures.nav;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.TreeMap;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.file.CarmenLog;
import majic.nav.grid.GridBuilder;
import majic.nav.grid.LikelihoodField;
import majic.nav.grid.OccupancyGrid;
import majic.nav.localisation.Localizer;
import majic.nav.localisation.PoseEstimate;
import majic.nav.mapping.Mapper;
import majic.nav.mapping.Trajectory;

/**
 * Builds a map from a public log, and finds the robot of its second half on the map of its first. The system property
 * {@code majic.nav} names the folder of {@code intel.clf.gz} and {@code intel.relations}; another name of a log is
 * given by {@code majic.nav.log}.
 */
public final class MappingFigures {
    private static final double NEAREST_S = 0.3;
    private static final double NANOS = 1e9;
    private static final double MM = 1000;
    private static final int STARTS = 20;
    private static final double RIGHT_MM = 500;
    private static final double RIGHT_DEG = 10;

    private final Path folder = Path.of(System.getProperty("majic.nav", "../shared/nav"));
    private final String name = System.getProperty("majic.nav.log", "intel");
    private final List<RangeScan> scans = new ArrayList<>();
    private final Mapper mapper = new Mapper();
    private final List<String> lines = new ArrayList<>();

    private boolean missing() {
        return !Files.exists(log());
    }

    private Path log() {
        return folder.resolve(name + ".clf.gz");
    }

    /** The rows of {@code mapping}. */
    public List<String> mapping() throws IOException {
        if (missing()) {
            return List.of(log() + " is missing; -Dmajic.nav names its folder");
        }
        long begin = nanos();
        Trajectory trajectory = build();
        lines.add(String.format(
                Locale.ROOT,
                "%d scans, %d loops, %.1f s of processor time",
                mapper.scans(),
                mapper.loops(),
                (nanos() - begin) / NANOS));
        TreeMap<Double, Pose> poses = new TreeMap<>();
        trajectory.poses().forEach(at -> poses.putIfAbsent(at.timeS(), at.pose()));
        lines.add(error(poses));
        return lines;
    }

    private static long nanos() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    private Trajectory build() throws IOException {
        Trajectory trajectory = new Trajectory(mapper);
        CarmenLog.read(
                log(),
                new CarmenLog.Listener() {
                    @Override
                    public void odometry(double timeS, Pose pose) {
                        trajectory.add(timeS, pose);
                    }

                    @Override
                    public void scan(RangeScan scan) {
                        scans.add(scan);
                        mapper.add(scan);
                        trajectory.add(scan.timeS(), scan.odometry());
                    }
                },
                share -> {});
        mapper.finish();
        return trajectory;
    }

    /** The error of Kümmerle et al. 2009, "On measuring the accuracy of SLAM algorithms", of single relations. */
    private String error(TreeMap<Double, Pose> poses) throws IOException {
        List<Double> places = new ArrayList<>();
        List<Double> headings = new ArrayList<>();
        for (String line : Files.readAllLines(folder.resolve(name + ".relations"))) {
            String[] fields = line.trim().split("\\s+");
            Pose from = nearest(poses, Double.parseDouble(fields[0]));
            Pose to = nearest(poses, Double.parseDouble(fields[1]));
            if (from != null && to != null) {
                Pose wanted = new Pose(
                        Double.parseDouble(fields[2]) * MM,
                        Double.parseDouble(fields[3]) * MM,
                        Math.toDegrees(Double.parseDouble(fields[7])));
                Pose error = to.seenFrom(from).seenFrom(wanted);
                places.add(error.distanceMm(Pose.START) / MM);
                headings.add(Math.abs(error.headingDeg()));
            }
        }
        return String.format(
                Locale.ROOT,
                "%d relations: translation %s m (at most 0.066 ± 0.080), rotation %s deg",
                places.size(),
                text(places),
                text(headings));
    }

    private static Pose nearest(TreeMap<Double, Pose> poses, double time) {
        var below = poses.floorEntry(time);
        var above = poses.ceilingEntry(time);
        var best = below == null || above != null && above.getKey() - time < time - below.getKey() ? above : below;
        return best == null || Math.abs(best.getKey() - time) > NEAREST_S ? null : best.getValue();
    }

    private static String text(List<Double> values) {
        double mean = values.stream().mapToDouble(value -> value).average().orElse(Double.NaN);
        double variance = values.stream()
                .mapToDouble(value -> (value - mean) * (value - mean))
                .average()
                .orElse(Double.NaN);
        return String.format(Locale.ROOT, "%.4f ± %.4f", mean, Math.sqrt(variance));
    }

    /** The rows of {@code localisation}. */
    public List<String> localisation() throws IOException {
        if (missing()) {
            return List.of(log() + " is missing; -Dmajic.nav names its folder");
        }
        build();
        GridBuilder half = new GridBuilder();
        int middle = mapper.scans() / 2;
        for (int index = 0; index < middle; index++) {
            half.add(mapper.scan(index), mapper.pose(index));
        }
        OccupancyGrid map = half.toGrid();
        Localizer tracking = new Localizer(map, 1);
        tracking.place(mapper.pose(middle), 100, 3);
        int right = 0;
        double worst = 0;
        for (int index = middle; index < mapper.scans(); index++) {
            tracking.add(mapper.scan(index));
            Pose is = tracking.estimate(mapper.scan(index).odometry()).pose();
            double mm = is.distanceMm(mapper.pose(index));
            worst = Math.max(worst, mm);
            right += mm < 100 && Math.abs(turned(is, mapper.pose(index))) < 2 ? 1 : 0;
        }
        lines.add(String.format(
                Locale.ROOT,
                "tracking: within 100 mm and 2 deg for %.1f %% of the scans (at least 95), worst %.0f mm",
                100.0 * right / (mapper.scans() - middle),
                worst));
        int found = 0;
        int wrong = 0;
        List<String> ways = new ArrayList<>();
        List<Integer> known = startsOn(map, middle);
        for (int start = 0; start < STARTS; start++) {
            int from = known.get(start * known.size() / STARTS);
            double way = way(new Localizer(map, start), from);
            wrong += way < 0 ? 1 : 0;
            found += way >= 0 && way <= 20 ? 1 : 0;
            ways.add(Double.isInfinite(way) ? "never" : "" + Math.round(way));
        }
        lines.add("global: right after at most 20 m in " + found + " of " + STARTS + " starts (at least 18), wrong in "
                + wrong + " (none); m until right: " + ways);
        return lines;
    }

    /**
     * The scans whose echoes are nearly all in parts of the map that are known: others are in rooms it does not have.
     */
    private List<Integer> startsOn(OccupancyGrid map, int middle) {
        LikelihoodField field = new LikelihoodField(map);
        List<Integer> starts = new ArrayList<>();
        for (int index = middle; index < mapper.scans() - 60; index++) {
            RangeScan scan = mapper.scan(index);
            int near = 0;
            int echoes = 0;
            for (int beam = 0; beam < scan.size(); beam++) {
                if (Float.isFinite(scan.rangeMm(beam))) {
                    Pose end = mapper.pose(index)
                            .plus(scan.sensor().beams().get(beam).mount())
                            .plus(new Pose(scan.rangeMm(beam), 0, 0));
                    echoes++;
                    near += field.distanceMm(end.xMm(), end.yMm()) < 200 ? 1 : 0;
                }
            }
            if (near > 0.8 * echoes) {
                starts.add(index);
            }
        }
        return starts;
    }

    /** The way until the robot is placed, m; −1 if it is placed wrongly, infinite if it is not placed within 60 m. */
    private double way(Localizer localizer, int from) {
        double way = 0;
        for (int index = from; index < mapper.scans() && way < 60_000; index++) {
            way += index > from ? mapper.pose(index).distanceMm(mapper.pose(index - 1)) : 0;
            localizer.add(mapper.scan(index));
            PoseEstimate is = localizer.estimate(mapper.scan(index).odometry());
            if (is.placed()) {
                boolean right = is.pose().distanceMm(mapper.pose(index)) < RIGHT_MM
                        && Math.abs(turned(is.pose(), mapper.pose(index))) < RIGHT_DEG;
                return right ? way / MM : -1;
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    private static double turned(Pose one, Pose other) {
        return Pose.normalised(one.headingDeg() - other.headingDeg());
    }

    /** Measures alone. */
    public static void main(String[] names) throws IOException {
        MappingFigures figures = new MappingFigures();
        (names[0].equals("mapping") ? figures.mapping() : figures.localisation()).forEach(System.out::println);
    }
}
