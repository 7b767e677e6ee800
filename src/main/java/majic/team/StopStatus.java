package majic.team;

import java.util.Collections;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Which robots have confirmed that they were stopped. Immutable.
 *
 * @param asked how many robots of the team the latched STOP was meant for; 0 while STOP is not latched
 * @param confirmed how many of those have confirmed it, 0 to {@code asked}
 * @param unconfirmed the numbers of the robots whose last stop failed to be confirmed, by STOP or alone, each with the
 *     reason as half a sentence; a robot stays until it confirms a later stop or is removed
 * @param elsewhere why the latched STOP has not reached programs that share it, as a sentence; empty if it has reached
 *     all of them, or is not shared
 */
public record StopStatus(int asked, int confirmed, SortedMap<Integer, String> unconfirmed, String elsewhere) {
    /** The status of a team that was not stopped. */
    public static final StopStatus NONE = new StopStatus(0, 0, new TreeMap<>(), "");

    /** Copies the map. */
    public StopStatus {
        unconfirmed = Collections.unmodifiableSortedMap(new TreeMap<>(unconfirmed));
    }

    /**
     * Returns why the stop of a robot was not confirmed.
     *
     * @param robot its number
     * @return half a sentence; empty if its last stop was confirmed or is still pending for the first time
     */
    public Optional<String> problem(int robot) {
        return Optional.ofNullable(unconfirmed.get(robot));
    }
}
