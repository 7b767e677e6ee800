package majicsim.pioneer;

import java.util.ArrayList;
import java.util.List;
import majicsim.net.Line;

/** Keeps what the robot sends. */
public final class FakeLine implements Line {
    private final List<byte[]> messages = new ArrayList<>();
    private boolean open = true;
    /** The speed at the client's end; 0 as on a network. */
    public int baud;

    @Override
    public String peer() {
        return "test";
    }

    @Override
    public void send(byte[] message) {
        messages.add(message);
    }

    @Override
    public void close() {
        open = false;
    }

    @Override
    public int baud() {
        return baud;
    }

    @Override
    public boolean isOpen() {
        return open;
    }

    /** The messages since the last call. */
    public List<byte[]> take() {
        List<byte[]> taken = List.copyOf(messages);
        messages.clear();
        return taken;
    }
}
