package majic.pioneer.state;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import majic.bot.Pose;
import majic.pioneer.arcos.SonarReadings;
import org.jspecify.annotations.Nullable;

/**
 * The recent echoes of the sonars at one SIP, as points in the frame of the odometry, and their distances from the
 * hull. The distances are computed when they are read first, because those of most SIPs are never read. Immutable.
 *
 * <p>A disc fires only every third of a second, gets no echo of walls at more than about 30° from square, and loses an
 * echo now and then. So every echo is kept for {@value #MEMORY_S} s at its place on the floor, and every point counts
 * on each side, whichever disc detected it. In return an obstacle that was removed is reported for that long.
 */
final class ObstacleMemory {
    /** How long an echo is kept, seconds: four firings of a disc. */
    static final double MEMORY_S = 1.5;

    /** A disc without a reading for so long counts as off, seconds. */
    private static final double DISC_SILENCE_S = MEMORY_S;

    /**
     * Added to the path for the width of the cones: a wall detected at the edge of a cone seems farther aside than it
     * is.
     */
    private static final double MARGIN_MM = 40;

    private static final Side[] SIDES = Side.values();

    private final Hull hull;
    private final SonarDisc[] discs;
    private final Map<Side, List<SonarDisc>> covering;
    private final Echo[] echoes;
    private final SonarScan scan;
    private final Pose pose;
    private final long atNanos;
    private volatile @Nullable Map<Side, Double> gaps;

    /** A point of an obstacle, in the frame of the odometry. */
    private record Echo(double xMm, double yMm, long atNanos) {}

    /** Creates one without echoes. */
    ObstacleMemory(Model model) {
        this.hull = model.hull();
        this.discs = model.discs().toArray(new SonarDisc[0]);
        this.covering = new EnumMap<>(Side.class);
        for (Side side : SIDES) {
            covering.put(side, model.discs().stream().filter(side::isCoveredBy).toList());
        }
        this.echoes = new Echo[0];
        this.scan = SonarScan.EMPTY;
        this.pose = Pose.START;
        this.atNanos = 0;
    }

    private ObstacleMemory(ObstacleMemory before, Echo[] echoes, SonarScan scan, Pose pose, long atNanos) {
        this.hull = before.hull;
        this.discs = before.discs;
        this.covering = before.covering;
        this.echoes = echoes;
        this.scan = scan;
        this.pose = pose;
        this.atNanos = atNanos;
    }

    /**
     * The memory at the next SIP.
     *
     * @param newScan the last range of every disc, the new ones included
     * @param readings which ranges are new
     * @param newPose where they were taken
     * @param nanos when they came, on the driver's clock
     */
    ObstacleMemory with(SonarScan newScan, SonarReadings readings, Pose newPose, long nanos) {
        int outdated = 0;
        while (outdated < echoes.length && (nanos - echoes[outdated].atNanos()) / 1e9 > MEMORY_S) {
            outdated++;
        }
        Echo[] added = echoes(newScan, readings, newPose, nanos);
        int kept = echoes.length - outdated;
        Echo[] all = new Echo[kept + added.length];
        System.arraycopy(echoes, outdated, all, 0, kept);
        System.arraycopy(added, 0, all, kept, added.length);
        return new ObstacleMemory(this, all, newScan, newPose, nanos);
    }

    private Echo[] echoes(SonarScan newScan, SonarReadings readings, Pose from, long nanos) {
        double cos = Math.cos(Math.toRadians(from.headingDeg()));
        double sin = Math.sin(Math.toRadians(from.headingDeg()));
        Echo[] found = new Echo[readings.count()];
        int count = 0;
        for (int index = 0; index < found.length; index++) {
            SonarDisc disc = disc(readings.disc(index));
            int range = disc == null ? SonarScan.NOTHING_MM : newScan.rangeMm(disc.number());
            if (disc != null && range < SonarScan.NOTHING_MM) {
                double x = disc.echoX(range);
                double y = disc.echoY(range);
                found[count++] = new Echo(from.xMm() + x * cos - y * sin, from.yMm() + x * sin + y * cos, nanos);
            }
        }
        return first(count, found);
    }

    /** As {@link Arrays#copyOf}, which in code without later optimization takes as long as decoding a report. */
    private static Echo[] first(int count, Echo[] found) {
        Echo[] first = new Echo[count];
        System.arraycopy(found, 0, first, 0, count);
        return first;
    }

    private @Nullable SonarDisc disc(int number) {
        for (SonarDisc disc : discs) {
            if (disc.number() == number) {
                return disc;
            }
        }
        return null;
    }

    /**
     * The distance from the hull to the nearest obstacle, mm, on every side whose discs have all had a recent reading.
     */
    Map<Side, Double> gaps() {
        Map<Side, Double> known = gaps;
        if (known == null) {
            known = knownGaps();
            gaps = known;
        }
        return known;
    }

    private Map<Side, Double> knownGaps() {
        double[] nearest = nearest();
        Map<Side, Double> known = new EnumMap<>(Side.class);
        covering.forEach((side, discs) -> {
            if (isKnown(discs)) {
                known.put(side, nearest[side.ordinal()]);
            }
        });
        return Map.copyOf(known);
    }

    private boolean isKnown(List<SonarDisc> discs) {
        for (SonarDisc disc : discs) {
            if (!scan.hasReading(disc.number()) || (atNanos - scan.atNanos(disc.number())) / 1e9 > DISC_SILENCE_S) {
                return false;
            }
        }
        return !discs.isEmpty();
    }

    /** The distances of all sides, by ordinal number; each echo is converted to the robot's frame once. */
    private double[] nearest() {
        double cos = Math.cos(Math.toRadians(pose.headingDeg()));
        double sin = Math.sin(Math.toRadians(pose.headingDeg()));
        double[] nearest = new double[SIDES.length];
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
        for (Echo echo : echoes) {
            double dx = echo.xMm() - pose.xMm();
            double dy = echo.yMm() - pose.yMm();
            double x = dx * cos + dy * sin;
            double y = dy * cos - dx * sin;
            for (int side = 0; side < SIDES.length; side++) {
                nearest[side] = Math.min(nearest[side], SIDES[side].gapMm(hull, x, y, MARGIN_MM));
            }
        }
        return nearest;
    }
}
