package majic.stop;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import majic.link.PseudoTerminal;

/** Forwards a TCP port or a serial port of the system to a simulated robot and records the data sent to the robot. */
public final class RecordingRelay implements AutoCloseable {
    private static final int NO_ROBOT = 0;

    private final TimedBytes sent = new TimedBytes();
    private final AutoCloseable plug;
    private final String address;

    /** Forwards data. */
    private interface Sink {
        void take(String text) throws IOException;
    }

    private RecordingRelay(AutoCloseable plug, String address) {
        this.plug = plug;
        this.address = address;
    }

    /** Creates a TCP port in front of a robot's. */
    public static RecordingRelay tcp(int robotPort) throws IOException {
        ServerSocket server = new ServerSocket(0, 8, InetAddress.getLoopbackAddress());
        RecordingRelay line = new RecordingRelay(server, "//127.0.0.1:" + server.getLocalPort());
        begin(() -> {
            while (true) {
                line.connect(server.accept(), robotPort);
            }
        });
        return line;
    }

    /** Creates a TCP port of a robot that accepts all data and never answers. */
    static RecordingRelay mute() throws IOException {
        return tcp(NO_ROBOT);
    }

    /** Creates a serial port in front of a robot's TCP port. */
    public static RecordingRelay serial(int robotPort) throws IOException {
        PseudoTerminal terminal = new PseudoTerminal();
        RecordingRelay line = new RecordingRelay(terminal, terminal.name());
        Socket robot = new Socket(InetAddress.getLoopbackAddress(), robotPort);
        Sink toRobot = toSocket(robot);
        begin(() -> pump(robot.getInputStream(), terminal::write));
        begin(() -> {
            try (robot) {
                while (true) {
                    line.pass(terminal.read(), toRobot);
                }
            }
        });
        return line;
    }

    private void connect(Socket client, int robotPort) throws IOException {
        if (robotPort == NO_ROBOT) {
            begin(() -> pump(client.getInputStream(), text -> pass(text, nothing -> {})));
            return;
        }
        Socket robot = new Socket(InetAddress.getLoopbackAddress(), robotPort);
        Sink toRobot = toSocket(robot);
        begin(() -> {
            try (robot) {
                pump(client.getInputStream(), text -> pass(text, toRobot));
            }
        });
        begin(() -> {
            try (client) {
                pump(robot.getInputStream(), toSocket(client));
            }
        });
    }

    private void pass(String text, Sink robot) throws IOException {
        sent.add(text, System.nanoTime());
        robot.take(text);
    }

    private static Sink toSocket(Socket socket) throws IOException {
        OutputStream out = socket.getOutputStream();
        return text -> out.write(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    private static void pump(InputStream in, Sink sink) throws IOException {
        byte[] chunk = new byte[1024];
        for (int count = in.read(chunk); count >= 0; count = in.read(chunk)) {
            sink.take(new String(chunk, 0, count, StandardCharsets.ISO_8859_1));
        }
    }

    private interface Work {
        void run() throws IOException;
    }

    private static void begin(Work work) {
        Thread thread = new Thread(
                () -> {
                    try {
                        work.run();
                    } catch (IOException e) {
                        // one of the two ends was closed
                    }
                },
                "recorded line");
        thread.setDaemon(true);
        thread.start();
    }

    /** Returns the part of a driver's address behind the type of robot. */
    public String address() {
        return address;
    }

    /** Returns what was sent so far, with the times of its arrival. */
    public TimedBytes sent() {
        return sent;
    }

    @Override
    public void close() {
        try {
            plug.close();
        } catch (Exception e) {
            throw new UncheckedIOException(new IOException(e));
        }
    }
}
