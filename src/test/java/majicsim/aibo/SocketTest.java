package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.locks.ReentrantLock;
import majicsim.net.Clients;
import majicsim.net.Faults;
import majicsim.net.TcpPort;
import majicsim.net.Wiring;
import majicsim.world.Noise;
import org.junit.jupiter.api.Test;

/** The dog behind a real port on loopback. */
class SocketTest {
    @Test
    void aClientOnARealSocketIsGreetedAnsweredAndSentTheEnd() throws IOException {
        Bench bench = Bench.exact();
        ReentrantLock lock = new ReentrantLock();
        Wiring wiring = new Wiring(lock, bench.dog(), new Faults(Noise.exact()));
        try (TcpPort port = TcpPort.open(0, Clients.MANY, wiring);
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), port.number())) {
            socket.setSoTimeout(60_000);
            BufferedReader lines =
                    new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
            assertThat(lines.readLine()).matches("\\[\\d{8}:start] \\*\\*\\* \\*+");
            until(lines, "ident");

            socket.getOutputStream().write("w+end: robot.walk(100), go: 1;".getBytes(StandardCharsets.US_ASCII));
            until(lines, "go");
            lock.lock();
            try {
                bench.run(200);
            } finally {
                lock.unlock();
            }

            assertThat(until(lines, "w")).endsWith("*** end");
        }
    }

    private static String until(BufferedReader lines, String tag) throws IOException {
        String line = lines.readLine();
        while (line != null && !line.contains(":" + tag + "] ")) {
            line = lines.readLine();
        }
        assertThat(line).as("a line with tag " + tag).isNotNull();
        return line;
    }
}
