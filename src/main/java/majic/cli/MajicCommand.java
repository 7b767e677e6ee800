package majic.cli;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.lang.reflect.Field;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import majic.console.Console;
import majic.program.Program;
import majic.program.UserFolder;
import majic.program.Version;
import majic.program.Window;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Option;

/** {@code majic}: opens the window, or the console where there is no display. */
@Command(
        name = "majic",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        sortOptions = false,
        description = "Commands a team of different robots from one window, in one small language.",
        footer = {
            "",
            "Try: majic --lab, then type: 2 move 500",
            "Exit status: 0 all went well, 1 a line failed, 2 wrong command line, 3 could not start."
        })
public final class MajicCommand implements Callable<Integer> {
    private final UserFolder folder;

    @Mixin
    private StartOptions start = new StartOptions();

    @Option(names = "--console", description = "Read MAJIC Script from standard input instead of opening the window.")
    private boolean console;

    @Option(
            names = "--reconnect",
            description = "In the console: connect robots again whose connection was lost, as the window does.")
    private boolean reconnect;

    public MajicCommand(UserFolder folder) {
        this.folder = folder;
    }

    /** Returns whether these are the usual arguments: none or {@code --lab}. */
    public static boolean isUsual(String... arguments) {
        return arguments.length == 0 || (arguments.length == 1 && arguments[0].equals("--lab"));
    }

    /**
     * Returns the command for the usual arguments, without the parser of command lines: its classes cannot be in the
     * class-data archive, and loading them delays the window by a third.
     *
     * @return empty for any other arguments
     */
    public static Optional<MajicCommand> usual(UserFolder folder, String... arguments) {
        if (!isUsual(arguments)) {
            return Optional.empty();
        }
        MajicCommand command = new MajicCommand(folder);
        command.start.useLab(arguments.length > 0);
        return Optional.of(command);
    }

    StartOptions start() {
        return start;
    }

    @Override
    public Integer call() throws IOException {
        boolean windowFirst = !console && !GraphicsEnvironment.isHeadless();
        if (windowFirst) {
            Window.preload();
        }
        try (Program program = start.program(folder, windowFirst)) {
            return console || withoutDisplay() ? console(program) : new Window(program).run(start);
        }
    }

    private static boolean withoutDisplay() {
        Optional<String> problem = Window.displayProblem();
        problem.ifPresent(sentence ->
                System.err.println("majic: " + sentence + "; this is the console (help lists the commands)"));
        return problem.isPresent();
    }

    private int console(Program program) throws IOException {
        if (reconnect) {
            program.reconnectLost();
        }
        return Console.standard(program).run(start.firstRobots(program), List.of());
    }

    /**
     * Leaves each command only those of the inherited options that it uses: {@code run} all, {@code lab} those of the
     * lab, the others none.
     *
     * @param majic the command line with all commands
     * @return the same object
     */
    public static CommandLine limitOptions(CommandLine majic) {
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
