package majicsim.aibo;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A client that reads as the original libraries do (URBI sheet, section 4, reader algorithm); it blocks, with a
 * time-out.
 */
final class UrbiClient implements AutoCloseable {
    private static final Pattern MESSAGE = Pattern.compile("\\[(\\d{8,}):([A-Za-z0-9_.]*)] (.*)");
    private static final Pattern BINARY = Pattern.compile("BIN (\\d+).*");
    private static final int TIME_OUT_MS = 60_000;

    /** One message; a binary's bytes stand behind its header and a line feed. */
    record Message(String tag, String body) {}

    /** What is done again until something comes. */
    interface Attempt {
        void make() throws IOException;
    }

    private final Socket socket;
    private final InputStream input;

    UrbiClient(int port) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(TIME_OUT_MS);
        socket.setTcpNoDelay(true);
        input = new BufferedInputStream(socket.getInputStream());
    }

    void send(String text) throws IOException {
        socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** The body of the next message with that tag; others are passed over. */
    String await(String tag) throws IOException {
        Message message = next();
        while (!message.tag().equals(tag)) {
            message = next();
        }
        return message.body();
    }

    /** The same, with something done after each other message. */
    String awaitAmong(String tag, Attempt attempt) throws IOException {
        Message message = next();
        while (!message.tag().equals(tag)) {
            attempt.make();
            message = next();
        }
        return message.body();
    }

    Message next() throws IOException {
        String line = line();
        Matcher matcher = MESSAGE.matcher(line);
        if (!matcher.matches()) {
            throw new IOException("no message: " + line);
        }
        String body = matcher.group(3);
        Matcher binary = BINARY.matcher(body);
        if (binary.matches()) {
            byte[] bytes = input.readNBytes(Integer.parseInt(binary.group(1)));
            body += "\n" + new String(bytes, StandardCharsets.ISO_8859_1);
        }
        return new Message(matcher.group(2), body);
    }

    /** Closes the half of the connection on which it sends. */
    void endSending() throws IOException {
        socket.shutdownOutput();
    }

    /** Goes as a process does that is killed: without a farewell. */
    void kill() throws IOException {
        socket.setSoLinger(true, 0);
        socket.close();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }

    private String line() throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        for (int c = input.read(); c != '\n'; c = input.read()) {
            if (c < 0) {
                throw new EOFException("the server hung up after: " + line);
            }
            line.write(c);
        }
        return line.toString(StandardCharsets.ISO_8859_1);
    }
}
