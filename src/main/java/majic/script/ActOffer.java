package majic.script;

import java.util.List;
import java.util.stream.Collectors;
import majic.act.ActDetails;
import majic.act.Role;
import majic.act.file.ActFile;
import majic.script.record.SessionRecord;
import org.jspecify.annotations.Nullable;

/**
 * A behaviour that can be loaded onto a robot, with what is known before any of its code is loaded. Immutable.
 *
 * @param called what a line calls it: its name, or the path of its file
 * @param details its description
 * @param roles the robots it asks for, the one it is loaded onto first
 * @param file the act's file; null for a script
 */
public record ActOffer(
        String called,
        ActDetails details,
        List<Role> roles,
        @Nullable ActFile file) {
    /** Keeps a copy of the roles. */
    public ActOffer {
        roles = List.copyOf(roles);
    }

    /**
     * Returns the line that ends the acts on robots.
     *
     * @param robots their numbers
     * @return for instance {@code 1,2 act off}
     */
    public static String endLine(List<Integer> robots) {
        return numbers(robots) + " act off";
    }

    private static String numbers(List<Integer> robots) {
        return robots.stream().map(String::valueOf).collect(Collectors.joining(","));
    }

    /**
     * The line that loads it onto a robot.
     *
     * @param me the number of the robot it is loaded onto
     * @param others the numbers of the further robots, in the order of the roles
     * @return for instance {@code 1 act Convoy with 2,3}
     */
    public String line(int me, List<Integer> others) {
        String with = numbers(others);
        return me + " act " + SessionRecord.quoted(called) + (with.isEmpty() ? "" : " with " + with);
    }
}
