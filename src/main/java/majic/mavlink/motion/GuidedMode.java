package majic.mavlink.motion;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import majic.bot.MotionFailed;
import majic.driver.Motion;
import majic.mavlink.message.CommandAck;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.message.VehicleHeartbeat;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;
import majic.velocity.Obstruction;
import majic.velocity.Obstruction.Side;
import majic.velocity.ObstructionSource;
import org.jspecify.annotations.Nullable;

/**
 * The mode GUIDED, in which a vehicle follows MAJIC. A motion sets it. When it is another one afterwards, the radio
 * control, another ground station or a failsafe has taken the vehicle over, which ends the motion. Thread-safe.
 */
final class GuidedMode implements ObstructionSource {
    /** A mode that is not taken on after this time is refused, seconds. */
    private static final double ACCEPT_S = 3;

    /** Without an answer the mode is set again after this time, seconds. */
    private static final double AGAIN_S = 0.5;

    /** The texts that explain a refusal come this long after it at most, seconds. */
    private static final double REASON_S = 0.3;

    /** A heartbeat that is older says nothing about the present mode, seconds. */
    private static final double FRESH_S = 2.5;

    private final VehicleSession session;
    private final StopControl stop;
    private final TimeSource time;
    private final AtomicReference<Hold> hold = new AtomicReference<>(Hold.NONE);
    private volatile long sentNanos;
    private volatile long stoppedNanos;

    /** How far MAJIC has the mode. */
    private enum Claim {
        /** It was not set, or a stop has ended it. */
        NONE,
        /** It was set, and no heartbeat has shown it yet. */
        SET,
        /** A heartbeat has shown it. */
        SHOWN,
        /** It was shown, and another one later. */
        LOST
    }

    private record Hold(Claim claim, long sinceNanos, String reason) {
        static final Hold NONE = new Hold(Claim.NONE, 0, "");
    }

    GuidedMode(VehicleSession session, StopControl stop, TimeSource time) {
        this.session = session;
        this.stop = stop;
        this.time = time;
    }

    /** Takes a heartbeat; on the reader thread. */
    void heartbeat(VehicleHeartbeat heartbeat) {
        Hold now = hold.get();
        boolean guided = isGuided(heartbeat);
        if (now.claim() == Claim.SET && guided) {
            hold.compareAndSet(now, new Hold(Claim.SHOWN, now.sinceNanos(), ""));
        } else if (now.claim() == Claim.SHOWN && !guided) {
            hold.compareAndSet(now, new Hold(Claim.LOST, now.sinceNanos(), lost(heartbeat)));
        } else if (now.claim() == Claim.SHOWN && !heartbeat.armed()) {
            hold.compareAndSet(now, new Hold(Claim.LOST, now.sinceNanos(), "it was disarmed"));
        }
    }

    private String lost(VehicleHeartbeat heartbeat) {
        String mode = session.modes().name(heartbeat.customMode());
        return heartbeat.isFailsafe()
                ? "a failsafe of the autopilot changed the mode to " + mode
                : "the mode was changed to " + mode + " by another";
    }

    private boolean isGuided(VehicleHeartbeat heartbeat) {
        return session.modes().guided().stream().anyMatch(number -> number == heartbeat.customMode());
    }

    /** Ends the claim: a stop has been ordered, or the connection ends. */
    void release() {
        hold.set(Hold.NONE);
    }

    /** Takes the end of the autopilot's program. */
    void restarted() {
        Hold now = hold.get();
        if (now.claim() == Claim.SET || now.claim() == Claim.SHOWN) {
            hold.set(new Hold(Claim.LOST, now.sinceNanos(), "the autopilot has restarted"));
        }
    }

    /** Whether the newest heartbeat shows the mode, whoever has set it. */
    boolean isShown() {
        return isGuided(session.newestHeartbeat());
    }

    /** Whether MAJIC has set the mode, and nothing has ended that since. */
    boolean isHeld() {
        Claim claim = hold.get().claim();
        return claim == Claim.SET || claim == Claim.SHOWN;
    }

    /** Lets a motion begin that was commanded anew: it may set a mode that was lost before. */
    void begins() {
        Hold now = hold.get();
        if (now.claim() == Claim.LOST) {
            hold.compareAndSet(now, Hold.NONE);
        }
    }

