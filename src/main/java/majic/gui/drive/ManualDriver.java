package majic.gui.drive;

import java.util.EnumSet;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javax.swing.Timer;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.team.ManualControl;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Drives one robot while arrows are held, and releases it when they are not. Runs on the event dispatch thread and
 * never blocks there: if that thread hangs, the commands are not renewed and the robot stops 600 ms later.
 */
final class ManualDriver {
    private static final int TICK_MS = 25;
    private static final long RENEWAL_MS = 150;

    /** Time in ms that a released manual control may take until the next one can own the robot. */
    private static final long RELEASE_TIME_MS = 500;

    private final Member member;
    private final Consumer<String> errors;
    private final LongSupplier clockMs;
    private final HeldKeys keys = new HeldKeys();
    private final Timer ticks = new Timer(TICK_MS, event -> tick());
    private @Nullable Direction pointed;
    private @Nullable ManualControl control;
    private Set<Direction> driven = Set.of();
    private long renewedMs;
    private long releasedMs = Long.MIN_VALUE / 2;
    private boolean refused;
    private double share = 1;

    /**
     * Creates a driver that does not drive yet.
     *
     * @param errors receives the reason when the robot cannot be driven
     * @param clockMs any clock that does not go back
     */
    ManualDriver(Member member, Consumer<String> errors, LongSupplier clockMs) {
        this.member = member;
        this.errors = errors;
        this.clockMs = clockMs;
    }

    void keyPressed(Direction key) {
        keys.press(key, clockMs.getAsLong());
        begin();
    }

    void keyReleased(Direction key) {
        keys.release(key, clockMs.getAsLong());
    }

    /** Sets the arrow on which the mouse is pressed; null for none. */
    void point(@Nullable Direction arrow) {
        pointed = arrow;
        begin();
    }

    /** Stops at once, regardless of the keys held; called when the focus is lost or the panel is hidden. */
    void stopDriving() {
        keys.releaseAll();
        pointed = null;
        tick();
    }

    /** Sets the speed as a share of the cruise speed in the robot's profile, 0 to 1. */
    void share(double newShare) {
        share = newShare;
    }

    private void begin() {
        tick();
        if (!ticks.isRunning()) {
            ticks.start();
        }
    }

    private Set<Direction> wanted() {
        Set<Direction> all = EnumSet.noneOf(Direction.class);
        all.addAll(keys.held(clockMs.getAsLong()));
        if (pointed != null) {
            all.add(pointed);
        }
        return all;
    }

    private void tick() {
        Set<Direction> wanted = wanted();
        if (wanted.isEmpty()) {
            release();
        } else if (!refused && (control != null || acquire())) {
            drive(wanted);
        }
    }

    private void release() {
        ticks.stop();
        refused = false;
        driven = Set.of();
        if (control != null) {
            control.close();
            control = null;
            releasedMs = clockMs.getAsLong();
        }
    }

    private boolean acquire() {
        try {
            control = new ManualControl(member);
            return true;
        } catch (BotException e) {
            if (clockMs.getAsLong() - releasedMs > RELEASE_TIME_MS) {
                refused = true;
                errors.accept(e.getMessage());
            }
            return false;
        }
    }

    private void drive(Set<Direction> wanted) {
        long now = clockMs.getAsLong();
        if (control == null || (wanted.equals(driven) && now - renewedMs < RENEWAL_MS)) {
            return;
        }
        driven = wanted;
        renewedMs = now;
        BotProfile profile = member.bot().profile();
        control.drive(
                share * profile.cruiseMmPerSec() * Direction.forward(wanted),
                share * profile.cruiseTurnDegPerSec() * Direction.left(wanted));
    }
}
