package majic.velocity;

import org.jspecify.annotations.Nullable;

/** The sensors of a base that report contacts; safe from any thread. */
@FunctionalInterface
public interface ObstructionSource {
    /** A base without such sensors. */
    ObstructionSource NONE = () -> null;

    /**
     * Returns the obstruction that was reported last.
     *
     * @return also one that is over; null if none was reported so far
     */
    @Nullable
    Obstruction newest();
}
