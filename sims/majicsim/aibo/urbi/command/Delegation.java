package majicsim.aibo.urbi.command;

import java.util.List;
import majicsim.aibo.urbi.run.Connection;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.EvaluatingTask;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.Expr;
import majicsim.aibo.urbi.syntax.Flag;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Value;

/**
 * A command with the flag {@code +connection}: it runs in the connections that the flag names (URBI sheet, section 7).
 */
final class Delegation {
    private static final String FLAG = "connection";

    private Delegation() {}

    static Task start(Context context, Statement.Tagged command) {
        List<Expr> named = command.flags().stream()
                .filter(flag -> flag.name().equals(FLAG))
                .map(flag -> flag.argument() == null ? new Expr.Constant(Value.of("")) : flag.argument())
                .limit(1)
                .toList();
        return new EvaluatingTask(context, named, values -> {
            String meant = values.get(0).text();
            for (Connection each : context.server().recipients(context.connection(), meant)) {
                hand(each, command);
            }
            return null;
        });
    }

    private static void hand(Connection connection, Statement.Tagged command) {
        List<Flag> rest = command.flags().stream()
                .filter(flag -> !flag.name().equals(FLAG))
                .toList();
        Statement.Tagged plain = new Statement.Tagged(command.tag(), rest, command.body());
        connection.adopt(connection.context().start(plain));
    }
}
