package majic.pioneer.state;

import majic.bot.Pose;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipField;
import org.jspecify.annotations.Nullable;

/**
 * Makes a state of each report of one session: adds up the odometry, keeps sonar readings and other reports, measures
 * the SIP rate. The counters of the odometry roll over; their differences do not (ARCOS sheet 9.2). For one thread,
 * except {@link #last}.
 */
public final class StateTracker {
    /** The weight of a new interval in the SIP rate. */
    private static final double RATE_SMOOTHING = 0.1;

    /** The low bits of x and y that count; the top one is unreliable. */
    private static final int COUNTER = 0x8000;

    /** More counts than any robot covers between two SIPs: the controller has reset its odometry. */
    private static final int LONGEST_STEP = 0x1000;

    private final Scaling scaling;
    private SonarScan sonar;
    private LatestReports reports = LatestReports.NONE;
    private volatile @Nullable PioneerState last;
    private double xMm;
    private double yMm;
    private double headingDeg;

    /** From the robot's own frame, which its controller may reset, to that of the pose. */
    private double rotationDeg;

    private double periodS;
    private double longestSilenceS;
    private long lastNanos;

    /**
     * Creates a tracker before the first SIP.
     *
     * @param start the pose at the first SIP
     */
    public StateTracker(Model model, Pose start) {
        this.scaling = model.scaling();
        this.sonar = new SonarScan(model);
        this.xMm = start.xMm();
        this.yMm = start.yMm();
        this.headingDeg = start.headingDeg();
    }

    /** Goes on with the model with other sonars; the obstacles detected by those before are dropped. */
    public void use(Model newModel) {
        sonar = sonar.of(newModel);
    }

    /**
     * Adds a SIP.
     *
     * @param nanos when it came, on the driver's clock
     */
    public PioneerState track(Sip sip, long nanos) {
        PioneerState before = last;
        if (before == null) {
            beginFrame(sip);
        } else {
            move(before.sip(), sip);
            forgetSwitchedOff(before.sip().get(SipField.FLAGS) & ~sip.get(SipField.FLAGS));
        }
        Pose pose = new Pose(xMm, yMm, headingDeg);
        sonar = sonar.with(sip, pose, nanos);
        measure(nanos);
        PioneerState now = new PioneerState(
                sip,
                reports,
                pose,
                headingDeg,
                scaling.speedMmPerSec(sip),
                scaling.turnRateDegPerSec(sip),
                sonar,
                periodS > 0 ? 1 / periodS : 0,
                longestSilenceS,
                nanos);
        last = now;
        return now;
    }

    private void beginFrame(Sip sip) {
        rotationDeg = headingDeg - sip.get(SipField.TH_POS) * scaling.degPerCount();
    }

    private void move(Sip before, Sip now) {
        int dx = difference(before, now, SipField.X_POS, COUNTER);
        int dy = difference(before, now, SipField.Y_POS, COUNTER);
        if (Math.abs(dx) > LONGEST_STEP || Math.abs(dy) > LONGEST_STEP) {
            beginFrame(now);
            return;
        }
        double cos = Math.cos(Math.toRadians(rotationDeg));
        double sin = Math.sin(Math.toRadians(rotationDeg));
        xMm += (dx * cos - dy * sin) * scaling.mmPerCount();
        yMm += (dx * sin + dy * cos) * scaling.mmPerCount();
        headingDeg += difference(before, now, SipField.TH_POS, scaling.countsPerTurn()) * scaling.degPerCount();
    }

    /** The shorter way from one reading of a counter to the next. */
    private static int difference(Sip before, Sip now, SipField counter, int modulus) {
        int ahead = Math.floorMod(now.get(counter) - before.get(counter), modulus);
        return ahead < modulus / 2 ? ahead : ahead - modulus;
    }

    /**
     * Drops the readings of an array that was switched off, which a guard condition must not use; no effect on firmware
     * without these flags.
     */
    private void forgetSwitchedOff(int flags) {
        for (int array = 1; flags != 0 && array <= Equipment.SONAR_ARRAYS; array++) {
            if ((flags & 1 << array) != 0) {
                sonar = sonar.without((array - 1) * Equipment.DISCS_OF_AN_ARRAY, Equipment.DISCS_OF_AN_ARRAY);
            }
        }
    }

    private void measure(long nanos) {
        if (lastNanos != 0) {
            double interval = (nanos - lastNanos) / 1e9;
            longestSilenceS = Math.max(longestSilenceS, interval);
            periodS = periodS == 0 ? interval : periodS + RATE_SMOOTHING * (interval - periodS);
        }
        lastNanos = nanos;
    }

    /** Adds another report, to the last state and all later ones. */
    public void add(Report report) {
        reports = reports.with(report);
        PioneerState now = last;
        if (now != null) {
            last = now.with(reports);
        }
    }

    /** The last state, from any thread; null before the first SIP. */
    public @Nullable PioneerState last() {
        return last;
    }
}
