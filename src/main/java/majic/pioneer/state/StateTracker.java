package majic.pioneer.state;

import majic.bot.Pose;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.Sip;

/** Makes a state of each SIP of one session: adds up odometry, keeps sonar readings, counts packets. For one thread. */
public final class StateTracker {
    /** How much one new interval counts in the packet rate. */
    private static final double RATE_SMOOTHING = 0.1;

    private final Model model;
    private final Odometry odometry;
    private final ObstacleMemory surroundings;
    private SonarScan scan = SonarScan.EMPTY;
    private Reports reports = Reports.NONE;
    private int lastFlags;
    private double periodS;
    private double longestSilenceS;
    private long lastNanos;

    public StateTracker(Model model, Pose start) {
        this.model = model;
        this.odometry = new Odometry(model.scaling(), start);
        this.surroundings = new ObstacleMemory(model);
    }

    public PioneerState track(Sip sip, long nanos) {
        odometry.add(sip);
        Pose pose = odometry.pose();
        forgetSwitchedOff(sip.flags());
        scan = scan.with(sip.sonar(), model.scaling().mmPerRangeCount(), nanos);
        surroundings.hear(scan, sip.sonar(), pose, nanos);
        time(nanos);
        return new PioneerState(
                sip,
                reports,
                pose,
                odometry.turnedDeg(),
                model.scaling().speedMmPerSec(sip),
                model.scaling().turnRateDegPerSec(sip),
                scan,
                surroundings.gaps(scan, pose, nanos),
                periodS > 0 ? 1 / periodS : 0,
                longestSilenceS,
                nanos);
    }

    /** A guard must not go on by what an array heard before it was switched off; firmware without these flags is not asked. */
    private void forgetSwitchedOff(int flags) {
        int switchedOff = lastFlags & ~flags;
        for (int array = 1; array <= Equipment.SONAR_ARRAYS; array++) {
            if ((switchedOff & 1 << array) != 0) {
                scan = scan.without((array - 1) * Equipment.DISCS_OF_AN_ARRAY, Equipment.DISCS_OF_AN_ARRAY);
            }
        }
        lastFlags = flags;
    }

    /** Keeps what came beside the SIPs, for this state and all later ones. */
    public Reports keep(Report report) {
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
