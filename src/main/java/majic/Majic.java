package majic;

import java.io.IOException;
import majic.cli.ActCommand;
import majic.cli.ClassDataCommand;
import majic.cli.KeyCommand;
import majic.cli.LabCommand;
import majic.cli.MajicCommand;
import majic.cli.MapCommand;
import majic.cli.NewCommand;
import majic.cli.PackageCommand;
import majic.cli.RunCommand;
import majic.program.Failures;
import majic.program.LogSetup;
import majic.program.UserFolder;
import majic.program.Window;
import picocli.CommandLine;

/** Starts MAJIC. */
public final class Majic {
    private Majic() {}

    /**
     * Starts the program and ends it with its exit status: 0 if all went well, 1 if a line of a console or script
     * failed, 2 for a wrong command line, 3 if the window or the lab could not start.
     *
     * @param args the command line; see {@code --help}
     */
    public static void main(String[] args) {
        UserFolder folder = UserFolder.standard();
        LogSetup.install(folder.path(), System.getProperty("majic.log", "INFO"));
        if (MajicCommand.isUsual(args)) {
            Window.preload();
        }
        int status = run(folder, args);
        System.exit(status);
    }

    static int run(UserFolder folder, String... args) {
        return MajicCommand.usual(folder, args)
                .map(command -> start(folder, command))
                .orElseGet(() -> commandLine(folder).execute(args));
    }

    private static int start(UserFolder folder, MajicCommand command) {
        try {
            return command.call();
        } catch (IOException | RuntimeException e) {
            return Failures.explain(commandLine(folder), e);
        }
    }

    /**
     * Returns the command line with all commands and options.
     *
     * @param folder the folder of the user that its commands use
     * @return a new one
     */
    public static CommandLine commandLine(UserFolder folder) {
        return MajicCommand.limitOptions(new CommandLine(new MajicCommand(folder))
                        .addSubcommand(new LabCommand())
                        .addSubcommand(new RunCommand(folder))
                        .addSubcommand(new KeyCommand(folder))
                        .addSubcommand(new ActCommand())
                        .addSubcommand(new MapCommand())
                        .addSubcommand(new NewCommand())
                        .addSubcommand(new PackageCommand())
                        .addSubcommand(new ClassDataCommand()))
                .setExecutionExceptionHandler((problem, command, parsed) -> Failures.explain(command, problem))
                .setParameterExceptionHandler((problem, parsed) -> Failures.usage(problem))
                .setCaseInsensitiveEnumValuesAllowed(true);
    }
}
