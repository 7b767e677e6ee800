package majic.script.lines;

import java.util.List;
import majic.script.conditions.Selection;
import majic.script.run.ActionLookup;
import majic.script.run.Execution;
import majic.script.run.SessionAction;
import majic.script.syntax.CommandTrait;
import majic.script.syntax.Statement;

/** A command for the session. */
final class SessionLine extends PreparedLine {
    private final Statement.ForSession line;
    private final SessionAction action;

    SessionLine(Statement.ForSession line, String text, SessionAction action) {
        super(text, line.scheduling(), line.command().traits(), List.of(), List.of());
        this.line = line;
        this.action = action;
    }

    @Override
    Statement statement() {
        return line;
    }

    @Override
    void check(ActionLookup actions, Selection selection) {
        if (!has(CommandTrait.READS_FILES)) {
            checkWithFiles(actions, selection);
        }
    }

    @Override
    void checkWithFiles(ActionLookup actions, Selection selection) {
        action.check(new SessionAction.Check(selection, false));
        markChecked();
    }

    @Override
    void run(Execution execution, ActionLookup actions) {
        action.run(execution);
    }
}
