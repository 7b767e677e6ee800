package majic.script.run;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import majic.script.conditions.Comparisons;
import majic.script.conditions.Selection;
import majic.script.syntax.Condition;
import majic.script.syntax.Mistake;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Checks a script against the robots that are there, before anything of it runs. Behind a command that changes the team
 * nothing is checked, since other robots may be there by then.
 */
public final class Checker extends Inspection {
    private final SessionState session;
    private final Selection selection;
    private final Set<Member> limitsSet = new HashSet<>();
    private final boolean readsFiles;
    private boolean teamMayChange;
    private boolean filesMayAppear;

    private Checker(SessionState session, Selection selection, boolean readsFiles) {
        this.session = session;
        this.selection = selection;
        this.readsFiles = readsFiles;
    }

    /** Everything wrong in a script, in its order. Reads the files it names, so it may block. */
    public static List<Mistake> check(List<Statement> script, SessionState session, Selection selection) {
        return check(script, new Checker(session, selection, true));
    }

    /** Everything wrong in a script except for what only its files show. Reads no file. */
    public static List<Mistake> checkWithoutFiles(List<Statement> script, SessionState session, Selection selection) {
        return check(script, new Checker(session, selection, false));
    }

    private static List<Mistake> check(List<Statement> script, Checker checker) {
        checker.walk(script);
        return checker.mistakes();
    }

    @Override
    public void inspect(Condition condition) {
        if (!teamMayChange) {
            Comparisons.check(condition, selection, null);
        }
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        if (!teamMayChange) {
            List<Member> robots = selection.members(line.robots());
            line.command()
                    .check(robots.stream()
                            .map(robot ->
                                    new Command.Check(session, selection, robot, limitsSet.contains(robot), readsFiles))
                            .toList());
            if (line.command().has(CommandTrait.CHANGES_LIMIT)) {
                limitsSet.addAll(robots);
            }
            teamMayChange = line.command().has(CommandTrait.CHANGES_TEAM);
        }
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        if (!teamMayChange && (readsFiles || !line.command().has(CommandTrait.READS_FILES))) {
            line.command().check(new SessionCommand.Check(session, selection, filesMayAppear));
        }
        filesMayAppear |= line.command().has(CommandTrait.WRITES_FILE);
        teamMayChange |= line.command().has(CommandTrait.CHANGES_TEAM);
        return null;
    }
}
