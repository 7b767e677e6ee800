package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import majic.drivertest.TestClock;
import majic.link.Link;
import majic.link.Links;
import majic.simulation.TransitCheck;
import majicsim.net.Clients;
import majicsim.net.Faults;
import majicsim.net.Firmware;
import majicsim.net.Line;
import majicsim.net.TcpPort;
import majicsim.net.Wiring;
import majicsim.world.Noise;
import org.junit.jupiter.api.Test;

/** Tests that a robot that closes its connection before its last data has arrived does not block a stepped clock. */
class ClosingLineTest {
    private final Faults faults = new Faults(Noise.seeded(1));
    private final ReentrantLock lock = new ReentrantLock(true);

    /** Answers the first bytes and closes the connection. */
    private static final class LastWords implements Firmware {
        @Override
        public void received(Line line, byte[] bytes) {
            line.send(new byte[] {1, 2, 3});
            line.close();
        }

        @Override
        public void step(double seconds) {}
    }

    @Test
    void whatIsStillUnderWayArrivesBeforeTheEnd() throws IOException, InterruptedException {
        TcpPort port = TcpPort.open(0, Clients.ONE, new Wiring(lock, new LastWords(), faults));
        TransitCheck quietness = new TransitCheck(Links::traffic, port::lines, Set.of(port.address()));
        Link link = Links.of("//" + port.address(), 0, 0);
        StringBuffer heard = new StringBuffer();
        try (TestClock clock = new TestClock(nanos -> step(port, nanos), quietness)) {
            link.open(1000);
            Thread reader = new Thread(() -> heard.append(readAll(link)));
            reader.start();
            faults.delay(50);
            link.write(new byte[] {9});

            clock.time().sleep(1);

            reader.join();
            assertThat(heard).hasToString("3");
        } finally {
            link.close();
            port.close();
        }
    }

    private void step(TcpPort port, long nanos) {
        lock.lock();
        try {
            port.step(nanos);
        } finally {
            lock.unlock();
        }
    }

    /** Returns the number of bytes until the end of the stream. */
    private static int readAll(Link link) {
        byte[] chunk = new byte[10];
        int bytes = 0;
        try {
            for (int count = link.read(chunk); count >= 0; count = link.read(chunk)) {
                bytes += count;
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes;
    }
}
