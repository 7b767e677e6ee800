package majic.script.run;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import majic.script.conditions.Selection;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Finds the robots that a script commands, as far as they are there, and whether it names files. */
public final class RobotsIn extends StatementWalk {
    private final Selection selection;
    private final Set<Member> commanded = new LinkedHashSet<>();
    private boolean readsFiles;

    private RobotsIn(Selection selection) {
        this.selection = selection;
    }

    public static RobotsIn of(List<Statement> script, Selection selection) {
        RobotsIn robots = new RobotsIn(selection);
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
        Command command = line.command();
        readsFiles |= command.has(CommandTrait.READS_FILES);
        if (command.has(CommandTrait.COMMANDS_ROBOTS)) {
            commanded.addAll(selection.present(line.robots()));
            commanded.addAll(selection.present(command.others()));
        }
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        readsFiles |= line.command().has(CommandTrait.READS_FILES);
        return null;
    }
}
