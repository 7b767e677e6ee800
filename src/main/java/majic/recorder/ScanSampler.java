package majic.recorder;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.ScanListener;
import org.jspecify.annotations.Nullable;

/**
 * Asks one robot with laser scanners for its scans while it drives, and adds those to a recording that were measured in
 * another place than the one before. Samples are taken by one thread; {@link #end} is thread-safe.
 */
final class ScanSampler implements ScanListener {
    /** A scan is recorded if the robot has moved as far, or turned as far, since the last one. */
    private static final double LEAST_MM = 100;

    private static final double LEAST_DEG = 5;

    /** The most scans of a sensor in a second, and the most ranges. */
    private static final double MOST_SCANS_PER_S = 5;

    private static final double MOST_RANGES_PER_S = 2000;

    /** A robot that has not moved as far for as long is stationary, and is no longer asked. */
    private static final double STATIONARY_MM = 10;

    private static final double STATIONARY_DEG = 1;
    private static final double STATIONARY_S = 5;

    /** A scan that is older was measured before the connection was lost. */
    private static final double MOST_AGE_S = 1;

    private final int robot;
    private final MajicBot bot;
    private final Map<String, RangeScan> newest = new ConcurrentHashMap<>();
    private final Map<String, Recorded> recorded = new HashMap<>();
    private @Nullable Pose place;
    private double movedS;
    private boolean asking;
    private boolean ended;

    /** A scan that was recorded, and when. */
    private record Recorded(RangeScan scan, double seconds) {
        boolean isFollowedBy(RangeScan next, double nowS) {
            double period = Math.max(1 / MOST_SCANS_PER_S, next.size() / MOST_RANGES_PER_S);
            return nowS - seconds >= period && isApart(scan.odometry(), next.odometry(), LEAST_MM, LEAST_DEG);
        }
    }

    ScanSampler(int robot, MajicBot bot) {
        this.robot = robot;
        this.bot = bot;
    }

    /** Describes the sensors anew the next time. */
    void forget() {
        recorded.clear();
    }

    @Override
    public void scanned(RangeScan scan) {
        if (scan.sensor().isLaser()) {
            newest.put(scan.sensor().name(), scan);
        }
    }

    /** Adds a line for the newest scan of each sensor if it is due. */
    void sample(StringBuilder lines, double nowS) {
        askWhileItDrives(nowS);
        for (String sensor : newest.keySet()) {
            RangeScan scan = newest.remove(sensor);
            double ageS = bot.time().nanos() / 1e9 - scan.timeS();
            if (bot.isConnected() && ageS <= MOST_AGE_S) {
                sample(lines, scan, Math.max(0, nowS - ageS), nowS);
            }
        }
    }

    private void sample(StringBuilder lines, RangeScan scan, double measuredS, double nowS) {
        String sensor = scan.sensor().name();
        Recorded last = recorded.get(sensor);
        if (last != null && !last.isFollowedBy(scan, nowS)) {
            return;
        }
        if (last == null || !last.scan.sensor().equals(scan.sensor())) {
            lines.append(ScanText.sensor(robot, scan.sensor()));
        }
        lines.append(ScanText.scan(robot, scan, measuredS));
        recorded.put(sensor, new Recorded(scan, nowS));
    }

    /** A stationary robot is not asked, so that its scans cost nothing. */
    private synchronized void askWhileItDrives(double nowS) {
        BotState state = bot.state();
        if (state.moving() || place == null || isApart(place, state.pose(), STATIONARY_MM, STATIONARY_DEG)) {
            place = state.pose();
            movedS = nowS;
        }
        boolean drives = !ended && bot.isConnected() && nowS - movedS < STATIONARY_S;
        if (asking && !drives) {
            bot.removeScanListener(this);
            asking = false;
        } else if (!asking && drives && bot.rangeSensors().stream().anyMatch(RangeSensor::isLaser)) {
            bot.addScanListener(this);
            asking = true;
        }
    }

    /** Asks the robot no longer. */
    synchronized void end() {
        ended = true;
        bot.removeScanListener(this);
        asking = false;
    }

    private static boolean isApart(Pose one, Pose other, double mm, double deg) {
        return one.distanceMm(other) >= mm || Math.abs(Pose.normalised(one.headingDeg() - other.headingDeg())) >= deg;
    }
}
