package majic.bot;

import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Leave to move a robot. Every motion is begun under one and asks it again before each thing it sends, so a motion whose
 * permit was revoked cannot move the robot any more, however late its thread comes. A stop revokes all that were given
 * out before it. Thread-safe.
 */
public final class Permit {
    private final List<Permit> parents;
    private volatile @Nullable Supplier<? extends BotException> revocation;

    /** A permit of its own. */
    public Permit() {
        this(List.of());
    }

    private Permit(List<Permit> parents) {
        this.parents = parents;
    }

    /**
     * Leave for those who have this permit and another one.
     *
     * @param other the other one
     * @return a new permit that holds as long as both do and itself is not revoked
     */
    public Permit and(Permit other) {
        return new Permit(List.of(this, other));
    }

    /**
     * Takes the leave back, for good. Of several revocations the first counts.
     *
     * @param reason makes what is thrown at those who still try to move
     */
    public synchronized void revoke(Supplier<? extends BotException> reason) {
        if (revocation == null) {
            revocation = reason;
        }
    }

    /**
     * Whether the leave was taken back.
     *
     * @return true from the first revocation on
     */
    public boolean isRevoked() {
        return revocation != null || parents.stream().anyMatch(Permit::isRevoked);
    }

    /**
     * Goes on only with a valid permit.
     *
     * @throws BotException what the revocation said, usually {@link MotionStopped}
     */
    public void check() {
        Supplier<? extends BotException> reason = revocation;
        if (reason != null) {
            throw reason.get();
        }
        parents.forEach(Permit::check);
    }
}
