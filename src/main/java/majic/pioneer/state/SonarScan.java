package majic.pioneer.state;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import majic.bot.Pose;
import majic.pioneer.arcos.Sip;
import org.jspecify.annotations.Nullable;

/**
 * What the sonars have measured by one SIP: the last range of every disc, the recent echoes as points in the frame of
 * the odometry, and their distances from the hull. Points and distances are computed when they are read first, because
 * those of most SIPs are never read. Immutable.
 *
 * <p>A disc fires only every third of a second, gets no echo of walls at more than about 30° from square, and loses an
 * echo now and then. So every echo is kept for {@value #MEMORY_S} s at its place on the floor, and every point counts
 * on each side, whichever disc detected it. In return an obstacle that was removed is reported for that long.
 */
public final class SonarScan {
    /** As many discs as the protocol can number. */
    static final int DISCS = 32;

    /** The range that a disc reports without an echo, mm. */
    public static final int NOTHING_MM = 5000;

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

    private final Model model;

    /** As sent. */
    private final int[] ranges;

    private final long[] atNanos;
    private final Sighting[] recent;
    private final Pose pose;
    private final long nanos;
    private volatile @Nullable Map<Side, Double> gaps;

    /** The readings of one SIP and where they were taken. Its points are computed once. */
    private static final class Sighting {
        final Sip sip;
        final Pose from;
        final long nanos;
        volatile double @Nullable [] points;

        Sighting(Sip sip, Pose from, long nanos) {
            this.sip = sip;
            this.from = from;
            this.nanos = nanos;
        }
    }

    /** Creates one without readings. */
    SonarScan(Model model) {
        this(model, new int[DISCS], new long[DISCS], new Sighting[0], Pose.START, 0);
    }

    private SonarScan(Model model, int[] ranges, long[] atNanos, Sighting[] recent, Pose pose, long nanos) {
        this.model = model;
        this.ranges = ranges;
        this.atNanos = atNanos;
        this.recent = recent;
        this.pose = pose;
        this.nanos = nanos;
    }

    /** This scan for a model with other sonars; drops the echoes of those before. */
    SonarScan of(Model newModel) {
        return newModel.equals(model) ? this : new SonarScan(newModel, ranges, atNanos, new Sighting[0], pose, nanos);
    }

    /**
     * The scan at the next SIP; readings of discs beyond the last one are dropped.
     *
     * @param now where it was taken
     * @param nowNanos when it came, on the driver's clock
     */
    SonarScan with(Sip sip, Pose now, long nowNanos) {
        int[] newest = ranges;
        long[] times = atNanos;
        int count = sip.readings();
        if (count > 0) {
            newest = ranges.clone();
            times = atNanos.clone();
        }
        for (int index = 0; index < count; index++) {
            int disc = sip.disc(index);
            if (disc < DISCS) {
                newest[disc] = sip.range(index);
                times[disc] = nowNanos == 0 ? 1 : nowNanos;
            }
        }
        return new SonarScan(model, newest, times, sightings(sip, now, nowNanos), now, nowNanos);
    }

    private Sighting[] sightings(Sip sip, Pose now, long nowNanos) {
        int outdated = 0;
        while (outdated < recent.length && (nowNanos - recent[outdated].nanos) / 1e9 > MEMORY_S) {
            outdated++;
        }
        Sighting[] all = new Sighting[recent.length - outdated + 1];
        System.arraycopy(recent, outdated, all, 0, all.length - 1);
        all[all.length - 1] = new Sighting(sip, now, nowNanos);
        return all;
    }

    /** This scan without the readings of some discs. */
    SonarScan without(int firstDisc, int discs) {
        long[] times = atNanos.clone();
        Arrays.fill(times, firstDisc, firstDisc + discs, 0);
        return new SonarScan(model, ranges, times, recent, pose, nanos);
    }

    public boolean hasReading(int disc) {
        return atNanos[disc] != 0;
    }

    /** mm from the disc's surface; {@link #NOTHING_MM} or more without an echo. */
    public int rangeMm(int disc) {
        return mm(ranges[disc]);
    }

    private int mm(int range) {
        return (int) Math.round(range * model.scaling().mmPerRangeCount());
    }

    /** When the disc last fired, on the driver's clock. */
    public long atNanos(int disc) {
        return atNanos[disc];
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
        for (Side side : SIDES) {
            if (isKnown(model.discs().stream().filter(side::isCoveredBy).toList())) {
                known.put(side, nearest[side.ordinal()]);
            }
        }
        return Map.copyOf(known);
    }

    private boolean isKnown(List<SonarDisc> covering) {
        return !covering.isEmpty()
                && covering.stream()
                        .allMatch(disc ->
                                hasReading(disc.number()) && (nanos - atNanos(disc.number())) / 1e9 <= DISC_SILENCE_S);
    }

    /** The distances of all sides, by ordinal number; each point is converted to the robot's frame once. */
    private double[] nearest() {
        double cos = Math.cos(Math.toRadians(pose.headingDeg()));
        double sin = Math.sin(Math.toRadians(pose.headingDeg()));
        double[] nearest = new double[SIDES.length];
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
        for (Sighting sighting : recent) {
            double[] points = points(sighting);
            for (int index = 0; index < points.length; index += 2) {
                double dx = points[index] - pose.xMm();
                double dy = points[index + 1] - pose.yMm();
                double x = dx * cos + dy * sin;
                double y = dy * cos - dx * sin;
                for (int side = 0; side < SIDES.length; side++) {
                    nearest[side] = Math.min(nearest[side], SIDES[side].gapMm(model.hull(), x, y, MARGIN_MM));
                }
            }
        }
        return nearest;
    }

    /** x and y of each echo in turn, mm, in the frame of the odometry. */
    private double[] points(Sighting sighting) {
        double[] known = sighting.points;
        if (known == null) {
            known = computed(sighting.sip, sighting.from);
            sighting.points = known;
        }
        return known;
    }

    private double[] computed(Sip sip, Pose from) {
        double cos = Math.cos(Math.toRadians(from.headingDeg()));
        double sin = Math.sin(Math.toRadians(from.headingDeg()));
        double[] points = new double[2 * sip.readings()];
        int count = 0;
        for (int index = 0; index < sip.readings(); index++) {
            SonarDisc disc = disc(sip.disc(index));
            int range = mm(sip.range(index));
            if (disc != null && range < NOTHING_MM) {
                double x = disc.echoX(range);
                double y = disc.echoY(range);
                points[count++] = from.xMm() + x * cos - y * sin;
                points[count++] = from.yMm() + x * sin + y * cos;
            }
        }
        return Arrays.copyOf(points, count);
    }

    private @Nullable SonarDisc disc(int number) {
        for (SonarDisc disc : model.discs()) {
            if (disc.number() == number) {
                return disc;
            }
        }
        return null;
    }
}
