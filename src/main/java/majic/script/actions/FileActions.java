package majic.script.actions;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.BotException;
import majic.file.DamagedFile;
import majic.file.RegularFile;
import majic.file.WholeFile;
import majic.log.ParameterLog;
import majic.script.record.SessionRecord;
import majic.script.run.Execution;
import majic.script.run.ScriptFiles;
import majic.script.run.SessionAction;
import majic.script.syntax.Literal;
import majic.script.syntax.ScriptException;
import majic.script.syntax.SessionCommand;
import majic.text.IoReason;
import majic.text.VisibleText;

/** The commands that read or write files. */
final class FileActions {
    private FileActions() {}

    static final class RunAction implements SessionAction {
        private final Literal file;
        private final ScriptFiles files;

        RunAction(SessionCommand.Run run, ScriptFiles files) {
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

    /** Writes a file. */
    private abstract static class SaveAction implements SessionAction {
        private final String what;
        private final Literal file;

        SaveAction(String what, Literal file) {
            this.what = what;
            this.file = file;
        }

        /** Waits until there is all that is to be written. */
        abstract void prepare(Execution execution);

        /** Replaces the file as a whole. */
        abstract void write(Path path) throws IOException;

        /** Does what is needed before an existing file is replaced; returns what the answer adds. */
        String beforeReplacing(Path path) throws IOException {
            return "";
        }

        @Override
        public final void check(Check check) {
            file.path();
        }

        @Override
        public final void run(Execution execution) {
            prepare(execution);
            Path path = file.path();
            String done;
            try {
                done = "done" + beforeReplacing(path);
                write(path);
            } catch (IOException e) {
                throw new BotException(path + ": cannot be written (" + IoReason.of(e) + ")", e);
            }
            execution.answer(what + " " + file.text() + ": " + done);
        }
    }

    static final class SaveSessionAction extends SaveAction {
        private final SessionRecord record;

        SaveSessionAction(SessionCommand.SaveSession save, SessionRecord record) {
            super("save session", save.file());
            this.record = record;
        }

        @Override
        void prepare(Execution execution) {}

        @Override
        void write(Path path) throws IOException {
            record.save(path);
        }
    }

    static final class SaveTeamAction extends SaveAction {
        private final TeamScript team;

        SaveTeamAction(SessionCommand.SaveTeam save, TeamScript team) {
            super("save team", save.file());
            this.team = team;
        }

        @Override
        void prepare(Execution execution) {
            if (team.isEmpty()) {
                throw new BotException("save team: there are no robots yet; \"add\" connects one");
            }
        }

        /** A saved team that is damaged may be the only record of calibrations. */
        @Override
        String beforeReplacing(Path path) throws IOException {
            if (!Files.isRegularFile(path)
                    || !DamagedFile.isDamagedText(RegularFile.read(path, ScriptFiles.LARGEST_BYTES))) {
                return "";
            }
            return "; the file that was there is damaged and is kept as "
                    + VisibleText.of(DamagedFile.rename(path).toString());
        }

        @Override
        void write(Path path) throws IOException {
            WholeFile.replace(path, team.text());
        }
    }

    static final class SaveLogAction extends SaveAction {
        private final ParameterLog log;

        SaveLogAction(SessionCommand.SaveLog save, ParameterLog log) {
            super("save log", save.file());
            this.log = log;
        }

        @Override
        void prepare(Execution execution) {
            if (!execution.isTyped()) {
                execution.waits().awaitCommands(ParameterActions.LogAction::isLogging);
            }
            if (log.isEmpty()) {
                throw new BotException("save log: there are no readings yet; \"1 log x every 100ms\" takes some");
            }
        }

        @Override
        void write(Path path) throws IOException {
            log.save(path);
        }
    }
}
