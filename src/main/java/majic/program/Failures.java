package majic.program;

import java.io.IOException;
import java.io.PrintWriter;
import java.lang.System.Logger.Level;
import java.nio.file.FileSystemException;
import majic.bot.BotException;
import majic.text.IoReason;
import majic.text.VisibleText;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Converts an error at the start into one sentence and an exit status. */
public final class Failures {
    /** Exit status: a line failed. */
    public static final int FAILED = 1;

    /** Exit status: the command line is wrong. */
    public static final int USAGE = 2;

    /** Exit status: window or lab did not start. */
    static final int NO_START = 3;

    private static final System.Logger LOG = System.getLogger(Failures.class.getName());

    private Failures() {}

    public static int usage(ParameterException problem) {
        PrintWriter err = problem.getCommandLine().getErr();
        err.println("majic: " + plain(problem));
        if (!UnmatchedArgumentException.printSuggestions(problem, err)) {
            err.println("majic: --help lists what can be said");
        }
        err.flush();
        return USAGE;
    }

    /** Rewrites messages of the command-line parser that name Java types, such as for numbers. */
    private static String plain(ParameterException problem) {
        return String.valueOf(problem.getMessage())
                .replaceFirst("is not an? (long|int)$", "is not a whole number")
                .replaceFirst("is not a double$", "is not a number");
    }

    /** Prints why a request cannot be carried out, and returns the exit status. */
    public static int failed(CommandLine command, BotException problem) {
        LOG.log(Level.DEBUG, "a command failed", problem);
        say(command, problem);
        return FAILED;
    }

    private static void say(CommandLine command, Exception problem) {
        PrintWriter err = command.getErr();
        err.println("majic: " + VisibleText.of(sentence(problem)));
        err.flush();
    }

    public static int explain(CommandLine command, Exception problem) {
        LOG.log(Level.ERROR, "could not start", problem);
        say(command, problem);
        return problem instanceof UsageException ? USAGE : NO_START;
    }

    private static String sentence(Exception problem) {
        if (problem instanceof FileSystemException refused) {
            return refused.getFile() + ": " + IoReason.of(refused);
        }
        if (problem instanceof UsageException
                || problem instanceof BotException
                || problem instanceof IOException
                || problem instanceof Window.WindowFailed) {
            return String.valueOf(problem.getMessage());
        }
        return "an error in MAJIC, see majic.0.log in its folder";
    }
}
