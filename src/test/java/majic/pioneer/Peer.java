package majic.pioneer;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Command;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipBytes;
import org.jspecify.annotations.Nullable;

/**
 * A peer on loopback that behaves as a test wants a Pioneer to: it answers the handshake and sends a SIP every 100 ms
 * from a model with ramps. Stricter than a robot nowhere, worse wherever a test says so.
 */
final class Peer implements AutoCloseable {
    private final ServerSocket server;
    private final List<String> heard = new CopyOnWriteArrayList<>();
    private final RampModel robot = new RampModel(300, 300, 100);
    private final ScheduledThreadPoolExecutor clock = new ScheduledThreadPoolExecutor(1);
    private final Quirk quirk;
    private volatile @Nullable Socket client;
    private volatile boolean sendsSips;
    private volatile boolean motors;
    private volatile int stallBits;
    private volatile int extraFlags;
    private int syncs;
    private boolean shaken;

    /** How it misbehaves. */
    enum Quirk {
        NONE,
        IN_OPEN_SESSION,
        LOSES_STEP_ONCE,
        DEAF_TO_FIRST_SYNC,
        HANGS_UP,
        NEVER_ANSWERS,
        NO_CONFIG,
        STICKS_WHEN_SLOW
    }

    Peer(Quirk quirk) throws IOException {
        this.quirk = quirk;
        this.server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        this.sendsSips = quirk == Quirk.IN_OPEN_SESSION;
        this.motors = sendsSips;
        clock.setRemoveOnCancelPolicy(true);
        Thread acceptor = new Thread(this::accept, "peer");
        acceptor.setDaemon(true);
        acceptor.start();
        clock.scheduleAtFixedRate(this::tick, 100, 100, TimeUnit.MILLISECONDS);
    }

    static Sip sip(int x, int y, int heading) {
        return new SipBytes().pose(x, y, heading).sip();
    }

    String address() {
        return "//127.0.0.1:" + server.getLocalPort();
    }

    /** What it heard, as {@code "VEL 250"}; the handshake not counted. */
    List<String> heard() {
        return heard;
    }

    /** Waits for a command to arrive, a second at most. */
    synchronized boolean hears(String command) throws InterruptedException {
        long deadline = System.nanoTime() + 1_000_000_000;
        while (!heard.contains(command) && System.nanoTime() < deadline) {
            wait(100);
        }
        return heard.contains(command);
    }

    /** Waits, a second at most, until these are the last commands it heard, pulses not counted. */
    synchronized boolean hearsLast(String... commands) throws InterruptedException {
        long deadline = System.nanoTime() + 1_000_000_000;
        while (!endsWith(commands) && System.nanoTime() < deadline) {
            wait(100);
        }
        return endsWith(commands);
    }

    private boolean endsWith(String... commands) {
        List<String> orders =
                heard.stream().filter(command -> !command.equals("PULSE 0")).toList();
        int from = Math.max(0, orders.size() - commands.length);
        return orders.subList(from, orders.size()).equals(List.of(commands));
    }

    void fallSilent() {
        sendsSips = false;
    }

    void stall() {
        stallBits = 0x0101;
    }

    void pressStopButton() {
        extraFlags = 1 << 5;
    }

    void hangUp() throws IOException {
        Socket open = client;
        if (open != null) {
            open.close();
        }
    }

    private void accept() {
        try {
            while (true) {
                Socket open = server.accept();
                open.setTcpNoDelay(true);
                client = open;
                shaken = quirk == Quirk.IN_OPEN_SESSION && heard.isEmpty();
                serve(open);
            }
        } catch (IOException e) {
            client = null;
        }
    }

    private void serve(Socket open) {
        FrameDecoder decoder = new FrameDecoder();
        byte[] chunk = new byte[512];
        try {
            for (int count = open.getInputStream().read(chunk);
                    count >= 0;
                    count = open.getInputStream().read(chunk)) {
                decoder.feed(chunk, count, this::received);
            }
        } catch (IOException e) {
            sendsSips = false;
        }
    }

    private synchronized void received(Packet packet) {
        if (!shaken) {
            sync(packet);
            return;
        }
        obey(packet.type(), argument(packet.data()));
    }

    private static int argument(byte[] data) {
        int magnitude = data.length < 3 ? 0 : data[1] & 0xFF | (data[2] & 0xFF) << 8;
        return data.length > 0 && data[0] == 0x1B ? -magnitude : magnitude;
    }

    private void sync(Packet packet) {
        syncs++;
        if (quirk == Quirk.NEVER_ANSWERS || quirk == Quirk.DEAF_TO_FIRST_SYNC && syncs == 1) {
            return;
        }
        if (quirk == Quirk.HANGS_UP) {
            closeClient();
        } else if (quirk == Quirk.LOSES_STEP_ONCE && syncs == 2) {
            send(0xFF, new byte[0]);
        } else if (packet.type() < 2) {
            send(packet.type(), new byte[0]);
        } else {
            shaken = true;
            send(2, "Peer\0Pioneer\0p3dx-sh\0".getBytes(StandardCharsets.US_ASCII));
        }
    }

    private void obey(int number, int value) {
        heard.add(name(number) + " " + value);
        notifyAll();
        switch (number) {
            case 1 -> sendsSips = true;
            case 2 -> endSession();
            case 4 -> motors = value != 0;
            case 11 -> robot.speed(motors && !isStuckAt(value) ? value : 0);
            case 18 -> config();
            case 21 -> robot.rate(motors ? value : 0);
            case 29 -> {
                robot.speed(0);
                robot.rate(0);
            }
            default -> {}
        }
    }

    private boolean isStuckAt(int speed) {
        return quirk == Quirk.STICKS_WHEN_SLOW && Math.abs(speed) < 20;
    }

    /** A serial line's other end does not hang up. */
    private void endSession() {
        sendsSips = false;
        shaken = false;
        if (quirk != Quirk.IN_OPEN_SESSION) {
            closeClient();
        }
    }

    private void config() {
        if (quirk != Quirk.NO_CONFIG) {
            byte[] whole = Bytes.of(Bytes.CONFIG);
            send(0x20, Arrays.copyOfRange(whole, 4, whole.length - 2));
        }
    }

    private static String name(int number) {
        for (Command command : Command.values()) {
            if (command.number() == number) {
                return command.name();
            }
        }
        return "number " + number;
    }

    private synchronized void tick() {
        for (int step = 0; step < 20; step++) {
            robot.step(0.005);
        }
        if (sendsSips) {
            send(0x32, sipData());
        }
    }

    private byte[] sipData() {
        return robot.sipData((motors ? 0x1F : 0x1E) | extraFlags, stallBits);
    }

    private void send(int type, byte[] data) {
        Socket open = client;
        if (open != null && !open.isClosed()) {
            try {
                OutputStream stream = open.getOutputStream();
                stream.write(Bytes.wire(type, data));
            } catch (IOException e) {
                sendsSips = false;
            }
        }
    }

    private void closeClient() {
        try {
            hangUp();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() throws IOException {
        clock.shutdownNow();
        server.close();
        hangUp();
    }
}
