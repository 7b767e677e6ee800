package majic.script.lines;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.Trait;
import majic.script.syntax.Statement;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * A line or block with what decides when it runs. Immutable.
 *
 * @param statement its tree
 * @param text as it was typed
 * @param scheduling when it runs
 * @param traits of its commands
 * @param robots those it is for; of a block those it commands; as far as they are in the team
 * @param checked runs it without another check; null if it has to be checked in its turn
 */
public record PreparedLine(
        Statement statement,
        String text,
        Scheduling scheduling,
        Set<Trait> traits,
        List<Member> robots,
        @Nullable Consumer<Execution> checked) {
    public boolean has(Trait trait) {
        return traits.contains(trait);
    }

    boolean isBlock() {
        return !(statement instanceof Statement.ForRobots) && !(statement instanceof Statement.ForSession);
    }

    /** Its first line, as answers call it. */
    String title() {
        return text.strip().lines().findFirst().orElse("").replaceAll("\\s+", " ");
    }

    /** The numbers of the robots it makes do something. */
    Set<Integer> commanded() {
        return has(Trait.COMMANDS_ROBOTS) ? robots.stream().map(Member::number).collect(Collectors.toSet()) : Set.of();
    }
}
