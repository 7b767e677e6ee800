package majic.script;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import majic.script.syntax.Command;
import majic.script.syntax.SessionCommand;
import majic.script.syntax.Statement;
import majic.team.Member;

/**
 * A line or block as it was given to a parser. Immutable.
 *
 * @param statement what it says
 * @param text as it was typed
 * @param robots those it makes do something, as far as they were there by then
 * @param stops how often they had been stopped by then
 * @param refused gets the reason if the files it names do not let it be done
 * @param failed gets the reason if it is refused by the session or a robot when its turn comes
 * @param sent whether it is a stop that was sent already, of which only the end is waited for
 */
record Given(
        Statement statement,
        String text,
        Set<Integer> robots,
        long stops,
        Consumer<String> refused,
        Consumer<String> failed,
        boolean sent) {
    /** The same, once it was sent. */
    Given asSent() {
        return new Given(statement, text, robots, stops, refused, failed, true);
    }

    /** Its first line, as answers call it. */
    String title() {
        return text.strip().lines().findFirst().orElse("").replaceAll("\\s+", " ");
    }

    boolean isBlock() {
        return !(statement instanceof Statement.ForRobots) && !(statement instanceof Statement.ForSession);
    }

    /** Whether it goes past a wait when a person types it. */
    boolean overtakes() {
        if (statement instanceof Statement.ForRobots line) {
            Command command = line.command();
            return command instanceof Command.Stop || command instanceof Command.Get || command instanceof Command.Help;
        }
        return statement instanceof Statement.ForSession line
                && (line.command() instanceof SessionCommand.StopAll
                        || line.command() instanceof SessionCommand.Help
                        || line.command() instanceof SessionCommand.Bots
                        || line.command() instanceof SessionCommand.Release
                        || line.command() instanceof SessionCommand.Quit);
    }

    /** Whether checking it reads files. */
    boolean namesFile() {
        return FileUse.in(statement);
    }

    boolean isStop() {
        return isStop(statement);
    }

    /** Whether a statement is a STOP or stops some robots. */
    static boolean isStop(Statement statement) {
        return isStopAll(statement)
                || (statement instanceof Statement.ForRobots line && line.command() instanceof Command.Stop);
    }

    private static boolean isStopAll(Statement statement) {
        return statement instanceof Statement.ForSession line && line.command() instanceof SessionCommand.StopAll;
    }

    boolean isAdd() {
        return statement instanceof Statement.ForSession line && line.command() instanceof SessionCommand.Add;
    }

    /** Whether it waits until the behaviour it ends has given its robots back. */
    boolean isActOff() {
        return statement instanceof Statement.ForRobots line && line.command() instanceof Command.ActOff;
    }

    /** Whether it holds up the lines behind it, also those a person types. */
    boolean isWait() {
        return (statement instanceof Statement.ForRobots line && line.command() instanceof Command.Await)
                || (statement instanceof Statement.ForSession session
                        && (session.command() instanceof SessionCommand.Await
                                || session.command() instanceof SessionCommand.Pause));
    }

    /** Whether it is done at once, so that the caller's thread can do it. */
    boolean isQuick() {
        if (isWait() || isBlock()) {
            return false;
        }
        return !(statement instanceof Statement.ForSession line)
                || line.command() instanceof SessionCommand.StopAll
                || line.command() instanceof SessionCommand.Help
                || line.command() instanceof SessionCommand.Bots
                || line.command() instanceof SessionCommand.Release
                || line.command() instanceof SessionCommand.Quit
                || line.command() instanceof SessionCommand.Lab;
    }

    /** Whether it may set robots moving, and so is dropped by a STOP that comes before its turn. */
    boolean mayMove() {
        if (statement instanceof Statement.ForRobots line) {
            return Commanded.orders(line.command());
        }
        return isBlock()
                || (statement instanceof Statement.ForSession line && line.command() instanceof SessionCommand.Run);
    }

    /** Whether other robots may be there afterwards, or other code be agreed to. */
    boolean changesTeam() {
        return isBlock() || (statement instanceof Statement.ForSession line && Checker.changesTeam(line.command()));
    }

    /** The robots that a statement makes do something, as far as they are there. */
    static Set<Integer> robots(Statement statement, Selection selection) {
        return Commanded.in(List.of(statement), selection).stream()
                .map(Member::number)
                .collect(Collectors.toSet());
    }
}
