package majic.console;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import majic.file.NativeFolder;
import majic.program.Program;
import majic.program.ProgramSharing;
import majic.script.MajicParser;
import majic.script.help.Completion;
import majic.script.help.Completions;
import majic.text.VisibleText;
import org.jline.reader.Candidate;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.ParsedLine;
import org.jline.reader.UserInterruptException;
import org.jline.reader.impl.DefaultParser;
import org.jline.terminal.TerminalBuilder;
import org.jspecify.annotations.Nullable;

/** Reads lines at a terminal: prompt, history, completion; answers appear above the line being typed. */
final class Terminal implements Console.Source {
    private static final Logger LOG = System.getLogger(Terminal.class.getName());
    private static final String PROMPT = "majic> ";

    private final org.jline.terminal.Terminal terminal;
    private final LineReader reader;
    private final LoginQuestion login;

    /**
     * Opens the terminal for reading lines.
     *
     * @param program provides the session
     * @throws IOException if the terminal cannot be used
     */
    Terminal(Program program) throws IOException {
        MajicParser completions = MajicParser.prompt(program.session());
        prepareNativeCode();
        terminal = TerminalBuilder.builder().system(true).build();
        DefaultParser plain = new DefaultParser();
        plain.setEscapeChars(new char[0]);
        plain.setQuoteChars(new char[0]);
        reader = LineReaderBuilder.builder()
                .terminal(terminal)
                .appName("MAJIC")
                .parser(plain)
                .completer((line, typed, found) -> complete(completions, typed, found))
                .variable(LineReader.HISTORY_FILE, program.folder().file("history"))
                .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true)
                .build();
        login = new LoginQuestion(
                new Answers(LineReaderBuilder.builder().terminal(terminal).build(), completions, program.sharing()));
    }

    /** Without native code JLine controls the terminal by other programs. */
    private static void prepareNativeCode() {
        try {
            NativeFolder.prepare();
        } catch (IOException e) {
            LOG.log(Level.INFO, e.getMessage());
        }
    }

    /** Reads answers, which are neither completed nor kept in the history. */
    private record Answers(LineReader answers, MajicParser parser, ProgramSharing sharing)
            implements LoginQuestion.Prompts {
        @Override
        public @Nullable String text(String prompt) {
            try {
                return answers.readLine(prompt);
            } catch (UserInterruptException | EndOfFileException e) {
                return null;
            }
        }

        @Override
        public char @Nullable [] secret(String prompt) {
            try {
                return answers.readLine(prompt, '\0').toCharArray();
            } catch (UserInterruptException | EndOfFileException e) {
                return null;
            }
        }

        @Override
        public boolean isStop(String answer) {
            return parser.isStop(answer);
        }

        @Override
        public void use(String address, String user, char[] password) {
            sharing.useLogin(address, user, password);
        }
    }

    private static void complete(MajicParser completions, ParsedLine typed, List<Candidate> found) {
        Completions completed = completions.complete(typed.line(), typed.cursor());
        int word = typed.cursor() - typed.wordCursor();
        for (Completion entry : completed.entries()) {
            if (!entry.isHint()) {
                found.add(candidate(entry, typed.line(), word, completed.start()));
            }
        }
    }

    /**
     * Makes a candidate for the terminal, which replaces all that stands together, while a completion may replace only
     * the end of that, or begin before it.
     */
    private static Candidate candidate(Completion entry, String line, int word, int start) {
        String text = entry.text();
        String value = start >= word ? line.substring(word, start) + text : text.substring(word - start);
        String note = VisibleText.of((entry.values() + "  " + entry.explanation()).strip());
        return new Candidate(
                value, VisibleText.of(text), null, note.isEmpty() ? null : note, null, null, !Completion.goesOn(text));
    }

    @Override
    public @Nullable String next() {
        try {
            String line = reader.readLine(PROMPT);
            return line.isBlank() ? login.ask() : line;
        } catch (UserInterruptException | EndOfFileException e) {
            return null;
        }
    }

    @Override
    public void show(String line) {
        reader.printAbove(line);
    }

    @Override
    public void offerLogin(String address, String again) {
        login.note(address, again).ifPresent(this::show);
    }

    @Override
    public boolean interactive() {
        return true;
    }

    @Override
    public void close() throws IOException {
        terminal.close();
    }
}
