package majic.hemisson;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;

/** A peer behind a loopback socket that answers commands as told, and remembers what it heard and when. */
final class ScriptedHemisson implements AutoCloseable {
    /** A command and when it arrived. */
    record Heard(String command, long nanos) {}

    private final ServerSocket server;
    private final List<Heard> heard = new CopyOnWriteArrayList<>();
    private final Map<Character, Function<String, String>> answers = new ConcurrentHashMap<>();
    private volatile String speeds = "00,00";
    private volatile boolean silent;
    private volatile Socket client;
    private volatile byte[] greeting = {};

    ScriptedHemisson() throws IOException {
        server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        answers.put('B', command -> "b,HemiOS_v_1.50");
        answers.put('I', command -> "i,1,1,1,1");
        answers.put('N', command -> "n,004,004,004,004,004,004,060,080");
        answers.put('O', command -> "o,220,220,220,220,220,220,220,200");
        answers.put('E', command -> "e," + speeds);
        answers.put('H', command -> "h");
        answers.put('J', command -> "j");
        answers.put('T', command -> "t,000");
        answers.put('L', command -> "l");
        answers.put('D', this::setSpeeds);
        Thread thread = new Thread(this::serve, "scripted hemisson");
        thread.setDaemon(true);
        thread.start();
    }

    String address() {
        return "tcp://127.0.0.1:" + server.getLocalPort();
    }

    void answer(char command, Function<String, String> answer) {
        answers.put(command, answer);
    }

    void greetWith(byte... bytes) {
        greeting = bytes;
    }

    void fallSilent(boolean now) {
        silent = now;
    }

    void hangUp() throws IOException {
        client.close();
    }

    String hangUpInsteadOfAnswering() {
        try {
            hangUp();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return "";
    }

    void say(String line) throws IOException {
        client.getOutputStream().write((line + "\r\n").getBytes(StandardCharsets.ISO_8859_1));
    }

    List<Heard> heard() {
        return heard;
    }

    List<String> commands() {
        return heard.stream().map(Heard::command).toList();
    }

    long count(String command) {
        return commands().stream().filter(command::equals).count();
    }

    private String setSpeeds(String command) {
        String[] parts = command.split(",");
        speeds = padded(parts[1]) + "," + padded(parts[2]);
        return "d";
    }

    private static String padded(String digit) {
        return digit.startsWith("-") ? digit : "0" + digit;
    }

    private void serve() {
        while (!server.isClosed()) {
            try (Socket accepted = server.accept()) {
                client = accepted;
                accepted.setTcpNoDelay(true);
                accepted.getOutputStream().write(greeting);
                converse(accepted.getInputStream(), accepted.getOutputStream());
            } catch (IOException e) {
                continue;
            }
        }
    }

    private void converse(InputStream in, OutputStream out) throws IOException {
        StringBuilder command = new StringBuilder();
        for (int next = in.read(); next >= 0; next = in.read()) {
            if (next != '\r') {
                command.append((char) next);
                continue;
            }
            heard.add(new Heard(command.toString(), System.nanoTime()));
            if (!silent) {
                out.write((answerTo(command.toString()) + "\r\n").getBytes(StandardCharsets.ISO_8859_1));
            }
            command.setLength(0);
        }
    }

    private String answerTo(String command) {
        Function<String, String> answer = command.isEmpty() ? null : answers.get(command.charAt(0));
        return answer == null ? "Unknown Command ?!" : answer.apply(command);
    }

    @Override
    public void close() throws IOException {
        server.close();
        if (client != null) {
            client.close();
        }
    }
}
