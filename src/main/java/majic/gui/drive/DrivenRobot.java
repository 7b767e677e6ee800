package majic.gui.drive;

import java.util.Set;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.team.ManualControl;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * One of the robots that are driven manually: takes it when the first arrow is held, renews its speed, and releases it.
 * Must be used on the event dispatch thread; never blocks there.
 */
final class DrivenRobot {
    private static final long RENEWAL_MS = 150;

    /** Time in ms that a released manual control may take until the next one can own the robot. */
    private static final long RELEASE_TIME_MS = 500;

    private final Member member;
    private final Consumer<String> errors;
    private final LongSupplier clockMs;
    private @Nullable ManualControl control;
    private Set<Direction> driven = Set.of();
    private long renewedMs;
    private long releasedMs = Long.MIN_VALUE / 2;
    private boolean refused;

    DrivenRobot(Member member, Consumer<String> errors, LongSupplier clockMs) {
        this.member = member;
        this.errors = errors;
        this.clockMs = clockMs;
    }

    Member member() {
        return member;
    }

    /**
     * Drives the robot; must be called again and again as long as it is to be driven.
     *
     * @param wanted the arrows that are held, at least one
     * @param share the speed as a share of the cruise speed in the robot's profile, 0 to 1
     */
    void drive(Set<Direction> wanted, double share) {
        long now = clockMs.getAsLong();
        if (refused || (control == null && !acquire()) || (wanted.equals(driven) && now - renewedMs < RENEWAL_MS)) {
            return;
        }
        driven = wanted;
        renewedMs = now;
        BotProfile profile = member.bot().profile();
        if (control != null) {
            control.drive(
                    share * profile.cruiseMmPerSec() * Direction.forward(wanted),
                    share * profile.cruiseTurnDegPerSec() * Direction.left(wanted));
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
        driven = Set.of();
        if (control != null) {
            control.close();
            control = null;
            releasedMs = clockMs.getAsLong();
        }
    }
}
