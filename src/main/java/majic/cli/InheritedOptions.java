package majic.cli;

import java.lang.reflect.Field;
import java.util.List;
import java.util.function.Predicate;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;

/** The options that commands of {@code majic} inherit, so that they may also stand behind the command. */
public final class InheritedOptions {
    private InheritedOptions() {}

    /**
     * Leaves each command only the options that it uses: {@code run} all, {@code lab} those of the lab, the others
     * none.
     *
     * @param majic the command line with all commands
     * @return the same object
     */
    public static CommandLine limit(CommandLine majic) {
        majic.getSubcommands().forEach((name, command) -> {
            if (name.equals("lab")) {
                remove(command, option -> !isOfLab(option));
            } else if (!name.equals("run")) {
                remove(command, option -> true);
            }
        });
        return majic;
    }

    private static boolean isOfLab(ArgSpec option) {
        return option.userObject() instanceof Field field && field.getDeclaringClass() == LabChoice.class;
    }

    private static void remove(CommandLine command, Predicate<ArgSpec> unused) {
        List.copyOf(command.getCommandSpec().options()).stream()
                .filter(option -> option.inherited() && unused.test(option))
                .forEach(command.getCommandSpec()::remove);
        command.getSubcommands().values().forEach(inner -> remove(inner, unused));
    }
}
