package majic.script.run;

import majic.script.syntax.Command;
import majic.script.syntax.SessionCommand;

/** Finds the action for each command of the tree. */
public interface ActionLookup {
    RobotAction of(Command command);

    SessionAction of(SessionCommand command);
}
