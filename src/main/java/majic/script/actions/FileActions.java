package majic.script.actions;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.BotException;
import majic.log.ParameterLog;
import majic.script.record.SessionRecord;
import majic.script.run.CommandTrait;
import majic.script.run.Execution;
import majic.script.run.Scheduling;
import majic.script.run.ScriptFiles;
import majic.script.run.SessionAction;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.SessionCommand;
import majic.text.IoReason;

/** The commands that read or write files. */
final class FileActions {
    private FileActions() {}

    static final class RunAction extends SessionAction {
        private final Literal file;
        private final ScriptFiles files;

        RunAction(SessionCommand.Run run, ScriptFiles files) {
            super(Scheduling.BESIDE, CommandTrait.COMMANDS_ROBOTS, CommandTrait.READS_FILES, CommandTrait.CHANGES_TEAM);
            this.file = run.file();
            this.files = files;
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
            files.run(file.path(), execution);
        }
    }

    static final class SaveSessionAction extends SessionAction {
        private final Literal file;
        private final SessionRecord record;

        SaveSessionAction(SessionCommand.SaveSession save, SessionRecord record) {
            super(Scheduling.BESIDE, CommandTrait.WRITES_FILE);
            this.file = save.file();
            this.record = record;
        }

        @Override
        public void check(Check check) {
            file.path();
        }

        @Override
        public void run(Execution execution) {
            save(file, record::save);
            execution.answer("save session " + file.text() + ": done");
        }
    }

    static final class SaveLogAction extends SessionAction {
        private final Literal file;
        private final ParameterLog log;

        SaveLogAction(SessionCommand.SaveLog save, ParameterLog log) {
            super(Scheduling.BESIDE);
            this.file = save.file();
            this.log = log;
        }

        @Override
        public void check(Check check) {
            file.path();
        }

        @Override
        public void run(Execution execution) {
            if (!execution.isTyped()) {
                execution.awaitCommands(ParameterActions.LogAction::isLogging);
            }
            if (log.isEmpty()) {
                throw new BotException("save log: there are no readings yet; \"1 log x every 100ms\" takes some");
            }
            save(file, log::save);
            execution.answer("save log " + file.text() + ": done");
        }
    }

    /** Writes a file. */
    private interface Saving {
        void to(Path path) throws IOException;
    }

    private static void save(Literal file, Saving saving) {
        Path path = file.path();
        try {
            saving.to(path);
        } catch (IOException e) {
            throw new BotException(path + ": cannot be written (" + IoReason.of(e) + ")", e);
        }
    }
}
