package majic.bot;

import java.util.List;

/** What ends a motion before its time: the {@code until} of MAJIC Script. */
@FunctionalInterface
public interface Guard {
    /** Never ends a motion. */
    Guard NEVER = () -> false;

    /**
     * Looks whether the motion has gone far enough. Called by the driver on the thread of the motion, as often as
     * readings arrive.
     *
     * @return whether the motion is to end now
     * @throws BotException if it cannot be told, for instance because a reading is missing; the motion then fails
     */
    boolean reached();

    /**
     * The other robots whose readings count as well; their news make the driver look again.
     *
     * @return none unless overridden
     */
    default List<MajicBot> alsoWatches() {
        return List.of();
    }
}
