package majic.script.run;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import majic.script.conditions.Selection;
import majic.script.syntax.Statement;
import majic.script.syntax.StatementWalk;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Finds the robots that a script commands, as far as they are there, and whether it names files. */
public final class RobotsIn extends StatementWalk {
    private final ActionLookup actions;
    private final Selection selection;
    private final Set<Member> commanded = new LinkedHashSet<>();
    private boolean readsFiles;

    private RobotsIn(ActionLookup actions, Selection selection) {
        this.actions = actions;
        this.selection = selection;
    }

    public static RobotsIn of(List<Statement> script, ActionLookup actions, Selection selection) {
        RobotsIn robots = new RobotsIn(actions, selection);
        robots.walk(script);
        return robots;
    }

    /** The robots that it makes do something; those it only reads do not count. */
    public Set<Member> commanded() {
        return commanded;
    }

    /** Whether its check reads files. */
    public boolean readsFiles() {
        return readsFiles;
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        RobotAction action = actions.of(line.command());
        readsFiles |= action.has(CommandTrait.READS_FILES);
        if (action.has(CommandTrait.COMMANDS_ROBOTS)) {
            commanded.addAll(selection.present(line.robots()));
            commanded.addAll(action.others(selection));
        }
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        readsFiles |= actions.of(line.command()).has(CommandTrait.READS_FILES);
        return null;
    }
}
