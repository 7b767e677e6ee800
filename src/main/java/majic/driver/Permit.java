package majic.driver;

import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import org.jspecify.annotations.Nullable;

/**
 * Permission to move a robot. Every motion starts under one and checks it again before each command it sends, so a
 * motion whose permit was revoked cannot move the robot any more, however late its thread runs. A stop revokes all that
 * were given out before it. Thread-safe.
 */
public final class Permit {
    /** This one, then those that it depends on. */
    private final Permit[] all;

    private volatile @Nullable Supplier<? extends BotException> revocation;

    /** A permit of its own. */
    public Permit() {
        this.all = new Permit[] {this};
    }

    private Permit(Permit one, Permit other) {
        this.all = new Permit[1 + one.all.length + other.all.length];
        all[0] = this;
        System.arraycopy(one.all, 0, all, 1, one.all.length);
        System.arraycopy(other.all, 0, all, 1 + one.all.length, other.all.length);
    }

    /**
     * Returns a permit that is valid only while this one and another one are valid.
     *
     * @param other the other one
     * @return a new permit that holds as long as both do and itself is not revoked
     */
    public Permit and(Permit other) {
        return new Permit(this, other);
    }

    /**
     * Revokes the permission permanently. Of several revocations the first counts.
     *
     * @param reason creates the exception that later attempts to move throw
     */
    public synchronized void revoke(Supplier<? extends BotException> reason) {
        if (revocation == null) {
            revocation = reason;
        }
    }

    /**
     * Returns whether the permission was revoked.
     *
     * @return true from the first revocation on
     */
    public boolean isRevoked() {
        for (Permit each : all) {
            if (each.revocation != null) {
                return true;
            }
        }
        return false;
    }

    /**
     * Goes on only with a valid permit.
     *
     * @throws BotException the exception of the revocation, usually {@link MotionStopped}
     */
    public void check() {
        for (Permit each : all) {
            Supplier<? extends BotException> reason = each.revocation;
            if (reason != null) {
                throw reason.get();
            }
        }
    }
}
