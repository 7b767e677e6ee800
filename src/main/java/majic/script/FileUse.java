package majic.script;

import java.util.List;
import majic.script.syntax.Command;
import majic.script.syntax.SessionCommand;
import majic.script.syntax.Statement;
import majic.script.syntax.Walk;
import org.jspecify.annotations.Nullable;

/** Finds out whether checking a script reads files, which may block, and so has to wait for the source's own worker. */
final class FileUse extends Walk {
    private boolean found;

    private FileUse() {}

    static boolean in(Statement statement) {
        FileUse use = new FileUse();
        use.walk(List.of(statement));
        return use.found;
    }

    /** Whether checking a command reads a file. */
    static boolean by(SessionCommand command) {
        return command instanceof SessionCommand.Run
                || command instanceof SessionCommand.Trust
                || command instanceof SessionCommand.TrustOff;
    }

    @Override
    public @Nullable Void forRobots(Statement.ForRobots line) {
        found |= line.command() instanceof Command.Act;
        return null;
    }

    @Override
    public @Nullable Void forSession(Statement.ForSession line) {
        found |= by(line.command());
        return null;
    }
}
