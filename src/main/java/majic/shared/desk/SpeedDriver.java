package majic.shared.desk;

import majic.bot.BotException;
import majic.shared.broker.BrokerMessage;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.SpeedMessage;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Sends the newest speed of the holder to one robot, on a thread that exists while speeds arrive: writing to a robot
 * may block, and a speed that waits behind a blocked one is out of date. Thread-safe.
 */
final class SpeedDriver {
    /** The thread ends after this without a speed, seconds. */
    private static final double UNUSED_S = 2;

    private final DeskContext desk;
    private final String thread;
    private final Signal changed;
    private @Nullable Speed newest;
    private boolean running;

    private record Speed(RobotHold hold, SpeedMessage message, BrokerMessage source, SeenRequests seen) {}

    SpeedDriver(DeskContext desk, int robot) {
        this.desk = desk;
        this.thread = "robot " + robot + " driven from the broker";
        this.changed = desk.connection().time().signal();
    }

    /** Replaces the speed that was not sent yet; returns at once. */
    void drive(RobotHold hold, SpeedMessage message, BrokerMessage source, SeenRequests seen) {
        boolean begins;
        synchronized (this) {
            newest = new Speed(hold, message, source, seen);
            begins = !running;
            running = true;
        }
        TimeSource time = desk.connection().time();
        if (begins && !time.tryRunAsync(thread, this::run)) {
            synchronized (this) {
                running = false;
            }
            desk.reply(source, RequestReply.of(Outcome.FAILED, "the system has no thread left to drive the robot"));
        }
        changed.raise();
    }

    private void run() {
        try {
            for (Speed next = next(); next != null; next = next()) {
                send(next);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private @Nullable Speed next() throws InterruptedException {
        changed.await(this::hasSpeed, UNUSED_S);
        synchronized (this) {
            Speed taken = newest;
            newest = null;
            running = taken != null;
            return taken;
        }
    }

    private synchronized boolean hasSpeed() {
        return newest != null;
    }

    private void send(Speed speed) {
        SpeedMessage message = speed.message;
        try {
            desk.clock().check(message.validUntil());
            if (speed.seen.isVoid(message.sender().session(), message.number())) {
                return;
            }
            speed.hold.control().drive(message.mmPerSec(), message.degPerSec());
            speed.hold.use();
            desk.reply(speed.source, RequestReply.done(""));
        } catch (BotException e) {
            desk.reply(speed.source, RequestReply.of(Outcome.REFUSED, String.valueOf(e.getMessage())));
        }
    }
}
