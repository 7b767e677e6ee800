package majic.aibo;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;

/**
 * The guard that runs on the dog itself (URBI sheet 19): it ends a walk when the program that ordered it has not been
 * heard for {@value #PATIENCE_MS} ms. It lives on the motion connection and is renewed on the sensor connection, with
 * the last time the dog's own clock was heard: a renewal that arrives late says so and renews nothing. While nothing of
 * ours walks it is disarmed, so that it ends nobody else's walk.
 */
final class DogGuard {
    private static final Logger LOG = System.getLogger(DogGuard.class.getName());
    private static final int PATIENCE_MS = 1500;
    private static final double RENEWAL_S = 0.4;
    private static final String FAR_AHEAD = "1000000000000";
    private static final double ANSWER_S = 4;

    private final AiboLinks links;
    private final Tags tags;
    private final Watch watch;
    private final String alive;
    private final String tag;
    private volatile boolean installed;
    private volatile double clockAheadMs;
    private boolean armed;
    private long renewedNanos;

    DogGuard(AiboLinks links, Tags tags, Watch watch) {
        this.links = links;
        this.tags = tags;
        this.watch = watch;
        this.alive = tags.sharedVariable("alive");
        this.tag = tags.named("guard");
    }

    /** Sets the guard up, disarmed; without one if the server refuses it. Moves nothing. */
    void install() {
        Ask clock = new Ask(tags.next(), Ask.Expects.VALUE);
        UrbiConnection motion = links.motion();
        motion.send(clock, motion.dialect().labelled(clock.tag(), "time()") + ";");
        Ask guard = new Ask(tag, Ask.Expects.END);
        motion.send(
                guard,
                alive + " = " + FAR_AHEAD + "; " + tag + ": every(200) { if (time() - " + alive + " > " + PATIENCE_MS
                        + ") { stop walk & stop turn } },");
        Ask pong = new Ask(tags.next(), Ask.Expects.PONG);
        motion.send(pong, pong.tag() + ": ping;");
        watch.await(() -> pong.isDone() || motion.isEnded(), ANSWER_S);
        motion.forget(guard);
        if (guard.failure() == null && clock.value() instanceof UrbiValue.Num serverMs) {
            clockAheadMs = serverMs.amount() - clock.doneMs();
            installed = true;
        } else {
            LOG.log(Level.INFO, "the dog takes no guard: {0}", guard.failure());
        }
    }

    /** Arms it, or renews it: to be sent before anything walks. It then stays armed for as long as one renewal holds. */
    synchronized void renew() {
        if (installed) {
            armed = true;
            renewedNanos = watch.time().nanos();
            double heardMs = links.sensors().lastTimeMs() + clockAheadMs;
            links.sensors().send(alive + " = " + Dialect.number(heardMs) + ",");
        }
    }

    /** Renews it in time while the dog walks; disarms it once it does not, unless a walk is just about to begin. */
    synchronized void tend(boolean walking) {
        boolean due = !armed || watch.time().secondsSince(renewedNanos) >= RENEWAL_S;
        if (walking && due) {
            renew();
        } else if (armed && due) {
            armed = false;
            links.sensors().send(alive + " = " + FAR_AHEAD + ",");
        }
    }

    /** What removes it. */
    String stop() {
        return "stop " + tag + ",";
    }
}
