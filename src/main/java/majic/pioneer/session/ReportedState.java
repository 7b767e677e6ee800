package majic.pioneer.session;

import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.driver.RobotWait;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.Sip;
import majic.pioneer.state.LatestReports;
import majic.pioneer.state.Model;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.StateTracker;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * The last state that the robot reported in one session, and waiting for later ones. Reports are taken on the line's
 * reader thread; the state is read and awaited from any thread.
 */
public final class ReportedState {
    private final RobotLine line;
    private final RobotWait waiting;
    private volatile StateTracker tracker = new StateTracker(Models.USUAL, Pose.START);
    private volatile @Nullable PioneerState last;

    /**
     * Creates one without a state.
     *
     * @param waiting woken after each report, and when the line ends
     */
    ReportedState(RobotLine line, RobotWait waiting) {
        this.line = line;
        this.waiting = waiting;
    }

    /** Begins to track a robot that has been identified; its reports come afterwards. */
    void begin(Model model, Pose start) {
        tracker = new StateTracker(model, start);
    }

    /** Goes on with the sonars that the robot has. */
    void use(Model fitted) {
        tracker.use(fitted);
    }

    /** Takes a SIP; returns the state that it makes. */
    PioneerState take(Sip sip) {
        PioneerState now = tracker.track(sip, waiting.time().nanos());
        last = now;
        return now;
    }

    /** Takes another report. */
    void take(Report report) {
        LatestReports reports = tracker.add(report);
        PioneerState now = last;
        if (now != null) {
            last = now.with(reports);
        }
    }

    /** The last state; null before the first. */
    @Nullable
    PioneerState last() {
        return last;
    }

    /** Whether the robot has reported a state in this session. */
    public boolean isKnown() {
        return last != null;
    }

    /**
     * The last state.
     *
     * @throws BotException before the first one; a session that has been opened has one
     */
    public PioneerState get() {
        PioneerState now = last;
        if (now == null) {
            throw new BotException("no reading yet");
        }
        return now;
    }

    /**
     * Waits until the reported state meets a condition, or the line ends. A thread that must not wait only tests the
     * last state.
     *
     * @param seconds the longest wait
     * @return whether the last state meets it
     * @throws MotionStopped if the thread is interrupted meanwhile
     */
    public boolean await(Predicate<PioneerState> condition, double seconds) {
        BooleanSupplier met = () -> {
            PioneerState now = last;
            return now != null && condition.test(now);
        };
        waiting.await(() -> line.hasEnded() || met.getAsBoolean(), WaitPolicy.isAllowed() ? seconds : 0);
        return met.getAsBoolean();
    }

    /**
     * Waits for a SIP, newer than the last, that shows the robot stationary.
     *
     * @param seconds the longest wait
     * @return whether one came in time
     * @throws LinkLost if the line ended before: whether the robot is stationary is not known
     * @throws MotionStopped if the thread is interrupted meanwhile
     */
    public boolean awaitStationary(double seconds) {
        PioneerState before = last;
        Sip old = before == null ? null : before.sip();
        boolean stationary = await(now -> now.sip() != old && !now.isMoving(), seconds);
        LinkLost end = line.end();
        if (!stationary && end != null) {
            throw new LinkLost(end.getMessage(), end);
        }
        return stationary;
    }
}
