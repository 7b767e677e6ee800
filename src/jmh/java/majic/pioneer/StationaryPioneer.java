package majic.pioneer;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import majic.StandingRobot;
import majic.pioneer.arcos.Bytes;

/**
 * A Pioneer for benchmarks: answers the handshake, reports every 100 ms that it is stationary with its motors on, and
 * discards all other packets.
 */
final class StationaryPioneer {
    private static final int SYNC2 = 2;

    private StationaryPioneer() {}

    static StandingRobot open() throws IOException {
        return new StandingRobot("pioneer", StationaryPioneer::talk);
    }

    private static void talk(Socket client, StandingRobot robot) throws IOException {
        if (shakesHands(client)) {
            robot.every(100, () -> client.getOutputStream().write(Bytes.of(Bytes.AT_REST)));
        }
        discard(client.getInputStream());
    }

    /** Echoes the SYNCs. Returns false for a client that sends other data, which is only read. */
    private static boolean shakesHands(Socket client) throws IOException {
        byte[] sync = client.getInputStream().readNBytes(6);
        while (sync.length == 6 && sync[3] < SYNC2 && sync[2] == 3) {
            client.getOutputStream().write(sync);
            sync = client.getInputStream().readNBytes(6);
        }
        boolean last = sync.length == 6 && sync[2] == 3;
        if (last) {
            client.getOutputStream().write(Bytes.of(Bytes.NAMES));
        }
        return last;
    }

    private static void discard(InputStream in) throws IOException {
        byte[] buffer = new byte[8192];
        while (in.read(buffer) >= 0) {
            // Only the reading counts.
        }
    }
}
