package majicsim.net;

import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.jspecify.annotations.Nullable;

/** Sends "hi" to a new client, answers every piece of bytes in brackets, and closes the line on "bye". */
final class EchoFirmware implements Firmware {
    final BlockingQueue<String> events = new LinkedBlockingQueue<>();

    private @Nullable Line last;

    /** The line that was connected last. */
    Line last() {
        return Objects.requireNonNull(last);
    }

    @Override
    public void connected(Line line) {
        last = line;
        line.send(bytes("hi"));
        events.add("connected");
    }

    @Override
    public void received(Line line, byte[] bytes) {
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        line.send(bytes("[" + text + "]"));
        if (text.equals("bye")) {
            line.close();
        }
        events.add("received " + text);
    }

    @Override
    public void disconnected(Line line) {
        events.add("disconnected");
    }

    @Override
    public void step(double seconds) {
        events.add("step");
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }
}
