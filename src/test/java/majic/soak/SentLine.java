package majic.soak;

import java.util.Set;

/**
 * A line of MAJIC Script that was sent.
 *
 * @param number its number in the round, as refusals repeat it
 * @param text the line; a tagged one contains its number, which its answers repeat
 * @param robots the robots that have to answer it; empty for a line without a robot
 * @param untagged for a line without tag, the command as its answers begin behind the robot; otherwise empty
 */
record SentLine(int number, String text, Set<Integer> robots, String untagged) {
    boolean isTagged() {
        return untagged.isEmpty();
    }
}
