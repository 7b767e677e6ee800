package majic.script;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import majic.script.syntax.Command;
import majic.script.syntax.Statement;
import majic.script.syntax.Walk;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Finds the robots that a script gives orders to, as far as they are there; those it only reads do not count. */
final class Commanded extends Walk {
    private final Selection selection;
    private final Set<Member> found = new LinkedHashSet<>();

    private Commanded(Selection selection) {
        this.selection = selection;
    }

    static Set<Member> in(List<Statement> script, Selection selection) {
        Commanded commanded = new Commanded(selection);
        commanded.walk(script);
        return commanded.found;
    }

    /** Whether a command makes its robot do something. */
    static boolean orders(Command command) {
        return command instanceof Command.Move
                || command instanceof Command.Turn
                || command instanceof Command.Drive
                || command instanceof Command.Set
                || command instanceof Command.Act
                || command instanceof Command.Own;
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        if (orders(line.command())) {
            found.addAll(selection.present(line.robots()));
        }
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        return null;
    }
}
