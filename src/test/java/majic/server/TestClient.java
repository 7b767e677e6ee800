package majic.server;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import majic.time.WaitLimit;

/** A client of a line server. */
final class TestClient implements AutoCloseable {
    private final Socket socket;
    private final BufferedReader answers;

    TestClient(Socket socket) throws IOException {
        this.socket = socket;
        socket.setSoTimeout(WaitLimit.MS);
        answers = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
    }

    /** Connects without TLS. */
    static TestClient of(LineServer server) throws IOException {
        return new TestClient(new Socket(InetAddress.getLoopbackAddress(), server.port()));
    }

    /** Connects without TLS and sends the token. */
    static TestClient admitted(LineServer server) throws IOException {
        return of(server).say(server.token().orElseThrow().word());
    }

    TestClient say(String... lines) throws IOException {
        return sayRaw(String.join("\n", lines) + "\n");
    }

    TestClient sayRaw(String text) throws IOException {
        return sayBytes(text.getBytes(StandardCharsets.UTF_8));
    }

    TestClient sayBytes(byte[] bytes) throws IOException {
        socket.getOutputStream().write(bytes);
        return this;
    }

    String next() throws IOException {
        return answers.readLine();
    }

    /** Returns whether an answer has arrived that was not read yet. */
    boolean hasAnswer() throws IOException {
        return answers.ready();
    }

    /**
     * Returns the first answer that contains a text; null if the connection ends before. Fails if none comes in time.
     */
    String await(String part) throws IOException {
        String last = "none";
        try {
            String line = next();
            while (line != null && !line.contains(part)) {
                last = line;
                line = next();
            }
            return line;
        } catch (SocketTimeoutException e) {
            throw new AssertionError("timed out waiting for an answer with: " + part + "; the last answer: " + last, e);
        }
    }

    /** Ends the sending direction and returns all further answers. */
    List<String> all() throws IOException {
        socket.shutdownOutput();
        return answers.lines().toList();
    }

    List<String> untilItIsClosed() {
        List<String> all = new ArrayList<>();
        try {
            for (String line = next(); line != null; line = next()) {
                all.add(line);
            }
        } catch (IOException e) {
            all.add("reset");
        }
        return all;
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