    /**
     * Sets the mode and waits until the autopilot has taken it on.
     *
     * @return false if the guard of the motion ended it
     * @throws MotionFailed if the autopilot refuses it
     */
    boolean enter(Motion motion) {
        motion.send(this::set);
        while (!isTaken()) {
            boolean decided = motion.await(() -> isTaken() || refusal() != null, AGAIN_S);
            if (refusal() != null) {
                motion.pause(REASON_S);
                String refused = refusal();
                throw new MotionFailed(refused == null ? "the mode GUIDED was refused" : refused);
            }
            if (motion.guardReached()) {
                return false;
            }
            if (!decided && !isInProgress(hold.get())) {
                motion.send(this::set);
            }
        }
        return true;
    }

    /**
     * Sets the mode, unless it is in force or was set just now; does not wait. Called under a permit to move.
     *
     * @throws MotionFailed if it was lost since the motion was commanded: another has the vehicle
     */
    void set() {
        Hold now = hold.get();
        if (now.claim() == Claim.LOST) {
            throw new MotionFailed(now.reason());
        }
        boolean held = now.claim() == Claim.SHOWN || now.claim() == Claim.SET;
        stop.cancel();
        if (now.claim() != Claim.SHOWN && !held && isInForce()) {
            hold.set(new Hold(Claim.SHOWN, time.nanos(), ""));
            return;
        }
        if (now.claim() == Claim.SHOWN || held && (time.secondsSince(sentNanos) < AGAIN_S || isInProgress(now))) {
            return;
        }
        sentNanos = time.nanos();
        stop.otherModeSent();
        if (!held) {
            hold.set(new Hold(Claim.SET, sentNanos, ""));
        }
        session.modes()
                .guided()
                .ifPresent(mode -> session.send(MavlinkRequests.command(
                        session.system(),
                        MavlinkRequests.SET_MODE,
                        0,
                        session.modes().arguments(mode))));
    }

    /** Whether a heartbeat shows the mode, and no stop that may not be shown yet has changed it since. */
    private boolean isInForce() {
        boolean stopped = stoppedNanos != 0 && time.secondsSince(stoppedNanos) < FRESH_S;
        return !stopped
                && session.reports()
                        .newest(VehicleHeartbeat.class)
                        .filter(received -> time.secondsSince(received.atNanos()) < FRESH_S)
                        .filter(received -> isGuided(received.value()))
                        .isPresent();
    }

    /** Takes note of a stop, whose mode later heartbeats show. */
    void stopped() {
        stoppedNanos = Math.max(1, time.nanos());
        release();
    }

    private boolean isTaken() {
        Hold now = hold.get();
        return now.claim() == Claim.SHOWN
                || now.claim() == Claim.SET
                        && answer(now).filter(CommandAck::isAccepted).isPresent();
    }

    private Optional<CommandAck> answer(Hold now) {
        return session.commands().answer(MavlinkRequests.SET_MODE, now.sinceNanos());
    }

    /** Whether the autopilot has answered that it is still at it. */
    private boolean isInProgress(Hold now) {
        return now.claim() == Claim.SET && session.commands().isInProgress(MavlinkRequests.SET_MODE, now.sinceNanos());
    }

    /** Returns why the mode is not in force though it was set; null while it is or may still come. */
    private @Nullable String refusal() {
        Hold now = hold.get();
        if (now.claim() == Claim.LOST) {
            return now.reason();
        }
        if (now.claim() != Claim.SET) {
            return null;
        }
        Optional<CommandAck> answer = answer(now);
        boolean refused = answer.filter(one -> !one.isAccepted()).isPresent();
        boolean late = time.secondsSince(now.sinceNanos()) > ACCEPT_S && !isInProgress(now);
        if (!refused && !late) {
            return null;
        }
        return "the autopilot does not take on the mode GUIDED"
                + (refused
                        ? " (" + answer.get().title() + ")"
                        : "; it is in "
                                + session.modes().name(session.newestHeartbeat().customMode()))
                + session.texts().reasonsSince(now.sinceNanos());
    }

    /** What ends a motion: the mode is lost or refused. */
    @Override
    public @Nullable Obstruction newest() {
        String reason = refusal();
        return reason == null ? null : new Obstruction(reason, Side.ALL, false, time.nanos());
    }
}
