package majic.script;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import majic.bot.Member;
import org.jspecify.annotations.Nullable;

/**
 * Looks through a script for what cannot work with the robots that are there, before anything of it runs. Behind an
 * {@code add} or {@code run} robots may be others by then, so what is wrong only for want of a robot is left for later.
 */
final class Checker extends Inspection {
    private final Session session;
    private final Selection selection;
    private final Set<Member> limitsSet = new HashSet<>();
    private boolean teamMayChange;

    private Checker(Session session, Selection selection) {
        this.session = session;
        this.selection = selection;
    }

    /** Everything wrong in a script, in its order. */
    static List<Mistake> check(List<Statement> script, Session session, Selection selection) {
        Checker checker = new Checker(session, selection);
        checker.walk(script);
        return checker.mistakes();
    }

    /** What is wrong with one command, if anything. */
    static Optional<Mistake> check(Statement statement, Session session, Selection selection) {
        return check(List.of(statement), session, selection).stream().findFirst();
    }

    @Override
    void inspect(Condition condition) {
        if (!teamMayChange) {
            Comparing.check(condition, selection, null);
        }
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        if (!teamMayChange) {
            for (Member member : selection.members(line.robots())) {
                line.command()
                        .accept(new CommandCheck(session.behaviours(), selection, member, limitsSet.contains(member)));
                if (setsLimit(line.command())) {
                    limitsSet.add(member);
                }
            }
        }
        return null;
    }

    /** Behind it, only the robot can tell how far a move may go. */
    private static boolean setsLimit(Command command) {
        return command instanceof Command.Set set && set.parameter().text().equalsIgnoreCase("maxMove");
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        SessionCommand command = line.command();
        if (!teamMayChange) {
            command.accept(new SessionCheck(session, selection));
        }
        teamMayChange |= changesTeam(command);
        return null;
    }

    /** Whether other robots may be there, or other code be agreed to, once this has been done. */
    static boolean changesTeam(SessionCommand command) {
        return command instanceof SessionCommand.Add
                || command instanceof SessionCommand.Remove
                || command instanceof SessionCommand.Run
                || command instanceof SessionCommand.Trust
                || command instanceof SessionCommand.TrustOff;
    }
}
