package majic.mavlink.motion;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Value;
import majic.driver.RobotWait;
import majic.mavlink.message.CommandAck;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.message.VehicleHeartbeat;
import majic.mavlink.session.Received;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;
import majic.time.WaitPolicy;

/**
 * The stop of a vehicle: a mode in which it stays where it is, and a zero velocity for one that MAJIC moves. Sent again
 * every 100 ms until a heartbeat or an answer shows it. Never disarms. Thread-safe; only {@link #confirm} waits.
 */
public final class StopControl {
    private static final Logger LOG = System.getLogger(StopControl.class.getName());

    /** From one sending to the next, seconds. */
    static final double PERIOD_S = 0.1;

    /** A stop that is not shown is sent for so long, seconds. */
    private static final double LONGEST_S = 10;

    private static final double CONFIRM_S = 4;
    private static final double REFUSED_S = 1;
    private static final int CLOSING_TIMES = 5;

    /** A stop is sent so often in any case: what shows it may be older than the command that it stops. */
    private static final int LEAST_TIMES = 3;

    /** An answer belongs to another command of the same kind if that was sent so shortly before, seconds. */
    private static final double OTHER_S = 1.5;

    private final VehicleSession session;
    private final TimeSource time;
    private final Runnable schedule;
    private volatile Order order = Order.NONE;
    private final AtomicInteger times = new AtomicInteger();
    private volatile long otherNanos;

    /**
     * A stop that was ordered.
     *
     * @param pending whether it is still to be repeated
     * @param atNanos when
     * @param refusedNanos when its mode was refused, for which there is another; 0 if it was not
     */
    private record Order(boolean pending, long atNanos, long refusedNanos) {
        static final Order NONE = new Order(false, 0, 0);

        /** What shows the stop arrives after this time. */
        long fromNanos() {
            return Math.max(atNanos, refusedNanos);
        }

        boolean exists() {
            return atNanos != 0;
        }
    }

    /**
     * Creates the control.
     *
     * @param schedule has {@link #repeat} called after 100 ms
     */
    StopControl(VehicleSession session, TimeSource time, Runnable schedule) {
        this.session = session;
        this.time = time;
        this.schedule = schedule;
    }

    /**
     * Sends the stop at once.
     *
     * @throws LinkLost if the connection has ended
     */
    public void order() {
        times.set(0);
        order = new Order(true, Math.max(1, time.nanos()), 0);
        try {
            write();
        } finally {
            schedule.run();
        }
    }

    private void write() {
        times.incrementAndGet();
        OptionalLong mode = mode();
        if (mode.isPresent()) {
            session.send(MavlinkRequests.command(
                    session.system(),
                    MavlinkRequests.SET_MODE,
                    0,
                    session.modes().arguments(mode.getAsLong())));
        }
        if (session.vehicle().isOnSurface()) {
            session.send(MavlinkRequests.velocity(session.system(), 0, 0));
        } else if (session.vehicle().isMoved() && session.modes().guided().isPresent()) {
            session.send(MavlinkRequests.flight(session.system(), 0, 0, 0));
        }
    }

    /** The mode of the stop; another one once that was refused. */
    private OptionalLong mode() {
        return order.refusedNanos() == 0
                ? session.modes().stop()
                : session.modes().otherStop();
    }

    /** Goes over to the other mode of a stop when the first one is refused. */
    private synchronized void goOver(Order now) {
        boolean isOwnAnswer = otherNanos == 0 || time.secondsSince(otherNanos) > OTHER_S;
        if (order == now && hasOther(now) && isOwnAnswer && isRefused(now)) {
            order = new Order(now.pending(), now.atNanos(), time.nanos());
        }
    }

    private boolean hasOther(Order now) {
        return now.refusedNanos() == 0 && session.modes().otherStop().isPresent();
    }

