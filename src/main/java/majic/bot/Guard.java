package majic.bot;

import java.util.List;
import java.util.Optional;

/** What ends a motion before its time: the {@code until} of MAJIC Script. */
@FunctionalInterface
public interface Guard {
    /** Never ends a motion. */
    Guard NEVER = () -> false;

    /**
     * Checks whether the motion is to end. Called by the driver on the thread of the motion, as often as readings
     * arrive.
     *
     * @return whether the motion is to end now
     * @throws BotException if it cannot be evaluated, for instance because a reading is missing; the motion then fails
     */
    boolean reached();

    /**
     * The other robots whose readings count as well; each new reading of them makes the driver check the guard again.
     *
     * @return none unless overridden
     */
    default List<? extends ReadingSource> alsoWatches() {
        return List.of();
    }

    /**
     * Returns the condition as a text that another program can evaluate, next to the robot.
     *
     * @return MAJIC Script, {@code distanceFront < 300mm}; empty unless overridden, and for a condition that reads
     *     anything but the robot that moves
     */
    default Optional<String> text() {
        return Optional.empty();
    }

    /** Something that can report that it has new readings, as each robot can. */
    interface ReadingSource {
        /**
         * Begins to call a watcher after each new reading.
         *
         * @param watcher quick; called on the thread that took the reading
         */
        void addWatcher(Runnable watcher);

        /**
         * Ends the calls of a watcher.
         *
         * @param watcher the one that was added
         */
        void removeWatcher(Runnable watcher);
    }
}
