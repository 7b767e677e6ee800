package majic.script;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import majic.script.syntax.Command;
import majic.script.syntax.Condition;
import majic.script.syntax.Mistake;
import majic.script.syntax.SessionCommand;
import majic.script.syntax.Statement;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Looks through a script for what cannot work with the robots that are there, before anything of it runs. Behind an
 * {@code add} or {@code run} robots may be others by then, so what is wrong only for want of a robot is left for later.
 */
final class Checker extends Inspection {
    private final Session session;
    private final Selection selection;
    private final Set<Member> limitsSet = new HashSet<>();
    private final boolean readsFiles;
    private boolean teamMayChange;
    private boolean saves;

    private Checker(Session session, Selection selection, boolean readsFiles) {
        this.session = session;
        this.selection = selection;
        this.readsFiles = readsFiles;
    }

    /** Everything wrong in a script, in its order. Reads the files it names, so it may block. */
    static List<Mistake> check(List<Statement> script, Session session, Selection selection) {
        return check(script, new Checker(session, selection, true));
    }

    /** Everything wrong in a script but for what only its files can tell. Reads no file. */
    static List<Mistake> checkWithoutFiles(List<Statement> script, Session session, Selection selection) {
        return check(script, new Checker(session, selection, false));
    }

    private static List<Mistake> check(List<Statement> script, Checker checker) {
        checker.walk(script);
        return checker.mistakes();
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
                check(line.command(), member);
                if (setsLimit(line.command())) {
                    limitsSet.add(member);
                }
            }
        }
        return null;
    }

    private void check(Command command, Member member) {
        if (command instanceof Command.Act act && !readsFiles) {
            Behaviours.others(act, selection);
            return;
        }
        command.accept(new CommandCheck(session.behaviours(), selection, member, limitsSet.contains(member)));
    }

    /** Behind it, only the robot can tell how far a move may go. */
    private static boolean setsLimit(Command command) {
        return command instanceof Command.Set set && set.parameter().text().equalsIgnoreCase("maxMove");
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        SessionCommand command = line.command();
        boolean runsSaved = saves && command instanceof SessionCommand.Run;
        if (!teamMayChange && !runsSaved && (readsFiles || !FileUse.by(command))) {
            command.accept(new SessionCheck(session, selection));
        }
        saves |= command instanceof SessionCommand.SaveSession;
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
