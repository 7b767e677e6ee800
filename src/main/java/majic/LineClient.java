package majic;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.lang.System.Logger.Level;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.function.Consumer;
import majic.script.Line;
import majic.script.MajicParser;
import majic.script.Session;
import majic.script.SessionListener;

/** One program connected to a {@link LineServer}. A client that does not read its answers is dropped, not waited for. */
final class LineClient implements SessionListener {
    private static final System.Logger LOG = System.getLogger(LineClient.class.getName());
    private static final int UNREAD_LINES = 10_000;
    private static final int LONGEST_LINE = 10_000;
    private static final int LAST_ANSWERS_MS = 1000;

    /** Behind the last answer; no answer has a line end in it. */
    private static final String END = "\n";

    private final Socket socket;
    private final Session session;
    private final Consumer<LineClient> whenGone;
    private final MajicParser parser;
    private final BlockingQueue<String> answers = new ArrayBlockingQueue<>(UNREAD_LINES);
    private final Thread writer = daemon(this::write, "client writer");

    LineClient(Socket socket, Session session, Consumer<LineClient> whenGone) {
        this.socket = socket;
        this.session = session;
        this.whenGone = whenGone;
        this.parser = MajicParser.remote(session);
    }

    void start() {
        session.addListener(this);
        daemon(this::read, "client reader").start();
        writer.start();
    }

    private static Thread daemon(Runnable body, String name) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        return thread;
    }

    @Override
    public void line(Line line) {
        if (line.kind() != Line.Kind.COMMAND) {
            say(line.text());
        }
    }

    private void say(String text) {
        if (!answers.offer(text)) {
            LOG.log(Level.WARNING, "a client does not read its answers; dropped");
            close();
        }
    }

    private void read() {
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = next(lines); line != null; line = next(lines)) {
                parser.parseText(line);
                parser.awaitRoom();
            }
            parser.awaitAll();
            answers.offer(END);
            writer.join(LAST_ANSWERS_MS);
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a client is gone", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            close();
        }
    }

    /** A line, cut where no sensible one reaches, so that a client cannot fill the memory. */
    private static String next(BufferedReader in) throws IOException {
        StringBuilder line = new StringBuilder();
        int character = in.read();
        while (character >= 0 && character != '\n') {
            if (line.length() < LONGEST_LINE && character != '\r') {
                line.append((char) character);
            }
            character = in.read();
        }
        return character < 0 && line.isEmpty() ? null : line.toString();
    }

    private void write() {
        try {
            OutputStream out = socket.getOutputStream();
            for (String answer = answers.take(); !answer.equals(END); answer = answers.take()) {
                out.write((answer + "\n").getBytes(StandardCharsets.UTF_8));
                out.flush();
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a client is gone", e);
            close();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    void close() {
        session.removeListener(this);
        whenGone.accept(this);
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a client", e);
        }
        writer.interrupt();
    }
}
