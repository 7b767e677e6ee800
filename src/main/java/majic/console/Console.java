package majic.console;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.util.List;
import java.util.function.Consumer;
import majic.log.Line;
import majic.log.SessionListener;
import majic.program.Failures;
import majic.program.FirstRobots;
import majic.program.Program;
import majic.script.MajicParser;
import org.jspecify.annotations.Nullable;

/**
 * Runs MAJIC Script from standard input. At a terminal it has a prompt, history and completion; in a pipe it prints one
 * answer per line and ends at the end of the input, after all commands are finished.
 */
public final class Console {
    private final Program program;
    private final Source source;
    private final MajicParser parser;
    private volatile boolean added = true;

    /** Provides lines and shows answers. */
    public interface Source extends AutoCloseable {
        /** Returns the next line; null at the end. Blocks. */
        @Nullable
        String next() throws IOException;

        /** Shows a line, from any thread. */
        void show(String line);

        /**
         * Offers to ask for the user name and the password of a broker that refused those it was given, from any
         * thread.
         *
         * @param address an address at the broker
         * @param again the line that is to be run then; {@link #next} returns it
         */
        default void offerLogin(String address, String again) {}

        /** Returns whether a user enters the lines interactively. */
        boolean interactive();

        @Override
        void close() throws IOException;
    }

    public Console(Program program, Source source) {
        this.program = program;
        this.source = source;
        this.parser =
                source.interactive() ? MajicParser.prompt(program.session()) : MajicParser.pipe(program.session());
    }

    /** Creates a console for standard input, at a terminal or in a pipe. */
    public static Console standard(Program program) throws IOException {
        return System.console() == null || System.getenv("TERM") == null
                ? new Console(program, new Pipe(System.in, System.out))
                : new Console(program, new Terminal(program));
    }

    /** Creates a console without input, which runs only the lines it is given. */
    public static Console silent(Program program) {
        return new Console(program, new Pipe(InputStream.nullInputStream(), System.out));
    }

    /**
     * Adds robots, then runs some lines and those of the input, until the end or until the program is asked to quit. At
     * a terminal the prompt does not wait for the robots.
     *
     * @param adding the robots to add
     * @param lines the lines to run before any input is read
     * @return the exit status: 0 only if every line succeeded
     */
    public int run(FirstRobots adding, List<String> lines) {
        program.session().addListener(new Listener());
        program.announce();
        if (source.interactive()) {
            start("adding robots", () -> add(adding));
            start("console", () -> read(lines));
        } else {
            start("console", () -> {
                add(adding);
                read(lines);
            });
        }
        try {
            program.awaitQuit();
            program.session().flush();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return added && parser.allSucceeded() ? 0 : Failures.FAILED;
    }

    private static void start(String name, Runnable body) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        thread.start();
    }

    private void add(FirstRobots adding) {
        try {
            added = program.addFirst(adding);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void read(List<String> firstLines) {
        try (source) {
            firstLines.forEach(parser::parseText);
            int number = 0;
            for (String line = source.next(); line != null && !program.isQuitting(); line = source.next()) {
                take(line, ++number);
                parser.awaitRoom();
            }
            if (!source.interactive()) {
                parser.awaitAll();
            }
        } catch (IOException e) {
            source.show("the input broke: " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            program.quit();
        }
    }

    /**
     * Runs a line. In a pipe, an error names the line's number: at a terminal the refused line is visible, in the
     * output of a pipe it is not.
     */
    private void take(String line, int number) {
        if (source.interactive()) {
            parser.parseText(line);
        } else {
            parser.parseLine(number, line);
        }
    }

    /** Shows the answers of the session, and passes its requests for a password on. */
    private final class Listener implements SessionListener {
        @Override
        public void line(Line line) {
            if (line.kind() != Line.Kind.COMMAND) {
                source.show(line.text());
            }
        }

        @Override
        public void loginRefused(String address, String again) {
            source.offerLogin(address, again);
        }
    }

    /** Reads the lines of a pipe or file. */
    private static final class Pipe implements Source {
        private final BufferedReader in;
        private final Consumer<String> out;

        Pipe(InputStream in, PrintStream out) {
            this.in = new BufferedReader(new InputStreamReader(in, Charset.defaultCharset()));
            this.out = out::println;
        }

        @Override
        public @Nullable String next() throws IOException {
            return in.readLine();
        }

        @Override
        public void show(String line) {
            out.accept(line);
        }

        @Override
        public boolean interactive() {
            return false;
        }

        @Override
        public void close() throws IOException {
            in.close();
        }
    }
}
