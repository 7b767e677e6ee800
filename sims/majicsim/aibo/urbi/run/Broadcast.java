package majicsim.aibo.urbi.run;

import java.util.List;
import java.util.function.Function;
import majicsim.aibo.urbi.syntax.Name;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;
import org.jspecify.annotations.Nullable;

/**
 * A command to a group: the kernel replaces it by the same command for each member, all with its tag and flags, in
 * parallel (URBI sheet, sections 10 and 21). A group inside a group counts as its members.
 */
public final class Broadcast {
    private Broadcast() {}

    /** Returns the replacement of the command, or null if the name is not that of a group. */
    public static @Nullable Task of(Context context, Name name, Function<Name, Statement> command) throws Failure {
        Evaluator evaluator = new Evaluator(context);
        List<String> members = context.variables().members(context.scope(), evaluator.key(name));
        if (members == null) {
            return null;
        }
        List<Task> tasks = members.stream()
                .map(member -> Name.of(member).withSuffix(name.suffix()))
                .map(member -> new Statement.Tagged(context.tag(), context.flags(), command.apply(member)))
                .map(each -> context.start(each))
                .toList();
        return new Substitute(context, ParallelTask.of(Substitute.context(context), tasks));
    }
}