    /** Sends the stop again unless it is shown; on the timer thread. */
    void repeat() {
        goOver(order);
        Order now = order;
        if (!now.pending() || session.hasEnded()) {
            return;
        }
        if (times.get() >= LEAST_TIMES && isShown() || time.secondsSince(now.atNanos()) > LONGEST_S) {
            end(now);
            return;
        }
        try {
            writeAgain(now);
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "the stop was not sent again", e);
        } finally {
            schedule.run();
        }
    }

    /** Not while a new motion cancels the stop: its mode must not be followed by that of the stop. */
    private synchronized void writeAgain(Order now) {
        if (order == now) {
            write();
        }
    }

    private synchronized void end(Order now) {
        if (order == now) {
            order = new Order(false, now.atNanos(), now.refusedNanos());
        }
    }

    /** Takes note that another mode is being set, whose answer is none to a stop. */
    void otherModeSent() {
        otherNanos = time.nanos();
    }

    /** Ends the repetition: a motion begins that was commanded after the stop. */
    synchronized void cancel() {
        order = Order.NONE;
    }

    /**
     * Has an ordered stop shown before the connection is closed, after the timer of the robot has ended; takes half a
     * second at most.
     */
    void finish(RobotWait waiting) {
        for (int more = 0; order.pending() && more < CLOSING_TIMES && !session.hasEnded(); more++) {
            if (waiting.awaitClosing(() -> isShown() || session.hasEnded(), PERIOD_S)) {
                return;
            }
            goOver(order);
            try {
                write();
            } catch (LinkLost e) {
                LOG.log(Level.DEBUG, "the last stop was not sent again", e);
                return;
            }
        }
    }

    /** Whether a stop was ordered since the last motion began. */
    public boolean isOrdered() {
        return order.exists();
    }

    /** When the stop was ordered. */
    long orderedNanos() {
        return order.atNanos();
    }

    /** Whether a heartbeat or an answer after the stop shows its mode. */
    private boolean isShown() {
        long from = order.fromNanos();
        boolean inMode = session.reports()
                .newest(VehicleHeartbeat.class)
                .filter(received -> received.atNanos() > from && isStopMode(received))
                .isPresent();
        boolean isAnswered = otherNanos == 0 || (from - otherNanos) / 1e9 > OTHER_S;
        return inMode
                || isAnswered && answer(from).filter(CommandAck::isAccepted).isPresent();
    }

    private boolean isStopMode(Received<VehicleHeartbeat> received) {
        OptionalLong mode = mode();
        return mode.isPresent() && mode.getAsLong() == received.value().customMode();
    }

    private Optional<CommandAck> answer(long from) {
        return session.commands().answer(MavlinkRequests.SET_MODE, from);
    }

    /**
     * Waits until the stop is shown; does nothing if none was ordered, or on a thread that must not wait.
     *
     * @throws BotException if it is refused, or not shown in time
     * @throws LinkLost if the connection ended meanwhile
     */
    public void confirm(String name, RobotWait waiting) {
        if (!order.exists() || !WaitPolicy.isAllowed()) {
            return;
        }
        String mode = mode().stream()
                .mapToObj(session.modes()::name)
                .findFirst()
                .orElseThrow(() -> new BotException(
                        name + " has an autopilot for which MAJIC has no stop; stop it by its" + " radio control"));
        waiting.await(() -> !order.exists() || isShown() || isRefusedForGood(order) || session.hasEnded(), CONFIRM_S);
        Order last = order;
        // A motion that was commanded after the stop ends it.
        if (!last.exists() || isShown()) {
            return;
        }
        if (session.hasEnded()) {
            throw new LinkLost("connection lost before the autopilot confirmed the stop");
        }
        String what = isRefused(last)
                ? "'s autopilot refuses " + mode + session.texts().reasonsSince(last.atNanos())
                : " has not confirmed " + mode + " within " + Value.plain(CONFIRM_S) + " s";
        throw new BotException(name + what + "; stop it by its radio control");
    }

    /** Its reasons have come by then, and one of the repetitions might have been accepted. */
    private boolean isRefusedForGood(Order now) {
        return isRefused(now) && !hasOther(now) && time.secondsSince(now.fromNanos()) > REFUSED_S;
    }

    private boolean isRefused(Order now) {
        return answer(now.fromNanos()).filter(answer -> !answer.isAccepted()).isPresent();
    }
}
