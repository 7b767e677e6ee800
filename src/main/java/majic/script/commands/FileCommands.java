package majic.script.commands;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.file.DamagedFile;
import majic.file.RegularFile;
import majic.file.WholeFile;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.ScriptSource;
import majic.script.run.SessionCommand;
import majic.script.run.SessionState;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.text.IoReason;
import majic.text.VisibleText;

/** The commands that read or write files. */
final class FileCommands {
    private FileCommands() {}

    /** Runs a script from a file. */
    record Run(Literal file) implements SessionCommand {
        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS, CommandTrait.READS_FILES, CommandTrait.CHANGES_TEAM);
        }

        @Override
        public void check(Check check) {
            if (check.filesMayAppear()) {
                return;
            }
            Path path = file.path();
            if (!Files.exists(path)) {
                throw new ScriptException(file.at(), file.text() + ": there is no such file");
            }
            if (!Files.isRegularFile(path)) {
                throw new ScriptException(file.at(), file.text() + ": not a file with a script");
            }
        }

        @Override
        public void run(Execution execution) {
            new ScriptFiles(execution.session()).run(file.path(), execution);
        }
    }

    /** Writes a file. */
    private interface SaveCommand extends SessionCommand {
        /** The words of the command, as its answer repeats them. */
        String what();

        Literal file();

        /** Waits until there is all that is to be written; throws a {@link BotException} if there is nothing. */
        default void prepare(Execution execution) {}

        /** Replaces the file as a whole. */
        void write(Path path, SessionState session) throws IOException;

        /** Does what is needed before an existing file is replaced; returns what the answer adds. */
        default String beforeReplacing(Path path) throws IOException {
            return "";
        }

        @Override
        default Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        default List<CommandTrait> traits() {
            return List.of(CommandTrait.WRITES_FILE);
        }

        @Override
        default void check(Check check) {
            file().path();
        }

        @Override
        default void run(Execution execution) {
            prepare(execution);
            Path path = file().path();
            String done;
            try {
                done = "done" + beforeReplacing(path);
                write(path, execution.session());
            } catch (IOException e) {
                throw new BotException(path + ": cannot be written (" + IoReason.of(e) + ")", e);
            }
            execution.answer(what() + " " + file().text() + ": " + done);
        }
    }

    /** Writes what was done in the session as a script. */
    record SaveSession(Literal file) implements SaveCommand {
        @Override
        public String what() {
            return "save session";
        }

        @Override
        public void write(Path path, SessionState session) throws IOException {
            session.record().save(path);
        }
    }

    /** Writes the robots of the team as a script that adds them. */
    record SaveTeam(Literal file) implements SaveCommand {
        @Override
        public String what() {
            return "save team";
        }

        @Override
        public void prepare(Execution execution) {
            if (TeamScript.of(execution.session()).isEmpty()) {
                throw new BotException("save team: there are no robots yet; \"add\" connects one");
            }
        }

        /** A saved team that is damaged may be the only record of calibrations. */
        @Override
        public String beforeReplacing(Path path) throws IOException {
            if (!Files.isRegularFile(path)
                    || !DamagedFile.isDamagedText(RegularFile.read(path, ScriptSource.LARGEST_BYTES))) {
                return "";
            }
            return "; the file that was there is damaged and is kept as "
                    + VisibleText.of(DamagedFile.rename(path).toString());
        }

        @Override
        public void write(Path path, SessionState session) throws IOException {
            WholeFile.replace(path, TeamScript.of(session).text());
        }
    }

    /** Writes the parameter log as CSV. */
    record SaveLog(Literal file) implements SaveCommand {
        @Override
        public String what() {
            return "save log";
        }

        @Override
        public void prepare(Execution execution) {
            if (!execution.isTyped()) {
                execution.awaitCommands(ParameterCommands::isLogging);
            }
            if (execution.session().parameterLog().isEmpty()) {
                throw new BotException("save log: there are no readings yet; \"1 log x every 100ms\" takes some");
            }
        }

        @Override
        public void write(Path path, SessionState session) throws IOException {
            session.parameterLog().save(path);
        }
    }

    /** Writes the map, as {@code office.yaml} and {@code office.pgm} for {@code office}. */
    record SaveMap(Literal file) implements SaveCommand {
        private static final Pattern ENDING = Pattern.compile("(?i)\\.ya?ml$");

        @Override
        public String what() {
            return "map save";
        }

        @Override
        public void write(Path path, SessionState session) throws IOException {
            String name = String.valueOf(path.getFileName());
            session.map().save(ENDING.matcher(name).find() ? path : path.resolveSibling(name + ".yaml"));
        }
    }
}
