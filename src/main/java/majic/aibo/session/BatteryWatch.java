package majic.aibo.session;

import java.util.function.Consumer;
import majic.bot.LinkLost;

/** Reports once that the battery is low, and keeps that for the message of a lost connection. Thread-safe. */
final class BatteryWatch {
    /** Where the scripts on the stick begin to warn (URBI sheet 16). */
    private static final double LOW = 0.2;

    /** A charge must have risen so far before it can be low anew: readings waver. */
    private static final double CHARGED = 0.25;

    private final Consumer<String> notice;
    private boolean reported;
    private double charge = 1;

    BatteryWatch(Consumer<String> notice) {
        this.notice = notice;
    }

    /** Takes a charge, 0 to 1. */
    void update(double newCharge) {
        if (becomesLow(newCharge)) {
            notice.accept("the dog's battery is down to " + percent(newCharge) + "; it needs charging soon");
        }
    }

    private synchronized boolean becomesLow(double newCharge) {
        charge = newCharge;
        boolean report = newCharge < LOW && !reported;
        reported = newCharge < LOW || reported && newCharge < CHARGED;
        return report;
    }

    /** Adds to the cause of a lost connection that the battery may be why. */
    synchronized LinkLost explained(LinkLost cause) {
        return charge < LOW
                ? new LinkLost(cause.getMessage() + "; its battery was at " + percent(charge), cause)
                : cause;
    }

    private static String percent(double charge) {
        return Math.round(charge * 100) + " %";
    }
}
