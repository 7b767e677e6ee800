package majic.gui.drive;

import java.util.function.Consumer;
import java.util.function.LongSupplier;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.team.ManualControl;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * One of the robots that are driven manually: takes it with the first command, renews its speed, and releases it. Must
 * be used on the event dispatch thread; never blocks there.
 */
final class DrivenRobot {
    private static final long RENEWAL_MS = 150;

    /** Time in ms that a released manual control may take until the next one can own the robot. */
    private static final long RELEASE_TIME_MS = 500;

    private final Member member;
    private final GuardChoice guard;
    private final Consumer<String> errors;
    private final LongSupplier clockMs;
    private @Nullable ManualControl control;
    private boolean driven;
    private double forward;
    private double left;
    private long renewedMs;
    private long releasedMs = Long.MIN_VALUE / 2;
    private boolean refused;

    DrivenRobot(Member member, GuardChoice guard, Consumer<String> errors, LongSupplier clockMs) {
        this.member = member;
        this.guard = guard;
        this.errors = errors;
        this.clockMs = clockMs;
    }

    Member member() {
        return member;
    }

    /**
     * Drives the robot; must be called again and again as long as it is to be driven.
     *
     * @param newForward the speed as a share of the cruise speed in the robot's profile, −1 to 1, ahead positive
     * @param newLeft the same of the turn rate, counterclockwise positive
     */
    void drive(double newForward, double newLeft) {
        long now = clockMs.getAsLong();
        boolean same = driven && newForward == forward && newLeft == left;
        if (refused || (control == null && !acquire()) || (same && now - renewedMs < RENEWAL_MS)) {
            return;
        }
        driven = true;
        forward = newForward;
        left = newLeft;
        renewedMs = now;
        BotProfile profile = member.bot().profile();
        if (control != null) {
            control.drive(forward * profile.cruiseMmPerSec(), left * profile.cruiseTurnDegPerSec(), guard.isOn());
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

    /** Stops the robot and releases it, if it is driven. */
    void release() {
        refused = false;
        driven = false;
        if (control != null) {
            control.close();
            control = null;
            releasedMs = clockMs.getAsLong();
        }
    }
}
