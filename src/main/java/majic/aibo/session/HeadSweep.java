package majic.aibo.session;

import java.util.concurrent.atomic.AtomicReference;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiVersion;
import org.jspecify.annotations.Nullable;

/**
 * Lets the head look left and right while the dog walks ahead, because the infra-red beams are far narrower than the
 * dog. Started only by a motion. Never makes a stop wait.
 */
public final class HeadSweep {
    /** There and back again. */
    static final double PERIOD_S = 2;

    private static final int AMPLITUDE_DEG = 45;
    private static final int BACK_MS = 300;

    private final UrbiConnection sensors;
    private final Tags tags;
    private final AtomicReference<@Nullable String> sweeping = new AtomicReference<>();
    private final AtomicReference<@Nullable String> halted = new AtomicReference<>();
    private final AtomicReference<@Nullable String> homing = new AtomicReference<>();
    private volatile double homeDeg;

    HeadSweep(UrbiConnection sensors, Tags tags) {
        this.sensors = sensors;
        this.tags = tags;
    }

    /**
     * Where the head looks when it does not sweep, degrees to the left. A head that is still on its way back from a
     * sweep goes no further, for on the dog the older of two movements would end where it likes.
     */
    public void home(double degrees) {
        homeDeg = degrees;
        String tag = homing.getAndSet(null);
        if (tag != null) {
            sensors.send("stop " + tag + ",");
        }
    }

    boolean isSweeping() {
        return sweeping.get() != null;
    }

    /** Begins to sweep, unless it does; to be sent as part of a motion. */
    void start() {
        String tag = tags.next();
        if (sweeping.compareAndSet(null, tag)) {
            sensors.send(tag + ": headPan.val = 0 sin:" + (int) (PERIOD_S * 1000) + " ampli:" + AMPLITUDE_DEG + ",");
        }
    }

    /** Ends it and brings the head back to where it was; to be sent as part of a motion. */
    void end() {
        String tag = sweeping.getAndSet(null);
        if (tag != null) {
            String back = tags.next();
            homing.set(back);
            sensors.send("stop " + tag + "; " + back + ": headPan.val = " + UrbiVersion.number(homeDeg) + " time:"
                    + BACK_MS + ",");
        }
    }

    /**
     * What stops it at once on another connection. Since that may overtake the command that began it, {@link #tick}
     * sends it again on the same one.
     */
    String halt() {
        String tag = sweeping.getAndSet(null);
        if (tag == null) {
            return "";
        }
        halted.set(tag);
        return " stop " + tag + ",";
    }

    /** What stops it, for now: it still counts as sweeping. */
    String stopCommand() {
        String tag = sweeping.get();
        return tag == null ? "" : " stop " + tag + ",";
    }

    /** Makes sure that what was halted is over. */
    void tick() {
        String tag = halted.getAndSet(null);
        if (tag != null) {
            sensors.send("stop " + tag + ",");
        }
    }
}
