package majic.aibo.session;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.aibo.urbi.AiboConnections;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRequest;
import majic.aibo.urbi.UrbiValue;
import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/**
 * The guard that runs on the dog itself (URBI sheet 19): it ends a walk that was not renewed for {@value #PATIENCE_MS}
 * ms. It runs on the motion connection and is renewed on the sensor connection; each renewal contains the time of the
 * dog's clock at which it was sent, and one that arrives late renews nothing. While no motion of this driver runs, the
 * guard is disarmed, so that it ends no walk of another program.
 */
public final class DogGuard {
    private static final Logger LOG = System.getLogger(DogGuard.class.getName());
    private static final int PATIENCE_MS = 1500;

    /**
     * With replies up to 2 s late, the estimate of the dog's clock is off by up to 1 s; renewals must fit into the
     * remaining 0.5 s.
     */
    private static final double RENEWAL_S = 0.2;

    private static final String FAR_AHEAD = "1000000000000";
    private static final double ANSWER_S = 4;

    private final AiboConnections connections;
    private final Tags tags;
    private final RobotWait waiting;
    private final DogClock clock;
    private final String alive;
    private final String tag;
    private volatile boolean installed;
    private volatile double stampAheadMs;
    private boolean armed;
    private long renewedNanos;

    DogGuard(AiboConnections connections, Tags tags, RobotWait waiting, DogClock clock) {
        this.connections = connections;
        this.tags = tags;
        this.waiting = waiting;
        this.clock = clock;
        this.alive = tags.sharedVariable("alive");
        this.tag = tags.named("guard");
    }

    /** Sets the guard up, disarmed; returns whether the server accepts it. Moves nothing. */
    boolean install() {
        UrbiConnection motion = connections.motion();
        long askedNanos = waiting.time().nanos();
        UrbiRequest time = motion.ask(tags, "time()");
        UrbiRequest guard = new UrbiRequest(tag, UrbiRequest.Expects.END);
        motion.send(
                guard,
                alive + " = " + FAR_AHEAD + "; " + tag + ": every(200) { if (time() - " + alive + " > " + PATIENCE_MS
                        + ") { stop walk & stop turn } },");
        UrbiRequest pong = motion.ping(tags);
        waiting.awaitConnecting(() -> pong.isDone() || motion.isEnded(), ANSWER_S);
        motion.forget(guard);
        if (guard.failure() == null && time.value() instanceof UrbiValue.Num serverMs) {
            stampAheadMs = time.doneMs() - serverMs.amount();
            clock.answered(time.doneMs(), askedNanos);
            installed = true;
        } else {
            LOG.log(Level.INFO, "the dog takes no guard: {0}", guard.failure());
        }
        return installed;
    }

    /**
     * Arms it, or renews it: to be sent before anything walks. It then stays armed for as long as one renewal holds.
     */
    public synchronized void renew() {
        if (installed) {
            armed = true;
            renewedNanos = waiting.time().nanos();
            connections.sensors().send(alive + " = " + Math.round(clock.estimateMs() - stampAheadMs) + ",");
        }
    }

    /**
     * Renews it in time while the dog walks; disarms it once it does not, unless a walk is just about to begin. A walk
     * that is being stopped is neither renewed nor disarmed: the guard ends it if the stop does not.
     */
    synchronized void tick(@Nullable RunningMotion running) {
        boolean due = waiting.time().secondsSince(renewedNanos) >= RENEWAL_S;
        if (running != null && running.mayWalk()) {
            if (!running.isStopRequested() && (due || !armed)) {
                renew();
            }
        } else if (armed && due) {
            armed = false;
            connections.sensors().send(alive + " = " + FAR_AHEAD + ",");
        }
    }

    /** What removes it. */
    String stop() {
        return "stop " + tag + ",";
    }
}
