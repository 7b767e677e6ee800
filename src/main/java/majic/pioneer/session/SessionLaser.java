package majic.pioneer.session;

import java.util.Optional;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.driver.LastTimes;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.ConfigField;
import majic.pioneer.state.LaserScans;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Keeps the newest scan of a laser, and requests the scans of the one that a simulated robot may have (ARCOS sheet 6.2,
 * 11.8). For one session.
 *
 * <p>No packet tells whether a simulator has a laser. So scans are requested from each simulator at connecting, until
 * the first one has come, and then only while something needs them. A library sends them without a request.
 */
public final class SessionLaser {
    /** The serial number of simulators (ARCOS sheet 10). */
    private static final String SIMULATOR = "SIM";

    private static final int STEP_HUNDREDTHS_DEG = 100;
    private static final int OFF = 0;

    /** Packets of type 0x60, which are the shortest. */
    private static final int ON = 1;

    /** A simulator that has a laser sends a scan within this time from the request, seconds. */
    private static final double FIRST_SCAN_S = 0.5;

    /** A request without a scan for so long is repeated, or taken back if nothing needs scans, seconds. */
    private static final double REPEAT_S = 1;

    /** After so many requests without a scan the simulator is taken to have no laser. */
    private static final int TRIES = 5;

    /** An older scan is not read as a new one: several cycles of the robot, seconds. */
    private static final double FRESH_S = 0.5;

    /** A scan counts as being read for so long after a reading, seconds. */
    private static final double READ_S = 5;

    private final RobotLine line;
    private final LastTimes<Event> last;
    private volatile boolean possible;
    private volatile boolean streaming;
    private volatile int unanswered;
    private volatile @Nullable RangeScan newest;

    private enum Event {
        BEGUN,
        REQUESTED,
        RECEIVED,
        READ
    }

    SessionLaser(RobotLine line, TimeSource time) {
        this.line = line;
        this.last = new LastTimes<>(time);
    }

    /** Requests the first scan from a simulator; to be called once, after CONFIG. */
    void begin(@Nullable Config config) {
        possible = config != null && config.text(ConfigField.SERNUM).equals(SIMULATOR) && line.carriesScans();
        if (possible) {
            last.record(Event.BEGUN);
            request();
        }
    }

    private void request() {
        last.record(Event.REQUESTED);
        unanswered++;
        streaming = true;
        line.send(
                ArcosCommand.SIM_LRF_SET_FOV_START.packet(-LaserScans.HALF_FIELD_DEG),
                ArcosCommand.SIM_LRF_SET_FOV_END.packet(LaserScans.HALF_FIELD_DEG),
                ArcosCommand.SIM_LRF_SET_RES.packet(STEP_HUNDREDTHS_DEG),
                ArcosCommand.SIM_LRF_ENABLE.packet(ON));
    }

    /**
     * Begins, repeats or ends the request as it is due; to be called twice a second or more often, by one thread.
     *
     * @param needed whether something asks for scans
     */
    void requestDue(boolean needed) {
        boolean unansweredLong =
                last.secondsSince(Event.REQUESTED) >= REPEAT_S && last.secondsSince(Event.RECEIVED) >= REPEAT_S;
        if (needed || last.secondsSince(Event.READ) < READ_S) {
            if (possible && unanswered < TRIES && (!streaming || unansweredLong)) {
                request();
            }
        } else if (streaming && (isThere() || unansweredLong)) {
            streaming = false;
            line.send(ArcosCommand.SIM_LRF_ENABLE.packet(OFF));
        }
    }

    /** Notes a scan. */
    void received(RangeScan scan) {
        unanswered = 0;
        newest = scan;
        last.record(Event.RECEIVED);
    }

    /** How long the first scan of a simulator may still take, seconds; 0 or less if it came, or will not come. */
    double undecidedS() {
        return possible && !isThere() ? FIRST_SCAN_S - last.secondsSince(Event.BEGUN) : 0;
    }

    /** Whether the robot has sent a scan. */
    public boolean isThere() {
        return newest != null;
    }

    /** The sensor; empty before the first scan. */
    Optional<RangeSensor> sensor() {
        return Optional.ofNullable(newest).map(RangeScan::sensor);
    }

    /** Notes that scans are being read, unless the thread only observes; to be called with each reading. */
    public void read() {
        if (!WaitPolicy.isObserving()) {
            last.record(Event.READ);
        }
    }

    /** The newest scan; empty if none came in the last half second. */
    public Optional<RangeScan> fresh() {
        return last.secondsSince(Event.RECEIVED) < FRESH_S ? Optional.ofNullable(newest) : Optional.empty();
    }
}
