package majic.pioneer.line;

import java.util.ArrayList;
import java.util.List;
import majic.link.Link;
import majic.link.Traffic;

/** A link that only records what is written. */
final class RecordingLink implements Link {
    final List<byte[]> written = new ArrayList<>();
    String address = "tcp:robot";

    @Override
    public void open(int timeoutMs) {}

    @Override
    public int read(byte[] buffer) {
        return -1;
    }

    @Override
    public void write(byte[] message) {
        written.add(message);
    }

    @Override
    public void close() {}

    @Override
    public void abort() {}

    @Override
    public String address() {
        return address;
    }

    @Override
    public Traffic traffic() {
        return new Traffic("", "", 0, 0, true);
    }
}
