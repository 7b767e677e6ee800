package majic.pioneer;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import majic.StandingRobot;
import majic.pioneer.arcos.Bytes;

/**
 * What a Pioneer says in a benchmark: it answers the handshake, says every 100 ms that it stands with its motors on, and reads
 * whatever else comes without looking at it.
 */
final class StandingPioneer {
    private static final int SYNC2 = 2;

    private StandingPioneer() {}

    static StandingRobot open() throws IOException {
        return new StandingRobot("pioneer", StandingPioneer::talk);
    }

    private static void talk(Socket client, StandingRobot robot) throws IOException {
        if (shakesHands(client)) {
            robot.every(100, () -> client.getOutputStream().write(Bytes.of(Bytes.AT_REST)));
        }
        discard(client.getInputStream());
    }

    /** Echoes the SYNCs; false for a client that says something else, which is only to be read. */
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
