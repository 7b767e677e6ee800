package majic.pioneer.state;

import java.util.Optional;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.pioneer.arcos.LaserChunk;
import org.jspecify.annotations.Nullable;

/**
 * Puts the packets of a simulator's laser together to scans. For one thread.
 *
 * <p>A packet tells neither where the laser is nor which way it looks: its place is that of the maker's parameter
 * files, and its field is the half circle ahead, from the right to the left (ARCOS sheet 6.2, 11.8).
 */
public final class LaserScans {
    /** From straight ahead to either end of the field, deg. */
    public static final int HALF_FIELD_DEG = 90;

    /** What simulators report if nothing was hit, mm. */
    private static final double REACH_MM = 32_000;

    private static final double NOISE_MM = 10;

    /** LaserX of the parameter files, mm. */
    private static final double AHEAD_MM = 21;

    private static final double AHEAD_ON_LONG_DECKS_MM = 125;

    private final Pose mount;
    private @Nullable RangeSensor sensor;
    private @Nullable Begun begun;

    /** The readings of a scan so far, and the state of the robot at its first packet. */
    private static final class Begun {
        final int laser;
        final PioneerState state;
        final float[] rangesMm;
        int next;

        Begun(LaserChunk chunk, PioneerState state) {
            this.laser = chunk.laser();
            this.state = state;
            this.rangesMm = new float[chunk.total()];
        }

        boolean continuesWith(LaserChunk chunk) {
            return chunk.first() == next && chunk.total() == rangesMm.length && chunk.laser() == laser;
        }

        void add(LaserChunk chunk) {
            for (int index = chunk.first(); index < chunk.end(); index++) {
                rangesMm[index] = chunk.rangeMm(index);
            }
            next = chunk.end();
        }
    }

    /** Creates one without packets. */
    public LaserScans(Model model) {
        double ahead = model.subclass().startsWith("p3at") ? AHEAD_ON_LONG_DECKS_MM : AHEAD_MM;
        this.mount = new Pose(ahead, 0, 0);
    }

    /**
     * Adds a packet. One that does not follow the last one ends the scan without a result.
     *
     * @param state the last that the robot reported: a scan has the odometry and the time of the one before it
     * @return the scan that the packet completes
     */
    public Optional<RangeScan> add(LaserChunk chunk, PioneerState state) {
        if (chunk.first() == 0) {
            begun = new Begun(chunk, state);
        }
        Begun scan = begun;
        if (scan == null || !scan.continuesWith(chunk)) {
            begun = null;
            return Optional.empty();
        }
        scan.add(chunk);
        if (scan.next < scan.rangesMm.length) {
            return Optional.empty();
        }
        begun = null;
        return Optional.of(new RangeScan(
                sensor(scan.rangesMm.length), scan.state.atNanos() / 1e9, scan.state.pose(), scan.rangesMm));
    }

    /** The sensor of scans with as many readings, equally far apart over the field; the same one for all of them. */
    private RangeSensor sensor(int readings) {
        RangeSensor known = sensor;
        if (known == null || known.beams().size() != readings) {
            double stepDeg = 2.0 * HALF_FIELD_DEG / Math.max(1, readings - 1);
            known = RangeSensor.laser(mount, readings, -HALF_FIELD_DEG, stepDeg, REACH_MM, NOISE_MM);
            sensor = known;
        }
        return known;
    }
}
