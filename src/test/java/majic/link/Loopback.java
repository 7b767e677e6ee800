package majic.link;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.concurrent.ThreadLocalRandom;

/** Provides free ports for peers that tests play. */
public final class Loopback {
    private static final int FIRST = 10_000;
    private static final int END = 32_000;

    private Loopback() {}

    /** Listens at a free port of this computer only. */
    public static ServerSocket listen() {
        try {
            return new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Returns a port at which nothing listens. The system gives ports of this range to no program that asks for any
     * free one, so no other test takes it meanwhile.
     */
    public static int freePort() {
        while (true) {
            int port = ThreadLocalRandom.current().nextInt(FIRST, END);
            try (ServerSocket free = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
                return free.getLocalPort();
            } catch (BindException e) {
                // Another program uses it.
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }
}
