package majic.figures;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import majic.link.Link;
import majic.link.Traffic;
import majic.stop.TimedBytes;

/** A link that records what is written to it, with the times at which the system had taken the bytes. */
final class TimedLink implements Link {
    private final Link link;
    private final TimedBytes written;

    TimedLink(Link link, TimedBytes written) {
        this.link = link;
        this.written = written;
    }

    @Override
    public void open(int timeoutMs) throws IOException {
        link.open(timeoutMs);
    }

    @Override
    public int read(byte[] buffer) throws IOException {
        return link.read(buffer);
    }

    @Override
    public void write(byte[] message) throws IOException {
        link.write(message);
        long takenNanos = System.nanoTime();
        written.add(new String(message, StandardCharsets.ISO_8859_1), takenNanos);
    }

    @Override
    public void close() {
        link.close();
    }

    @Override
    public void abort() {
        link.abort();
    }

    @Override
    public boolean setBaud(int baud) throws IOException {
        return link.setBaud(baud);
    }

    @Override
    public String address() {
        return link.address();
    }

    @Override
    public Traffic traffic() {
        return link.traffic();
    }
}
