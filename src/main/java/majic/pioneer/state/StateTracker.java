package majic.pioneer.state;

import majic.bot.Pose;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.Sip;

/**
 * Makes a state of each SIP of one session: adds up odometry, keeps sonar readings, measures the SIP rate. For one
 * thread.
 */
public final class StateTracker {
    /** The weight of a new interval in the SIP rate. */
    private static final double RATE_SMOOTHING = 0.1;

    private Model model;
    private final Odometry odometry;
    private ObstacleMemory obstacles;
    private SonarScan scan = SonarScan.EMPTY;
    private LatestReports reports = LatestReports.NONE;
    private int lastFlags;
    private double periodS;
    private double longestSilenceS;
    private long lastNanos;

    public StateTracker(Model model, Pose start) {
        this.model = model;
        this.odometry = new Odometry(model.scaling(), start);
        this.obstacles = new ObstacleMemory(model);
    }

    /** Goes on with the model with other sonars; the obstacles detected by those before are dropped. */
    public void use(Model newModel) {
        if (!newModel.equals(model)) {
            model = newModel;
            obstacles = new ObstacleMemory(newModel);
        }
    }

    public PioneerState track(Sip sip, long nanos) {
        odometry.add(sip);
        Pose pose = odometry.pose();
        forgetSwitchedOff(sip.flags());
        scan = scan.with(sip.sonar(), model.scaling().mmPerRangeCount(), nanos);
        obstacles = obstacles.with(scan, sip.sonar(), pose, nanos);
        time(nanos);
        return new PioneerState(
                sip,
                reports,
                pose,
                odometry.turnedDeg(),
                model.scaling().speedMmPerSec(sip),
                model.scaling().turnRateDegPerSec(sip),
                scan,
                obstacles,
                periodS > 0 ? 1 / periodS : 0,
                longestSilenceS,
                nanos);
    }

    /**
     * Drops the readings of an array that was switched off, which a guard condition must not use; no effect on firmware
     * without these flags.
     */
    private void forgetSwitchedOff(int flags) {
        int switchedOff = lastFlags & ~flags;
        for (int array = 1; array <= Equipment.SONAR_ARRAYS; array++) {
            if ((switchedOff & 1 << array) != 0) {
                scan = scan.without((array - 1) * Equipment.DISCS_OF_AN_ARRAY, Equipment.DISCS_OF_AN_ARRAY);
            }
        }
        lastFlags = flags;
    }

    /** Adds a report, for this state and all later ones. */
    public LatestReports add(Report report) {
        reports = reports.with(report);
        return reports;
    }

    private void time(long nanos) {
        if (lastNanos != 0) {
            double interval = (nanos - lastNanos) / 1e9;
            longestSilenceS = Math.max(longestSilenceS, interval);
            periodS = periodS == 0 ? interval : periodS + RATE_SMOOTHING * (interval - periodS);
        }
        lastNanos = nanos;
    }
}
